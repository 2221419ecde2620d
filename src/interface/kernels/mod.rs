//! The list of stock kernels.

mod constants;
mod points;
mod wide;

use super::{
    Binding, Constant, Element, FAMILIES, IrradiancePush, Kernel, MaskPush, PairsPush, Profile,
    PushConstants, ReducePush,
};
use constants::{
    ARGUMENTS, COORDINATES, DIMENSIONS, FUNCTION, INDEXED, KIND, MAP, MAP_ARGUMENTS, POINTS,
    RESULTS, TASK, TOROIDAL, WITH_PDF, WORK,
};
use points::{POINT_KERNELS, POINTS_OF, points};
use wide::WIDE;

/// A group of maps; its tables, if it has any, follow the points.
const fn maps(
    name: &'static str,
    source: &'static str,
    bindings: &'static [Binding],
    profile: Profile,
) -> Kernel {
    Kernel {
        name,
        source,
        defines: match profile {
            Profile::Native => &[("KERNEL_NATIVE", "1")],
            _ => &[],
        },
        local_size: 64,
        push: MAP_ARGUMENTS,
        bindings,
        constants: &[MAP, WITH_PDF, DIMENSIONS, TASK, COORDINATES],
        columns: None,
        shapes: 0,
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
        shapes: 0,
        profile,
    }
}

/// Elementary functions that both profiles have.
const fn functions(name: &'static str, profile: Profile) -> Kernel {
    Kernel {
        push: WORK,
        bindings: &[RESULTS, ARGUMENTS],
        constants: &[FUNCTION, TASK],
        ..maps(name, "function.comp", MAPPED, profile)
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
        shapes: 0,
        profile: Profile::Integer,
    }
}

/// The other kernels.
const OTHERS: &[Kernel] = &[
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
        shapes: 0,
        profile: Profile::Integer,
    },
    pairs("pairs", "pairs.comp", &[KIND]),
    pairs("nearest", "nearest.comp", &[TOROIDAL]),
    Kernel {
        push: ReducePush::MEMBERS,
        ..pairs("reduce", "reduce.comp", &[])
    },
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
        shapes: 0,
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
        shapes: 0,
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
    evaluate("evaluate_discrete", "evaluate_discrete.comp", &[], Profile::Integer),
    evaluate("evaluate_discrete_portable", "evaluate_discrete.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_domain", "evaluate_domain.comp", &[], Profile::Integer),
    evaluate("evaluate_domain_portable", "evaluate_domain.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_elementary", "evaluate_elementary.comp", &[], Profile::Integer),
    evaluate("evaluate_elementary_portable", "evaluate_elementary.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_net", "evaluate_net.comp", &[], Profile::Integer),
    evaluate("evaluate_net_portable", "evaluate_net.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_random", "evaluate_random.comp", &[], Profile::Integer),
    evaluate("evaluate_random_portable", "evaluate_random.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_real", "evaluate_real.comp", &[], Profile::Integer),
    evaluate("evaluate_real_portable", "evaluate_real.comp", PORTABLE, Profile::Integer),
    evaluate("evaluate_strata", "evaluate_strata.comp", &[], Profile::Integer),
    evaluate("evaluate_strata_portable", "evaluate_strata.comp", PORTABLE, Profile::Integer),
    functions("function", Profile::Integer),
    functions("function_native", Profile::Native),
];

const MAPPED: &[Binding] = &[RESULTS, POINTS];

/// Tables follow the points, in two buffers of at most
/// [`TABLE_WORDS`](super::TABLE_WORDS) words.
const TABLED: &[Binding] = &[
    RESULTS,
    POINTS,
    Binding {
        binding: 2,
        name: "tables",
        element: Element::Uint,
        input: true,
    },
    Binding {
        binding: 3,
        name: "more_tables",
        element: Element::Uint,
        input: true,
    },
];

/// What the host prepared of the parameters follows the points.
const PREPARED: &[Binding] = &[
    RESULTS,
    POINTS,
    Binding {
        binding: 2,
        name: "prepared",
        element: Element::Uint,
        input: true,
    },
];

/// The maps, by group, in both profiles.
#[rustfmt::skip]
const MAPPERS: &[Kernel] = &[
    maps("map_beckmann", "map_beckmann.comp", MAPPED, Profile::Integer),
    maps("map_beckmann_native", "map_beckmann.comp", MAPPED, Profile::Native),
    maps("map_ggx", "map_ggx.comp", MAPPED, Profile::Integer),
    maps("map_ggx_native", "map_ggx.comp", MAPPED, Profile::Native),
    maps("map_ggx_cap", "map_ggx_cap.comp", MAPPED, Profile::Integer),
    maps("map_ggx_cap_native", "map_ggx_cap.comp", MAPPED, Profile::Native),
    maps("map_hemisphere", "map_hemisphere.comp", MAPPED, Profile::Integer),
    maps("map_hemisphere_native", "map_hemisphere.comp", MAPPED, Profile::Native),
    maps("map_phase", "map_phase.comp", MAPPED, Profile::Integer),
    maps("map_phase_native", "map_phase.comp", MAPPED, Profile::Native),
    maps("map_planar", "map_planar.comp", MAPPED, Profile::Integer),
    maps("map_planar_native", "map_planar.comp", MAPPED, Profile::Native),
    maps("map_spherical", "map_spherical.comp", PREPARED, Profile::Integer),
    maps("map_spherical_native", "map_spherical.comp", MAPPED, Profile::Native),
    maps("map_lobe", "map_lobe.comp", MAPPED, Profile::Integer),
    maps("map_lobe_native", "map_lobe.comp", MAPPED, Profile::Native),
    maps("map_line", "map_line.comp", MAPPED, Profile::Integer),
    maps("map_line_native", "map_line.comp", MAPPED, Profile::Native),
    maps("map_normal", "map_normal.comp", MAPPED, Profile::Integer),
    maps("map_normal_native", "map_normal.comp", MAPPED, Profile::Native),
    maps("map_filter", "map_filter.comp", MAPPED, Profile::Integer),
    maps("map_filter_native", "map_filter.comp", MAPPED, Profile::Native),
    maps("map_filter_gaussian", "map_filter_gaussian.comp", PREPARED, Profile::Integer),
    maps("map_filter_gaussian_native", "map_filter_gaussian.comp", MAPPED, Profile::Native),
    maps("map_filter_window", "map_filter_window.comp", MAPPED, Profile::Integer),
    maps("map_filter_window_native", "map_filter_window.comp", MAPPED, Profile::Native),
    maps("map_filter_mitchell", "map_filter_mitchell.comp", MAPPED, Profile::Integer),
    maps("map_filter_mitchell_native", "map_filter_mitchell.comp", MAPPED, Profile::Native),
    maps("map_environment", "map_environment.comp", TABLED, Profile::Integer),
    maps("map_environment_native", "map_environment.comp", TABLED, Profile::Native),
];

const MADE: usize = POINT_KERNELS * FAMILIES.len();

const EVALUATED: usize = MADE + EVALUATORS.len();

const MAPS_END: usize = EVALUATED + MAPPERS.len();

const OTHERS_END: usize = MAPS_END + OTHERS.len();

const COUNT: usize = OTHERS_END + WIDE.len();

static ALL: [Kernel; COUNT] = {
    let mut all = [points(); COUNT];
    let mut at = 0;
    while at < COUNT {
        all[at] = if at < MADE {
            POINTS_OF[at / POINT_KERNELS][at % POINT_KERNELS]
        } else if at < EVALUATED {
            EVALUATORS[at - MADE]
        } else if at < MAPS_END {
            MAPPERS[at - EVALUATED]
        } else if at < OTHERS_END {
            OTHERS[at - MAPS_END]
        } else {
            WIDE[at - OTHERS_END]
        };
        at += 1;
    }
    all
};

/// Every stock kernel.
pub const KERNELS: &[Kernel] = &ALL;
