//! The list of stock kernels.

use super::{
    Binding, Constant, Element, IrradiancePush, Kernel, MaskPush, Member, Profile, PushConstants,
    WorkPush, map, output,
};

macro_rules! columns {
    ($($extra:expr,)* ; $(($index:literal, $prefix:literal)),*) => {
        &[
            $($extra,)*
            $(
                Constant { id: 16 + $index * 16, name: concat!($prefix, "_KIND"), default: 0 },
                Constant { id: 17 + $index * 16, name: concat!($prefix, "_BASE"), default: 2 },
                Constant { id: 18 + $index * 16, name: concat!($prefix, "_DIGITS"), default: 15 },
                Constant { id: 19 + $index * 16, name: concat!($prefix, "_GROUP_POWER"), default: 32768 },
                Constant { id: 20 + $index * 16, name: concat!($prefix, "_BASE_MAGIC"), default: 1 },
                Constant { id: 21 + $index * 16, name: concat!($prefix, "_BASE_SHIFT"), default: 0 },
                Constant { id: 22 + $index * 16, name: concat!($prefix, "_POWER_MAGIC"), default: 1 },
                Constant { id: 23 + $index * 16, name: concat!($prefix, "_POWER_SHIFT"), default: 14 },
                Constant { id: 24 + $index * 16, name: concat!($prefix, "_POWER"), default: 1 },
                Constant { id: 25 + $index * 16, name: concat!($prefix, "_QUOTIENT"), default: 0 },
                Constant { id: 26 + $index * 16, name: concat!($prefix, "_FRACTION"), default: 0 },
            )*
        ]
    };
}

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

const fn tile(
    name: &'static str,
    defines: &'static [(&'static str, &'static str)],
    constants: &'static [Constant],
) -> Kernel {
    Kernel {
        name,
        source: "generate_tile.comp",
        defines,
        local_size: 64,
        push: WORK,
        bindings: &[RESULTS],
        constants,
        profile: Profile::Integer,
    }
}

const fn directions(
    name: &'static str,
    source: &'static str,
    defines: &'static [(&'static str, &'static str)],
    bindings: &'static [Binding],
    constants: &'static [Constant],
    profile: Profile,
) -> Kernel {
    Kernel {
        name,
        source,
        defines,
        local_size: 64,
        push: WORK,
        bindings,
        constants,
        profile,
    }
}

const fn evaluate(
    name: &'static str,
    defines: &'static [(&'static str, &'static str)],
    profile: Profile,
) -> Kernel {
    Kernel {
        name,
        source: "evaluate.comp",
        defines,
        local_size: 64,
        push: WORK,
        bindings: &[RESULTS, ARGUMENTS],
        constants: &[FUNCTION, INDEXED],
        profile,
    }
}

/// Every stock kernel.
pub const KERNELS: &[Kernel] = &[
    Kernel {
        name: "generate",
        source: "generate.comp",
        defines: &[],
        local_size: 64,
        push: WORK,
        bindings: &[RESULTS, COLUMNS],
        constants: &[OUTPUT, DIMENSIONS],
        profile: Profile::Integer,
    },
    tile(
        "generate_tile_1",
        &[("TILE_COLUMNS", "1")],
        columns!(OUTPUT, TILE,; (0, "COLUMN0")),
    ),
    tile(
        "generate_tile_2",
        &[("TILE_COLUMNS", "2")],
        columns!(OUTPUT, TILE,; (0, "COLUMN0"), (1, "COLUMN1")),
    ),
    tile(
        "generate_tile_3",
        &[("TILE_COLUMNS", "3")],
        columns!(OUTPUT, TILE,; (0, "COLUMN0"), (1, "COLUMN1"), (2, "COLUMN2")),
    ),
    tile(
        "generate_tile_4",
        &[("TILE_COLUMNS", "4")],
        columns!(OUTPUT, TILE, ROW, PART,; (0, "COLUMN0"), (1, "COLUMN1"), (2, "COLUMN2"), (3, "COLUMN3")),
    ),
    directions(
        "map",
        "map.comp",
        &[],
        &[RESULTS, POINTS],
        &[MAP, WITH_PDF],
        Profile::Integer,
    ),
    directions(
        "map_native",
        "map.comp",
        &[("KERNEL_NATIVE", "1")],
        &[RESULTS, POINTS],
        &[MAP, WITH_PDF],
        Profile::Native,
    ),
    directions(
        "fused",
        "fused.comp",
        &[("TILE_COLUMNS", "2")],
        &[RESULTS],
        columns!(MAP, WITH_PDF, TILE,; (0, "COLUMN0"), (1, "COLUMN1")),
        Profile::Integer,
    ),
    directions(
        "fused_native",
        "fused.comp",
        &[("TILE_COLUMNS", "2"), ("KERNEL_NATIVE", "1")],
        &[RESULTS],
        columns!(MAP, WITH_PDF, TILE,; (0, "COLUMN0"), (1, "COLUMN1")),
        Profile::Native,
    ),
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
        profile: Profile::Integer,
    },
    evaluate("evaluate", &[], Profile::Integer),
    evaluate(
        "evaluate_portable",
        &[("CORPUT_PORTABLE", "1")],
        Profile::Integer,
    ),
    Kernel {
        source: "evaluate_blue_noise.comp",
        ..evaluate("evaluate_blue_noise", &[], Profile::Integer)
    },
    Kernel {
        source: "evaluate_blue_noise.comp",
        ..evaluate(
            "evaluate_blue_noise_portable",
            &[("CORPUT_PORTABLE", "1")],
            Profile::Integer,
        )
    },
    evaluate("evaluate_frame", &[("KERNEL_FRAME", "1")], Profile::Float),
    evaluate(
        "evaluate_native",
        &[("KERNEL_NATIVE", "1")],
        Profile::Native,
    ),
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
        profile: Profile::Probe,
    },
];
