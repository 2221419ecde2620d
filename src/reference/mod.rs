//! CPU reference: the Rust twin of every GLSL header, with the same names (less the
//! `corput_` prefix), the same order and the same bits.
//!
//! Porting rules between the two languages:
//!
//! | GLSL | Rust |
//! |---|---|
//! | `uint` `+ - *` wrap | `wrapping_add` and so on, wherever a wrap can happen |
//! | `uvec2(low, high)` | [`glam::UVec2`] |
//! | `x >> s`, `s < 32` | `x >> s` |
//! | `uint(i)`, `int(u)` | `as u32`, `as i32` (the bits stay) |
//! | `floatBitsToUint` | `f32::to_bits` |
//! | `uint(bool)` | `u32::from` |
//! | hook macro | a parameter or a table |
//!
//! [`native`] twins the native profile, whose bits depend on the device; only its
//! formulas are mirrored.

#![expect(
    clippy::manual_abs_diff,
    clippy::excessive_precision,
    clippy::needless_range_loop,
    reason = "statements and literals read as in the shaders"
)]

pub mod annulus;
pub mod arc;
pub mod axis;
pub mod beckmann;
pub mod bits;
pub mod blue_noise;
pub mod cone;
pub mod cosine_power;
pub mod defocus;
pub mod discrepancy;
pub mod discrete;
pub mod disk;
pub mod disk_light;
pub mod distance;
pub mod domain;
pub mod domain_draw;
pub mod domain_halton;
pub mod domain_sobol;
pub mod elementary;
pub mod environment;
pub mod envmap;
pub mod exponential;
pub mod filter;
pub mod filter_blackman_harris;
pub mod filter_mitchell;
pub mod fixed;
pub mod frame;
pub mod free_flight;
pub mod gaussian;
pub mod genz;
pub mod ggx;
pub mod ggx_furnace;
pub mod ggx_lobe;
pub mod ggx_vndf;
pub mod ggx_vndf_bounded;
pub mod ggx_vndf_cap;
pub mod halton;
pub mod halton_scrambled;
pub mod hammersley;
pub mod hash;
pub mod hemisphere;
pub mod henyey_greenstein;
pub mod highlight;
pub mod integrand;
pub mod irradiance;
pub mod keister;
pub mod lambert;
pub mod lattice;
pub mod lattice_vector;
pub mod logarithm;
pub mod mis;
pub mod native;
pub mod normal_quantile;
pub mod odometer;
pub mod owen;
pub mod permute;
pub mod pixel_edge;
pub mod pmj02;
pub mod primes;
pub mod radical_inverse;
pub mod random;
pub mod real;
pub mod real_angle;
pub mod real_frame;
pub mod real_vector;
pub mod reflect;
pub mod regular_polygon;
pub mod scattered;
pub mod scrambled_radical_inverse;
pub mod screen_space;
pub mod single_scattering;
pub mod sobol;
pub mod sobol_directions;
pub mod soft_shadow;
pub mod sphere;
pub mod sphere_light;
pub mod spherical_rectangle;
pub mod spherical_triangle;
pub mod stratified;
pub mod sum;
pub mod triangle;
pub mod unit;
pub mod wide;
