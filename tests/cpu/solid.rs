//! The distributions over areas and directions.

#[path = "solid/cone.rs"]
mod cone;
#[path = "solid/lights.rs"]
mod lights;
#[path = "solid/planar.rs"]
mod planar;
#[path = "solid/power.rs"]
mod power;
#[path = "solid/rectangle.rs"]
mod rectangle;
mod significance;
#[path = "solid/tools.rs"]
mod tools;
#[path = "solid/triangle.rs"]
mod triangle;
