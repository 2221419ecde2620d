//! The native profile's formulas in `f32`: a twin by formula, not by bits, since each
//! device has functions of its own.

pub mod annulus;
pub mod beckmann;
pub mod cone;
pub mod cosine_power;
pub mod disk;
pub mod disk_light;
pub mod environment;
pub mod filter;
pub mod filter_blackman_harris;
pub mod filter_mitchell;
pub mod frame;
pub mod free_flight;
pub mod gaussian;
pub mod ggx;
pub mod ggx_lobe;
pub mod ggx_vndf;
pub mod ggx_vndf_bounded;
pub mod ggx_vndf_cap;
pub mod hemisphere;
pub mod henyey_greenstein;
pub mod normal_quantile;
pub mod reflect;
pub mod regular_polygon;
pub mod scattered;
pub mod sphere;
pub mod sphere_light;
pub mod spherical_rectangle;
pub mod spherical_triangle;
pub mod triangle;
