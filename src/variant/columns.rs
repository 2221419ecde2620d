//! The words that tell a kernel what a column is.

use super::bases::{longest_odometer, odometer_base, radical_base};
use crate::interface::{Column, DigitScramble, Generator, NetScramble, column_kind, purpose};
use crate::reference::hammersley::hammersley_start;
use crate::reference::hash::seed as derived_seed;
use crate::reference::odometer::OdometerBase;
use crate::reference::owen::matrix_scramble;
use crate::reference::radical_inverse::Base;
use crate::tables::sobol_directions;
use glam::UVec2;

/// A column's words, as its family lists them; an odometer only where windows of
/// `window` points have one (0: never).
#[must_use]
pub fn column_words(column: Column, window: u32) -> Vec<u32> {
    match column {
        Column::Reversed | Column::Radical(_) | Column::Grid(_) => radical(column, window),
        Column::Sobol {
            dimension,
            gray,
            scramble,
            seed,
        } => net(dimension, gray, scramble, seed),
        Column::Pmj02 {
            dimension,
            seed: [low, high],
        } => {
            let mut words = vec![column_kind::PMJ02, 0, dimension, low, high, 0];
            words.resize(38, 0);
            words
        }
        Column::Random {
            generator,
            dimension,
            dimensions,
            seed: [low, high],
        } => {
            let kind = match generator {
                Generator::Philox => column_kind::PHILOX,
                Generator::Pcg4d => column_kind::PCG4D,
                Generator::Pcg32 => column_kind::PCG32,
            };
            vec![kind, dimension, dimensions, low, high]
        }
        Column::Stratified {
            stride,
            strata,
            dimension,
            seed: [low, high],
        } => {
            let kind = column_kind::STRATIFIED;
            vec![kind, dimension, low, high, stride, strata, 0, 1, 1]
        }
        Column::LatinHypercube {
            count,
            dimension,
            seed: [low, high],
            permutation,
        } => {
            let kind = column_kind::LATIN_HYPERCUBE;
            vec![kind, dimension, low, high, 1, count, permutation, 1, 1]
        }
        Column::MultiJittered {
            grid: [x, y],
            dimension,
            seed: [low, high],
            permutation,
        } => {
            let kind = column_kind::MULTI_JITTERED;
            vec![kind, dimension, low, high, 1, x * y, permutation, x, y]
        }
        Column::Digits {
            base,
            scramble,
            seed,
        } => digits(base, scramble, seed, window),
        Column::Lattice { z, shift } => vec![column_kind::LATTICE, z, 0, 1, shift],
        Column::Korobov { z, count, shift } => {
            let kind = match shift {
                None => column_kind::KOROBOV,
                Some(_) => column_kind::KOROBOV_ROTATED,
            };
            vec![kind, z, 0, count, shift.unwrap_or(0)]
        }
        Column::Additive { alpha, shift } => {
            let (low, high) = (alpha as u32, (alpha >> 32) as u32);
            vec![column_kind::ADDITIVE, low, high, 1, shift]
        }
    }
}

/// The words of columns as the table of a kernel has them, in whole rows and without
/// odometers.
#[must_use]
pub fn column_table(columns: &[Column]) -> Vec<u32> {
    columns
        .iter()
        .flat_map(|&one| padded(column_words(one, 0)))
        .collect()
}

/// A column's words in whole rows.
pub(super) fn padded(mut words: Vec<u32>) -> Vec<u32> {
    words.resize(words.len().next_multiple_of(4), 0);
    words
}

/// Points that an invocation makes in a row at most; of those that it stores it makes fewer.
pub const LONGEST_RUN: u32 = 240;

/// Points that an invocation stores in a row at most. Its neighbours in a vector write so far
/// apart, and from 200 points on some distances took llvmpipe half as long again.
pub const STORED_RUN: u32 = 192;

/// Points that an invocation may make in a row, a multiple of 8: as many as the column's
/// odometer allows, just below 3^5, 5^3 or 7^2; and so few of the costly kinds that the loops of four
/// columns stay below the 65,535 iterations after which llvmpipe ends an invocation.
#[must_use]
pub fn longest_run(column: &Column) -> u32 {
    match column {
        // Without one 16 points cost the same in any length.
        Column::Radical(prime) => {
            longest_odometer(*prime).map_or(16, |power| (power / 8 * 8).clamp(16, LONGEST_RUN))
        }
        // 50 rounds of Philox a value, 64 steps, or 32 steps of long division.
        Column::Sobol {
            scramble: NetScramble::Owen,
            ..
        }
        | Column::Pmj02 { .. }
        | Column::Random {
            generator: Generator::Pcg32,
            ..
        }
        | Column::Korobov { .. } => 48,
        // Two long divisions and a permutation a value; or one permutation per digit.
        Column::Stratified { .. }
        | Column::LatinHypercube { .. }
        | Column::MultiJittered { .. }
        | Column::Digits { .. } => 16,
        _ => LONGEST_RUN,
    }
}

/// Iterations of loops that a coordinate takes at most, without an odometer, where the turn
/// that leaves a loop counts; of permutations, which walk until they are within, so many that
/// hardly any takes more.
pub(super) fn turns(column: &Column) -> u32 {
    match column {
        // Four groups of digits.
        Column::Radical(prime) => 4 * (radical_base(*prime).digits + 1),
        Column::Sobol {
            scramble: NetScramble::Owen,
            ..
        } => OWEN_TURNS,
        // One block more for the order of the points.
        Column::Pmj02 { .. } => 2 * OWEN_TURNS,
        Column::Random { generator, .. } => match generator {
            Generator::Philox => PHILOX_TURNS,
            Generator::Pcg4d => 0,
            Generator::Pcg32 => 65,
        },
        // A long division.
        Column::Grid(_) | Column::Korobov { .. } => 33,
        // A walk takes ten, and every other leaves.
        Column::Stratified { .. }
        | Column::LatinHypercube { .. }
        | Column::MultiJittered { .. }
        | Column::Digits { .. } => 300,
        _ => 0,
    }
}

const PHILOX_TURNS: u32 = 11;

/// Five blocks of Philox, with five levels of each, of which four are in a loop.
const OWEN_TURNS: u32 = 5 * (PHILOX_TURNS + 6) + 5;

/// A coordinate of the Sobol sequence by direction numbers that hold all that is linear in the
/// index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LinearNet {
    /// What bit i of the index contributes, by exclusive or: a fraction of 2^32, for
    /// [`NetScramble::OwenHash`] with its bits in reverse order.
    pub directions: [u32; 32],
    /// What every point has besides.
    pub shift: u32,
    /// The seed of the hash, where one scrambles.
    pub hash: u32,
}

/// Bit b of the index sets bits b and b - 1 of its Gray code, and a matrix times a sum is the
/// sum of its products. Scrambling by [`NetScramble::Owen`] is not linear, and is left to do.
#[must_use]
pub fn linear_net(dimension: u32, gray: bool, scramble: NetScramble, seed: UVec2) -> LinearNet {
    let mut directions = sobol_directions(dimension);
    if gray {
        for bit in (1..32).rev() {
            directions[bit] ^= directions[bit - 1];
        }
    }
    if scramble == NetScramble::Matrix {
        directions = directions.map(|v| matrix_scramble(v, dimension, seed));
    }
    // The hash takes its digits in reverse order, which is linear too.
    if scramble == NetScramble::OwenHash {
        directions = directions.map(u32::reverse_bits);
    }
    LinearNet {
        directions,
        shift: match scramble {
            NetScramble::Shift => derived_seed(seed, dimension, purpose::SHIFT),
            NetScramble::Matrix => derived_seed(seed, dimension, purpose::MATRIX_SHIFT),
            _ => 0,
        },
        hash: derived_seed(seed, dimension, purpose::OWEN_HASH),
    }
}

fn net(dimension: u32, gray: bool, scramble: NetScramble, seed: [u32; 2]) -> Vec<u32> {
    let seed = UVec2::from(seed);
    let net = linear_net(dimension, gray, scramble, seed);
    let kind = match scramble {
        NetScramble::None | NetScramble::Shift | NetScramble::Matrix => column_kind::SOBOL,
        NetScramble::Owen => column_kind::SOBOL_OWEN,
        NetScramble::OwenHash => column_kind::SOBOL_OWEN_HASH,
    };
    let mut words = vec![kind, net.shift, dimension, seed.x, seed.y, net.hash];
    words.extend(net.directions);
    words
}

/// Permutations of positions are the same for all points, so that only the lowest digits are
/// permuted anew within `window` points.
fn digits(base: u32, scramble: DigitScramble, seed: u32, window: u32) -> Vec<u32> {
    let kind = match scramble {
        DigitScramble::Faure => column_kind::FAURE,
        DigitScramble::Permuted => column_kind::PERMUTED,
        DigitScramble::Owen => column_kind::OWEN,
        DigitScramble::Started => column_kind::STARTED,
    };
    let r = radical_base(base);
    let (mut low, mut block) = (0, 1);
    while block < window && low < r.digits && kind == column_kind::PERMUTED {
        block *= r.base;
        low += 1;
    }
    let mut words = vec![kind, seed, low, block, 0];
    words.extend(base_words(r));
    words
}

/// What kernels divide by a base and by its largest power with.
fn base_words(r: Base) -> [u32; 7] {
    [
        r.base,
        r.digits,
        r.power,
        r.base_magic,
        r.base_shift,
        r.power_magic,
        r.power_shift,
    ]
}

fn radical(column: Column, window: u32) -> Vec<u32> {
    let mut base = OdometerBase {
        radical: radical_base(2),
        power: 1,
        ..OdometerBase::default()
    };
    let kind = match column {
        Column::Radical(prime) => {
            base.radical = radical_base(prime);
            match odometer_base(prime, window).filter(|_| window > 0) {
                Some(odometer) => {
                    base = odometer;
                    column_kind::ODOMETER
                }
                None => column_kind::RADICAL,
            }
        }
        Column::Grid(count) => {
            // 2^32 is written as 0; N = 1 has no point 1, and takes no step.
            let written = count as u32;
            let step = hammersley_start(u32::from(written != 1), written);
            base.power = written;
            base.quotient = step.fraction;
            base.fraction = step.remainder;
            column_kind::GRID
        }
        _ => column_kind::REVERSED,
    };
    let mut words = vec![kind];
    words.extend(base_words(base.radical));
    words.extend([base.power, base.quotient, base.fraction]);
    words
}
