//! Directions of the whole sphere, uniformly, with pdf and inverse.
//!
//! Source: Archimedes' projection; PBRT 4th ed., A.5; z = 1 - 2 u and the radius
//! 2 sqrt(u (1 - u)) from the integers. Domain: two fractions of 2^32. Range: unit vectors to
//! 2^-23. Pdf: with respect to solid angle, 1/(4 pi). Errors: 0.6 ULP a coordinate; the
//! inverse agrees with the sample to 2^-23. At a pole the angle is lost. Tier I.
//! Mirror: `shaders/corput/sphere.glsl`.

use crate::reference::elementary::{atan2, sincos_scaled};
use crate::reference::fixed::mul64;
use crate::reference::real::{
    Real, real, real_add, real_divide, real_less, real_multiply, real_negate, real_scaled,
    real_shift, real_sqrt, real_square, real_subtract, real_uint, real_wide,
};
use crate::reference::real_angle::real_fraction_nearest;
use crate::reference::real_vector::{Real3, real3_floats};
use glam::{UVec2, Vec3, uvec2};

/// 1 - z of a unit vector, given its x^2 + y^2: z alone has no digits of it near +z.
#[inline]
#[must_use]
pub fn sphere_versine(square: Real, z: Real) -> Real {
    let one = real_uint(1, 0);
    if real_less(z, real_uint(1, -1)) {
        return real_subtract(one, z);
    }
    real_divide(square, real_add(one, z))
}

/// radius * (cos 2 pi u, sin 2 pi u) and z.
#[inline]
#[must_use]
pub fn sphere_direction(radius: Real, u: u32, z: Real) -> Real3 {
    let phi = sincos_scaled(u);
    let cosine = real_scaled(phi.cosine, phi.cosine_negative);
    let sine = real_scaled(phi.sine, phi.sine_negative);
    Real3 {
        x: real_multiply(radius, cosine),
        y: real_multiply(radius, sine),
        z,
    }
}

/// Uniform direction: z = 1 - 2 u.x, phi = 2 pi u.y.
#[inline]
#[must_use]
pub fn uniform_sphere(u: UVec2) -> Vec3 {
    // u (1 - u), exact, as a fraction of 2^64.
    let square = real_wide(mul64(u.x, 0u32.wrapping_sub(u.x)), -64);
    let magnitude = if u.x < 0x8000_0000 {
        0x8000_0000 - u.x
    } else {
        u.x - 0x8000_0000
    };
    let mut z = real_uint(magnitude, -31);
    if u.x > 0x8000_0000 {
        z = real_negate(z);
    }
    let radius = real_shift(real_sqrt(square), 1);
    real3_floats(sphere_direction(radius, u.y, z))
}

/// 1/(4 pi).
#[inline]
#[must_use]
pub fn uniform_sphere_pdf() -> f32 {
    f32::from_bits(0x3da2_f983)
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn uniform_sphere_invert(direction: Vec3) -> UVec2 {
    let x = real(direction.x);
    let y = real(direction.y);
    let z = real(direction.z);
    let square = real_add(real_square(x), real_square(y));
    let turn = atan2(direction.y, direction.x);
    if z.negative {
        let rest = sphere_versine(square, real_negate(z));
        let fraction = real_fraction_nearest(real_shift(rest, -1)).max(1);
        return uvec2(0u32.wrapping_sub(fraction), turn);
    }
    let versine = sphere_versine(square, z);
    uvec2(real_fraction_nearest(real_shift(versine, -1)), turn)
}
