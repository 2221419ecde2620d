//! Kernels of points whose results are stored as 64-bit integers, for devices of the CPU kind.

use super::super::{Family, Kernel, Profile};
use super::constants::{OUTPUT, PART, ROW, WIDE_RESULTS};
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

/// One per width, of the families whose points take few instructions.
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
];
