//! Kernels of points whose results are stored as 64-bit integers, for devices of the CPU kind.

use super::super::{Family, Kernel, Profile};
use super::constants::{OUTPUT, PART, PLACES, ROW, TILE, WIDE_RESULTS};
use super::points::points;

macro_rules! wide {
    ($family:expr, $suffix:literal, $columns:literal, $text:literal, $points:literal) => {
        Kernel {
            name: concat!("generate_wide_", $text, $suffix),
            source: "generate_wide.comp",
            defines: &[("WIDE_COLUMNS", $text), ("WIDE_POINTS", $points)],
            bindings: &[WIDE_RESULTS],
            constants: if $columns < 8 {
                &[OUTPUT]
            } else {
                &[OUTPUT, ROW, PART]
            },
            columns: Some(($family, $columns)),
            profile: Profile::Wide,
            ..points()
        }
    };
}

macro_rules! eight {
    ($family:expr, $suffix:literal, $columns:literal, $text:literal, $bindings:expr) => {
        Kernel {
            name: concat!("generate_eight_", $text, $suffix),
            source: "generate_eight.comp",
            defines: &[("TILE_COLUMNS", $text)],
            bindings: $bindings,
            constants: &[OUTPUT, TILE],
            columns: Some(($family, $columns)),
            profile: Profile::Wide,
            ..points()
        }
    };
}

/// One per width: without a loop over points, of the families whose points take few instructions;
/// and of tiles, where these stores gain something: of radical inverses, and permuted ones of up to
/// three columns. Points that take longer hide their stores.
#[rustfmt::skip]
pub(super) const WIDE: &[Kernel] = &[
    wide!(Family::Radical, "", 1, "1", "32"),
    wide!(Family::Radical, "", 2, "2", "16"),
    wide!(Family::Net, "_net", 1, "1", "32"),
    wide!(Family::Net, "_net", 2, "2", "16"),
    wide!(Family::Net, "_net", 3, "3", "16"),
    wide!(Family::Net, "_net", 4, "4", "8"),
    wide!(Family::Net, "_net", 8, "8", "8"),
    wide!(Family::Net, "_net", 16, "16", "4"),
    wide!(Family::Random, "_random", 1, "1", "32"),
    wide!(Family::Random, "_random", 2, "2", "16"),
    wide!(Family::Random, "_random", 3, "3", "16"),
    wide!(Family::Random, "_random", 4, "4", "8"),
    wide!(Family::Lattice, "_lattice", 1, "1", "32"),
    wide!(Family::Lattice, "_lattice", 2, "2", "16"),
    wide!(Family::Lattice, "_lattice", 3, "3", "16"),
    wide!(Family::Lattice, "_lattice", 4, "4", "8"),
    eight!(Family::Radical, "", 1, "1", &[WIDE_RESULTS]),
    eight!(Family::Radical, "", 2, "2", &[WIDE_RESULTS]),
    eight!(Family::Radical, "", 3, "3", &[WIDE_RESULTS]),
    eight!(Family::Radical, "", 4, "4", &[WIDE_RESULTS]),
    eight!(Family::Digits, "_digits", 1, "1", &[WIDE_RESULTS, PLACES]),
    eight!(Family::Digits, "_digits", 2, "2", &[WIDE_RESULTS, PLACES]),
    eight!(Family::Digits, "_digits", 3, "3", &[WIDE_RESULTS, PLACES]),
];
