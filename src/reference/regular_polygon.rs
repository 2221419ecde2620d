//! Points of a regular polygon of circumradius 1 with a vertex at (1, 0), uniformly, with pdf
//! and inverse.
//!
//! Source: the polygon's triangles from the centre in turn. Domain: 3 to 65,536 sides, others
//! count as the nearest of them; two fractions of 2^32. Range: the polygon. Pdf: with respect
//! to area, 1 / (n sin(pi/n) cos(pi/n)) inside, the edge widened by 2^-21. Errors: 0.9 ULP of a
//! float of at least 1/16; pdf 0.6 ULP; the inverse agrees with the sample to 2^-21. At the
//! centre the angle is lost. Tier I.
//! Mirror: `shaders/corput/regular_polygon.glsl`.

use crate::reference::elementary::{atan2, sincos_scaled};
use crate::reference::fixed::{mul64, mulhi};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_less, real_max, real_min, real_multiply,
    real_scaled, real_shift, real_sqrt, real_square, real_subtract, real_uint, real_zero,
};
use crate::reference::real_angle::{angle_cosine, angle_sine, real_fraction_nearest};
use crate::reference::real_vector::Real3;
use glam::{UVec2, Vec2, uvec2, vec2};

/// Half the angle of a side, in turns.
#[inline]
#[must_use]
pub fn regular_polygon_half(sides: u32) -> Real {
    real_divide(real_uint(1, -1), real_uint(sides.clamp(3, 65_536), 0))
}

/// The direction of the middle of a side, as a fraction of 2^32 of a turn.
#[inline]
#[must_use]
pub fn regular_polygon_middle(side: u32, half_side: Real) -> u32 {
    real_fraction_nearest(real_multiply(real_uint(2 * side + 1, 0), half_side))
}

/// Uniform point of the polygon.
#[inline]
#[must_use]
pub fn regular_polygon(sides: u32, u: UVec2) -> Vec2 {
    let half_side = regular_polygon_half(sides);
    let at = mul64(u.x, sides.clamp(3, 65_536));
    // From -1 to 1 along the side.
    let along = real_subtract(real_uint(at.x, -31), real_uint(1, 0));
    let radius = real_sqrt(real_uint(u.y, -32));
    let x = real_multiply(radius, angle_cosine(half_side));
    let y = real_multiply(real_multiply(radius, angle_sine(half_side)), along);
    let turn = sincos_scaled(regular_polygon_middle(at.y, half_side));
    let cosine = real_scaled(turn.cosine, turn.cosine_negative);
    let sine = real_scaled(turn.sine, turn.sine_negative);
    vec2(
        real_float(real_subtract(
            real_multiply(x, cosine),
            real_multiply(y, sine),
        )),
        real_float(real_add(real_multiply(x, sine), real_multiply(y, cosine))),
    )
}

/// The side that a point is at, and the point turned so that its middle is on +x.
#[inline]
#[must_use]
pub fn regular_polygon_turned(sides: u32, p: Vec2) -> Real3 {
    let half_side = regular_polygon_half(sides);
    let side = mulhi(atan2(p.y, p.x), sides.clamp(3, 65_536));
    let turn = sincos_scaled(regular_polygon_middle(side, half_side));
    let cosine = real_scaled(turn.cosine, turn.cosine_negative);
    let sine = real_scaled(turn.sine, turn.sine_negative);
    let x = real(p.x);
    let y = real(p.y);
    Real3 {
        x: real_add(real_multiply(x, cosine), real_multiply(y, sine)),
        y: real_subtract(real_multiply(y, cosine), real_multiply(x, sine)),
        z: real_uint(side, 0),
    }
}

/// 1 over the area inside, else 0.
#[inline]
#[must_use]
pub fn regular_polygon_pdf(sides: u32, p: Vec2) -> f32 {
    let half_side = regular_polygon_half(sides);
    let cosine = angle_cosine(half_side);
    let most = real_multiply(cosine, real_uint(2_097_153, -21));
    if real_less(most, regular_polygon_turned(sides, p).x) {
        return 0.0;
    }
    let area = real_multiply(
        real_uint(sides.clamp(3, 65_536), 0),
        real_multiply(angle_sine(half_side), cosine),
    );
    real_float(real_divide(real_uint(1, 0), area))
}

/// The fractions that give this point.
#[inline]
#[must_use]
pub fn regular_polygon_invert(sides: u32, p: Vec2) -> UVec2 {
    let half_side = regular_polygon_half(sides);
    let local = regular_polygon_turned(sides, p);
    let radius = real_divide(local.x, angle_cosine(half_side));
    let along = real_divide(local.y, real_multiply(radius, angle_sine(half_side)));
    let one = real_uint(1, 0);
    let mut part = real_shift(real_add(along, one), -1);
    part = real_min(real_max(part, real_zero()), one);
    let whole = real_divide(
        real_add(local.z, part),
        real_uint(sides.clamp(3, 65_536), 0),
    );
    uvec2(
        real_fraction_nearest(whole),
        real_fraction_nearest(real_square(radius)),
    )
}
