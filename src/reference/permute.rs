//! A permutation of 0 .. length - 1 chosen by a seed, one element at a time.
//!
//! Source: Kensler 2013, Pixar TM 13-01, for the cycle walk; up to 16 elements are ranked
//! by hashes, above that the rounds are quadratic permutation polynomials (Rivest 2001)
//! and reversals of bits. Mixer: Wellons 2018 (lowbias32).
//! Domain: i < length, 1 <= length <= 2^32; length = 2^32 is written as 0. Larger i count
//! as length - 1. Range: 0 to length - 1.
//! Mirror: `shaders/corput/permute.glsl`.

use crate::reference::bits::{find_msb, reverse_bits};
use crate::reference::fixed::mulhi;

/// A bijection of 32 bits in which each bit of x moves each bit of the result.
#[inline]
#[must_use]
pub fn permute_mix(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// Key `index` of a seed; different keys for different indices.
#[inline]
#[must_use]
pub fn permute_key(seed: u32, index: u32) -> u32 {
    permute_mix(permute_mix(seed).wrapping_add(index.wrapping_mul(0x9e37_79b9)))
}

/// The rank of key i among the first `length` keys of the seed.
#[inline]
#[must_use]
pub fn permute_rank(i: u32, length: u32, seed: u32) -> u32 {
    let stream = permute_mix(seed);
    let own = permute_mix(stream.wrapping_add(i.wrapping_mul(0x9e37_79b9)));
    let mut rank = 0;
    for j in 0..length {
        rank += u32::from(permute_mix(stream.wrapping_add(j.wrapping_mul(0x9e37_79b9))) < own);
    }
    rank
}

/// A bijection of the low 32 - shift bits, where x has no others.
#[inline]
#[must_use]
pub fn permute_round(mut x: u32, shift: u32, key: u32) -> u32 {
    x ^= key;
    // x (b + 2 a x) with odd b; each part of the key has bits of its own up to 2^8.
    x = x.wrapping_mul(
        (key.rotate_left(16) | 1).wrapping_add(2u32.wrapping_mul(key >> 8).wrapping_mul(x)),
    );
    reverse_bits(x) >> shift
}

/// Where the permutation of `seed` takes i.
#[inline]
#[must_use]
pub fn permute(i: u32, length: u32, seed: u32) -> u32 {
    // 2^32 - 1 for 2^32, which is written as 0.
    let last = length.wrapping_sub(1);
    let mut x = i.min(last);
    if last < 16 {
        return permute_rank(x, length, seed);
    }
    let stream = permute_mix(seed);
    let shift = 31 - find_msb(last);
    // The cycle of an element leads back to it, so the walk ends.
    let mut outside = true;
    while outside {
        for j in 0..8u32 {
            x = permute_round(
                x,
                shift,
                permute_mix(stream.wrapping_add(j.wrapping_mul(0x9e37_79b9))),
            );
        }
        outside = x > last;
    }
    // A rotation makes each position uniform, whatever the rounds do.
    let key = permute_mix(stream.wrapping_add(8u32.wrapping_mul(0x9e37_79b9)));
    let offset = if length == 0 { key } else { mulhi(key, length) };
    let room = last - offset;
    if x > room { x - room - 1 } else { x + offset }
}
