//! Hashes: a bijection of 32 bits, mixers of four words, and a 32-bit seed per dimension
//! and purpose.
//!
//! Source: Wellons 2018, hash-prospector, triple32; Jarzynski and Olano 2020,
//! Hash Functions for GPU Rendering, JCGT 9(3). Domain: any `u32`.
//! Range: every `u32`. [`hash`] never repeats a value, so hashes of an index are no random
//! numbers: those collide. The lowest bits of [`pcg4d`] are weak: bit k of each word
//! depends on bits 0 to k + 16 of the arguments alone, so it has a period of 2^(k + 17) in
//! each, and the lowest of x may be biased 3 to 1; high bits of the arguments hardly reach
//! the low ones. [`mix`] has neither fault.
//! Mirror: `shaders/corput/hash.glsl`.

use glam::{UVec2, UVec4, uvec4};

/// A bijection of 32 bits; it keeps 0.
#[inline]
#[must_use]
pub fn hash(mut x: u32) -> u32 {
    x ^= x >> 17;
    x = x.wrapping_mul(0xed5a_d4bb);
    x ^= x >> 11;
    x = x.wrapping_mul(0xac4c_1b51);
    x ^= x >> 15;
    x = x.wrapping_mul(0x3184_8bab);
    x ^ (x >> 14)
}

/// A bijection of 128 bits.
#[inline]
#[must_use]
pub fn pcg4d(mut v: UVec4) -> UVec4 {
    v = v
        .wrapping_mul(UVec4::splat(1_664_525))
        .wrapping_add(UVec4::splat(1_013_904_223));
    v.x = v.x.wrapping_add(v.y.wrapping_mul(v.w));
    v.y = v.y.wrapping_add(v.z.wrapping_mul(v.x));
    v.z = v.z.wrapping_add(v.x.wrapping_mul(v.y));
    v.w = v.w.wrapping_add(v.y.wrapping_mul(v.z));
    v ^= v >> 16;
    v.x = v.x.wrapping_add(v.y.wrapping_mul(v.w));
    v.y = v.y.wrapping_add(v.z.wrapping_mul(v.x));
    v.z = v.z.wrapping_add(v.x.wrapping_mul(v.y));
    v.w = v.w.wrapping_add(v.y.wrapping_mul(v.z));
    v
}

/// Four words of four. Products carry upwards only, so two rounds leave the low bits weak:
/// a third round, and its upper halves folded onto the lower, mend that.
#[inline]
#[must_use]
pub fn mix4(mut v: UVec4) -> UVec4 {
    v = pcg4d(v);
    v ^= v >> 16;
    v.x = v.x.wrapping_add(v.y.wrapping_mul(v.w));
    v.y = v.y.wrapping_add(v.z.wrapping_mul(v.x));
    v.z = v.z.wrapping_add(v.x.wrapping_mul(v.y));
    v.w = v.w.wrapping_add(v.y.wrapping_mul(v.z));
    v ^ (v >> 16)
}

/// One word of four: the first of [`mix4`].
#[inline]
#[must_use]
pub fn mix(v: UVec4) -> u32 {
    mix4(v).x
}

/// A seed of 32 bits for one dimension and one purpose, which is any number: whoever draws
/// several seeds for one dimension gives each use its own.
#[inline]
#[must_use]
pub fn seed(seed: UVec2, dimension: u32, purpose: u32) -> u32 {
    mix(uvec4(seed.x, seed.y, dimension, purpose))
}
