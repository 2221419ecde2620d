//! Families of columns, and the words that tell a kernel what a column is.

/// Columns that one module can make; the others are not compiled into it, since a driver
/// takes time for all that it is shown, whether it runs or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// Radical inverses and k/N.
    Radical,
    /// Nets in base 2.
    Net,
    /// Random numbers.
    Random,
    /// Jittered strata.
    Strata,
    /// Radical inverses with permuted digits.
    Digits,
    /// Lattices.
    Lattice,
}

/// Every family, in the order of their numbers.
pub const FAMILIES: [Family; 6] = [
    Family::Radical,
    Family::Net,
    Family::Random,
    Family::Strata,
    Family::Digits,
    Family::Lattice,
];

/// Values of the first word of a column.
pub mod column_kind {
    /// Radical inverse in base 2: bits in reverse.
    pub const REVERSED: u32 = 0;
    /// Radical inverse by the odometer.
    pub const ODOMETER: u32 = 1;
    /// k/N.
    pub const GRID: u32 = 2;
    /// Radical inverse, each from its index.
    pub const RADICAL: u32 = 3;
    /// Sobol, with what is linear in its direction numbers and shift.
    pub const SOBOL: u32 = 4;
    /// Sobol, nested uniform scramble.
    pub const SOBOL_OWEN: u32 = 5;
    /// Sobol, the scramble's fast form.
    pub const SOBOL_OWEN_HASH: u32 = 6;
    /// Progressive multi-jittered (0,2).
    pub const PMJ02: u32 = 7;
    /// Philox-4x32-10.
    pub const PHILOX: u32 = 8;
    /// pcg4d and half a third round.
    pub const PCG4D: u32 = 9;
    /// PCG32.
    pub const PCG32: u32 = 10;
    /// Jittered strata on a grid.
    pub const STRATIFIED: u32 = 11;
    /// Latin hypercube.
    pub const LATIN_HYPERCUBE: u32 = 12;
    /// Correlated multi-jittered.
    pub const MULTI_JITTERED: u32 = 13;
    /// Radical inverse, Faure's permutations.
    pub const FAURE: u32 = 14;
    /// Radical inverse, a permutation per place.
    pub const PERMUTED: u32 = 15;
    /// Radical inverse, nested permutations.
    pub const OWEN: u32 = 16;
    /// Radical inverse, random start.
    pub const STARTED: u32 = 17;
    /// Embedded rank-1 lattice.
    pub const LATTICE: u32 = 18;
    /// Rank-1 lattice of N points, multiples of 1/N.
    pub const KOROBOV: u32 = 19;
    /// The same, rotated.
    pub const KOROBOV_ROTATED: u32 = 20;
    /// Additive recurrence.
    pub const ADDITIVE: u32 = 21;
}

/// A word of a column: its name in the modules that take it as a constant, and the
/// default, with which nothing is undefined.
pub type Word = (&'static str, u32);

const RADICAL: &[Word] = &[
    ("KIND", 0),
    ("BASE", 2),
    ("DIGITS", 15),
    ("GROUP_POWER", 32768),
    ("BASE_MAGIC", 1),
    ("BASE_SHIFT", 0),
    ("POWER_MAGIC", 1),
    ("POWER_SHIFT", 14),
    ("POWER", 1),
    ("QUOTIENT", 0),
    ("FRACTION", 0),
];

#[rustfmt::skip]
const NET: &[Word] = &[
    ("KIND", 4), ("SHIFT", 0), ("DIMENSION", 0), ("SEED_LOW", 0), ("SEED_HIGH", 0), ("HASH", 0),
    ("D0", 0), ("D1", 0), ("D2", 0), ("D3", 0), ("D4", 0), ("D5", 0), ("D6", 0), ("D7", 0),
    ("D8", 0), ("D9", 0), ("D10", 0), ("D11", 0), ("D12", 0), ("D13", 0), ("D14", 0), ("D15", 0),
    ("D16", 0), ("D17", 0), ("D18", 0), ("D19", 0), ("D20", 0), ("D21", 0), ("D22", 0), ("D23", 0),
    ("D24", 0), ("D25", 0), ("D26", 0), ("D27", 0), ("D28", 0), ("D29", 0), ("D30", 0), ("D31", 0),
];

const RANDOM: &[Word] = &[
    ("KIND", 8),
    ("DIMENSION", 0),
    ("DIMENSIONS", 1),
    ("SEED_LOW", 0),
    ("SEED_HIGH", 0),
];

const STRATA: &[Word] = &[
    ("KIND", 11),
    ("DIMENSION", 0),
    ("SEED_LOW", 0),
    ("SEED_HIGH", 0),
    ("STRIDE", 1),
    ("STRATA", 1),
    ("PERMUTATION", 0),
    ("GRID_X", 1),
    ("GRID_Y", 1),
];

const DIGITS: &[Word] = &[
    ("KIND", 14),
    ("SEED", 0),
    ("LOW", 0),
    ("WINDOW", 1),
    ("PLACES", 0),
    ("BASE", 2),
    ("DIGITS", 15),
    ("GROUP_POWER", 32768),
    ("BASE_MAGIC", 1),
    ("BASE_SHIFT", 0),
    ("POWER_MAGIC", 1),
    ("POWER_SHIFT", 14),
];

const LATTICE: &[Word] = &[
    ("KIND", 18),
    ("LOW", 0),
    ("HIGH", 0),
    ("COUNT", 1),
    ("SHIFT", 0),
];

impl Family {
    /// The words of a column, in the order of the general kernels' tables.
    #[must_use]
    pub const fn words(self) -> &'static [Word] {
        match self {
            Self::Radical => RADICAL,
            Self::Net => NET,
            Self::Random => RANDOM,
            Self::Strata => STRATA,
            Self::Digits => DIGITS,
            Self::Lattice => LATTICE,
        }
    }

    /// The words of a column's shape: what neither the seed nor the number of points change,
    /// and what costs if it is not constant, such as divisors.
    #[must_use]
    pub const fn shape(self) -> &'static [&'static str] {
        match self {
            Self::Radical => &[
                "KIND",
                "BASE",
                "DIGITS",
                "GROUP_POWER",
                "BASE_MAGIC",
                "BASE_SHIFT",
                "POWER_MAGIC",
                "POWER_SHIFT",
            ],
            Self::Net | Self::Random | Self::Strata => &["KIND", "DIMENSION"],
            Self::Digits => &[
                "KIND",
                "LOW",
                "WINDOW",
                "BASE",
                "DIGITS",
                "GROUP_POWER",
                "BASE_MAGIC",
                "BASE_SHIFT",
                "POWER_MAGIC",
                "POWER_SHIFT",
            ],
            Self::Lattice => &["KIND"],
        }
    }

    /// Rows of four words that a column takes in the table.
    #[must_use]
    pub const fn rows(self) -> u32 {
        self.words().len().div_ceil(4) as u32
    }

    /// Value of the macro `COLUMN_FAMILY`.
    #[must_use]
    pub const fn number(self) -> u32 {
        self as u32
    }

    /// What the names of its modules end in.
    #[must_use]
    pub const fn suffix(self) -> &'static str {
        match self {
            Self::Radical => "",
            Self::Net => "_net",
            Self::Random => "_random",
            Self::Strata => "_strata",
            Self::Digits => "_digits",
            Self::Lattice => "_lattice",
        }
    }
}

/// Distance of the `constant_id`s of successive columns.
pub const COLUMN_STRIDE: u32 = 64;
