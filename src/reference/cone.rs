//! Directions of a cone around +z, uniformly, with pdf and inverse.
//!
//! Source: PBRT 4th ed., A.5.4, in terms of h = 1 - cos(theta_max) = 2 sin^2(theta_max/2):
//! 1 - z = u h, radius = sqrt(u h (2 - u h)). Domain: h from 0 to 2 (the sphere), two fractions
//! of 2^32; h <= 0 gives +z with pdf 0, h > 2 counts as 2, a NaN as an infinity of its
//! sign. Range: unit vectors to 2^-23. Pdf: with respect to solid angle, 1/(2 pi h) inside,
//! the edge widened by 2^-21 of h. Errors: 0.6 ULP a coordinate, for every h; pdf 0.51
//! ULP; the inverse agrees with the sample to 2^-21. On the axis the angle is lost. Tier I.
//! Mirror: `shaders/corput/cone.glsl`.

use crate::reference::fixed::{mul64, shl64, shr64, sub64};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_less, real_multiply, real_negate,
    real_sqrt, real_square, real_subtract, real_uint, real_wide, real_zero,
};
use crate::reference::real_angle::{real_fraction_nearest, real_turns};
use crate::reference::real_vector::{Real3, real3, real3_floats};
use crate::reference::sphere::{sphere_direction, sphere_versine};
use glam::{UVec2, Vec3, uvec2};

/// h within its domain.
#[inline]
#[must_use]
pub fn cone_height(h: f32) -> Real {
    let bits = h.to_bits();
    if bits >= 0x8000_0000 {
        return real_zero();
    }
    real(f32::from_bits(bits.min(0x4000_0000)))
}

/// floor(u h * 2^63), for h up to 2 and a fraction u.
#[inline]
#[must_use]
pub fn cone_versine(h: Real, u: u32) -> UVec2 {
    let product = mul64(u, h.m);
    if h.e > -31 {
        return shl64(product, 1);
    }
    shr64(product, ((-31 - h.e).min(63)) as u32)
}

/// Uniform direction for h: 1 - z = u.x h, phi = 2 pi u.y.
#[inline]
#[must_use]
pub fn cone_around(h: Real, u: UVec2) -> Real3 {
    let versine = real_multiply(real_uint(u.x, -32), h);
    // In fixed point 1 - z and 2 - (1 - z) lose nothing where they cancel.
    let fixed_versine = cone_versine(h, u.x);
    let mut rest = real_uint(2, 0);
    if (fixed_versine.x | fixed_versine.y) != 0 {
        rest = real_wide(sub64(UVec2::ZERO, fixed_versine), -63);
    }
    let cosine = sub64(uvec2(0, 0x8000_0000), fixed_versine);
    let mut z = real_wide(cosine, -63);
    if fixed_versine.y >= 0x8000_0000 {
        z = real_negate(real_wide(sub64(UVec2::ZERO, cosine), -63));
    }
    sphere_direction(real_sqrt(real_multiply(versine, rest)), u.y, z)
}

/// 1/(2 pi h); 0 for h = 0.
#[inline]
#[must_use]
pub fn cone_density(h: Real) -> Real {
    if h.m == 0 {
        return h;
    }
    real_divide(real_uint(2_734_261_102, -34), h)
}

/// Whether a direction lies within the cone of h, by 2^-21 of its distance to the poles.
#[inline]
#[must_use]
pub fn cone_inside(h: Real, direction: Real3) -> bool {
    let z = direction.z;
    let square = real_add(real_square(direction.x), real_square(direction.y));
    if z.negative {
        let rest = real_subtract(real_uint(2, 0), h);
        let least = real_multiply(rest, real_uint(2_097_151, -21));
        return !real_less(sphere_versine(square, real_negate(z)), least);
    }
    let most = real_multiply(h, real_uint(2_097_153, -21));
    !real_less(most, sphere_versine(square, z))
}

/// The fractions that give this direction for h.
#[inline]
#[must_use]
pub fn cone_around_invert(h: Real, direction: Real3) -> UVec2 {
    let z = direction.z;
    let square = real_add(real_square(direction.x), real_square(direction.y));
    let turn = real_turns(direction.y, direction.x);
    if z.negative {
        // 1 - u, by the distance to -z.
        let rest = sphere_versine(square, real_negate(z));
        let left = real_subtract(rest, real_subtract(real_uint(2, 0), h));
        let fraction = real_fraction_nearest(real_divide(left, h)).max(1);
        return uvec2(0u32.wrapping_sub(fraction), turn);
    }
    let versine = sphere_versine(square, z);
    uvec2(real_fraction_nearest(real_divide(versine, h)), turn)
}

/// Uniform direction of the cone.
#[inline]
#[must_use]
pub fn cone(h: f32, u: UVec2) -> Vec3 {
    real3_floats(cone_around(cone_height(h), u))
}

/// 1/(2 pi h) inside, else 0.
#[inline]
#[must_use]
pub fn cone_pdf(h: f32, direction: Vec3) -> f32 {
    let height = cone_height(h);
    if !cone_inside(height, real3(direction)) {
        return 0.0;
    }
    real_float(cone_density(height))
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn cone_invert(h: f32, direction: Vec3) -> UVec2 {
    cone_around_invert(cone_height(h), real3(direction))
}
