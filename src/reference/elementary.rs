//! Elementary functions with one set of bits everywhere: square root, division,
//! product, quotients in fixed point, sincos(2 pi u), and atan2 in turns.
//!
//! Source: correction of an inexact seed by its exact integer residual; minimax
//! polynomials in fixed point, Horner's scheme. Tier I.
//! Mirror: `shaders/corput/elementary.glsl`.

use crate::reference::bits::find_msb;
use crate::reference::fixed::{Scaled, mul64, mulhi, pack, scaled, scaled_mul, shl64};
use glam::{UVec2, Vec2, vec2};

/// sin and cos of one angle: magnitudes and signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SinCos {
    /// |sin|.
    pub sine: Scaled,
    /// |cos|.
    pub cosine: Scaled,
    /// Whether sin < 0.
    pub sine_negative: bool,
    /// Whether cos < 0.
    pub cosine_negative: bool,
}

// Seeds become integers by their bits: `as` looks at each number alone, whether it is none, which
// keeps the compiler from making vectors of the loops of `bulk`.

/// About `sqrt(m) * 2^9`, for `m >= 2^30`. Vulkan allows this to be off by 20.
#[inline(always)]
#[must_use]
pub fn seed_sqrt(m: u32) -> u32 {
    // From 2^24 to 2^25, where floats are whole.
    let bits = ((m as f32).sqrt() * 512.0).to_bits();
    ((bits & 0x7f_ffff) | 0x80_0000) << ((bits >> 23) - 150)
}

/// About `a / b * 2^24`, for a, b in [2^23, 2^25). Vulkan allows this to be off by 6.
#[inline]
#[must_use]
pub fn seed_divide(a: u32, b: u32) -> u32 {
    (a as f32 / b as f32 * 16_777_216.0) as u32
}

/// `floor(b * 2^15 / a)` or one less, for `b < 2^32`, `1 <= a`, `b <= a`.
#[inline(always)]
#[must_use]
pub fn seed_quotient(b: u32, a: u32) -> u32 {
    // 32767.875 = 2^15 (1 - 2^-18): two conversions, a division and a product are
    // together off by less than 2^-20, so the result is never too large.
    whole(b as f32 / a as f32 * 32_767.875)
}

/// `floor(x)`, for x from 0 to 2^23.
#[inline(always)]
fn whole(x: f32) -> u32 {
    (x.floor() + 8_388_608.0).to_bits() - 0x4b00_0000
}

/// About `floor(r / d)`, for `|r / d| < 32`, `d >= 2^23`.
#[inline(always)]
#[must_use]
pub fn seed_step(r: i32, d: u32) -> i32 {
    // 1.5 * 2^23, at which negative numbers are whole as well.
    ((r as f32 / d as f32).floor() + 12_582_912.0).to_bits() as i32 - 0x4b40_0000
}

/// `floor(sqrt(m * 2^18))`, for `m >= 2^30`: 25 bits.
#[inline(always)]
#[must_use]
pub fn sqrt_floor(m: u32) -> u32 {
    let mut s = seed_sqrt(m);
    // The residual is exact modulo 2^32, since |r| < 2^31 for a seed within 31.
    let mut r = (m << 18).wrapping_sub(s.wrapping_mul(s)) as i32;
    let step = seed_step(r, 2 * s);
    s = s.wrapping_add(step as u32);
    r = (m << 18).wrapping_sub(s.wrapping_mul(s)) as i32;
    // One step leaves at most one unit, for 2 s step differs from r by step^2.
    s + u32::from(r > (2 * s) as i32) - u32::from(r < 0)
}

/// `sqrt(u * 2^-32)`, rounded down to 25 significant bits.
#[inline(always)]
#[must_use]
pub fn sqrt_fraction(u: u32) -> Scaled {
    if u == 0 {
        return Scaled { m: 0, e: 0 };
    }
    let shift = (31 - find_msb(u)) & !1;
    let s = sqrt_floor(u << shift);
    Scaled {
        m: s << 7,
        e: -32 - (shift >> 1) as i32,
    }
}

/// `sqrt(v * 2^-64)`, rounded down to 25 significant bits, of v cut to 32 bits.
#[inline(always)]
#[must_use]
pub fn sqrt_fraction64(v: UVec2) -> Scaled {
    if v.y == 0 {
        let low = sqrt_fraction(v.x);
        return Scaled {
            m: low.m,
            e: low.e - 16,
        };
    }
    let shift = (31 - find_msb(v.y)) & !1;
    let s = sqrt_floor(shl64(v, shift).y);
    Scaled {
        m: s << 7,
        e: -32 - (shift >> 1) as i32,
    }
}

/// `sqrt(x)`, correctly rounded to nearest even. Denormals count as zero;
/// sqrt(+-0) = +0, sqrt(+inf) = +inf, NaN (0x7fc00000) for x < 0 and NaN.
#[inline]
#[must_use]
pub fn sqrt(x: f32) -> f32 {
    let bits = x.to_bits();
    let magnitude = bits & 0x7fff_ffff;
    if magnitude < 0x0080_0000 {
        return 0.0;
    }
    if magnitude > 0x7f80_0000 || bits != magnitude {
        return f32::from_bits(0x7fc0_0000);
    }
    if magnitude == 0x7f80_0000 {
        return x;
    }
    // x = m 2^18 * 2^(even): the root's exponent is a whole number.
    let exponent = bits >> 23;
    let odd = exponent & 1;
    let m = ((bits & 0x7f_ffff) | 0x80_0000) << (8 - odd);
    let s = sqrt_floor(m);
    // s is odd only where the root is irrational: no ties.
    f32::from_bits((((exponent + odd) >> 1) << 23) + (62 << 23) + (s >> 1) + (s & 1))
}

/// `x / y`, correctly rounded to nearest even; IEEE 754 for zeros, infinities and NaN
/// (0x7fc00000). Denormals count as zero, and a result below 2^-126 is zero.
#[inline]
#[must_use]
pub fn divide(x: f32, y: f32) -> f32 {
    let x_bits = x.to_bits() & 0x7fff_ffff;
    let y_bits = y.to_bits() & 0x7fff_ffff;
    let sign = (x.to_bits() ^ y.to_bits()) & 0x8000_0000;
    let x_zero = x_bits < 0x0080_0000;
    let y_zero = y_bits < 0x0080_0000;
    let x_infinite = x_bits == 0x7f80_0000;
    let y_infinite = y_bits == 0x7f80_0000;
    if x_bits > 0x7f80_0000
        || y_bits > 0x7f80_0000
        || (x_zero && y_zero)
        || (x_infinite && y_infinite)
    {
        return f32::from_bits(0x7fc0_0000);
    }
    if x_zero || y_infinite {
        return f32::from_bits(sign);
    }
    if y_zero || x_infinite {
        return f32::from_bits(sign | 0x7f80_0000);
    }
    let mut a = (x_bits & 0x7f_ffff) | 0x80_0000;
    let b = (y_bits & 0x7f_ffff) | 0x80_0000;
    let less = u32::from(a < b);
    a <<= less;
    // q = floor(a * 2^24 / b), 25 bits; its residual is exact modulo 2^32.
    let mut q = seed_divide(a, b);
    let mut r = (a << 24).wrapping_sub(q.wrapping_mul(b)) as i32;
    q = q.wrapping_add(seed_step(r, b) as u32);
    r = (a << 24).wrapping_sub(q.wrapping_mul(b)) as i32;
    if r < 0 {
        q -= 1;
        r += b as i32;
    } else if r >= b as i32 {
        q += 1;
        r -= b as i32;
    }
    let rounded = (q >> 1) + (q & (q >> 1 | u32::from(r != 0)) & 1);
    let exponent = (x_bits >> 23) as i32 - (y_bits >> 23) as i32 + 126 - less as i32;
    // The implicit bit of `rounded` adds one to the exponent field.
    if exponent < 0 {
        // A result that rounds up to 2^-126 is still a normal number.
        let least = exponent == -1 && rounded == 0x100_0000;
        return f32::from_bits(sign | if least { 0x0080_0000 } else { 0 });
    }
    let bits = ((exponent as u32) << 23) + rounded;
    f32::from_bits(sign | bits.min(0x7f80_0000))
}

/// `x * y`, correctly rounded to nearest even; IEEE 754 for zeros, infinities and NaN
/// (0x7fc00000). Denormals count as zero, and a result below 2^-126 is zero.
#[inline]
#[must_use]
pub fn multiply(x: f32, y: f32) -> f32 {
    let x_bits = x.to_bits() & 0x7fff_ffff;
    let y_bits = y.to_bits() & 0x7fff_ffff;
    let sign = (x.to_bits() ^ y.to_bits()) & 0x8000_0000;
    let x_zero = x_bits < 0x0080_0000;
    let y_zero = y_bits < 0x0080_0000;
    let x_infinite = x_bits == 0x7f80_0000;
    let y_infinite = y_bits == 0x7f80_0000;
    if x_bits > 0x7f80_0000
        || y_bits > 0x7f80_0000
        || (x_zero && y_infinite)
        || (x_infinite && y_zero)
    {
        return f32::from_bits(0x7fc0_0000);
    }
    if x_zero || y_zero {
        return f32::from_bits(sign);
    }
    if x_infinite || y_infinite {
        return f32::from_bits(sign | 0x7f80_0000);
    }
    let a = (x_bits & 0x7f_ffff) | 0x80_0000;
    let b = (y_bits & 0x7f_ffff) | 0x80_0000;
    // (a << 8)(b << 8) has bit 63 or bit 62 set.
    let mut product = mul64(a << 8, b << 8);
    let small = (product.y >> 31) ^ 1;
    product = shl64(product, small);
    let half_up = (product.y >> 7) & 1;
    let sticky = (product.y & 0x7f) | product.x;
    let kept = product.y >> 8;
    let rounded = kept + (half_up & (kept | u32::from(sticky != 0)));
    let exponent = (x_bits >> 23) as i32 + (y_bits >> 23) as i32 - 127 - small as i32;
    if exponent < 0 {
        let least = exponent == -1 && rounded == 0x100_0000;
        return f32::from_bits(sign | if least { 0x0080_0000 } else { 0 });
    }
    let bits = ((exponent as u32) << 23) + rounded;
    f32::from_bits(sign | bits.min(0x7f80_0000))
}

/// `floor(b * 2^30 / a)`, for `0 <= b <= a <= 2^31`, `a > 0`.
#[inline(always)]
#[must_use]
pub fn ratio(b: u32, a: u32) -> u32 {
    let mut high = seed_quotient(b, a);
    // Both residuals lie in [0, 2 a), hence fit in 32 bits.
    let mut r = (b << 15).wrapping_sub(high.wrapping_mul(a));
    if r >= a {
        r -= a;
        high += 1;
    }
    let mut low = seed_quotient(r, a);
    r = (r << 15).wrapping_sub(low.wrapping_mul(a));
    if r >= a {
        low += 1;
    }
    (high << 15) + low
}

/// rho^2 as a fraction of 2^32 (1 becomes 1 - 2^-32), for rho as a fraction of 2^31.
#[inline(always)]
#[must_use]
pub fn square31(rho: u32) -> u32 {
    let z = mulhi(rho, rho);
    (z << 2).wrapping_sub(z >> 30)
}

/// `sin(pi/4 rho) / rho * 2^32`, for w = rho^2 as a fraction of 2^32: at least 2^31.
#[inline(always)]
#[must_use]
pub fn sin_polynomial(w: u32) -> u32 {
    let mut p = 1346 - mulhi(w, 7);
    p = 157_094 - mulhi(w, p);
    p = 10_696_163 - mulhi(w, p);
    p = 346_799_334 - mulhi(w, p);
    3_373_259_426 - mulhi(w, p)
}

/// `cos(pi/4 rho) * 2^32`, for w = rho^2 as a fraction of 2^32: at least 2^31, and
/// 2^32 - 1 in place of 2^32.
#[inline(always)]
#[must_use]
pub fn cos_polynomial(w: u32) -> u32 {
    let mut p = 15_422 - mulhi(w, 104);
    p = 1_400_124 - mulhi(w, p);
    p = 68_093_890 - mulhi(w, p);
    p = 1_324_675_879 - mulhi(w, p);
    let versine = mulhi(w, p);
    !versine + u32::from(versine != 0)
}

/// sin and cos of 2 pi u, u a fraction of 2^32.
#[inline(always)]
#[must_use]
pub fn sincos_scaled(u: u32) -> SinCos {
    // Nearest quarter turn, and the signed rest, in integers: no reduction error.
    let quarter = u.wrapping_add(0x2000_0000) >> 30;
    let rest = u.wrapping_sub(quarter << 30) as i32;
    let t = rest.unsigned_abs();
    let w = square31(t << 2);
    let s = scaled_mul(
        scaled(t, -29),
        Scaled {
            m: sin_polynomial(w),
            e: -32,
        },
    );
    let c = Scaled {
        m: cos_polynomial(w),
        e: -32,
    };
    let swapped = quarter & 1 != 0;
    let sine_negative = if swapped {
        quarter == 3
    } else {
        (quarter == 2) != (rest < 0)
    };
    let cosine_negative = if swapped {
        (quarter == 1) == (rest > 0)
    } else {
        quarter == 2
    };
    if swapped {
        return SinCos {
            sine: c,
            cosine: s,
            sine_negative,
            cosine_negative,
        };
    }
    SinCos {
        sine: s,
        cosine: c,
        sine_negative,
        cosine_negative,
    }
}

/// `(cos 2 pi u, sin 2 pi u)`, u a fraction of 2^32.
#[inline]
#[must_use]
pub fn cos_sin(u: u32) -> Vec2 {
    let a = sincos_scaled(u);
    vec2(
        pack(a.cosine, a.cosine_negative),
        pack(a.sine, a.sine_negative),
    )
}

/// `atan(rho) / rho` in turns * 2^34, for w = rho^2 as a fraction of 2^32.
#[inline]
#[must_use]
pub fn atan_polynomial(w: u32) -> u32 {
    let mut p = 12_939_847 - mulhi(w, 1_813_896);
    p = 43_278_767 - mulhi(w, p);
    p = 92_489_715 - mulhi(w, p);
    p = 147_531_653 - mulhi(w, p);
    p = 197_640_003 - mulhi(w, p);
    p = 245_377_293 - mulhi(w, p);
    p = 303_282_135 - mulhi(w, p);
    p = 390_556_750 - mulhi(w, p);
    p = 546_849_516 - mulhi(w, p);
    p = 911_420_312 - mulhi(w, p);
    2_734_261_102 - mulhi(w, p)
}

/// `atan(b / a)` in turns, as a fraction of 2^32: 0 to 2^29; 0 for a = b = 0.
/// For `0 <= b <= a <= 2^31`. Within 1.2 * 2^-32 of a turn.
#[inline]
#[must_use]
pub fn atan_ratio(b: u32, a: u32) -> u32 {
    let rho = ratio(b, a.max(1)) << 1;
    let w = square31(rho);
    let p = atan_polynomial(w);
    // rho is at most 2^31, and p a fraction of 2^34.
    (mulhi(rho, p) + 1) >> 1
}

/// Angle of `(x, y)` in turns, counter-clockwise from +x, as a fraction of 2^32.
/// (0, 0) gives 0; signs of zeros do not matter; denormals count as zero;
/// finite arguments only. Within 2 * 2^-32 of a turn.
#[inline]
#[must_use]
pub fn atan2(y: f32, x: f32) -> u32 {
    let x_bits = x.to_bits() & 0x7fff_ffff;
    let y_bits = y.to_bits() & 0x7fff_ffff;
    let large = x_bits.max(y_bits);
    let small = x_bits.min(y_bits);
    if large < 0x0080_0000 {
        return 0;
    }
    // Both on the scale of the larger: what is shifted out is below 2^-30 of it.
    let a = ((large & 0x7f_ffff) | 0x80_0000) << 7;
    let mut b = ((small & 0x7f_ffff) | 0x80_0000) << 7;
    let shift = (large >> 23) - (small >> 23);
    b = if shift > 30 || small < 0x0080_0000 {
        0
    } else {
        b >> shift
    };
    let mut angle = atan_ratio(b, a);
    if y_bits > x_bits {
        angle = 0x4000_0000 - angle;
    }
    if x.to_bits() > 0x8000_0000 && x_bits >= 0x0080_0000 {
        angle = 0x8000_0000 - angle;
    }
    if y.to_bits() > 0x8000_0000 && y_bits >= 0x0080_0000 {
        angle = 0u32.wrapping_sub(angle);
    }
    angle
}
