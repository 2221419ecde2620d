//! The slow judge of both twins: exact rationals in 128 bits and `f64`, written from
//! the definitions and sharing no code with [`crate::reference`].
//!
//! `f64` carries 53 bits, 29 more than the results it judges, so its own error moves a
//! ULP figure by less than 2^-28.

mod digits;
pub mod environment;
mod functions;
mod highlight;
mod integrands;
pub mod irradiance;
pub mod lights;
pub mod line;
mod maps;
mod normal;
mod optics;
pub mod planar;
pub mod random;
mod reduce;
mod scattering;
mod scenes;
pub mod spherical;
pub mod spherical_triangle;
mod strata;
mod transcendental;
mod wide;

pub use digits::{Scrambled, faure_permutation, owen, permutation, permuted, started};
pub use environment::EnvironmentTables;
pub use functions::{
    RadicalInverses, atan2_turns, divide, hammersley, multiply, radical_inverse, sin_cos,
    sobol_directions, sqrt,
};
pub use highlight::highlight;
pub use integrands::{integrand, normal_peak};
pub use maps::{
    concentric_disk, cosine_hemisphere, cosine_hemisphere_polar, frame, polar_disk,
    uniform_hemisphere,
};
pub use normal::{normal_density, normal_mass, normal_quantile, normal_tail};
pub use reduce::float_sum;
pub use scattering::{
    Ggx, beckmann, beckmann_normal, henyey_greenstein, henyey_greenstein_fractions,
    henyey_greenstein_pdf,
};
pub use scenes::scene;
pub use strata::{additive, cmj, korobov, stratum};
pub use transcendental::{log, log2, negative_log};
pub use wide::Wide;

/// The distance from `truth` to `got` in units of the last place of the float nearest
/// to `truth`; zero counts the smallest normal float as its unit.
#[must_use]
pub fn ulp_error(got: f32, truth: f64) -> f64 {
    if f64::from(got) == truth {
        return 0.0;
    }
    let magnitude = truth.abs().max(f64::from(f32::MIN_POSITIVE));
    let exponent = (magnitude.to_bits() >> 52) as i32 - 1023;
    (f64::from(got) - truth).abs() / f64::powi(2.0, exponent - 23)
}

/// The same in units of the last place of `floor` where the truth is smaller, for functions
/// whose error is not relative there.
#[must_use]
pub fn ulp_above(got: f32, truth: f64, floor: f64) -> f64 {
    if truth.abs() >= floor {
        return ulp_error(got, truth);
    }
    let exponent = (floor.to_bits() >> 52) as i32 - 1023;
    (f64::from(got) - truth).abs() / f64::powi(2.0, exponent - 23)
}
