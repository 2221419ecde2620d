//! Points of the annulus between an inner radius and 1, uniformly, with pdf and inverse.
//!
//! Source: inversion of the radial CDF: r^2 = i^2 + u (1 - i) (1 + i). Domain: an inner radius i
//! from 0 to 1, others count as the nearest of them; two fractions of 2^32; i = 1: points of
//! the circle, with pdf 0. Range: i (1 - 2^-23) <= |p| <= 1 + 2^-23. Pdf: with respect to area,
//! 1 / (pi (1 - i) (1 + i)) inside, edges widened by 2^-22. Errors: 0.6 ULP a coordinate; pdf
//! 0.6 ULP; the inverse agrees with the sample to 2^-22 of 1 / (1 - i^2). Tier I.
//! Mirror: `shaders/corput/annulus.glsl`.

use crate::reference::elementary::atan2;
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_less, real_max, real_min, real_multiply,
    real_negate, real_shift, real_sqrt, real_square, real_subtract, real_uint, real_zero,
};
use crate::reference::real_angle::real_fraction_nearest;
use crate::reference::sphere::sphere_direction;
use crate::reference::wide::{wide_add, wide_product, wide_real};
use glam::{UVec2, Vec2, uvec2, vec2};

/// The inner radius within its domain.
#[inline]
#[must_use]
pub fn annulus_inner(inner: f32) -> Real {
    real_min(real_max(real(inner), real_zero()), real_uint(1, 0))
}

/// (1 - i) (1 + i).
#[inline]
#[must_use]
pub fn annulus_width(inner: Real) -> Real {
    let one = real_uint(1, 0);
    real_multiply(real_subtract(one, inner), real_add(one, inner))
}

/// Uniform point of the annulus: |p|^2 = i^2 + u.x (1 - i^2), at the angle 2 pi u.y.
#[inline]
#[must_use]
pub fn annulus(inner: f32, u: UVec2) -> Vec2 {
    let i = annulus_inner(inner);
    let part = real_multiply(annulus_width(i), real_uint(u.x, -32));
    let radius = real_sqrt(real_add(real_square(i), part));
    let p = sphere_direction(radius, u.y, real_zero());
    vec2(real_float(p.x), real_float(p.y))
}

/// |p|^2 - i^2.
#[inline]
#[must_use]
pub fn annulus_excess(inner: Real, p: Vec2) -> Real {
    let x = real(p.x);
    let y = real(p.y);
    let square = wide_add(wide_product(x, x), wide_product(y, y));
    wide_real(wide_add(square, wide_product(real_negate(inner), inner)))
}

/// 1/(pi (1 - i^2)) inside, else 0.
#[inline]
#[must_use]
pub fn annulus_pdf(inner: f32, p: Vec2) -> f32 {
    let i = annulus_inner(inner);
    let width = annulus_width(i);
    let excess = annulus_excess(i, p);
    let slack = real_shift(real_square(i), -22);
    let most = real_add(width, real_uint(1, -22));
    if width.m == 0 || real_add(excess, slack).negative || real_less(most, excess) {
        return 0.0;
    }
    // 1/pi to 32 bits.
    real_float(real_divide(real_uint(2_734_261_102, -33), width))
}

/// The fractions that give this point.
#[inline]
#[must_use]
pub fn annulus_invert(inner: f32, p: Vec2) -> UVec2 {
    let i = annulus_inner(inner);
    let part = real_divide(annulus_excess(i, p), annulus_width(i));
    uvec2(real_fraction_nearest(part), atan2(p.y, p.x))
}
