//! Angles and complements of reals: the turns of a point, and the fraction of two numbers
//! that sum to 1.
//!
//! Source: atan2 of elementary.glsl. Domain: any reals. Errors: an angle 2.5 * 2^-32 of a
//! turn. Tier I.
//! Mirror: `shaders/corput/real_angle.glsl`.

use crate::reference::elementary::atan_ratio;
use crate::reference::real::{Real, real_add, real_fraction, real_less, real_smaller, real_uint};

/// 1 - u, for u a fraction of 2^32: from 2^-32 to 1, exactly.
#[inline]
#[must_use]
pub fn real_complement(u: u32) -> Real {
    if u == 0 {
        return real_uint(1, 0);
    }
    real_uint(0u32.wrapping_sub(u), -32)
}

/// The fraction of 2^32 nearest to a, where b = 1 - a: from the smaller, so that either end is
/// exact.
#[inline]
#[must_use]
pub fn real_fraction_of(a: Real, b: Real) -> u32 {
    let half_unit = real_uint(1, -33);
    if real_less(a, b) {
        return real_fraction(real_add(a, half_unit));
    }
    0u32.wrapping_sub(real_fraction(real_add(b, half_unit)).max(1))
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
