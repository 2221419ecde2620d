//! The distributions over areas and directions.

#[path = "solid/cone.rs"]
mod cone;
#[path = "solid/tools.rs"]
mod tools;
#[path = "solid/triangle.rs"]
mod triangle;
