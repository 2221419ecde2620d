//! Draws of four dimensions of the Halton sequence from a domain, randomised.
//!
//! Source: Owen 2017, A randomized Halton algorithm in R. Domain: every domain. Range:
//! fractions of 2^32, truncated.
//! Mirror: `shaders/corput/domain_halton.glsl`.

use crate::reference::domain::{Domain, domain_seed};
use crate::reference::scrambled_radical_inverse::{
    radical_inverse_owen, radical_inverse_permuted, radical_inverse_started,
};
use glam::{UVec4, uvec4};

/// Nested permutations of the digits in four primes.
///
/// The shader finds the primes by its hook `CORPUT_PRIME(d)`.
#[inline]
#[must_use]
pub fn draw_halton(domain: Domain, primes: UVec4) -> UVec4 {
    let n = domain.index;
    uvec4(
        radical_inverse_owen(n, primes.x, domain_seed(domain, 0)),
        radical_inverse_owen(n, primes.y, domain_seed(domain, 1)),
        radical_inverse_owen(n, primes.z, domain_seed(domain, 2)),
        radical_inverse_owen(n, primes.w, domain_seed(domain, 3)),
    )
}

/// The same with one permutation per place of a digit.
///
/// The shader finds the primes by its hook `CORPUT_PRIME(d)`.
#[inline]
#[must_use]
pub fn draw_halton_permuted(domain: Domain, primes: UVec4) -> UVec4 {
    let n = domain.index;
    uvec4(
        radical_inverse_permuted(n, primes.x, domain_seed(domain, 0)),
        radical_inverse_permuted(n, primes.y, domain_seed(domain, 1)),
        radical_inverse_permuted(n, primes.z, domain_seed(domain, 2)),
        radical_inverse_permuted(n, primes.w, domain_seed(domain, 3)),
    )
}

/// The same from a random start, which costs least.
///
/// The shader finds the primes by its hook `CORPUT_PRIME(d)`.
#[inline]
#[must_use]
pub fn draw_halton_started(domain: Domain, primes: UVec4) -> UVec4 {
    let n = domain.index;
    uvec4(
        radical_inverse_started(n, primes.x, domain_seed(domain, 0)),
        radical_inverse_started(n, primes.y, domain_seed(domain, 1)),
        radical_inverse_started(n, primes.z, domain_seed(domain, 2)),
        radical_inverse_started(n, primes.w, domain_seed(domain, 3)),
    )
}
