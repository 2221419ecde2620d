//! Exponentials and powers with one set of bits everywhere: exp2, exp, 2^z - 1 without loss
//! near 0, exp(-z^2/2), x^y and 1 - x^y.
//!
//! Source: z = n + r with r in [0, 1); 1 + r P(r), P by interpolation in Chebyshev nodes
//! (`scripts/elementary_polynomials.py`), in fixed point. Domain: any real. From 2^13 on in
//! magnitude the result is 2^32767, or 0; as a float it saturates at the largest finite
//! one, and below 2^-126 it is +0. Range: reals within 2^-29.5 of themselves, 2^z - 1
//! within 2^-29; floats 0.52 ULP. A power x^y is within 2^-29.5 + |y log2 x| 2^-29.7 of
//! itself, and 1 - x^y within 2^-28 where x^y <= 1. Tier I.
//! Mirror: `shaders/corput/exponential.glsl`.

use crate::reference::fixed::{add64, mul64, mulhi, shr64, sub64};
use crate::reference::logarithm::real_log2;
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_multiply, real_negate, real_subtract,
    real_zero,
};
use glam::{UVec2, uvec2};

/// (2^r - 1) / r as a fraction of 2^32, for r a fraction of 2^32: at least ln 2.
#[inline]
#[must_use]
pub fn exp2_polynomial(r: u32) -> u32 {
    // The coefficients sum up to 2^32 - 1: no step carries.
    let mut p = 61_958 + mulhi(r, 7_749);
    p = 664_660 + mulhi(r, p);
    p = 5_725_253 + mulhi(r, p);
    p = 41_309_926 + mulhi(r, p);
    p = 238_388_284 + mulhi(r, p);
    p = 1_031_764_993 + mulhi(r, p);
    2_977_044_472 + mulhi(r, p)
}

/// 2^z for z = (negative ? -1 : 1) * m * 2^e, where m is 0 or at least 2^61.
#[inline]
#[must_use]
pub fn real_exp2_wide(m: UVec2, e: i32, negative: bool) -> Real {
    if m.y != 0 && e > -49 {
        return Real {
            m: if negative { 0 } else { 0x8000_0000 },
            e: if negative { 0 } else { 32736 },
            negative: false,
        };
    }
    // 32 bits of fraction, in two's complement.
    let mut z = UVec2::ZERO;
    if m.y != 0 && e > -96 {
        z = shr64(m, (-32 - e) as u32);
    }
    if negative {
        z = sub64(UVec2::ZERO, z);
    }
    let fraction = mulhi(z.x, exp2_polynomial(z.x));
    let rounded = ((fraction >> 1) + (fraction & 1)).min(0x7fff_ffff);
    Real {
        m: 0x8000_0000 + rounded,
        e: z.y as i32 - 31,
        negative: false,
    }
}

/// e^z for z = (negative ? -1 : 1) * m * 2^e, where m is 0 or at least 2^62.
#[inline]
#[must_use]
pub fn real_exp_wide(m: UVec2, e: i32, negative: bool) -> Real {
    // The upper half of m / ln 2 * 2^63: three of four products, within 3 units.
    let mut low = uvec2(mulhi(m.x, 3_098_164_009), 0);
    low = add64(low, uvec2(mulhi(m.y, 1_545_072_827), 0));
    let product = add64(mul64(m.y, 3_098_164_009), low);
    real_exp2_wide(product, e + 1, negative)
}

/// 2^z.
#[inline]
#[must_use]
pub fn real_exp2(z: Real) -> Real {
    real_exp2_wide(uvec2(0, z.m), z.e - 32, z.negative)
}

/// e^z.
#[inline]
#[must_use]
pub fn real_exp(z: Real) -> Real {
    real_exp_wide(uvec2(0, z.m), z.e - 32, z.negative)
}

/// e^(-z^2/2): the square is not rounded.
#[inline]
#[must_use]
pub fn real_gaussian(z: Real) -> Real {
    real_exp_wide(mul64(z.m, z.m), 2 * z.e - 1, true)
}

/// 2^z - 1, to full relative precision.
#[inline]
#[must_use]
pub fn real_exp2m1(z: Real) -> Real {
    let one = Real {
        m: 0x8000_0000,
        e: -31,
        negative: false,
    };
    if z.m == 0 {
        return real_zero();
    }
    if z.e > -32 {
        return real_subtract(real_exp2(z), one);
    }
    let r = if z.e > -64 {
        z.m >> (-32 - z.e) as u32
    } else {
        0
    };
    let t = real_multiply(
        Real {
            m: z.m,
            e: z.e,
            negative: false,
        },
        Real {
            m: exp2_polynomial(r),
            e: -32,
            negative: false,
        },
    );
    if z.negative {
        // 2^-|z| - 1 = -t / (1 + t).
        return real_negate(real_divide(t, real_add(t, one)));
    }
    t
}

/// x^y for x > 0. 0^y and negative x count as the limit x = 2^-2^128; x^0 = 1.
#[inline]
#[must_use]
pub fn real_power(x: Real, y: Real) -> Real {
    real_exp2(real_multiply(y, real_log2(x)))
}

/// 1 - x^y, without loss where x^y is near 1; x as in [`real_power`].
#[inline]
#[must_use]
pub fn real_power_complement(x: Real, y: Real) -> Real {
    real_negate(real_exp2m1(real_multiply(y, real_log2(x))))
}

/// 2^x.
#[inline]
#[must_use]
pub fn exp2(x: f32) -> f32 {
    real_float(real_exp2(real(x)))
}

/// e^x.
#[inline]
#[must_use]
pub fn exp(x: f32) -> f32 {
    real_float(real_exp(real(x)))
}

/// x^y.
#[inline]
#[must_use]
pub fn power(x: f32, y: f32) -> f32 {
    real_float(real_power(real(x), real(y)))
}
