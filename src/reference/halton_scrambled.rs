//! Scrambled Halton sequences: dimension d is a scrambled radical inverse in the d-th prime,
//! which keeps the high bases from lining up.
//!
//! The shader finds the prime by its hook `CORPUT_PRIME(dimension)`; here it is given.
//! Source: as `scrambled_radical_inverse`; Halton 1960. Domain: every index; primes up to
//! 65535. Range: fractions of 2^32, as the radical inverses have them.
//! Mirror: `shaders/corput/halton_scrambled.glsl`.

use crate::reference::scrambled_radical_inverse::{
    radical_inverse_faure, radical_inverse_owen, radical_inverse_permuted, radical_inverse_started,
};

/// Coordinate of point n with Faure's permutations in the dimension of a prime.
#[inline]
#[must_use]
pub fn halton_faure(n: u32, prime: u32) -> u32 {
    radical_inverse_faure(n, prime)
}

/// The same with a random permutation per position of a digit; dimensions may share a seed.
#[inline]
#[must_use]
pub fn halton_permuted(n: u32, prime: u32, seed: u32) -> u32 {
    radical_inverse_permuted(n, prime, seed)
}

/// The same with nested (Owen) scrambling; dimensions may share a seed.
#[inline]
#[must_use]
pub fn halton_owen(n: u32, prime: u32, seed: u32) -> u32 {
    radical_inverse_owen(n, prime, seed)
}

/// The same from a random start; dimensions may share a seed.
#[inline]
#[must_use]
pub fn halton_started(n: u32, prime: u32, seed: u32) -> u32 {
    radical_inverse_started(n, prime, seed)
}
