//! The factor of one coordinate in the product over two points that the closed forms of
//! the mean-square discrepancies sum: p K(x, y), for p a fixed-point number of 64 bits.
//!
//! Source: the kernels K of Warnock 1972 (star), Hickernell 1998 (centred, wrap-around,
//! modified) and Zhou, Fang and Ning 2013 (mixture). Domain: x and y fractions of 2^32;
//! p and p K(x, y) below 2^63. Range: at most 1 unit of p off for star, centred and
//! modified, 3 for wrap-around, 7 for mixture.
//! Mirror: `shaders/corput/discrepancy.glsl`.

use crate::reference::distance::apart;
use crate::reference::fixed::{add64, mul64, mulhi, shl64, shr64, sub64};
use glam::{UVec2, uvec2};

/// `floor(p f / 2^32)`.
#[inline]
#[must_use]
pub fn scale64(p: UVec2, f: u32) -> UVec2 {
    add64(mul64(p.y, f), uvec2(mulhi(p.x, f), 0))
}

/// |x - 1/2|.
#[inline]
#[must_use]
pub fn off_centre(x: u32) -> u32 {
    apart(x, 0x8000_0000)
}

/// p (1 - max(x, y)).
#[inline]
#[must_use]
pub fn star_factor(p: UVec2, x: u32, y: u32) -> UVec2 {
    sub64(p, scale64(p, x.max(y)))
}

/// p (1 + (|x - 1/2| + |y - 1/2| - |x - y|) / 2).
#[inline]
#[must_use]
pub fn centred_factor(p: UVec2, x: u32, y: u32) -> UVec2 {
    // On one side of the middle the sum is twice the lesser distance, else 0.
    let nearer = off_centre(x).min(off_centre(y));
    let both = if (x ^ y) >> 31 == 0 { nearer } else { 0 };
    add64(p, scale64(p, both))
}

/// p (3/2 - |x - y| (1 - |x - y|)).
#[inline]
#[must_use]
pub fn wrap_around_factor(p: UVec2, x: u32, y: u32) -> UVec2 {
    // That is 5/4 + (1/2 - |x - y|)^2.
    let h = off_centre(apart(x, y));
    let square = scale64(scale64(p, h), h);
    add64(add64(p, shr64(p, 2)), square)
}

/// p (15/8 - |x - 1/2| / 4 - |y - 1/2| / 4 - 3 |x - y| / 4 + |x - y|^2 / 2).
#[inline]
#[must_use]
pub fn mixture_factor(p: UVec2, x: u32, y: u32) -> UVec2 {
    let z = apart(x, y);
    let once = scale64(p, z);
    let twice = scale64(once, z);
    let centres = add64(scale64(p, off_centre(x)), scale64(p, off_centre(y)));
    let more = sub64(shl64(p, 1), shr64(p, 3));
    let less = add64(shr64(centres, 2), sub64(once, shr64(once, 2)));
    add64(sub64(more, less), shr64(twice, 1))
}

/// p (2 - max(x, y)).
#[inline]
#[must_use]
pub fn modified_factor(p: UVec2, x: u32, y: u32) -> UVec2 {
    add64(p, star_factor(p, x, y))
}
