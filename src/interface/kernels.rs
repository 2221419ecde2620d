//! The list of stock kernels.

use super::{
    Binding, Constant, Element, FAMILIES, Family, IrradiancePush, Kernel, MaskPush, Member,
    PairsPush, Profile, PushConstants, WorkPush, map, output, pair_kind,
};

const OUTPUT: Constant = Constant {
    id: 0,
    name: "OUTPUT",
    default: output::FLOATS,
};
const MAP: Constant = Constant {
    id: 1,
    name: "MAP",
    default: map::COSINE_HEMISPHERE,
};
const WITH_PDF: Constant = Constant {
    id: 2,
    name: "WITH_PDF",
    default: 0,
};
const TILE: Constant = Constant {
    id: 3,
    name: "TILE",
    default: 16,
};
const DIMENSIONS: Constant = Constant {
    id: 4,
    name: "DIMENSIONS",
    default: 1,
};
const FUNCTION: Constant = Constant {
    id: 5,
    name: "FUNCTION",
    default: 0,
};
const INDEXED: Constant = Constant {
    id: 6,
    name: "INDEXED",
    default: 0,
};

/// uvec4s of a row, of which the kernel writes one.
const ROW: Constant = Constant {
    id: 7,
    name: "ROW",
    default: 1,
};
/// Which of them.
const PART: Constant = Constant {
    id: 8,
    name: "PART",
    default: 0,
};

/// Which discrepancy.
const KIND: Constant = Constant {
    id: 9,
    name: "KIND",
    default: pair_kind::CENTRED,
};
/// Whether distances are on the torus.
const TOROIDAL: Constant = Constant {
    id: 10,
    name: "TOROIDAL",
    default: 1,
};

const RESULTS: Binding = Binding {
    binding: 0,
    name: "results",
    element: Element::Uvec4,
    input: false,
};
const COLUMNS: Binding = Binding {
    binding: 1,
    name: "columns",
    element: Element::Uint,
    input: true,
};
const POINTS: Binding = Binding {
    binding: 1,
    name: "points",
    element: Element::Uvec4,
    input: true,
};
const ARGUMENTS: Binding = Binding {
    binding: 1,
    name: "arguments",
    element: Element::Uvec4,
    input: true,
};

const WORK: &[Member] = WorkPush::MEMBERS;

/// The kernels of a family that make points: the general one, tiles of one to four
/// columns, and tiles of two that a map follows, in both profiles.
const POINT_KERNELS: usize = 7;

macro_rules! point_kernels {
    ($family:expr, $suffix:literal) => {
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
                columns: Some(($family, 1)),
                ..points()
            },
            Kernel {
                name: concat!("generate_tile_2", $suffix),
                defines: &[("TILE_COLUMNS", "2")],
                columns: Some(($family, 2)),
                ..points()
            },
            Kernel {
                name: concat!("generate_tile_3", $suffix),
                defines: &[("TILE_COLUMNS", "3")],
                columns: Some(($family, 3)),
                ..points()
            },
            Kernel {
                name: concat!("generate_tile_4", $suffix),
                defines: &[("TILE_COLUMNS", "4")],
                constants: &[OUTPUT, TILE, ROW, PART],
                columns: Some(($family, 4)),
                ..points()
            },
            Kernel {
                name: concat!("fused", $suffix),
                source: "fused.comp",
                defines: &[("TILE_COLUMNS", "2")],
                constants: &[MAP, WITH_PDF, TILE],
                columns: Some(($family, 2)),
                ..points()
            },
            Kernel {
                name: concat!("fused_native", $suffix),
                source: "fused.comp",
                defines: &[("TILE_COLUMNS", "2"), ("KERNEL_NATIVE", "1")],
                constants: &[MAP, WITH_PDF, TILE],
                columns: Some(($family, 2)),
                profile: Profile::Native,
                ..points()
            },
        ]
    };
}

/// What most kernels that make points have in common.
const fn points() -> Kernel {
    Kernel {
        name: "",
        source: "generate_tile.comp",
        defines: &[],
        local_size: 64,
        push: WORK,
        bindings: &[RESULTS],
        constants: &[OUTPUT, TILE],
        columns: None,
        profile: Profile::Integer,
    }
}

const POINTS_OF: [[Kernel; POINT_KERNELS]; FAMILIES.len()] = [
    point_kernels!(Family::Radical, ""),
    point_kernels!(Family::Net, "_net"),
    point_kernels!(Family::Random, "_random"),
    point_kernels!(Family::Strata, "_strata"),
    point_kernels!(Family::Digits, "_digits"),
    point_kernels!(Family::Lattice, "_lattice"),
];

const fn map_kernel(
    name: &'static str,
    defines: &'static [(&'static str, &'static str)],
    profile: Profile,
) -> Kernel {
    Kernel {
        name,
        source: "map.comp",
        defines,
        local_size: 64,
        push: WORK,
        bindings: &[RESULTS, POINTS],
        constants: &[MAP, WITH_PDF],
        columns: None,
        profile,
    }
}

const fn evaluate(
    name: &'static str,
    source: &'static str,
    defines: &'static [(&'static str, &'static str)],
    profile: Profile,
) -> Kernel {
    Kernel {
        name,
        source,
        defines,
        local_size: 64,
        push: WORK,
        bindings: &[RESULTS, ARGUMENTS],
        constants: &[FUNCTION, INDEXED],
        columns: None,
        profile,
    }
}

const fn pairs(name: &'static str, source: &'static str, constants: &'static [Constant]) -> Kernel {
    Kernel {
        name,
        source,
        defines: &[],
        local_size: 64,
        push: PairsPush::MEMBERS,
        bindings: &[
            RESULTS,
            Binding {
                binding: 1,
                name: "words",
                element: Element::Uint,
                input: true,
            },
        ],
        constants,
        columns: None,
        profile: Profile::Integer,
    }
}

/// The other kernels.
const OTHERS: &[Kernel] = &[
    map_kernel("map", &[], Profile::Integer),
    map_kernel("map_native", &[("KERNEL_NATIVE", "1")], Profile::Native),
    Kernel {
        name: "irradiance",
        source: "irradiance.comp",
        defines: &[],
        local_size: 64,
        push: IrradiancePush::MEMBERS,
        bindings: &[
            RESULTS,
            Binding {
                binding: 1,
                name: "texels",
                element: Element::Uint,
                input: true,
            },
            Binding {
                binding: 2,
                name: "edges",
                element: Element::Uint,
                input: true,
            },
        ],
        constants: &[],
        columns: None,
        profile: Profile::Integer,
    },
    pairs("pairs", "pairs.comp", &[KIND]),
    pairs("nearest", "nearest.comp", &[TOROIDAL]),
    Kernel {
        name: "void_and_cluster",
        source: "void_and_cluster.comp",
        defines: &[],
        local_size: 128,
        push: MaskPush::MEMBERS,
        bindings: &[
            Binding {
                binding: 0,
                name: "words",
                element: Element::Uint,
                input: false,
            },
            Binding {
                binding: 1,
                name: "ranks",
                element: Element::Uint,
                input: false,
            },
            Binding {
                binding: 2,
                name: "state",
                element: Element::Uint,
                input: false,
            },
            Binding {
                binding: 3,
                name: "energies",
                element: Element::Uint,
                input: true,
            },
        ],
        constants: &[],
        columns: None,
        profile: Profile::Integer,
    },
    Kernel {
        name: "probe",
        source: "probe.comp",
        defines: &[],
        local_size: 64,
        push: &[],
        bindings: &[
            Binding {
                binding: 0,
                name: "arguments",
                element: Element::Uint,
                input: true,
            },
            Binding {
                binding: 1,
                name: "results",
                element: Element::Uint,
                input: false,
            },
        ],
        constants: &[],
        columns: None,
        profile: Profile::Probe,
    },
];

const PORTABLE: &[(&str, &str)] = &[("CORPUT_PORTABLE", "1")];

/// The kernels that evaluate single functions, also with the portable forms of `fixed`.
#[rustfmt::skip]
const EVALUATORS: &[Kernel] = &[
    evaluate("evaluate", "evaluate.comp", &[], Profile::Integer),
    evaluate("evaluate_portable", "evaluate.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_frame", "evaluate.comp", &[("KERNEL_FRAME", "1")], Profile::Float),
    evaluate("evaluate_native", "evaluate.comp", &[("KERNEL_NATIVE", "1")], Profile::Native),
    evaluate("evaluate_blue_noise", "evaluate_blue_noise.comp", &[], Profile::Integer),
    evaluate("evaluate_blue_noise_portable", "evaluate_blue_noise.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_domain", "evaluate_domain.comp", &[], Profile::Integer),
    evaluate("evaluate_domain_portable", "evaluate_domain.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_net", "evaluate_net.comp", &[], Profile::Integer),
    evaluate("evaluate_net_portable", "evaluate_net.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_random", "evaluate_random.comp", &[], Profile::Integer),
    evaluate("evaluate_random_portable", "evaluate_random.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_strata", "evaluate_strata.comp", &[], Profile::Integer),
    evaluate("evaluate_strata_portable", "evaluate_strata.comp", PORTABLE, Profile::Integer),
];

const MADE: usize = POINT_KERNELS * FAMILIES.len();

const COUNT: usize = MADE + EVALUATORS.len() + OTHERS.len();

const ALL: [Kernel; COUNT] = {
    let mut all = [points(); COUNT];
    let mut at = 0;
    while at < COUNT {
        all[at] = if at < MADE {
            POINTS_OF[at / POINT_KERNELS][at % POINT_KERNELS]
        } else if at < MADE + EVALUATORS.len() {
            EVALUATORS[at - MADE]
        } else {
            OTHERS[at - MADE - EVALUATORS.len()]
        };
        at += 1;
    }
    all
};

/// Every stock kernel.
pub const KERNELS: &[Kernel] = &ALL;
