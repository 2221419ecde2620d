//! Angles as reals, and back, with all their digits however small they are.
//!
//! Source: the polynomials of `elementary`, in the tangent and the angle as reals. Domain:
//! as each function says; angles in turns. Errors: relative to the result, angle 2^-28,
//! sine 2^-29 up to an eighth of a turn, beyond it 2^-29 absolutely. Tier I.
//! Mirror: `shaders/corput/angle.glsl`.

use crate::reference::elementary::{atan_polynomial, cos_polynomial, sin_polynomial, square31};
use crate::reference::real::{
    Real, real_divide, real_fraction, real_less, real_min, real_multiply, real_negate, real_shift,
    real_subtract, real_uint, real_zero,
};

/// The angle of (x, y) from +x, for y >= 0: 0 to 1/2; 0 for (0, 0).
#[inline]
#[must_use]
pub fn angle(y: Real, x: Real) -> Real {
    let width = Real {
        m: x.m,
        e: x.e,
        negative: false,
    };
    let steep = real_less(width, y);
    let mut tangent = real_divide(y, width);
    if steep {
        tangent = real_divide(width, y);
    }
    let w = square31(real_fraction(tangent) >> 1);
    let mut turns = real_multiply(tangent, real_uint(atan_polynomial(w), -34));
    if y.m == 0 {
        turns = real_zero();
    }
    if steep {
        turns = real_subtract(real_uint(1, -2), turns);
    }
    if x.negative {
        turns = real_subtract(real_uint(1, -1), turns);
    }
    turns
}

/// The sine of an angle from 0 to 1/4.
#[inline]
#[must_use]
pub fn angle_sine(turns: Real) -> Real {
    if real_less(real_uint(1, -3), turns) {
        let rest = real_subtract(real_uint(1, -2), turns);
        let w = square31(real_fraction(real_shift(rest, 3)) >> 1);
        return real_uint(cos_polynomial(w), -32);
    }
    let eighths = real_shift(turns, 3);
    let w = square31(real_fraction(eighths) >> 1);
    real_multiply(eighths, real_uint(sin_polynomial(w), -32))
}

/// The sine of an angle from 0 to 1/2, given it and what it lacks of 1/2.
#[inline]
#[must_use]
pub fn angle_sine_half(turns: Real, rest: Real) -> Real {
    angle_sine(real_min(turns, rest))
}

/// The cosine of an angle from 0 to 1/2.
#[inline]
#[must_use]
pub fn angle_cosine(turns: Real) -> Real {
    let rest = real_subtract(real_uint(1, -2), turns);
    if rest.negative {
        return real_negate(angle_sine(real_negate(rest)));
    }
    angle_sine(rest)
}
