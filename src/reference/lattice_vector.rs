//! A generating vector of lattice sequences in base 2, embedded up to 2^20 points.
//!
//! Source: Cools, Kuo and Nuyens 2006, SIAM J. Sci. Comput. 28(6). Domain: 0 to 249. Range:
//! odd numbers below 2^20.
//! Mirror: `shaders/corput/lattice_vector.glsl`.

use crate::tables;

/// The generator of a dimension: `lattice_vector(0) = 1`. Indices past the table give 0.
#[inline]
#[must_use]
pub fn lattice_vector(index: u32) -> u32 {
    tables::lattice_vector()
        .get(index as usize)
        .copied()
        .unwrap_or(0)
}
