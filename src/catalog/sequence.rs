//! The sequences.

use crate::Result;
use crate::tables::PRIMES;

/// A sequence or set of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sequence {
    /// van der Corput 1935: one radical inverse.
    VanDerCorput,
    /// Halton 1960: one radical inverse per dimension.
    Halton,
    /// Hammersley 1960: k/N and radical inverses.
    Hammersley,
}

/// Every sequence.
pub const SEQUENCES: &[Sequence] = &[
    Sequence::VanDerCorput,
    Sequence::Halton,
    Sequence::Hammersley,
];

impl Sequence {
    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::VanDerCorput => "vdc",
            Self::Halton => "halton",
            Self::Hammersley => "hammersley",
        }
    }

    /// What it is, in a line.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::VanDerCorput => "radical inverse in one base; one dimension",
            Self::Halton => "radical inverses in the first primes; any number of points",
            Self::Hammersley => "k/N and radical inverses; the number of points is fixed",
        }
    }

    /// The sequence with this name.
    ///
    /// # Errors
    /// [`crate::Error::UnknownName`], with the nearest name.
    pub fn from_name(name: &str) -> Result<Self> {
        SEQUENCES
            .iter()
            .copied()
            .find(|sequence| sequence.name() == name)
            .ok_or_else(|| {
                let known: Vec<&str> = SEQUENCES.iter().map(|s| s.name()).collect();
                crate::Error::unknown_name("sequence", name, &known)
            })
    }

    /// The fewest and the most dimensions.
    #[must_use]
    pub fn dimensions(self) -> (u32, u32) {
        let primes = PRIMES.len() as u32;
        match self {
            Self::VanDerCorput => (1, 1),
            Self::Halton => (1, primes),
            Self::Hammersley => (1, primes + 1),
        }
    }

    /// Dimensions where none are asked for.
    #[must_use]
    pub fn default_dimensions(self) -> u32 {
        match self {
            Self::VanDerCorput => 1,
            Self::Halton | Self::Hammersley => 2,
        }
    }
}
