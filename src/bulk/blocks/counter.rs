//! Columns whose values share nothing, or only a step.

use crate::reference::fixed::{add64, mul64};
use crate::reference::lattice::{additive, rotate};
use crate::reference::random::{Pcg32, pcg32_advance, pcg32_seed, pcg32_value, random_fast};
use glam::{UVec2, uvec2};

/// A column.
#[derive(Clone, Copy, Debug)]
pub enum Counter {
    Additive { alpha: u64, shift: u32 },
    Pcg4d { dimension: u32, seed: [u32; 2] },
    Pcg32(Walk),
}

/// A generator that goes on by as many numbers as a point has.
#[derive(Clone, Copy, Debug)]
pub struct Walk {
    start: Pcg32,
    dimension: u32,
    dimensions: u32,
    multiplier: u64,
    increment: u64,
}

impl Counter {
    /// Numbers of PCG32 in turn, one for each dimension.
    pub fn pcg32(dimension: u32, dimensions: u32, seed: [u32; 2]) -> Self {
        let start = pcg32_seed(UVec2::from(seed), uvec2(54, 0));
        let wide = |x: UVec2| u64::from(x.y) << 32 | u64::from(x.x);
        let at = |state: u64| Pcg32 {
            state: uvec2(state as u32, (state >> 32) as u32),
            ..start
        };
        // The step is affine: where it takes 0 and 1 says all.
        let after = |state| wide(pcg32_advance(at(state), uvec2(dimensions, 0)).state);
        let increment = after(0);
        Self::Pcg32(Walk {
            start,
            dimension,
            dimensions,
            multiplier: after(1).wrapping_sub(increment),
            increment,
        })
    }

    /// Writes the words of consecutive indices from n on.
    #[inline(always)]
    pub fn fill(&self, n: u64, words: &mut [u32], finish: impl Fn(u32) -> u32) {
        // The loops count in words: the last index is 2^32 - 1.
        let first = n as u32;
        let each = (0u32..).zip(words);
        match *self {
            Self::Additive { alpha, shift } => {
                let alpha = uvec2(alpha as u32, (alpha >> 32) as u32);
                for (i, word) in each {
                    *word = finish(rotate(additive(first.wrapping_add(i), alpha), shift));
                }
            }
            Self::Pcg4d { dimension, seed } => {
                let seed = UVec2::from(seed);
                for (i, word) in each {
                    *word = finish(random_fast(first.wrapping_add(i), dimension, seed));
                }
            }
            Self::Pcg32(walk) => {
                let place = add64(mul64(first, walk.dimensions), uvec2(walk.dimension, 0));
                let mut p = pcg32_advance(walk.start, place);
                let mut state = u64::from(p.state.y) << 32 | u64::from(p.state.x);
                for (_, word) in each {
                    p.state = uvec2(state as u32, (state >> 32) as u32);
                    *word = finish(pcg32_value(p));
                    state = state
                        .wrapping_mul(walk.multiplier)
                        .wrapping_add(walk.increment);
                }
            }
        }
    }
}
