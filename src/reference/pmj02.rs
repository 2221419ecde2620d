//! A progressive multi-jittered (0,2) sequence: the first two dimensions of the Sobol
//! sequence, shuffled and scrambled by nested uniform permutations.
//!
//! Source: Christensen, Kensler and Kilpatrick 2018; Helmer, Christensen and Kensler
//! 2021; Burley 2020. Domain: every index; every seed. Range: fractions of 2^32, one
//! point in each elementary interval for every prefix of 2^k points.
//! Mirror: `shaders/corput/pmj02.glsl`.

use crate::reference::bits::reverse_bits;
use crate::reference::owen::owen;
use glam::{UVec2, uvec2};

/// The first two coordinates of point n of the Sobol sequence, without a table: bits in
/// reverse, and those times Pascal's triangle modulo 2.
#[inline]
#[must_use]
pub fn sobol_pair(n: u32) -> UVec2 {
    let x = reverse_bits(n);
    // Rows of the triangle fold like the halves of Sierpinski's.
    let mut y = n;
    y ^= y >> 16;
    y ^= (y & 0xff00_ff00) >> 8;
    y ^= (y & 0xf0f0_f0f0) >> 4;
    y ^= (y & 0xcccc_cccc) >> 2;
    y ^= (y & 0xaaaa_aaaa) >> 1;
    uvec2(x, reverse_bits(y))
}

/// Nested uniform scrambling in numbers of its own, so that a Sobol sequence scrambled with
/// the same seed has other points: of coordinate 0 or 1, or of the index, which is 2.
#[inline]
#[must_use]
pub fn pmj02_scramble(x: u32, which: u32, seed: UVec2) -> u32 {
    owen(x, 0x8000_0000 | which, seed)
}

/// Where point n stands in the Sobol sequence: a prefix of 2^k points comes from an
/// aligned block of as many.
#[inline]
#[must_use]
pub fn pmj02_index(n: u32, seed: UVec2) -> u32 {
    pmj02_scramble(n, 2, seed)
}

/// Point n.
#[inline]
#[must_use]
pub fn pmj02(n: u32, seed: UVec2) -> UVec2 {
    let p = sobol_pair(pmj02_index(n, seed));
    uvec2(pmj02_scramble(p.x, 0, seed), pmj02_scramble(p.y, 1, seed))
}
