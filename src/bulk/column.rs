//! Columns on the CPU, each value by the twin of its header.

use crate::interface::{Column, DigitScramble, Generator, NetScramble, column_kind, purpose};
use crate::reference::fixed::{add64, mul64};
use crate::reference::hash::seed as derived_seed;
use crate::reference::lattice::{additive, korobov, lattice, rotate};
use crate::reference::owen::{digital_shift, matrix_scramble, owen, owen_hash};
use crate::reference::pmj02::pmj02;
use crate::reference::radical_inverse::{Base, radical_inverse_table, van_der_corput};
use crate::reference::scrambled_radical_inverse::{
    radical_inverse_faure, radical_inverse_owen, radical_inverse_permuted, radical_inverse_started,
};
use crate::reference::sobol::{gray, sobol};
use crate::reference::stratified::{cmj, latin_hypercube, stratified, unit_stratum};
use crate::reference::{hammersley, random, unit};
use crate::tables::sobol_directions;
use crate::variant::radical_base;
use glam::{UVec2, uvec2};

/// A column with the constants that its values share.
#[derive(Clone, Debug)]
pub enum Prepared {
    Radical(Base),
    Sobol(Box<Sobol>),
    Plain(Column),
}

/// Where the float of a fraction lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// At it or below.
    Down,
    /// At it or above, and below 1.
    Up,
    /// In its stratum, of so many; 2^32 is written as 0.
    Within(u32),
}

/// A coordinate of the Sobol sequence with its direction numbers.
#[derive(Clone, Debug)]
pub struct Sobol {
    directions: [u32; 32],
    dimension: u32,
    gray: bool,
    scramble: NetScramble,
    seed: UVec2,
}

impl Prepared {
    pub fn new(column: &Column) -> Self {
        match *column {
            Column::Radical(base) => Self::Radical(radical_base(base)),
            Column::Sobol {
                dimension,
                gray,
                scramble,
                seed,
            } => Self::Sobol(Box::new(Sobol {
                directions: sobol_directions(dimension),
                dimension,
                gray,
                scramble,
                seed: UVec2::from(seed),
            })),
            column => Self::Plain(column),
        }
    }

    /// The value at index n, a fraction of 2^32.
    pub fn fraction(&self, n: u32) -> u32 {
        match self {
            Self::Radical(base) => radical_inverse_table(n, *base),
            Self::Sobol(column) => column.value(n),
            Self::Plain(column) => plain(n, *column),
        }
    }

    /// How its values become floats.
    pub fn rounding(&self) -> Rounding {
        match self {
            Self::Radical(_) => Rounding::Up,
            Self::Sobol(_) => Rounding::Down,
            Self::Plain(column) => match *column {
                Column::Grid(_) | Column::Korobov { shift: None, .. } => Rounding::Up,
                Column::Digits {
                    base,
                    scramble: DigitScramble::Faure,
                    ..
                } if base != 2 => Rounding::Up,
                Column::Stratified { strata, .. } => Rounding::Within(strata),
                Column::LatinHypercube { count, .. } => Rounding::Within(count),
                Column::MultiJittered { grid: [x, y], .. } => Rounding::Within(x * y),
                _ => Rounding::Down,
            },
        }
    }

    /// That value as a float in [0, 1).
    pub fn unit(&self, u: u32) -> f32 {
        match self.rounding() {
            Rounding::Down => unit::unit_floor(u),
            Rounding::Up => unit::unit_ceil(u),
            Rounding::Within(strata) => unit_stratum(u, strata),
        }
    }
}

impl Sobol {
    /// The scrambles one by one, where the kernels fold what is linear into the directions.
    fn value(&self, n: u32) -> u32 {
        let (dimension, seed) = (self.dimension, self.seed);
        let derived = |purpose| derived_seed(seed, dimension, purpose);
        let x = sobol(if self.gray { gray(n) } else { n }, &self.directions);
        match self.scramble {
            NetScramble::None => x,
            NetScramble::Shift => digital_shift(x, derived(purpose::SHIFT)),
            NetScramble::Matrix => digital_shift(
                matrix_scramble(x, dimension, seed),
                derived(purpose::MATRIX_SHIFT),
            ),
            NetScramble::Owen => owen(x, dimension, seed),
            NetScramble::OwenHash => owen_hash(x, derived(purpose::OWEN_HASH)),
        }
    }
}

fn plain(n: u32, column: Column) -> u32 {
    match column {
        Column::Reversed => van_der_corput(n),
        // These two have constants that others share; alone they find them each time.
        Column::Radical(_) | Column::Sobol { .. } => Prepared::new(&column).fraction(n),
        // 2^32 is written as 0.
        Column::Grid(count) => hammersley::hammersley(n, count as u32),
        Column::Digits {
            base,
            scramble,
            seed,
        } => match scramble {
            DigitScramble::Faure => radical_inverse_faure(n, base),
            DigitScramble::Permuted => radical_inverse_permuted(n, base, seed),
            DigitScramble::Owen => radical_inverse_owen(n, base, seed),
            DigitScramble::Started => radical_inverse_started(n, base, seed),
        },
        Column::Pmj02 { dimension, seed } => axis(pmj02(n, UVec2::from(seed)), dimension),
        Column::Random {
            generator,
            dimension,
            dimensions,
            seed,
        } => match generator {
            Generator::Philox => random::random(n, dimension, UVec2::from(seed)),
            Generator::Pcg4d => random::random_fast(n, dimension, UVec2::from(seed)),
            Generator::Pcg32 => {
                let place = add64(mul64(n, dimensions), uvec2(dimension, 0));
                let start = random::pcg32_seed(UVec2::from(seed), uvec2(54, 0));
                random::pcg32_value(random::pcg32_advance(start, place))
            }
        },
        Column::Stratified {
            stride,
            strata,
            dimension,
            seed,
        } => {
            let jitter = jitter(n, dimension, column_kind::STRATIFIED, seed);
            stratified(n, stride, strata, jitter)
        }
        Column::LatinHypercube {
            count,
            dimension,
            seed,
            permutation,
        } => {
            let jitter = jitter(n, dimension, column_kind::LATIN_HYPERCUBE, seed);
            latin_hypercube(n, count, permutation, jitter)
        }
        Column::MultiJittered {
            grid,
            dimension,
            seed,
            permutation,
        } => {
            let both = UVec2::splat(jitter(n, dimension, column_kind::MULTI_JITTERED, seed));
            axis(cmj(n, UVec2::from(grid), permutation, both), dimension)
        }
        Column::Lattice { z, shift } => rotate(lattice(n, z), shift),
        Column::Korobov { z, count, shift } => rotate(korobov(n, z, count), shift.unwrap_or(0)),
        Column::Additive { alpha, shift } => {
            let alpha = uvec2(alpha as u32, (alpha >> 32) as u32);
            rotate(additive(n, alpha), shift)
        }
    }
}

fn jitter(n: u32, dimension: u32, kind: u32, seed: [u32; 2]) -> u32 {
    random::random_of(n, dimension, kind, UVec2::from(seed))
}

fn axis(p: UVec2, dimension: u32) -> u32 {
    if dimension == 0 { p.x } else { p.y }
}
