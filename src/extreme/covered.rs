//! Extreme inputs that are no rows here, and what tests them.

/// What covers a number of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// A test of this repository: its file, and its function. Where the input says `--ignored`, it
    /// runs when asked alone.
    Test {
        /// The file.
        file: &'static str,
        /// The function.
        name: &'static str,
    },
    /// Rows of `corput check`: what to give `--only`.
    Check {
        /// A name of the catalogue.
        only: &'static str,
    },
}

impl std::fmt::Display for By {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Test { file, name } => write!(f, "{name} of {file}"),
            Self::Check { only } => write!(f, "corput check --only {only}"),
        }
    }
}

/// A number of the catalogue that `corput check --extreme` does not judge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Covered {
    /// The number.
    pub number: u32,
    /// The input.
    pub input: &'static str,
    /// What tests it.
    pub by: By,
}

const fn test(number: u32, input: &'static str, file: &'static str, name: &'static str) -> Covered {
    Covered {
        number,
        input,
        by: By::Test { file, name },
    }
}

const fn check(number: u32, input: &'static str, only: &'static str) -> Covered {
    Covered {
        number,
        input,
        by: By::Check { only },
    }
}

/// All of them. They are never counted as passed.
pub const COVERED: &[Covered] = &[
    test(
        1,
        "2^32 indices in a loop of 32 bits (--ignored)",
        "tests/gpu/estimate.rs",
        "x_squared_over_all_points_is_its_closed_form",
    ),
    test(
        5,
        "points at the edges of elementary intervals",
        "tests/cpu/sequences.rs",
        "elementary_intervals_hold_one_point_each",
    ),
    test(
        6,
        "pairs of high bases of Halton, at indices below both",
        "tests/cpu/sequences.rs",
        "pairs_of_high_bases_lie_on_lines_until_permuted",
    ),
    check(7, "shifts by 32 and more", "shl64"),
    test(
        8,
        "strata that a float fraction leaves",
        "tests/cpu/strata.rs",
        "each_stratum_holds_one_point",
    ),
    test(
        9,
        "a rotation just below 0",
        "tests/cpu/lattice.rs",
        "a_rotation_wraps",
    ),
    test(
        10,
        "integers of NaN and of 2^32",
        "tests/cpu/spirv.rs",
        "each_forbidden_operation_is_caught_in_its_function",
    ),
    test(
        11,
        "indices of 2^31 and more (--ignored)",
        "tests/gpu/estimate.rs",
        "x_squared_over_all_points_is_its_closed_form",
    ),
    test(
        42,
        "sums of terms that floats would swallow",
        "tests/cpu/estimate.rs",
        "sums_of_hostile_terms_are_exact",
    ),
    test(
        43,
        "sums in groups of any size",
        "tests/gpu/estimate.rs",
        "no_size_of_a_group_shows",
    ),
    test(
        44,
        "the variance under a large mean",
        "tests/cpu/estimate.rs",
        "the_variance_under_a_large_mean_is_exact",
    ),
    test(
        45,
        "an integrand without a variance",
        "tests/cpu/converge.rs",
        "infinite_variance_is_reported_by_the_median",
    ),
    check(46, "a peak that few points meet", "gaussian-peak"),
    check(47, "a checkerboard of 2^k cells", "checkerboard"),
    test(
        48,
        "a wave of as many periods as points",
        "tests/cpu/estimate.rs",
        "a_wave_of_as_many_periods_as_points_needs_a_scramble",
    ),
    check(49, "the step of a disk", "disk-step"),
    check(
        50,
        "products of peaks in many dimensions",
        "genz-product-peak",
    ),
    check(51, "the integrand of Keister", "keister"),
    check(52, "the function of Ishigami", "ishigami"),
    check(53, "products that vanish in many dimensions", "sobol-g"),
    check(55, "a product of 1000 dimensions", "product"),
];
