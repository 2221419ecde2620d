//! The index of a pixel's samples in one sequence for the whole image, so that the error
//! is blue noise in screen space.
//!
//! Source: Ahmed and Wonka 2020, ACM TOG 39(6). Domain: pixels below 2^d in x and y,
//! d = `floor((32 - samples_log2) / 2)`; `samples_log2` at most 32; `sample_index` below
//! `2^samples_log2`. Range: each index at most once; each aligned tile of 2^k x 2^k pixels
//! has all indices of one aligned block of `4^k 2^samples_log2`.
//! Mirror: `shaders/corput/screen_space.glsl`.

use crate::reference::fixed::mulhi;
use glam::UVec2;

/// The permutations of 0 to 3 in lexicographic order: two bits for each image, that of 0
/// lowest.
const PERMUTATIONS: [u32; 24] = [
    0xe4, 0xb4, 0xd8, 0x78, 0x9c, 0x6c, 0xe1, 0xb1, 0xc9, 0x39, 0x8d, 0x2d, 0xd2, 0x72, 0xc6, 0x36,
    0x4e, 0x1e, 0x93, 0x63, 0x87, 0x27, 0x4b, 0x1b,
];

/// The even bits of the result are the low 16 bits of x.
#[inline]
#[must_use]
pub fn screen_space_spread(x: u32) -> u32 {
    let y = x & 0xffff;
    let y = (y | (y << 8)) & 0x00ff_00ff;
    let y = (y | (y << 4)) & 0x0f0f_0f0f;
    let y = (y | (y << 2)) & 0x3333_3333;
    (y | (y << 1)) & 0x5555_5555
}

/// The place of a pixel in Z-order, x and y below 2^16.
#[inline]
#[must_use]
pub fn screen_space_morton(pixel: UVec2) -> u32 {
    screen_space_spread(pixel.x) | (screen_space_spread(pixel.y) << 1)
}

/// A word from a prefix of a code, its length and a seed: two rounds of multiply and xor
/// (lowbias32 by Wellons) around the seed.
#[inline]
#[must_use]
pub fn screen_space_hash(prefix: u32, level: u32, seed: u32) -> u32 {
    let x = prefix
        .wrapping_mul(0x9e37_79b9)
        .wrapping_add(level.wrapping_mul(0x85eb_ca6b));
    let x = (x ^ (x >> 16) ^ seed).wrapping_mul(0x7feb_352d);
    let x = (x ^ (x >> 15)).wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// A code of `digits` base-4 digits, at most 16, with each digit permuted by the digits
/// above it. Bits above are dropped.
#[inline]
#[must_use]
pub fn screen_space_shuffle(code: u32, digits: u32, seed: u32) -> u32 {
    let mut result = 0;
    for level in 0..digits {
        let shift = 2 * (digits - 1 - level);
        // Shifted twice, since by 32 is not defined.
        let prefix = ((code >> shift) >> 2) & ((1 << (2 * level)) - 1);
        let hash = screen_space_hash(prefix, level, seed);
        let permutation = PERMUTATIONS[mulhi(hash, 24) as usize];
        let digit = (code >> shift) & 3;
        result |= ((permutation >> (2 * digit)) & 3) << shift;
    }
    result
}

/// The index of a pixel's sample in the sequence of the image.
#[inline]
#[must_use]
pub fn screen_space_index(pixel: UVec2, sample_index: u32, samples_log2: u32, seed: u32) -> u32 {
    if samples_log2 >= 32 {
        return sample_index;
    }
    let digits = (32 - samples_log2) >> 1;
    let code = screen_space_morton(pixel);
    (screen_space_shuffle(code, digits, seed) << samples_log2) | sample_index
}
