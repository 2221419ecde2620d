//! The Halton sequence: dimension d is the radical inverse in the d-th prime.
//!
//! Source: Halton 1960, Numer. Math. 2. Domain: every index; 1,024 dimensions.
//! Range: fractions of 2^32, each `ceil(2^32 phi)`.
//! Mirror: `shaders/corput/halton.glsl`.

use crate::reference::radical_inverse::radical_inverse;

/// Coordinate of point n in the dimension whose prime is given, as a fraction of 2^32.
///
/// The shader finds the prime by its hook `CORPUT_PRIME(dimension)`.
#[inline]
#[must_use]
pub fn halton(n: u32, prime: u32) -> u32 {
    radical_inverse(n, prime)
}
