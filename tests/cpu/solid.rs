//! The distributions over areas and directions.

#[path = "solid/cone.rs"]
mod cone;
#[path = "solid/tools.rs"]
mod tools;
