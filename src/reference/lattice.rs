//! Rank-1 lattices: an embedded sequence in base 2, Korobov sets, and additive recurrences; a
//! rotation randomises any of them.
//!
//! Source: Hickernell, Hong, L'Ecuyer and Lemieux 2000, SIAM J. Sci. Comput. 22; Korobov
//! 1960; Roberts 2018 (R2); Cranley and Patterson 1976. Domain: every n unless a function
//! says otherwise. Range: fractions of 2^32.
//! Mirror: `shaders/corput/lattice.glsl`.

use crate::reference::bits::reverse_bits;
use crate::reference::fixed::{mul64, mulhi};
use crate::reference::hammersley::hammersley;
use glam::UVec2;

/// A coordinate of point n of a lattice sequence: frac(phi_2(n) z), exact. For odd z each
/// 2^k points from a multiple of 2^k on hold one of each interval of width 2^-k.
#[inline]
#[must_use]
pub fn lattice(n: u32, z: u32) -> u32 {
    reverse_bits(n).wrapping_mul(z)
}

/// A coordinate of point n < count of a lattice of `count` points: `ceil(2^32 k / count)`
/// with k = n z mod count, at most 2^32 - 1. z < count; count = 2^32 is written as 0.
#[inline]
#[must_use]
pub fn korobov(n: u32, z: u32, count: u32) -> u32 {
    let mut product = mul64(n, z);
    if count == 0 {
        return product.x;
    }
    // The high word is below `count`, and is the first remainder.
    let mut remainder = product.y;
    for _ in 0..32 {
        let carry = remainder >> 31 != 0;
        remainder = (remainder << 1) | (product.x >> 31);
        product.x <<= 1;
        if carry || remainder >= count {
            remainder = remainder.wrapping_sub(count);
        }
    }
    hammersley(remainder, count)
}

/// A coordinate of point n of an additive recurrence: `floor(2^32 frac(1/2 + n alpha))`,
/// exact for alpha as a fraction of 2^64 (x low, y high).
#[inline]
#[must_use]
pub fn additive(n: u32, alpha: UVec2) -> u32 {
    n.wrapping_mul(alpha.y)
        .wrapping_add(mulhi(n, alpha.x))
        .wrapping_add(0x8000_0000)
}

/// u moved by `shift` around the circle (Cranley and Patterson).
#[inline]
#[must_use]
pub fn rotate(u: u32, shift: u32) -> u32 {
    u.wrapping_add(shift)
}
