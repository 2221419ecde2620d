//! Direction numbers of the first 64 dimensions of the Sobol sequence.
//!
//! Domain: dimensions 0 to 63, bits 0 to 31. Range: fractions of 2^32.
//! Mirror: `shaders/corput/sobol_directions.glsl`.

use crate::tables::{SOBOL_GLSL_DIMENSIONS, sobol_directions};

/// What bit `bit` of the index contributes to the coordinate `dimension`; 0 past the
/// table.
#[inline]
#[must_use]
pub fn sobol_direction(dimension: u32, bit: u32) -> u32 {
    if dimension < SOBOL_GLSL_DIMENSIONS && bit < 32 {
        sobol_directions(dimension)[bit as usize]
    } else {
        0
    }
}
