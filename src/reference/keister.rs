//! Integrands over normal distributions, dimension by dimension by quantiles: Keister's, and
//! a Gaussian peak by importance sampling.
//!
//! Source: Keister 1996, Computers in Physics 10(2); Genz 1984 for the peak. Domain:
//! fractions of 2^32, of which quantiles take the midpoints; a centre w, a fraction of 2^32,
//! and a width above 0. Range: each sum is cut by 2^-30 of itself: of 20 dimensions the
//! cosine is within 2e-7, at the ends, where the sum is 800. Tier I.
//! Mirror: `shaders/corput/keister.glsl`.

use crate::reference::integrand::turns_sine;
use crate::reference::normal_quantile::real_normal_quantile;
use crate::reference::real::{
    Real, real_add, real_less, real_multiply, real_shift, real_sqrt, real_square, real_uint,
};

/// sum + z^2.
#[inline]
#[must_use]
pub fn keister_square(sum: Real, u: u32) -> Real {
    real_add(sum, real_square(real_normal_quantile(u)))
}

/// cos(sqrt(sum / 2)).
#[inline]
#[must_use]
pub fn keister_cosine(sum: Real) -> Real {
    let root = real_sqrt(real_shift(sum, -1));
    // 1/(2 pi) to 32 bits.
    let turns = real_multiply(root, real_uint(2_734_261_102, -34));
    let whole = turns.m << (turns.e + 32).clamp(0, 31) as u32;
    let part = turns.m >> (-32 - turns.e).clamp(0, 31) as u32;
    let mut phase = part;
    if turns.e > -32 {
        phase = whole;
    }
    turns_sine(phase.wrapping_add(0x4000_0000))
}

/// 1 where centre + width z lies outside [0, 1), else 0.
#[inline]
#[must_use]
pub fn peak_outside(u: u32, centre: u32, width: Real) -> u32 {
    let mut x = real_multiply(width, real_normal_quantile(u));
    x = real_add(real_uint(centre, -32), x);
    u32::from(x.negative) | u32::from(!real_less(x, real_uint(1, 0)))
}
