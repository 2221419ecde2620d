//! Look-ups of a dither mask: rank, fraction, animation and further dimensions.
//!
//! Source: Ulichney 1993; Roberts 2018; Wolfe et al. 2022. Domain: any pixel, frame and
//! dimension; masks of sides from 1 to 2^16 with at most 2^16 pixels, all frames together.
//! Range: fractions of 2^32. [`crate::blue_noise`] makes the masks.
//! Mirror: `shaders/corput/blue_noise.glsl`.

use crate::reference::fixed::mulhi;
use glam::{UVec2, UVec3, uvec2};

/// `floor(2^32 (rank + 1/2) / count)`: the middle of the rank-th of `count` equal parts.
/// 1 <= count <= 2^16, rank < count.
#[inline]
#[must_use]
pub fn blue_noise_fraction(rank: u32, count: u32) -> u32 {
    // Long division by digits of 16 bits: 2 rank + 1 < 2 count, so the first quotient
    // has 16 bits, and remainders are below 2^16.
    let high = rank.wrapping_mul(2).wrapping_add(1) << 15;
    ((high / count) << 16).wrapping_add(((high % count) << 16) / count)
}

/// The rank of a pixel, with the mask repeated over the plane.
///
/// The shader reads ranks by its hook `CORPUT_BLUE_NOISE(x, y)`.
#[inline]
#[must_use]
pub fn blue_noise_rank(pixel: UVec2, size: UVec2, ranks: &[u32]) -> u32 {
    ranks[((pixel.y % size.y) * size.x + pixel.x % size.x) as usize]
}

/// The fraction of a pixel in a still mask.
#[inline]
#[must_use]
pub fn blue_noise(pixel: UVec2, size: UVec2, ranks: &[u32]) -> u32 {
    blue_noise_fraction(blue_noise_rank(pixel, size, ranks), size.x * size.y)
}

/// The fraction of a pixel and frame in a mask over time of size.z frames.
#[inline]
#[must_use]
pub fn blue_noise_frame(pixel: UVec2, frame: u32, size: UVec3, ranks: &[u32]) -> u32 {
    let row = frame % size.z * size.y + pixel.y % size.y;
    let rank = ranks[(row * size.x + pixel.x % size.x) as usize];
    blue_noise_fraction(rank, size.x * size.y * size.z)
}

/// A still mask over time: each pixel goes round by the golden ratio from frame to frame,
/// so its values fill [0, 1) evenly, and each frame remains blue where it does not wrap.
#[inline]
#[must_use]
pub fn blue_noise_animate(fraction: u32, frame: u32) -> u32 {
    fraction.wrapping_add(frame.wrapping_mul(0x9e37_79b9))
}

/// The pixel to look up for another dimension: shifts of the mask as far apart as R2 is.
/// size.x and size.y at most 2^16.
#[inline]
#[must_use]
pub fn blue_noise_shift(pixel: UVec2, dimension: u32, size: UVec2) -> UVec2 {
    uvec2(
        pixel.x % size.x + mulhi(dimension.wrapping_mul(0xc13f_a9a9), size.x),
        pixel.y % size.y + mulhi(dimension.wrapping_mul(0x91e1_0da6), size.y),
    )
}
