//! The native profile's formulas in `f32`: a twin by formula, not by bits, since each
//! device has functions of its own.

pub mod cone;
pub mod disk;
pub mod disk_light;
pub mod frame;
pub mod hemisphere;
pub mod sphere;
pub mod sphere_light;
pub mod spherical_rectangle;
pub mod spherical_triangle;
