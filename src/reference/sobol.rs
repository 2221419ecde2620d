//! The Sobol sequence: coordinates are sums modulo 2 of direction numbers.
//!
//! Source: Sobol 1967; Antonov and Saleev 1979 for the order by Gray code.
//! Domain: every index. Range: fractions of 2^32, exact.
//! Mirror: `shaders/corput/sobol.glsl`.

/// The index whose point stands at place n of the order by Gray code, in which
/// neighbours differ in one direction number. The first 2^k places hold the first 2^k
/// points.
#[inline]
#[must_use]
pub fn gray(n: u32) -> u32 {
    n ^ (n >> 1)
}

/// Coordinate of point n in the dimension with these direction numbers, as a fraction of
/// 2^32.
///
/// The shader finds the numbers by its hook `CORPUT_SOBOL_DIRECTION(dimension, bit)`.
///
/// # Panics
/// If there are fewer than 32 direction numbers.
#[inline]
#[must_use]
pub fn sobol(n: u32, directions: &[u32]) -> u32 {
    let mut x = 0;
    for bit in 0..32 {
        x ^= if (n >> bit) & 1 != 0 {
            directions[bit]
        } else {
            0
        };
    }
    x
}
