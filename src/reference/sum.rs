//! Exact sums of fixed-point terms and of their squares: no bit depends on the order.
//!
//! Source: Kulisch 2002, Advanced Arithmetic for the Digital Computer, ch. 4: a long
//! accumulator in place of rounding, and carries that wait in a redundant one. Domain: terms
//! of 64 bits and a sign, at most 2^62 of them; in a tally at most 2^16. Range: exact; a term
//! made of a real is its nearest multiple of 2^-scale, halves away from zero, at most
//! 2^64 - 1 of them. Tier I.
//! Mirror: `shaders/corput/sum.glsl`.

use crate::reference::fixed::{addc, mul64, shl64, sub64};
use crate::reference::real::Real;
use glam::{UVec2, UVec4, uvec2, uvec4};

/// (negative ? -1 : 1) * m, in units of 2^-scale that all terms of a sum share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Term {
    /// The magnitude.
    pub m: UVec2,
    /// The sign; a zero may have either.
    pub negative: bool,
}

/// Sum of terms, 128 bits in two's complement, and of their squares, 192 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sum {
    /// The sum of the terms, lowest word first.
    pub total: UVec4,
    /// The lower words of the sum of their squares.
    pub squares: UVec4,
    /// And the upper.
    pub squares_high: UVec2,
}

/// The sum of nothing.
#[inline]
#[must_use]
pub fn sum_zero() -> Sum {
    Sum {
        total: UVec4::ZERO,
        squares: UVec4::ZERO,
        squares_high: UVec2::ZERO,
    }
}

/// a in units of 2^-scale, for scales within +-2^29.
#[inline]
#[must_use]
pub fn term(a: Real, scale: i32) -> Term {
    // a.m, from 2^31 on, times 2^place.
    let place = a.e + scale;
    let left = shl64(uvec2(a.m, 0), place.clamp(0, 32) as u32);
    // One bit more than is kept, to round by.
    let right = a.m >> (-1 - place).clamp(0, 31) as u32;
    let mut m = left;
    if place < 0 {
        m = uvec2((right >> 1) + (right & 1), 0);
    }
    if place < -32 {
        m = UVec2::ZERO;
    }
    if place > 32 {
        m = UVec2::splat(0u32.wrapping_sub(u32::from(a.m != 0)));
    }
    Term {
        m,
        negative: a.negative,
    }
}

/// The float of these bits where its exponent is one of the 32 of a window of 8, in units of
/// 2^(32 window - 150) and exact, denormals too; else 0, as infinities and NaN are.
#[inline]
#[must_use]
pub fn term_window(bits: u32, window: u32) -> Term {
    let exponent = (bits >> 23) & 0xff;
    let mut m = bits & 0x7f_ffff;
    if exponent != 0 {
        m |= 0x80_0000;
    }
    let place = exponent.max(1);
    if (u32::from((place >> 5) != window) | u32::from(exponent == 255)) != 0 {
        m = 0;
    }
    Term {
        m: shl64(uvec2(m, 0), place & 31),
        negative: (bits >> 31) != 0,
    }
}

/// The sum with one term more.
#[inline]
#[must_use]
pub fn sum_add(sum: Sum, term: Term) -> Sum {
    let flip = 0u32.wrapping_sub(u32::from(term.negative));
    // Of -m the complement, and one more.
    let low = addc(term.m.x ^ flip, flip & 1);
    let w0 = addc(sum.total.x, low.x);
    let high = addc(term.m.y ^ flip, low.y + w0.y);
    let w1 = addc(sum.total.y, high.x);
    let sign = addc(flip, high.y + w1.y);
    let w2 = addc(sum.total.z, sign.x);
    let w3 = sum.total.w.wrapping_add(flip).wrapping_add(sign.y + w2.y);

    let outer = mul64(term.m.x, term.m.x);
    let cross = mul64(term.m.x, term.m.y);
    let inner = mul64(term.m.y, term.m.y);
    // Words of the square; the cross product counts twice.
    let s1 = addc(outer.y, cross.x << 1);
    let s2 = addc(inner.x, (cross.y << 1) | (cross.x >> 31));
    let t2 = addc(s2.x, s1.y);
    let s3 = inner.y + (cross.y >> 31) + s2.y + t2.y;
    let q0 = addc(sum.squares.x, outer.x);
    let c1 = addc(sum.squares.y, q0.y);
    let q1 = addc(c1.x, s1.x);
    let c2 = addc(sum.squares.z, c1.y + q1.y);
    let q2 = addc(c2.x, t2.x);
    let c3 = addc(sum.squares.w, c2.y + q2.y);
    let q3 = addc(c3.x, s3);
    let q4 = addc(sum.squares_high.x, c3.y + q3.y);
    Sum {
        total: uvec4(w0.x, w1.x, w2.x, w3),
        squares: uvec4(q0.x, q1.x, q2.x, q3.x),
        squares_high: uvec2(q4.x, sum.squares_high.y.wrapping_add(q4.y)),
    }
}

/// Sums of up to 2^16 terms before any carry: place k of four has units of 2^(16 k).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tally {
    /// Of the lower 64 bits of each term in two's complement.
    pub total: UVec4,
    /// Of the squares: those of the lower words,
    pub outer: UVec4,
    /// the products of both,
    pub cross: UVec4,
    /// those of the upper.
    pub inner: UVec4,
    /// Terms below zero.
    pub negatives: u32,
}

/// The tally of nothing.
#[inline]
#[must_use]
pub fn tally_zero() -> Tally {
    Tally {
        total: UVec4::ZERO,
        outer: UVec4::ZERO,
        cross: UVec4::ZERO,
        inner: UVec4::ZERO,
        negatives: 0,
    }
}

/// 64 bits in four places.
#[inline]
#[must_use]
pub fn tally_places(v: UVec2) -> UVec4 {
    uvec4(v.x & 0xffff, v.x >> 16, v.y & 0xffff, v.y >> 16)
}

/// The tally with one term more.
#[inline]
#[must_use]
pub fn tally_add(tally: Tally, term: Term) -> Tally {
    let negative = u32::from(term.negative);
    let flip = 0u32.wrapping_sub(negative);
    // Of -m the complement; the one more is that of `negatives`.
    Tally {
        total: tally.total + tally_places(uvec2(term.m.x ^ flip, term.m.y ^ flip)),
        outer: tally.outer + tally_places(mul64(term.m.x, term.m.x)),
        cross: tally.cross + tally_places(mul64(term.m.x, term.m.y)),
        inner: tally.inner + tally_places(mul64(term.m.y, term.m.y)),
        negatives: tally.negatives + negative,
    }
}

/// Four places carried: the lower three of four words.
#[inline]
#[must_use]
pub fn tally_carried(places: UVec4) -> UVec4 {
    let w0 = addc(places.x, places.y << 16);
    let middle = addc(places.z, (places.y >> 16) + w0.y);
    let w1 = addc(middle.x, places.w << 16);
    uvec4(w0.x, w1.x, (places.w >> 16) + middle.y + w1.y, 0)
}

/// What the terms of a tally come to.
#[inline]
#[must_use]
pub fn tally_sum(tally: Tally) -> Sum {
    let t = tally_carried(tally.total);
    let t0 = addc(t.x, tally.negatives);
    let t1 = addc(t.y, t0.y);
    // Each complement of 64 bits is 2^64 too much.
    let high = sub64(uvec2(t.z + t1.y, 0), uvec2(tally.negatives, 0));
    let o = tally_carried(tally.outer);
    let c = tally_carried(tally.cross);
    let i = tally_carried(tally.inner);
    // The cross products count twice, one word up.
    let s1 = addc(o.y, c.x << 1);
    let a2 = addc(o.z, i.x);
    let b2 = addc((c.y << 1) | (c.x >> 31), s1.y);
    let s2 = addc(a2.x, b2.x);
    let a3 = addc((c.z << 1) | (c.y >> 31), i.y);
    let s3 = addc(a3.x, a2.y + b2.y + s2.y);
    Sum {
        total: uvec4(t0.x, t1.x, high.x, high.y),
        squares: uvec4(o.x, s1.x, s2.x, s3.x),
        squares_high: uvec2(i.z + a3.y + s3.y, 0),
    }
}
