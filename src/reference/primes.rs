//! The first 1,024 primes.
//!
//! Domain: 0 to 1023. Range: 2 to 8161.
//! Mirror: `shaders/corput/primes.glsl`.

use crate::tables::PRIMES;

/// The prime with this index: `prime(0) = 2`. Indices past the table give 0.
#[inline]
#[must_use]
pub fn prime(index: u32) -> u32 {
    PRIMES.get(index as usize).copied().unwrap_or(0)
}
