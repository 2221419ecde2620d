//! The kernels that make points, for each family of columns.

use super::super::{FAMILIES, Family, Kernel, Profile};
use super::constants::{
    COEFFICIENTS, COLUMNS, COORDINATES, DIMENSIONS, ESTIMATE, FEW_COLUMNS, FIRST_COLUMN, INTEGRAND,
    MAP, OUTPUT, PIXEL_ROWS, PLACES, RESULTS, ROW_WORDS, SIDE_BY_SIDE, SKIPPED, TABLES, TILE,
    WIDE_COEFFICIENTS, WITH_PDF, WORK,
};

/// The kernels of a family that make points: the general one, tiles of one to four
/// columns, tiles of two that a map follows, in both profiles, and estimates: the general
/// one, tiles of one to four columns, the general one of each group of integrands of
/// rendering, that of more columns than a uniform block holds, and that of pictures.
pub(super) const POINT_KERNELS: usize = 16;

macro_rules! point_kernels {
    ($family:expr, $suffix:literal, $bindings:expr) => {
        [
            Kernel {
                name: concat!("generate", $suffix),
                source: "generate.comp",
                defines: &[("COLUMN_TABLE", "1")],
                bindings: &[RESULTS, COLUMNS],
                constants: &[OUTPUT, DIMENSIONS],
                columns: Some(($family, 0)),
                ..points()
            },
            Kernel {
                name: concat!("generate_tile_1", $suffix),
                defines: &[("TILE_COLUMNS", "1")],
                bindings: $bindings,
                columns: Some(($family, 1)),
                ..points()
            },
            Kernel {
                name: concat!("generate_tile_2", $suffix),
                defines: &[("TILE_COLUMNS", "2")],
                bindings: $bindings,
                columns: Some(($family, 2)),
                ..points()
            },
            Kernel {
                name: concat!("generate_tile_3", $suffix),
                defines: &[("TILE_COLUMNS", "3")],
                bindings: $bindings,
                columns: Some(($family, 3)),
                ..points()
            },
            Kernel {
                name: concat!("generate_tile_4", $suffix),
                defines: &[("TILE_COLUMNS", "4")],
                bindings: $bindings,
                constants: &[OUTPUT, TILE, ROW_WORDS, FIRST_COLUMN, SKIPPED],
                columns: Some(($family, 4)),
                ..points()
            },
            Kernel {
                name: concat!("fused", $suffix),
                source: "fused.comp",
                defines: &[("TILE_COLUMNS", "2")],
                constants: &[MAP, WITH_PDF, TILE, COORDINATES],
                columns: Some(($family, 2)),
                ..points()
            },
            Kernel {
                name: concat!("fused_native", $suffix),
                source: "fused.comp",
                defines: &[("TILE_COLUMNS", "2"), ("KERNEL_NATIVE", "1")],
                constants: &[MAP, WITH_PDF, TILE, COORDINATES],
                columns: Some(($family, 2)),
                profile: Profile::Native,
                ..points()
            },
            Kernel {
                name: concat!("estimate", $suffix),
                defines: &[("COLUMN_TABLE", "1")],
                columns: Some(($family, 0)),
                ..estimates()
            },
            Kernel {
                name: concat!("estimate_tile_1", $suffix),
                defines: &[("COLUMN_TABLE", "1"), ("TILE_COLUMNS", "1")],
                columns: Some(($family, 0)),
                shapes: 1,
                ..estimates()
            },
            Kernel {
                name: concat!("estimate_tile_2", $suffix),
                defines: &[("COLUMN_TABLE", "1"), ("TILE_COLUMNS", "2")],
                columns: Some(($family, 0)),
                shapes: 2,
                ..estimates()
            },
            Kernel {
                name: concat!("estimate_tile_3", $suffix),
                defines: &[("COLUMN_TABLE", "1"), ("TILE_COLUMNS", "3")],
                columns: Some(($family, 0)),
                shapes: 3,
                ..estimates()
            },
            Kernel {
                name: concat!("estimate_tile_4", $suffix),
                defines: &[("COLUMN_TABLE", "1"), ("TILE_COLUMNS", "4")],
                columns: Some(($family, 0)),
                shapes: 4,
                ..estimates()
            },
            Kernel {
                name: concat!("estimate_environment", $suffix),
                defines: &[("COLUMN_TABLE", "1"), ("RENDER_ENVIRONMENT", "1")],
                bindings: &[RESULTS, FEW_COLUMNS, COEFFICIENTS, TABLES],
                columns: Some(($family, 0)),
                ..estimates()
            },
            Kernel {
                name: concat!("estimate_scene", $suffix),
                defines: &[("COLUMN_TABLE", "1"), ("RENDER_SCENE", "1")],
                columns: Some(($family, 0)),
                ..estimates()
            },
            Kernel {
                name: concat!("estimate_wide", $suffix),
                defines: &[("COLUMN_TABLE", "1")],
                bindings: &[RESULTS, COLUMNS, WIDE_COEFFICIENTS],
                columns: Some(($family, 0)),
                ..estimates()
            },
            Kernel {
                name: concat!("estimate_pixels", $suffix),
                defines: &[
                    ("COLUMN_TABLE", "1"),
                    ("RENDER_SCENE", "1"),
                    ("PIXELS", "1"),
                ],
                bindings: &[RESULTS, COLUMNS, WIDE_COEFFICIENTS],
                constants: &[DIMENSIONS, TILE, INTEGRAND, PIXEL_ROWS],
                columns: Some(($family, 0)),
                ..estimates()
            },
        ]
    };
}

/// What most kernels that make points have in common.
pub(super) const fn points() -> Kernel {
    Kernel {
        name: "",
        source: "generate_tile.comp",
        defines: &[],
        local_size: 64,
        push: WORK,
        bindings: &[RESULTS],
        constants: &[OUTPUT, TILE],
        columns: None,
        shapes: 0,
        profile: Profile::Integer,
    }
}

/// What the kernels that estimate have in common.
const fn estimates() -> Kernel {
    Kernel {
        source: "estimate.comp",
        push: ESTIMATE,
        bindings: &[RESULTS, FEW_COLUMNS, COEFFICIENTS],
        constants: &[DIMENSIONS, TILE, INTEGRAND, SIDE_BY_SIDE],
        ..points()
    }
}

pub(super) const POINTS_OF: [[Kernel; POINT_KERNELS]; FAMILIES.len()] = [
    point_kernels!(Family::Radical, "", &[RESULTS]),
    point_kernels!(Family::Net, "_net", &[RESULTS]),
    point_kernels!(Family::Random, "_random", &[RESULTS]),
    point_kernels!(Family::Strata, "_strata", &[RESULTS]),
    point_kernels!(Family::Digits, "_digits", &[RESULTS, PLACES]),
    point_kernels!(Family::Lattice, "_lattice", &[RESULTS]),
];
