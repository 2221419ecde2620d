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

    /// What it is, in a line.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Random => "random numbers by counter, Philox-4x32-10",
            Self::RandomFast => "random numbers by counter, pcg4d with half a third round: faster",
            Self::Pcg32 => "random numbers in sequence, PCG32",
            Self::Stratified => "one jittered point per cell of a grid; a fixed number",
            Self::LatinHypercube => "one point per stratum of each axis; a fixed number",
            Self::MultiJittered => "correlated multi-jittered; m x n points",
            Self::VanDerCorput => "radical inverse in one base; one dimension",
            Self::Halton => "radical inverses in the first primes; any number of points",
            Self::Hammersley => "k/N and radical inverses; the number of points is fixed",
            Self::Sobol => "digital sequence in base 2; any number, best powers of two",
            Self::Pmj02 => "shuffled and scrambled Sobol pair; any number of points",
            Self::Lattice => "embedded rank-1 lattice; to 2^20, best powers of two",
            Self::Korobov => "rank-1 lattice of one generator; a fixed number of points",
            Self::R2 => "additive recurrence of the plastic number's kin; any number",
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

    /// Whether it is a set of a fixed number of points.
    #[must_use]
    pub fn is_set(self) -> bool {
        matches!(
            self,
            Self::Hammersley
                | Self::Stratified
                | Self::LatinHypercube
                | Self::MultiJittered
                | Self::Korobov
        )
    }
}

/// Dimensions of sequences whose definition has no end: 2^16, a row of 256 KiB.
const MOST_DIMENSIONS: u32 = 1 << 16;
