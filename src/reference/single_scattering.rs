//! Estimators of light that a homogeneous slab scatters once into a ray: free flight along
//! the ray, then the phase function of Henyey and Greenstein, under a sky of radiance 1 + z
//! around the ray, which is not attenuated.
//!
//! Source: Chandrasekhar 1950, Radiative transfer; Henyey and Greenstein 1941, ApJ 93.
//! Domain: fractions of 2^32; optical depths above 0; the phase function of
//! `henyey_greenstein`. Range: by the phase function 0 to 2, by uniform distances and
//! directions 0 to 2 depth (1 + g) / (1 - g)^2. Errors: 2^-22 of each sample, by uniform
//! directions 2^-20. Tier I.
//! Mirror: `shaders/corput/single_scattering.glsl`.

use crate::reference::exponential::real_exp;
use crate::reference::henyey_greenstein::{
    HenyeyGreenstein, henyey_greenstein, henyey_greenstein_pdf,
};
use crate::reference::logarithm::real_negative_log;
use crate::reference::real::{
    Real, real, real_add, real_less, real_multiply, real_negate, real_uint, real_zero,
};
use crate::reference::sphere::uniform_sphere;
use glam::{UVec3, Vec3, Vec3Swizzles};

/// 1 + z.
#[inline]
#[must_use]
pub fn scattering_sky(direction: Vec3) -> Real {
    real_add(real_uint(1, 0), real(direction.z))
}

/// A uniform distance and direction: depth e^-t 4 pi p (1 + z).
#[inline]
#[must_use]
pub fn scattering_uniform(h: HenyeyGreenstein, depth: Real, u: UVec3) -> Real {
    let d = uniform_sphere(u.xy());
    let t = real_multiply(depth, real_uint(u.z, -32));
    let flight = real_multiply(depth, real_exp(real_negate(t)));
    let phase = real_multiply(
        real(henyey_greenstein_pdf(h, d)),
        real_uint(3_373_259_426, -28),
    );
    real_multiply(real_multiply(flight, phase), scattering_sky(d))
}

/// A free flight, and a direction by the phase function: 1 + z for flights that end within.
#[inline]
#[must_use]
pub fn scattering_phase(h: HenyeyGreenstein, depth: Real, u: UVec3) -> Real {
    let mut value = scattering_sky(henyey_greenstein(h, u.xy()).direction);
    if !real_less(real_negative_log(u.z), depth) {
        value = real_zero();
    }
    value
}
