//! Points of a triangle in the plane, uniformly, with pdf and inverse.
//!
//! Source: Heitz 2019, A low-distortion map between triangle and square: continuous, and
//! without a root, so that barycentric coordinates are integers of an exact sum. Domain:
//! three vertices, two fractions of 2^32, of which 30 bits count; a degenerate triangle:
//! points of it, with pdf 0. Range: the triangle. Pdf: with respect to area, 1 over it inside,
//! edges widened by the rounding of a point. Errors: 0.6 ULP, or 2^-29 of the largest vertex
//! where they cancel; pdf 0.6 ULP; the inverse agrees with the sample to 2^-20. Tier I.
//! Mirror: `shaders/corput/triangle.glsl`.

use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_less, real_max, real_multiply, real_negate,
    real_shift, real_subtract, real_uint, real_zero,
};
use crate::reference::real_angle::real_fraction_nearest;
use crate::reference::wide::{wide_determinant, wide_real};
use glam::{UVec2, UVec3, Vec2, uvec2, uvec3, vec2};

/// Barycentric coordinates as fractions of 2^31, whose sum is 2^31.
#[inline]
#[must_use]
pub fn triangle_weights(u: UVec2) -> UVec3 {
    let x = u.x >> 2;
    let y = u.y >> 2;
    if y > x {
        return uvec3(x, 2 * y - x, 0x8000_0000 - 2 * y);
    }
    uvec3(2 * x - y, y, 0x8000_0000 - 2 * x)
}

/// a, b and c by their weights.
#[inline]
#[must_use]
pub fn triangle_mean(a: f32, b: f32, c: f32, weights: UVec3) -> Real {
    let x = real_multiply(real(a), real_uint(weights.x, -31));
    let y = real_multiply(real(b), real_uint(weights.y, -31));
    let z = real_multiply(real(c), real_uint(weights.z, -31));
    real_add(real_add(x, y), z)
}

/// Twice the area of a, b, c; negative if they turn clockwise.
#[inline]
#[must_use]
pub fn triangle_area(a: Vec2, b: Vec2, c: Vec2) -> Real {
    let x = real(a.x);
    let y = real(a.y);
    wide_real(wide_determinant(
        real_subtract(real(b.x), x),
        real_subtract(real(b.y), y),
        real_subtract(real(c.x), x),
        real_subtract(real(c.y), y),
    ))
}

/// Uniform point of the triangle.
#[inline]
#[must_use]
pub fn triangle(a: Vec2, b: Vec2, c: Vec2, u: UVec2) -> Vec2 {
    let weights = triangle_weights(u);
    vec2(
        real_float(triangle_mean(a.x, b.x, c.x, weights)),
        real_float(triangle_mean(a.y, b.y, c.y, weights)),
    )
}

/// The magnitude of a vector's larger coordinate.
#[inline]
#[must_use]
pub fn triangle_size(x: Real, y: Real) -> Real {
    real_max(
        Real {
            m: x.m,
            e: x.e,
            negative: false,
        },
        Real {
            m: y.m,
            e: y.e,
            negative: false,
        },
    )
}

/// Whether p is on the inner side of ab, or beyond it by its rounding.
#[inline]
#[must_use]
pub fn triangle_side(a: Vec2, b: Vec2, p: Vec2, clockwise: bool) -> bool {
    let mut area = triangle_area(a, b, p);
    if clockwise {
        area = real_negate(area);
    }
    let side = triangle_size(
        real_subtract(real(b.x), real(a.x)),
        real_subtract(real(b.y), real(a.y)),
    );
    let size = triangle_size(real(p.x), real(p.y));
    let slack = real_shift(real_multiply(side, real_add(side, size)), -22);
    !real_add(area, slack).negative
}

/// 1 over the area inside, else 0.
#[inline]
#[must_use]
pub fn triangle_pdf(a: Vec2, b: Vec2, c: Vec2, p: Vec2) -> f32 {
    let area = triangle_area(a, b, c);
    if area.m == 0
        || !triangle_side(a, b, p, area.negative)
        || !triangle_side(b, c, p, area.negative)
        || !triangle_side(c, a, p, area.negative)
    {
        return 0.0;
    }
    real_float(real_divide(
        real_uint(2, 0),
        Real {
            m: area.m,
            e: area.e,
            negative: false,
        },
    ))
}

/// The fractions that give this point.
#[inline]
#[must_use]
pub fn triangle_invert(a: Vec2, b: Vec2, c: Vec2, p: Vec2) -> UVec2 {
    let area = triangle_area(a, b, c);
    if area.m == 0 {
        return UVec2::ZERO;
    }
    let zero = real_zero();
    let x = real_max(real_divide(triangle_area(p, b, c), area), zero);
    let y = real_max(real_divide(triangle_area(p, c, a), area), zero);
    let sum = real_fraction_nearest(real_add(x, y));
    if real_less(x, y) {
        return uvec2(real_fraction_nearest(real_shift(x, 1)), sum);
    }
    uvec2(sum, real_fraction_nearest(real_shift(y, 1)))
}
