//! Randomisations of a fraction in base 2: nested uniform scrambling, exact and by a fast
//! hash, random linear matrix scrambling, and the digital shift.
//!
//! Source: Owen 1995; Laine and Karras 2011, with the constants of Vegdahl 2021, Building a
//! Better LK Hash; Matousek 1998; Cranley and Patterson 1976; L'Ecuyer and Lemieux 2002.
//! Domain: x any `u32`, a fraction of 2^32: its highest bit is the first digit.
//! Range: every `u32`. Each is a bijection that keeps every elementary interval: the first
//! k digits of the result depend on the first k digits of x alone. [`owen`] flips each of
//! the 2^32 - 1 nodes of the binary tree by a bit of its own. [`owen_hash`] has only 2^32
//! scrambles and wants a random seed, such as [`crate::reference::hash::seed`] gives; its
//! flips are independent in pairs, but the four of the third level sum to the same parity
//! in 5 cases of 8. [`matrix_scramble`] is linear: 0 stays 0, and with a digital shift its
//! flips are independent in pairs alone. [`digital_shift`] has one flip for each level.
//! Mirror: `shaders/corput/owen.glsl`.

use crate::reference::bits::reverse_bits;
use crate::reference::random::philox;
use glam::{UVec2, UVec4, Vec4Swizzles, uvec4};

/// Flips each digit by a digit of `shift`.
#[inline]
#[must_use]
pub fn digital_shift(x: u32, shift: u32) -> u32 {
    x ^ shift
}

/// The flips of seven levels. Of the 128 bits of the block, bit n (of word n / 32) belongs
/// to node n of the subtree, where the root is node 1 and the children of node n are 2n and
/// 2n + 1; bit 0 is unused. `digits` are the seven digits that lead down, the highest first.
#[inline]
#[must_use]
pub fn owen_flips(block: UVec4, digits: u32) -> u32 {
    let mut flips = 0u32;
    for level in 0..5 {
        let node = (1 << level) | (digits >> (7 - level));
        flips = (flips << 1) | ((block.x >> node) & 1);
    }
    // Level 5 is nodes 32 to 63, level 6 nodes 64 to 127.
    let last = if (digits >> 6) != 0 { block.w } else { block.z };
    flips = (flips << 1) | ((block.y >> (digits >> 2)) & 1);
    (flips << 1) | ((last >> ((digits >> 1) & 31)) & 1)
}

/// Nested uniform scrambling. The subtrees of levels 0, 7, 14, 21 and 28 on have each their
/// Philox block, whose counter is the digits above, the number of the level's subtree (0 to
/// 4), the dimension, and the purpose 1.
#[inline]
#[must_use]
pub fn owen(x: u32, dimension: u32, seed: UVec2) -> u32 {
    let mut flips = 0u32;
    for subtree in 0..4 {
        let below = 25 - 7 * subtree;
        let prefix = (x >> below) >> 7;
        let block = philox(uvec4(prefix, subtree, dimension, 1), seed);
        flips |= owen_flips(block, (x >> below) & 127) << below;
    }
    let block = philox(uvec4(x >> 4, 4, dimension, 1), seed);
    flips |= owen_flips(block, (x & 15) << 3) >> 3;
    x ^ flips
}

/// The permutation of Laine and Karras of a fraction whose digits are in reverse order, so
/// that a digit changes only by those before it, which products carry upwards.
#[inline]
#[must_use]
pub fn owen_hash_reversed(mut x: u32, seed: u32) -> u32 {
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^= x.wrapping_mul(0x53a2_2864);
    reverse_bits(x)
}

/// The same of a fraction.
#[inline]
#[must_use]
pub fn owen_hash(x: u32, seed: u32) -> u32 {
    owen_hash_reversed(reverse_bits(x), seed)
}

/// The digits of x times a random lower triangular matrix over {0, 1} with ones on its
/// diagonal. Column j, for digit j of x from the highest, is word j % 4 of the Philox block
/// of counter (j / 4, 0, dimension, 2): its bits below the diagonal.
#[inline]
#[must_use]
pub fn matrix_scramble(mut x: u32, dimension: u32, seed: UVec2) -> u32 {
    let mut y = x;
    let mut below = 0x7fff_ffffu32;
    for quarter in 0..8 {
        let mut block = philox(uvec4(quarter, 0, dimension, 2), seed);
        for _ in 0..4 {
            y ^= if (x >> 31) != 0 { block.x & below } else { 0 };
            block = block.yzwx();
            below >>= 1;
            x <<= 1;
        }
    }
    y
}
