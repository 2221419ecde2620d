//! Angles of reals, their sines and cosines, and fractions of 2^32.
//!
//! Source: the polynomials of `elementary`, in the tangent and the angle as reals; its atan2.
//! Domain: any reals, or as a function says; angles in turns. Errors: a fraction of a turn
//! 2.5 * 2^-32; relative to the result, however small: an angle 2^-28, a sine 2^-29 up to an
//! eighth of a turn, beyond it 2^-29 absolutely. Tier I.
//! Mirror: `shaders/corput/real_angle.glsl`.

use crate::reference::elementary::{
    atan_polynomial, atan_ratio, cos_polynomial, sin_polynomial, square31,
};
use crate::reference::real::{
    Real, real_add, real_divide, real_fraction, real_less, real_min, real_multiply, real_negate,
    real_shift, real_smaller, real_subtract, real_uint, real_zero,
};

/// 1 - u, for u a fraction of 2^32: from 2^-32 to 1, exactly.
#[inline]
#[must_use]
pub fn real_complement(u: u32) -> Real {
    if u == 0 {
        return real_uint(1, 0);
    }
    real_uint(0u32.wrapping_sub(u), -32)
}

/// The fraction of 2^32 nearest to a, from 0 to 2^32 - 1.
#[inline]
#[must_use]
pub fn real_fraction_nearest(a: Real) -> u32 {
    real_fraction(real_add(a, real_uint(1, -33)))
}

/// The fraction of 2^32 nearest to a, where b = 1 - a: from the smaller, so that either end is
/// exact.
#[inline]
#[must_use]
pub fn real_fraction_of(a: Real, b: Real) -> u32 {
    if real_less(a, b) {
        return real_fraction_nearest(a);
    }
    0u32.wrapping_sub(real_fraction_nearest(b).max(1))
}

/// Angle of (x, y) in turns, counter-clockwise from +x, as a fraction of 2^32; 0 for (0, 0).
#[inline]
#[must_use]
pub fn real_turns(y: Real, x: Real) -> u32 {
    let mut large = x;
    let mut small = y;
    if real_smaller(x, y) {
        large = y;
        small = x;
    }
    // Both on the scale of the larger, at most 2^31: what is shifted out is below 2^-31.
    let mut angle = 0;
    if small.m != 0 {
        let shift = (large.e - small.e).min(30) as u32 + 1;
        angle = atan_ratio(small.m >> shift, large.m >> 1);
    }
    if real_smaller(x, y) {
        angle = 0x4000_0000 - angle;
    }
    if x.negative {
        angle = 0x8000_0000 - angle;
    }
    if y.negative {
        angle = 0u32.wrapping_sub(angle);
    }
    angle
}

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
