//! What the columns of points are.

use super::Family;

/// What one column of the points is. All columns are fractions of 2^32. Seeds of two
/// words are those of the request, low word first; a seed or shift of one word has been
/// derived from it for this column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Column {
    /// The radical inverse in base 2.
    Reversed,
    /// The radical inverse in an odd prime base.
    Radical(u32),
    /// k/N, for N up to 2^32.
    Grid(u64),
    /// A radical inverse whose digits are permuted.
    Digits {
        /// A prime.
        base: u32,
        /// How.
        scramble: DigitScramble,
        /// Of the permutations.
        seed: u32,
    },
    /// A coordinate of the Sobol sequence.
    Sobol {
        /// From 0 on.
        dimension: u32,
        /// Order by Gray code.
        gray: bool,
        /// How it is randomised.
        scramble: NetScramble,
        /// The request's seed.
        seed: [u32; 2],
    },
    /// A coordinate of the progressive multi-jittered (0,2) sequence.
    Pmj02 {
        /// 0 or 1.
        dimension: u32,
        /// The request's seed.
        seed: [u32; 2],
    },
    /// Random numbers.
    Random {
        /// Whose.
        generator: Generator,
        /// From 0 on.
        dimension: u32,
        /// Columns of a point, by which a sequential generator steps.
        dimensions: u32,
        /// The request's seed.
        seed: [u32; 2],
    },
    /// A coordinate of jittered strata on a grid.
    Stratified {
        /// Points between steps along this axis.
        stride: u32,
        /// Strata along this axis.
        strata: u32,
        /// From 0 on.
        dimension: u32,
        /// The request's seed.
        seed: [u32; 2],
    },
    /// A coordinate of a Latin hypercube.
    LatinHypercube {
        /// Points of the set, below 2^32.
        count: u32,
        /// From 0 on.
        dimension: u32,
        /// The request's seed.
        seed: [u32; 2],
        /// Of the permutation.
        permutation: u32,
    },
    /// A coordinate of a correlated multi-jittered set.
    MultiJittered {
        /// Cells along x and y.
        grid: [u32; 2],
        /// 0 or 1.
        dimension: u32,
        /// The request's seed.
        seed: [u32; 2],
        /// Of the permutations, the same for both coordinates.
        permutation: u32,
    },
    /// A coordinate of an embedded rank-1 lattice in base 2.
    Lattice {
        /// Entry of the generating vector.
        z: u32,
        /// Cranley-Patterson rotation.
        shift: u32,
    },
    /// A coordinate of a rank-1 lattice of a fixed number of points.
    Korobov {
        /// Entry of the generating vector, below `count`.
        z: u32,
        /// Points, below 2^32.
        count: u32,
        /// Cranley-Patterson rotation; `None` leaves multiples of 1/N.
        shift: Option<u32>,
    },
    /// A coordinate of an additive recurrence.
    Additive {
        /// The step, a fraction of 2^64.
        alpha: u64,
        /// Cranley-Patterson rotation.
        shift: u32,
    },
}

/// How the digits of a radical inverse are permuted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DigitScramble {
    /// Faure's permutation in every place.
    Faure,
    /// A random permutation per place.
    Permuted,
    /// A random permutation per place and digits before it.
    Owen,
    /// A random start of the odometer.
    Started,
}

/// How a coordinate of a net in base 2 is randomised.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NetScramble {
    /// Not at all.
    None,
    /// Digital shift.
    Shift,
    /// Linear matrix scramble, and digital shift.
    Matrix,
    /// Nested uniform scramble.
    Owen,
    /// The fast approximation of it by a hash.
    OwenHash,
}

/// A generator of random numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Generator {
    /// Philox-4x32-10.
    Philox,
    /// pcg4d and half a third round.
    Pcg4d,
    /// PCG32, which is sequential.
    Pcg32,
}

/// What seeds of one word are derived for: the last argument of `corput_seed`. Each use has
/// its own, so that two sequences or scrambles with one seed are not alike. Headers take
/// numbers below 16.
pub mod purpose {
    /// Digital shift.
    pub const SHIFT: u32 = 16;
    /// Digital shift after a matrix scramble.
    pub const MATRIX_SHIFT: u32 = 17;
    /// Nested scramble by a hash.
    pub const OWEN_HASH: u32 = 18;
    /// One permutation per digit's place.
    pub const PERMUTED_DIGITS: u32 = 19;
    /// Nested permutations of digits.
    pub const NESTED_DIGITS: u32 = 20;
    /// Start of a radical inverse.
    pub const START: u32 = 21;
    /// Permutations of a Latin hypercube.
    pub const LATIN_HYPERCUBE: u32 = 22;
    /// Permutations of a correlated multi-jittered set.
    pub const MULTI_JITTERED: u32 = 23;
    /// Rotation of the embedded lattice.
    pub const LATTICE: u32 = 24;
    /// Rotation of a Korobov lattice.
    pub const KOROBOV: u32 = 25;
    /// Rotation of the additive recurrence.
    pub const ADDITIVE: u32 = 26;
    /// Seed of a pixel, whose number is in place of the dimension.
    pub const PIXEL: u32 = 27;
    /// Its upper half.
    pub const PIXEL_HIGH: u32 = 28;
}

impl Column {
    /// The family whose modules make this column.
    #[must_use]
    pub fn family(&self) -> Family {
        match self {
            Self::Reversed | Self::Radical(_) | Self::Grid(_) => Family::Radical,
            Self::Sobol { .. } | Self::Pmj02 { .. } => Family::Net,
            Self::Random { .. } => Family::Random,
            Self::Stratified { .. } | Self::LatinHypercube { .. } | Self::MultiJittered { .. } => {
                Family::Strata
            }
            Self::Digits { .. } => Family::Digits,
            Self::Lattice { .. } | Self::Korobov { .. } | Self::Additive { .. } => Family::Lattice,
        }
    }
}
