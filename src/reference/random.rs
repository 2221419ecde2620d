//! Random numbers without a state in memory, from index, dimension and seed; and the
//! sequential generator PCG32.
//!
//! Source: Philox-4x32-10: Salmon, Moraes, Dror and Shaw 2011. PCG32: O'Neill 2014.
//! Jump ahead: Brown 1994.
//! Domain: any `u32`. The last word of a Philox counter is its purpose, so that no two uses
//! of one seed share a block: 0 random numbers, 1 nested uniform scrambling, 2 matrix
//! scrambling. Headers take numbers below 2^16, a host those from there on.
//! Range: every `u32`; results are fractions of 2^32.
//! Mirror: `shaders/corput/random.glsl`.

use crate::reference::fixed::{add64, mul64, shr64};
use crate::reference::hash::mix;
use glam::{UVec2, UVec4, uvec2, uvec4};

/// PCG32: 64 bits of state, and an odd increment that selects the stream.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pcg32 {
    /// The state, x low.
    pub state: UVec2,
    /// What each step adds; odd.
    pub increment: UVec2,
}

/// 128 random bits of a counter; a bijection for each key.
#[inline]
#[must_use]
pub fn philox(mut counter: UVec4, mut key: UVec2) -> UVec4 {
    for _ in 0..10 {
        let a = mul64(0xd251_1f53, counter.x);
        let b = mul64(0xcd9e_8d57, counter.z);
        counter = uvec4(b.y ^ counter.y ^ key.x, b.x, a.y ^ counter.w ^ key.y, a.x);
        key = key.wrapping_add(uvec2(0x9e37_79b9, 0xbb67_ae85));
    }
    counter
}

/// A random number: dimension d of point `index`. Four dimensions share a block.
#[inline]
#[must_use]
pub fn random(index: u32, dimension: u32, seed: UVec2) -> u32 {
    let block = philox(uvec4(index, dimension >> 2, 0, 0), seed);
    block[(dimension & 3) as usize]
}

/// The same by the cheaper mixer.
#[inline]
#[must_use]
pub fn random_fast(index: u32, dimension: u32, seed: UVec2) -> u32 {
    mix(uvec4(index, dimension, seed.x, seed.y))
}

/// `state * multiplier + increment` modulo 2^64.
#[inline]
#[must_use]
pub fn pcg32_affine(state: UVec2, multiplier: UVec2, increment: UVec2) -> UVec2 {
    let mut product = mul64(state.x, multiplier.x);
    product.y = product
        .y
        .wrapping_add(state.x.wrapping_mul(multiplier.y))
        .wrapping_add(state.y.wrapping_mul(multiplier.x));
    add64(product, increment)
}

/// The generator after this one.
#[inline]
#[must_use]
pub fn pcg32_next(p: Pcg32) -> Pcg32 {
    Pcg32 {
        state: pcg32_affine(p.state, uvec2(0x4c95_7f2d, 0x5851_f42d), p.increment),
        increment: p.increment,
    }
}

/// A generator, seeded as its author does. The highest bit of `stream` is ignored. Generators
/// of successive seeds or streams start out alike: give each a state from [`random`].
#[inline]
#[must_use]
pub fn pcg32_seed(state: UVec2, stream: UVec2) -> Pcg32 {
    let increment = uvec2((stream.x << 1) | 1, (stream.y << 1) | (stream.x >> 31));
    let p = pcg32_next(Pcg32 {
        state: UVec2::ZERO,
        increment,
    });
    pcg32_next(Pcg32 {
        state: add64(p.state, state),
        increment,
    })
}

/// The random number of a state.
#[inline]
#[must_use]
pub fn pcg32_value(p: Pcg32) -> u32 {
    let turn = p.state.y >> 27;
    let mixed = shr64(p.state, 18) ^ p.state;
    let x = shr64(mixed, 27).x;
    (x >> turn) | (x << (32u32.wrapping_sub(turn) & 31))
}

/// The generator `delta` steps ahead, modulo 2^64: 2^64 - n steps go back by n.
#[inline]
#[must_use]
pub fn pcg32_advance(p: Pcg32, mut delta: UVec2) -> Pcg32 {
    // The step of 2^i, composed with itself at each bit.
    let mut multiplier = uvec2(0x4c95_7f2d, 0x5851_f42d);
    let mut increment = p.increment;
    let mut state = p.state;
    while (delta.x | delta.y) != 0 {
        if (delta.x & 1) != 0 {
            state = pcg32_affine(state, multiplier, increment);
        }
        increment = pcg32_affine(increment, multiplier, increment);
        multiplier = pcg32_affine(multiplier, multiplier, UVec2::ZERO);
        delta = shr64(delta, 1);
    }
    Pcg32 {
        state,
        increment: p.increment,
    }
}
