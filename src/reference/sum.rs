//! Exact sums of fixed-point terms and of their squares: no bit depends on the order.
//!
//! Source: Kulisch 2002, Advanced Arithmetic for the Digital Computer, ch. 4: a long
//! accumulator in place of rounding. Domain: terms of 64 bits and a sign, at most 2^62 of
//! them. Range: exact; a term made of a real is its nearest multiple of 2^-scale, halves
//! away from zero, at most 2^64 - 1 of them. Tier I.
//! Mirror: `shaders/corput/sum.glsl`.

use crate::reference::fixed::{addc, mul64, shl64};
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
