//! Real numbers with a significand of 32 bits, in integers: what float arithmetic would
//! give if every device agreed on it, and 8 bits more.
//!
//! Source: Knuth, TAOCP vol. 2, 4.2.1; Newton's iteration for the reciprocal, its last bits
//! by the exact residual. Domain: exponents within +-2^29. Range: each result is within
//! 2^-30 of itself of the exact one, also where a difference cancels; never an infinity or
//! NaN. Tier I.
//! Mirror: `shaders/corput/real.glsl`.

use crate::reference::bits::find_msb;
use crate::reference::elementary::sqrt_floor;
use crate::reference::fixed::{Scaled, add64, addc, mul64, mulhi, pack_bits, shl64, shr64, sub64};
use glam::{UVec2, uvec2};

/// (negative ? -1 : 1) * m * 2^e: bit 31 of m is set, or all of it is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Real {
    /// The significand.
    pub m: u32,
    /// The exponent; 0 for 0.
    pub e: i32,
    /// The sign; false for 0.
    pub negative: bool,
}

/// 0.
#[inline]
#[must_use]
pub fn real_zero() -> Real {
    Real {
        m: 0,
        e: 0,
        negative: false,
    }
}

/// x, exactly. Denormals count as 0; infinities and NaN as numbers of at least 2^128.
#[inline]
#[must_use]
pub fn real(x: f32) -> Real {
    let bits = x.to_bits();
    let exponent = (bits >> 23) & 255;
    if exponent == 0 {
        return real_zero();
    }
    Real {
        m: (bits << 8) | 0x8000_0000,
        e: exponent as i32 - 158,
        negative: bits > 0x8000_0000,
    }
}

/// m * 2^e, exactly, for any m.
#[inline]
#[must_use]
pub fn real_uint(m: u32, e: i32) -> Real {
    if m == 0 {
        return real_zero();
    }
    let shift = 31 - find_msb(m);
    Real {
        m: m << shift,
        e: e - shift as i32,
        negative: false,
    }
}

/// v * 2^e, for v of 64 bits, cut to 32 significant bits.
#[inline]
#[must_use]
pub fn real_wide(v: UVec2, e: i32) -> Real {
    if v.y == 0 {
        return real_uint(v.x, e);
    }
    let shift = 31 - find_msb(v.y);
    Real {
        m: shl64(v, shift).y,
        e: e + 32 - shift as i32,
        negative: false,
    }
}

/// (negative ? -1 : 1) * v.
#[inline]
#[must_use]
pub fn real_scaled(v: Scaled, negative: bool) -> Real {
    if v.m == 0 {
        return real_zero();
    }
    Real {
        m: v.m,
        e: v.e,
        negative,
    }
}

/// -a.
#[inline]
#[must_use]
pub fn real_negate(a: Real) -> Real {
    Real {
        m: a.m,
        e: a.e,
        negative: a.m != 0 && !a.negative,
    }
}

/// a * 2^k.
#[inline]
#[must_use]
pub fn real_shift(a: Real, k: i32) -> Real {
    Real {
        m: a.m,
        e: if a.m == 0 { 0 } else { a.e + k },
        negative: a.negative,
    }
}

/// Whether |a| < |b|.
#[inline]
#[must_use]
pub fn real_smaller(a: Real, b: Real) -> bool {
    if a.m == 0 || b.m == 0 {
        return b.m != 0;
    }
    a.e < b.e || (a.e == b.e && a.m < b.m)
}

/// Whether a < b.
#[inline]
#[must_use]
pub fn real_less(a: Real, b: Real) -> bool {
    if a.negative != b.negative {
        return a.negative;
    }
    // Of two negative numbers the larger magnitude is the lesser.
    if a.negative {
        return real_smaller(b, a);
    }
    real_smaller(a, b)
}

/// The lesser of a and b.
#[inline]
#[must_use]
pub fn real_min(a: Real, b: Real) -> Real {
    if real_less(b, a) {
        return b;
    }
    a
}

/// The greater of a and b.
#[inline]
#[must_use]
pub fn real_max(a: Real, b: Real) -> Real {
    if real_less(a, b) {
        return b;
    }
    a
}

/// a + b.
#[inline]
#[must_use]
pub fn real_add(a: Real, b: Real) -> Real {
    let mut large = a;
    let mut small = b;
    if real_smaller(a, b) {
        large = b;
        small = a;
    }
    if small.m == 0 {
        return large;
    }
    let shifted = shr64(uvec2(0, small.m), (large.e - small.e).min(63) as u32);
    if large.negative == small.negative {
        let sum = addc(large.m, shifted.y);
        if sum.y != 0 {
            return Real {
                m: (sum.x >> 1) | 0x8000_0000,
                e: large.e + 1,
                negative: large.negative,
            };
        }
        return Real {
            m: sum.x,
            e: large.e,
            negative: large.negative,
        };
    }
    // 32 guard bits: where more than one bit cancels, none was shifted out.
    let rest = real_wide(sub64(uvec2(0, large.m), shifted), large.e - 32);
    Real {
        m: rest.m,
        e: rest.e,
        negative: rest.m != 0 && large.negative,
    }
}

/// a - b.
#[inline]
#[must_use]
pub fn real_subtract(a: Real, b: Real) -> Real {
    real_add(a, real_negate(b))
}

/// a * b.
#[inline]
#[must_use]
pub fn real_multiply(a: Real, b: Real) -> Real {
    if a.m == 0 || b.m == 0 {
        return real_zero();
    }
    let product = mul64(a.m, b.m);
    let shift = (product.y >> 31) ^ 1;
    Real {
        m: shl64(product, shift).y,
        e: a.e + b.e + 32 - shift as i32,
        negative: a.negative != b.negative,
    }
}

/// a * a.
#[inline]
#[must_use]
pub fn real_square(a: Real) -> Real {
    real_multiply(a, a)
}

/// About 2^63 / m, and never more, for m >= 2^31.
#[inline]
#[must_use]
pub fn real_reciprocal(m: u32) -> u32 {
    // 1/d for d = m / 2^32, in units of 2^-30: wrong by 1/17, 2^-8, 2^-16 of itself.
    let mut x = 3_031_741_621 - mulhi(2_021_161_080, m);
    x = shr64(mul64(x, 0x8000_0000 - mulhi(m, x)), 30).x;
    x = shr64(mul64(x, 0x8000_0000 - mulhi(m, x)), 30).x << 1;
    // In units of 2^-31; ~v is 2 - d x or less, so that x never passes 1/d.
    shr64(mul64(x, !mulhi(m, x)), 31).x
}

/// a / b; 0 / b is 0, also for b = 0, and a / 0 is 2^128 with the sign of a.
#[inline]
#[must_use]
pub fn real_divide(a: Real, b: Real) -> Real {
    if a.m == 0 {
        return real_zero();
    }
    if b.m == 0 {
        return Real {
            m: 0x8000_0000,
            e: 97,
            negative: a.negative,
        };
    }
    let x = real_reciprocal(b.m);
    // a.m / b.m in units of 2^-31, never too large; the residual gives 26 bits more.
    let q = mulhi(a.m, x);
    let r = sub64(shr64(uvec2(0, a.m), 1), mul64(q, b.m));
    let low = mulhi(shr64(r, 5).x, x);
    let quotient = add64(shl64(uvec2(q, 0), 26), uvec2(low, 0));
    let result = real_wide(quotient, a.e - b.e - 57);
    Real {
        m: result.m,
        e: result.e,
        negative: a.negative != b.negative,
    }
}

/// sqrt(a); 0 for a < 0.
#[inline]
#[must_use]
pub fn real_sqrt(a: Real) -> Real {
    if a.m == 0 || a.negative {
        return real_zero();
    }
    let odd = a.e as u32 & 1;
    let half_m = a.m >> odd;
    let s = sqrt_floor(half_m);
    // The residual, and with it the next term of Taylor's series.
    let r = (half_m << 18)
        .wrapping_sub(s.wrapping_mul(s))
        .wrapping_add((a.m & odd) << 17);
    let low = ((r << 6) / s).min(127);
    Real {
        m: (s << 7) + low,
        e: ((a.e + odd as i32) >> 1) - 16,
        negative: false,
    }
}

/// The nearest float, halves away from zero: at most the largest finite float in
/// magnitude, +0 below 2^-126.
#[inline]
#[must_use]
pub fn real_float(a: Real) -> f32 {
    if a.m == 0 || a.e < -157 {
        return 0.0;
    }
    let mut bits = 0x7f7f_ffff;
    if a.e <= 96 {
        bits = pack_bits(Scaled { m: a.m, e: a.e }).min(bits);
    }
    f32::from_bits(if a.negative { bits | 0x8000_0000 } else { bits })
}

/// floor(a * 2^32), from 0 to 2^32 - 1.
#[inline]
#[must_use]
pub fn real_fraction(a: Real) -> u32 {
    if a.negative || a.e < -63 {
        return 0;
    }
    if a.e > -32 {
        return if a.m == 0 { 0 } else { 0xffff_ffff };
    }
    a.m >> (-32 - a.e) as u32
}
