//! Constants, declared once.

mod primes;

pub use primes::{LARGEST_PRIME, PRIMES, is_prime, nearest_prime, primes_glsl};
