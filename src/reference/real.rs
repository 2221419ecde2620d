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

/// (negative ? -1 : 1) * m * 2^e with bit 31 of m set, or 0 for m = 0. A zero has no sign
/// and no exponent: one place sets them, since each branch costs compilers dear.
#[inline]
#[must_use]
pub fn real_or_zero(m: u32, e: i32, negative: bool) -> Real {
    let mut result = Real { m, e, negative };
    if m == 0 {
        result = real_zero();
    }
    result
}

/// x, exactly. Denormals count as 0; infinities and NaN as numbers of at least 2^128.
#[inline]
#[must_use]
pub fn real(x: f32) -> Real {
    let bits = x.to_bits();
    let exponent = (bits >> 23) & 255;
    let mut m = (bits << 8) | 0x8000_0000;
    if exponent == 0 {
        m = 0;
    }
    real_or_zero(m, exponent as i32 - 158, bits > 0x8000_0000)
}

/// m * 2^e, exactly, for any m.
#[inline]
#[must_use]
pub fn real_uint(m: u32, e: i32) -> Real {
    let shift = 31 - find_msb(m | 1);
    real_or_zero(m << shift, e - shift as i32, false)
}

/// v * 2^e, for v of 64 bits, cut to 32 significant bits.
#[inline]
#[must_use]
pub fn real_wide(v: UVec2, e: i32) -> Real {
    let whole = 0u32.wrapping_sub(u32::from(v.y == 0));
    let high = v.y | (v.x & whole);
    let low = v.x & !whole;
    let shift = 31 - find_msb(high | 1);
    real_or_zero(
        (high << shift) | ((low >> 1) >> (31 - shift)),
        e + 32 - shift as i32 - (whole & 32) as i32,
        false,
    )
}

/// (negative ? -1 : 1) * v.
#[inline]
#[must_use]
pub fn real_scaled(v: Scaled, negative: bool) -> Real {
    real_or_zero(v.m, v.e, negative)
}

/// -a.
#[inline]
#[must_use]
pub fn real_negate(a: Real) -> Real {
    real_or_zero(a.m, a.e, !a.negative)
}

/// a * 2^k.
#[inline]
#[must_use]
pub fn real_shift(a: Real, k: i32) -> Real {
    real_or_zero(a.m, a.e + k, a.negative)
}

/// Whether |a| < |b|.
#[inline]
#[must_use]
pub fn real_smaller(a: Real, b: Real) -> bool {
    // 0 below all others: its exponent is 0.
    let a_e = a.e - (i32::from(a.m == 0) << 30);
    let b_e = b.e - (i32::from(b.m == 0) << 30);
    (u32::from(a_e < b_e) | (u32::from(a_e == b_e) & u32::from(a.m < b.m))) != 0
}

/// Whether a < b.
#[inline]
#[must_use]
pub fn real_less(a: Real, b: Real) -> bool {
    let smaller = u32::from(real_smaller(a, b));
    // Of two negative numbers the larger magnitude is the lesser.
    let larger = u32::from(real_smaller(b, a));
    let a_sign = u32::from(a.negative);
    let b_sign = u32::from(b.negative);
    ((a_sign & ((b_sign ^ 1) | larger)) | (((a_sign | b_sign) ^ 1) & smaller)) != 0
}

/// The lesser of a and b.
#[inline]
#[must_use]
pub fn real_min(a: Real, b: Real) -> Real {
    let mut lesser = a;
    if real_less(b, a) {
        lesser = b;
    }
    lesser
}

/// The greater of a and b.
#[inline]
#[must_use]
pub fn real_max(a: Real, b: Real) -> Real {
    let mut greater = a;
    if real_less(a, b) {
        greater = b;
    }
    greater
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
    // 32 guard bits: where more than one bit cancels, none was shifted out.
    let shifted = shr64(uvec2(0, small.m), (large.e - small.e).clamp(0, 63) as u32);
    let differ = u32::from(large.negative) ^ u32::from(small.negative);
    let flip = 0u32.wrapping_sub(differ);
    let low = addc(shifted.x ^ flip, differ);
    let high = addc(large.m, (shifted.y ^ flip).wrapping_add(low.y));
    // The sum's carry; that of a difference says only that it is not negative.
    let carry = high.y & !flip;
    let sum = real_wide(
        uvec2(low.x, (high.x >> carry) | (carry << 31)),
        large.e - 32 + carry as i32,
    );
    real_or_zero(sum.m, sum.e, large.negative)
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
    let product = mul64(a.m, b.m);
    let shift = (product.y >> 31) ^ 1;
    real_or_zero(
        (product.y << shift) | ((product.x >> 31) & shift),
        a.e + b.e + 32 - shift as i32,
        a.negative != b.negative,
    )
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
    let x = real_reciprocal(b.m);
    // a.m / b.m in units of 2^-31, never too large; the residual gives 26 bits more.
    let q = mulhi(a.m, x);
    let r = sub64(shr64(uvec2(0, a.m), 1), mul64(q, b.m));
    let low = mulhi(shr64(r, 5).x, x);
    let quotient = add64(shl64(uvec2(q, 0), 26), uvec2(low, 0));
    let mut result = real_wide(quotient, a.e - b.e - 57);
    if b.m == 0 {
        result = Real {
            m: a.m.min(0x8000_0000),
            e: 97,
            negative: false,
        };
    }
    real_or_zero(result.m, result.e, a.negative != b.negative)
}

/// sqrt(a); 0 for a < 0.
#[inline]
#[must_use]
pub fn real_sqrt(a: Real) -> Real {
    // 1 in place of what has no root.
    let none = (u32::from(a.m == 0) | u32::from(a.negative)) != 0;
    let mut square = a;
    if none {
        square = Real {
            m: 0x8000_0000,
            e: -31,
            negative: false,
        };
    }
    let odd = square.e as u32 & 1;
    let half_m = square.m >> odd;
    let s = sqrt_floor(half_m);
    // The residual, and with it the next term of Taylor's series.
    let r = (half_m << 18)
        .wrapping_sub(s.wrapping_mul(s))
        .wrapping_add((square.m & odd) << 17);
    let mut m = (s << 7) + ((r << 6) / s).min(127);
    if none {
        m = 0;
    }
    real_or_zero(m, ((square.e + odd as i32) >> 1) - 16, false)
}

/// The nearest float, halves away from zero: at most the largest finite float in
/// magnitude, +0 below 2^-126.
#[inline]
#[must_use]
pub fn real_float(a: Real) -> f32 {
    let mut bits = pack_bits(Scaled {
        m: a.m,
        e: a.e.clamp(-157, 97),
    })
    .min(0x7f7f_ffff);
    if a.e < -157 {
        bits = 0;
    }
    let sign = u32::from(a.negative) & u32::from(bits != 0);
    f32::from_bits(bits | (sign << 31))
}

/// floor(a * 2^32), from 0 to 2^32 - 1.
#[inline]
#[must_use]
pub fn real_fraction(a: Real) -> u32 {
    let mut bits = a.m >> (-32 - a.e).clamp(0, 31) as u32;
    if a.e > -32 {
        bits = 0u32.wrapping_sub(u32::from(a.m != 0));
    }
    if (u32::from(a.negative) | u32::from(a.e < -63)) != 0 {
        bits = 0;
    }
    bits
}
