//! The randomisations of sequences.

use crate::{Error, Result};

/// A way to randomise a sequence, or to mend it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scramble {
    /// The sequence as it is.
    None,
    /// Random digital shift: exclusive or with one random word per dimension.
    Shift,
    /// Random linear matrix scramble (Matousek 1998), and digital shift.
    Matrix,
    /// Nested uniform scramble (Owen 1995), exact.
    Owen,
    /// Nested scramble by a hash (Laine and Karras 2011): fast, nearly uniform.
    OwenHash,
    /// Faure's permutations of digits (1992), which are not random.
    Faure,
    /// One random permutation per digit's place.
    Permute,
    /// Random start of each radical inverse (Wang and Hickernell 2000).
    Start,
    /// Cranley-Patterson rotation (1976).
    Rotate,
}

/// Every scramble.
pub const SCRAMBLES: &[Scramble] = &[
    Scramble::None,
    Scramble::Shift,
    Scramble::Matrix,
    Scramble::Owen,
    Scramble::OwenHash,
    Scramble::Faure,
    Scramble::Permute,
    Scramble::Start,
    Scramble::Rotate,
];

impl Scramble {
    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Shift => "shift",
            Self::Matrix => "matrix",
            Self::Owen => "owen",
            Self::OwenHash => "owen-hash",
            Self::Faure => "faure",
            Self::Permute => "permute",
            Self::Start => "start",
            Self::Rotate => "rotate",
        }
    }

    /// Whether the seed changes its points.
    #[must_use]
    pub fn is_random(self) -> bool {
        !matches!(self, Self::None | Self::Faure)
    }

    /// What it does, in a line.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::None => "the sequence as it is",
            Self::Shift => "digital shift: one random word per dimension; fastest",
            Self::Matrix => "random linear matrix and digital shift (Matousek 1998)",
            Self::Owen => "nested uniform scramble, exact (Owen 1995); the best",
            Self::OwenHash => "the same by a hash, fast and nearly uniform (Laine and Karras 2011)",
            Self::Faure => "Faure's permutations of digits (1992), which take no seed",
            Self::Permute => "a random permutation of the digits at each place",
            Self::Start => "a random index to start from (Wang and Hickernell 2000)",
            Self::Rotate => "rotation modulo 1 (Cranley and Patterson 1976)",
        }
    }

    /// The scramble with this name.
    ///
    /// # Errors
    /// [`Error::UnknownName`], with the nearest name.
    pub fn from_name(name: &str) -> Result<Self> {
        let found = SCRAMBLES.iter().find(|scramble| scramble.name() == name);
        found.copied().ok_or_else(|| {
            let known: Vec<&str> = SCRAMBLES.iter().map(|s| s.name()).collect();
            Error::unknown_name("scramble", name, &known)
        })
    }
}

/// The order in which a Sobol sequence is walked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Order {
    /// Point n at place n.
    #[default]
    Natural,
    /// Gray code: neighbours differ in one direction number. The first 2^k places hold
    /// the same points.
    Gray,
}

impl Order {
    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Natural => "natural",
            Self::Gray => "gray",
        }
    }

    /// The order with this name.
    ///
    /// # Errors
    /// [`Error::UnknownName`], with the nearest name.
    pub fn from_name(name: &str) -> Result<Self> {
        [Self::Natural, Self::Gray]
            .into_iter()
            .find(|order| order.name() == name)
            .ok_or_else(|| Error::unknown_name("order", name, &["natural", "gray"]))
    }
}
