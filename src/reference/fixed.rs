//! Wide products, carries, 64-bit integers as `UVec2` (x low, y high), and numbers
//! m * 2^e packed to float.
//!
//! Source: schoolbook arithmetic; Knuth, TAOCP vol. 2, 4.3.1.
//! Domain: any `u32` unless a function says otherwise.
//! Mirror: `shaders/corput/fixed.glsl`.

use crate::reference::bits::find_msb;
use glam::{UVec2, uvec2};

/// A non-negative number m * 2^e, with bit 31 of m set, or m = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scaled {
    /// Mantissa, 32 bits.
    pub m: u32,
    /// Exponent of two.
    pub e: i32,
}

/// `floor(a * b / 2^32)`.
#[inline(always)]
#[must_use]
pub fn mulhi(a: u32, b: u32) -> u32 {
    ((u64::from(a) * u64::from(b)) >> 32) as u32
}

/// `a * b`, all 64 bits.
#[inline(always)]
#[must_use]
pub fn mul64(a: u32, b: u32) -> UVec2 {
    uvec2(a.wrapping_mul(b), mulhi(a, b))
}

/// x: `a + b` modulo 2^32; y: the carry, 0 or 1.
#[inline(always)]
#[must_use]
pub fn addc(a: u32, b: u32) -> UVec2 {
    let (sum, carry) = a.overflowing_add(b);
    uvec2(sum, u32::from(carry))
}

/// x: `a - b` modulo 2^32; y: the borrow, 0 or 1.
#[inline(always)]
#[must_use]
pub fn subb(a: u32, b: u32) -> UVec2 {
    let (difference, borrow) = a.overflowing_sub(b);
    uvec2(difference, u32::from(borrow))
}

/// `a + b` modulo 2^64.
#[inline(always)]
#[must_use]
pub fn add64(a: UVec2, b: UVec2) -> UVec2 {
    let low = addc(a.x, b.x);
    uvec2(low.x, a.y.wrapping_add(b.y).wrapping_add(low.y))
}

/// `a - b` modulo 2^64.
#[inline(always)]
#[must_use]
pub fn sub64(a: UVec2, b: UVec2) -> UVec2 {
    let low = subb(a.x, b.x);
    uvec2(low.x, a.y.wrapping_sub(b.y).wrapping_sub(low.y))
}

/// `v * 2^s` modulo 2^64, for s from 0 to 63.
#[inline(always)]
#[must_use]
pub fn shl64(v: UVec2, s: u32) -> UVec2 {
    let whole = 0u32.wrapping_sub(s >> 5);
    let part = s & 31;
    let low = v.x & !whole;
    let high = (v.y & !whole) | (v.x & whole);
    uvec2(low << part, (high << part) | ((low >> 1) >> (31 - part)))
}

/// `floor(v / 2^s)`, for s from 0 to 63.
#[inline(always)]
#[must_use]
pub fn shr64(v: UVec2, s: u32) -> UVec2 {
    let whole = 0u32.wrapping_sub(s >> 5);
    let part = s & 31;
    let low = (v.x & !whole) | (v.y & whole);
    let high = v.y & !whole;
    uvec2((low >> part) | ((high << 1) << (31 - part)), high >> part)
}

/// The bits of the float nearest to `v.m * 2^v.e`, halves away from zero.
/// The result must be 0 or a normal float: `v.e` from -157 to 96.
#[inline(always)]
#[must_use]
pub fn pack_bits(v: Scaled) -> u32 {
    // m >> 8 carries the implicit bit, which raises the exponent field by one; so
    // does a rounding carry out of the mantissa, as it should.
    let bits = (((v.e + 157) as u32) << 23)
        .wrapping_add(v.m >> 8)
        .wrapping_add((v.m >> 7) & 1);
    if v.m == 0 { 0 } else { bits }
}

/// m * 2^e in [`Scaled`] form, for any m.
#[inline(always)]
#[must_use]
pub fn scaled(m: u32, e: i32) -> Scaled {
    let shift = if m == 0 { 0 } else { 31 - find_msb(m) };
    Scaled {
        m: m << shift,
        e: e - shift as i32,
    }
}

/// `a * b`, truncated to at least 31 significant bits.
#[inline(always)]
#[must_use]
pub fn scaled_mul(a: Scaled, b: Scaled) -> Scaled {
    let high = mulhi(a.m, b.m);
    let shift = (high >> 31) ^ 1;
    Scaled {
        m: high << shift,
        e: a.e + b.e + 32 - shift as i32,
    }
}

/// The float nearest to `(if negative { -1 } else { 1 }) * v`; never -0.
#[inline(always)]
#[must_use]
pub fn pack(v: Scaled, negative: bool) -> f32 {
    let bits = pack_bits(v);
    f32::from_bits(if negative && bits != 0 {
        bits | 0x8000_0000
    } else {
        bits
    })
}

/// `floor(|x| * 2^31)`, saturated to 2^31; 0 for NaN.
#[inline]
#[must_use]
pub fn fixed31(x: f32) -> u32 {
    let bits = x.to_bits() & 0x7fff_ffff;
    let exponent = bits >> 23;
    let mantissa = (bits & 0x7f_ffff) | 0x80_0000;
    if bits > 0x7f80_0000 {
        return 0;
    }
    if exponent >= 127 {
        return 0x8000_0000;
    }
    if exponent >= 119 {
        return mantissa << (exponent - 119);
    }
    let shift = 119 - exponent;
    if shift > 23 { 0 } else { mantissa >> shift }
}

/// `floor(x * 2^scale)` modulo 2^64, for finite `x >= 0`; `scale` from -64 to 64.
#[inline]
#[must_use]
pub fn fixed64(x: f32, scale: i32) -> UVec2 {
    let bits = x.to_bits();
    let exponent = bits >> 23;
    let mantissa = uvec2((bits & 0x7f_ffff) | 0x80_0000, 0);
    let shift = exponent as i32 - 150 + scale;
    if exponent == 0 || !(-23..=63).contains(&shift) {
        return uvec2(0, 0);
    }
    if shift < 0 {
        shr64(mantissa, (-shift) as u32)
    } else {
        shl64(mantissa, shift as u32)
    }
}
