//! The sequences.

use super::Scramble;
use crate::tables::{PRIMES, SOBOL_DIMENSIONS, lattice_vector};
use crate::{Error, Result};

/// A sequence or set of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sequence {
    /// Random numbers by counter: Philox-4x32-10, Salmon et al. 2011.
    Random,
    /// Random numbers by counter: pcg4d, Jarzynski and Olano 2020, and half a third round.
    RandomFast,
    /// Random numbers in sequence: PCG32, O'Neill 2014.
    Pcg32,
    /// Jittered strata on a grid.
    Stratified,
    /// Latin hypercube, McKay, Beckman and Conover 1979.
    LatinHypercube,
    /// Correlated multi-jittered, Kensler 2013.
    MultiJittered,
    /// van der Corput 1935: one radical inverse.
    VanDerCorput,
    /// Halton 1960: one radical inverse per dimension.
    Halton,
    /// Hammersley 1960: k/N and radical inverses.
    Hammersley,
    /// Sobol 1967, with the numbers of Joe and Kuo 2008.
    Sobol,
    /// Progressive multi-jittered (0,2): a shuffled and scrambled Sobol pair.
    Pmj02,
    /// Embedded rank-1 lattice in base 2.
    Lattice,
    /// Korobov lattice of a fixed number of points.
    Korobov,
    /// Additive recurrence, Roberts 2018.
    R2,
}

/// Every sequence.
pub const SEQUENCES: &[Sequence] = &[
    Sequence::Random,
    Sequence::RandomFast,
    Sequence::Pcg32,
    Sequence::Stratified,
    Sequence::LatinHypercube,
    Sequence::MultiJittered,
    Sequence::VanDerCorput,
    Sequence::Halton,
    Sequence::Hammersley,
    Sequence::Sobol,
    Sequence::Pmj02,
    Sequence::Lattice,
    Sequence::Korobov,
    Sequence::R2,
];

const RADICAL: &[Scramble] = &[
    Scramble::None,
    Scramble::Faure,
    Scramble::Permute,
    Scramble::Owen,
    Scramble::Start,
];
const NET: &[Scramble] = &[
    Scramble::None,
    Scramble::Shift,
    Scramble::Matrix,
    Scramble::Owen,
    Scramble::OwenHash,
];
const ROTATION: &[Scramble] = &[Scramble::None, Scramble::Rotate];

impl Sequence {
    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::RandomFast => "random-fast",
            Self::Pcg32 => "pcg32",
            Self::Stratified => "stratified",
            Self::LatinHypercube => "latin-hypercube",
            Self::MultiJittered => "cmj",
            Self::VanDerCorput => "vdc",
            Self::Halton => "halton",
            Self::Hammersley => "hammersley",
            Self::Sobol => "sobol",
            Self::Pmj02 => "pmj02",
            Self::Lattice => "lattice",
            Self::Korobov => "korobov",
            Self::R2 => "r2",
        }
    }

    /// The sequence with this name.
    ///
    /// # Errors
    /// [`Error::UnknownName`], with the nearest name.
    pub fn from_name(name: &str) -> Result<Self> {
        let found = SEQUENCES.iter().find(|sequence| sequence.name() == name);
        found.copied().ok_or_else(|| {
            let known: Vec<&str> = SEQUENCES.iter().map(|s| s.name()).collect();
            Error::unknown_name("sequence", name, &known)
        })
    }

    /// The fewest and the most dimensions.
    #[must_use]
    pub fn dimensions(self) -> (u32, u32) {
        let primes = PRIMES.len() as u32;
        match self {
            Self::Random | Self::RandomFast | Self::Pcg32 => (1, MOST_DIMENSIONS),
            Self::Stratified => (1, 32),
            Self::LatinHypercube => (1, MOST_DIMENSIONS),
            Self::VanDerCorput => (1, 1),
            Self::Halton => (1, primes),
            Self::Hammersley => (1, primes + 1),
            Self::MultiJittered | Self::Pmj02 => (2, 2),
            Self::Sobol => (1, SOBOL_DIMENSIONS),
            Self::Lattice => (1, lattice_vector().len() as u32),
            Self::Korobov => (1, MOST_DIMENSIONS),
            Self::R2 => (1, 16),
        }
    }

    /// Dimensions where none are asked for.
    #[must_use]
    pub fn default_dimensions(self) -> u32 {
        if self == Self::VanDerCorput { 1 } else { 2 }
    }

    /// Its scrambles; the first is the default, unless [`Self::default_scramble`] says
    /// otherwise. Empty where every point is random by itself.
    #[must_use]
    pub fn scrambles(self) -> &'static [Scramble] {
        match self {
            Self::VanDerCorput | Self::Halton => RADICAL,
            Self::Sobol => NET,
            Self::Lattice | Self::Korobov | Self::R2 => ROTATION,
            Self::Hammersley => &[Scramble::None],
            _ => &[],
        }
    }

    /// The scramble where none is asked for: a seed given to a lattice rotates it.
    #[must_use]
    pub fn default_scramble(self, seeded: bool) -> Scramble {
        match self {
            Self::Lattice | Self::Korobov | Self::R2 if seeded => Scramble::Rotate,
            _ => Scramble::None,
        }
    }

    /// Options of the command line that not every sequence takes.
    #[must_use]
    pub fn options(self) -> &'static [&'static str] {
        match self {
            Self::VanDerCorput | Self::Halton => &["--bases"],
            Self::Hammersley => &["--total", "--bases", "--index-first"],
            Self::Stratified | Self::MultiJittered => &["--total", "--grid"],
            Self::LatinHypercube => &["--total"],
            Self::Korobov => &["--total", "--generator"],
            Self::Sobol => &["--order gray"],
            Self::Random
            | Self::RandomFast
            | Self::Pcg32
            | Self::Pmj02
            | Self::Lattice
            | Self::R2 => &[],
        }
    }

    /// The most points of the whole: of sets whose kernels take the number as a word, one
    /// less than 2^32.
    pub(super) fn most_points(self) -> u64 {
        match self {
            Self::Stratified | Self::LatinHypercube | Self::MultiJittered | Self::Korobov => {
                (1 << 32) - 1
            }
            _ => 1 << 32,
        }
    }
}

/// Dimensions of sequences whose definition has no end: 2^16, a row of 256 KiB.
const MOST_DIMENSIONS: u32 = 1 << 16;
