//! The inputs of a row, each made from its number alone.

use crate::catalog::Kind;
use crate::check::{mix, normal};
use crate::reference::hemisphere::{cosine_hemisphere, uniform_hemisphere};
use crate::tables::PRIMES;
use glam::uvec2;

/// Random inputs of a row that does not try all.
pub const RANDOM: u64 = 1 << 24;

/// Inputs of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// The words first, first + stride, ..., so many, each in all four places.
    Words {
        /// The first of them.
        first: u32,
        /// From one to the next, modulo 2^32.
        stride: u32,
        /// Their number, up to 2^32.
        count: u64,
    },
    /// Every pair of critical values, and then [`RANDOM`] random inputs.
    Sampled,
}

impl Domain {
    /// All 2^32 words.
    pub const EVERY_WORD: Self = Self::Words {
        first: 0,
        stride: 1,
        count: 1 << 32,
    };

    /// How many there are for a function of that kind.
    #[must_use]
    pub fn inputs(&self, kind: Kind) -> u64 {
        match self {
            Self::Words { count, .. } => *count,
            Self::Sampled => (crate::check::critical(kind).len() as u64).pow(2) + RANDOM,
        }
    }

    /// What they are, in words.
    #[must_use]
    pub fn describe(&self, kind: Kind) -> String {
        match *self {
            Self::EVERY_WORD => "all 2^32 words".into(),
            Self::Words {
                first,
                stride,
                count,
            } => format!("{count} words from {first:#x} on, {stride} apart"),
            Self::Sampled => format!(
                "all pairs of {} critical values and 2^24 random inputs",
                crate::check::critical(kind).len()
            ),
        }
    }
}

/// Input number `i` of [`Domain::Sampled`]: of a pair of critical values, or random, brought
/// into what a function of that kind takes.
#[must_use]
pub fn arguments(kind: Kind, critical: &[u32], i: u64) -> [u32; 4] {
    let side = critical.len() as u64;
    let value = |at: u64| critical.get(at as usize).copied().unwrap_or(0);
    if i < side * side {
        let (x, y) = (value(i / side), value(i % side));
        return taken(kind, [x, y, mix(x ^ y), mix(x.wrapping_add(y))], false);
    }
    let n = (i - side * side) as u32;
    let words = [0, 1, 2, 3].map(|j| mix(n.wrapping_mul(4) + j));
    taken(kind, words, true)
}

/// What a function of that kind takes, of any four words.
fn taken(kind: Kind, [x, y, z, w]: [u32; 4], random: bool) -> [u32; 4] {
    // k < N, of N = 2^32 as 0: random ones of all sizes.
    let count = if random { y >> (w >> 27) } else { y };
    let below = |k: u32| if count == 0 { k } else { k % count };
    match kind {
        Kind::Word | Kind::Words | Kind::CostlyWords | Kind::Float => [x, y, z, w],
        Kind::Floats if random => [normal(x), normal(y), z, w],
        Kind::Floats => [x, y, z, w],
        Kind::Radical => {
            let prime = PRIMES.get(y as usize % PRIMES.len()).copied();
            [x, prime.unwrap_or(2), 0, 0]
        }
        Kind::Grid => [below(x), count, 0, 0],
        Kind::Strata => [below(x), count, z, w],
        Kind::Digits => [x, if random { y >> (16 + (w >> 28)) } else { y }, z, 0],
        Kind::Direction => {
            let u = uvec2(x, y);
            let d = match z & 1 {
                0 => uniform_hemisphere(u),
                _ => cosine_hemisphere(u),
            };
            let up = if z & 2 == 0 { d.z } else { -d.z };
            [d.x.to_bits(), d.y.to_bits(), up.to_bits(), w]
        }
    }
}
