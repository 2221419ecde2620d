//! The native profile's formulas in `f32`: a twin by formula, not by bits, since each
//! device has functions of its own.

pub mod cone;
pub mod disk;
pub mod filter;
pub mod frame;
pub mod free_flight;
pub mod gaussian;
pub mod hemisphere;
pub mod henyey_greenstein;
pub mod normal_quantile;
pub mod scattered;
pub mod sphere;
