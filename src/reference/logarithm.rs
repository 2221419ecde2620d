//! Logarithms with one set of bits everywhere, to full relative precision also next to 1:
//! -ln(1 - u) of a fraction, ln and log2 of floats and reals.
//!
//! Source: x = 2^n (1 + f), f from sqrt(1/2) - 1 to sqrt(2) - 1; f P(f), P by interpolation
//! in Chebyshev nodes (`scripts/elementary_polynomials.py`), in fixed point. Domain: all
//! fractions u of 2^32, 0 among them, for 1 - u is never 0; reals above 0 with exponents
//! within +-65535. 0 and negative numbers give -2^128, as a float the lowest finite one;
//! infinities and NaN count as numbers of at least 2^128. Range: reals within 2^-29.5 of
//! themselves; floats 0.52 ULP. Tier I.
//! Mirror: `shaders/corput/logarithm.glsl`.

use crate::reference::fixed::{add64, mul64, mulhi, shr64, sub64};
use crate::reference::real::{
    Real, real, real_add, real_float, real_multiply, real_negate, real_uint, real_wide,
};
use crate::reference::real_angle::real_complement;
use glam::UVec2;

/// ln x = n ln 2 + (negative ? -1 : 1) * rest * 2^-63.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Logarithm {
    /// The power of two.
    pub n: i32,
    /// |ln(1 + f)|.
    pub rest: UVec2,
    /// Whether f < 0.
    pub negative: bool,
}

/// c - f p, for f = (negative ? -1 : 1) * a * 2^-32.
#[inline]
#[must_use]
pub fn log_step(c: u32, a: u32, negative: bool, p: u32) -> u32 {
    let product = mulhi(a, p);
    if negative { c + product } else { c - product }
}

/// ln(1 + f) / f as a fraction of 2^31, for f = (negative ? -1 : 1) * a * 2^-32 from
/// sqrt(1/2) - 1 to sqrt(2) - 1.
#[inline]
#[must_use]
pub fn log_polynomial(a: u32, negative: bool) -> u32 {
    let mut p = log_step(421_096_635, a, negative, 224_879_699);
    p = log_step(431_524_174, a, negative, p);
    p = log_step(427_177_283, a, negative, p);
    p = log_step(472_705_744, a, negative, p);
    p = log_step(536_674_861, a, negative, p);
    p = log_step(613_785_691, a, negative, p);
    p = log_step(715_843_255, a, negative, p);
    p = log_step(858_988_655, a, negative, p);
    p = log_step(1_073_741_512, a, negative, p);
    p = log_step(1_431_655_805, a, negative, p);
    p = log_step(2_147_483_650, a, negative, p);
    // The last product with one bit less, and rounded.
    let product = (mulhi(a, p) + 1) >> 1;
    if negative {
        0x8000_0000 + product
    } else {
        0x8000_0000 - product
    }
}

/// The parts of ln(m * 2^e), for m >= 2^31.
#[inline]
#[must_use]
pub fn log_split(m: u32, e: i32) -> Logarithm {
    // 0xb504f333 = floor(sqrt(2) * 2^31). f is exact on either side.
    let negative = m > 0xb504_f333;
    let a = if negative {
        0u32.wrapping_sub(m)
    } else {
        m << 1
    };
    let n = if negative { e + 32 } else { e + 31 };
    Logarithm {
        n,
        rest: mul64(a, log_polynomial(a, negative)),
        negative,
    }
}

/// ln x.
#[inline]
#[must_use]
pub fn real_log(x: Real) -> Real {
    if x.m == 0 || x.negative {
        return Real {
            m: 0x8000_0000,
            e: 97,
            negative: true,
        };
    }
    let part = log_split(x.m, x.e);
    if part.n == 0 {
        let rest = real_wide(part.rest, -63);
        return Real {
            m: rest.m,
            e: rest.e,
            negative: rest.m != 0 && part.negative,
        };
    }
    // In units of 2^-48; 2977044472 = ln 2 * 2^32. The rest is at most half of n ln 2.
    let whole = mul64((part.n.abs().min(65535) as u32) << 16, 2_977_044_472);
    let mut rest = shr64(part.rest, 15);
    let negative = part.n < 0;
    if negative != part.negative {
        rest = sub64(UVec2::ZERO, rest);
    }
    let sum = real_wide(add64(whole, rest), -48);
    Real {
        m: sum.m,
        e: sum.e,
        negative,
    }
}

/// log2 x.
#[inline]
#[must_use]
pub fn real_log2(x: Real) -> Real {
    if x.m == 0 || x.negative {
        return Real {
            m: 0x8000_0000,
            e: 97,
            negative: true,
        };
    }
    let part = log_split(x.m, x.e);
    // 3098164009 = 2^31 / ln 2.
    let rest = real_multiply(
        real_wide(part.rest, -63),
        Real {
            m: 3_098_164_009,
            e: -31,
            negative: false,
        },
    );
    let whole = real_uint(part.n.unsigned_abs(), 0);
    real_add(
        Real {
            m: whole.m,
            e: whole.e,
            negative: part.n < 0,
        },
        Real {
            m: rest.m,
            e: rest.e,
            negative: rest.m != 0 && part.negative,
        },
    )
}

/// -ln(1 - u), u a fraction of 2^32: 0 to 32 ln 2, never infinite.
#[inline]
#[must_use]
pub fn real_negative_log(u: u32) -> Real {
    real_negate(real_log(real_complement(u)))
}

/// -ln(1 - u), u a fraction of 2^32: +0 to 22.18071.
#[inline]
#[must_use]
pub fn negative_log(u: u32) -> f32 {
    real_float(real_negative_log(u))
}

/// ln x.
#[inline]
#[must_use]
pub fn log(x: f32) -> f32 {
    real_float(real_log(real(x)))
}

/// log2 x; exact for powers of two.
#[inline]
#[must_use]
pub fn log2(x: f32) -> f32 {
    real_float(real_log2(real(x)))
}
