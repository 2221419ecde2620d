//! The native profile's formulas in `f32`: a twin by formula, not by bits, since each
//! device has functions of its own.

pub mod cone;
pub mod disk;
pub mod environment;
pub mod frame;
pub mod hemisphere;
pub mod henyey_greenstein;
pub mod scattered;
pub mod sphere;
