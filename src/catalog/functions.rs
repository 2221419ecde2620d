//! One row per function that a device can be asked to evaluate.

use super::Tier;

/// What a function's arguments are, which decides how inputs are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One 32-bit word: strided over its whole range, and edges.
    Word,
    /// Several words: all pairs of edges, and random ones.
    Words,
    /// Several words of a function that takes long: fewer pairs of edges, fewer random ones.
    CostlyWords,
    /// One float.
    Float,
    /// Two floats.
    Floats,
    /// n and a prime base.
    Radical,
    /// k < N.
    Grid,
    /// A unit vector, and a word.
    Direction,
    /// k < N, and two words.
    Strata,
    /// n, any base, and a seed.
    Digits,
}

/// A row of the catalogue.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// Its name: that of the GLSL function without `corput_`, or of the group.
    pub name: &'static str,
    /// The header.
    pub header: &'static str,
    /// The kernel that evaluates it.
    pub kernel: &'static str,
    /// Value of the kernel's constant `FUNCTION`.
    pub id: u32,
    /// Its arguments.
    pub kind: Kind,
    /// Where its bits are promised.
    pub tier: Tier,
    /// Worst error against the judge, in ULP of float or in the unit named; `None` for
    /// integers, which are exact.
    pub bound: Option<f64>,
    /// Unit of the bound and of the measured error. `2^-26 or ULP` of `normal_tail`: the relative
    /// error of the tail's mass up to 7 in units of 2^-26, or that of the density in ULP, whichever
    /// is larger.
    pub unit: &'static str,
}

const fn integer(name: &'static str, header: &'static str, id: u32, kind: Kind) -> Function {
    Function {
        name,
        header,
        kernel: "evaluate",
        id,
        kind,
        tier: Tier::Integer,
        bound: None,
        unit: "",
    }
}

const fn float(
    name: &'static str,
    header: &'static str,
    id: u32,
    kind: Kind,
    bound: f64,
    unit: &'static str,
) -> Function {
    Function {
        name,
        header,
        kernel: "evaluate",
        id,
        kind,
        tier: Tier::Integer,
        bound: Some(bound),
        unit,
    }
}

const fn random(name: &'static str, header: &'static str, id: u32) -> Function {
    Function {
        kernel: "evaluate_random",
        ..integer(name, header, id, Kind::Words)
    }
}

const fn costly(name: &'static str, header: &'static str, id: u32) -> Function {
    Function {
        kind: Kind::CostlyWords,
        ..random(name, header, id)
    }
}

const fn net(name: &'static str, header: &'static str, id: u32) -> Function {
    Function {
        kernel: "evaluate_net",
        ..integer(name, header, id, Kind::CostlyWords)
    }
}

const fn domain(name: &'static str, header: &'static str, id: u32) -> Function {
    Function {
        kernel: "evaluate_domain",
        ..integer(name, header, id, Kind::CostlyWords)
    }
}

const fn frame(name: &'static str, id: u32, bound: f64) -> Function {
    Function {
        name,
        header: "frame",
        kernel: "evaluate_frame",
        id,
        kind: Kind::Direction,
        tier: Tier::Float,
        bound: Some(bound),
        unit: "2^-24",
    }
}

const fn strata(name: &'static str, header: &'static str, id: u32, kind: Kind) -> Function {
    Function {
        kernel: "evaluate_strata",
        ..integer(name, header, id, kind)
    }
}

const fn real(name: &'static str, header: &'static str, id: u32) -> Function {
    Function {
        kernel: "evaluate_real",
        ..integer(name, header, id, Kind::CostlyWords)
    }
}

/// A pair of operations, each within 2^-30 of itself.
const fn judged(name: &'static str, id: u32) -> Function {
    Function {
        bound: Some(1.0),
        unit: "2^-30",
        ..real(name, "real", id)
    }
}

const fn elementary(
    name: &'static str,
    header: &'static str,
    id: u32,
    kind: Kind,
    bound: f64,
    unit: &'static str,
) -> Function {
    Function {
        kernel: "evaluate_elementary",
        ..float(name, header, id, kind, bound, unit)
    }
}

const fn discrete(name: &'static str, header: &'static str, id: u32, kind: Kind) -> Function {
    Function {
        kernel: "evaluate_discrete",
        ..integer(name, header, id, kind)
    }
}

const fn blue_noise(name: &'static str, header: &'static str, id: u32) -> Function {
    Function {
        kernel: "evaluate_blue_noise",
        ..integer(name, header, id, Kind::Words)
    }
}

/// Every function of the exact profile.
///
/// Bounds of inverses are against the exact inverse of the given floats: the concentric
/// one takes a root cut to 25 bits, 2^-24 of it, of which u is half; the polar one floors
/// two squares and rounds an angle. A frame's coordinates take up to five roundings of
/// values up to 1, half a unit of 2^-24 each, and one more of a product.
pub const FUNCTIONS: &[Function] = &[
    integer("mul64", "fixed", 0, Kind::Words),
    integer("add64", "fixed", 1, Kind::Words),
    integer("shl64", "fixed", 2, Kind::Words),
    integer("fixed64", "fixed", 3, Kind::Floats),
    float("unit", "unit", 4, Kind::Word, 0.0, "ULP"),
    float("cos_sin", "elementary", 5, Kind::Word, 0.53, "ULP"),
    float("sqrt", "elementary", 6, Kind::Float, 0.5, "ULP"),
    float("divide", "elementary", 7, Kind::Floats, 0.5, "ULP"),
    float("multiply", "elementary", 8, Kind::Floats, 0.5, "ULP"),
    float("atan2", "elementary", 9, Kind::Floats, 2.0, "2^-32 turn"),
    integer("ratio", "elementary", 10, Kind::Words),
    judged("real_add", 0),
    judged("real_multiply", 1),
    judged("real_sqrt", 2),
    real("real_min", "real", 3),
    real("real_float", "real", 4),
    real("real_vector", "real_vector", 5),
    elementary("negative_log", "logarithm", 0, Kind::Word, 0.51, "ULP"),
    elementary("log", "logarithm", 1, Kind::Float, 0.52, "ULP"),
    elementary("exp", "exponential", 2, Kind::Float, 0.52, "ULP"),
    elementary("power", "exponential", 3, Kind::Floats, 1.0, "of bound"),
    elementary(
        "normal_quantile",
        "normal_quantile",
        4,
        Kind::Word,
        0.55,
        "ULP",
    ),
    elementary(
        "normal_tail",
        "normal_quantile",
        5,
        Kind::Float,
        1.0,
        "2^-26 or ULP",
    ),
    integer("radical_inverse", "radical_inverse", 11, Kind::Radical),
    integer("hammersley", "hammersley", 12, Kind::Grid),
    float("concentric_disk", "disk", 13, Kind::Words, 0.6, "ULP"),
    float("polar_disk", "disk", 14, Kind::Words, 1.6, "ULP"),
    float(
        "uniform_hemisphere",
        "hemisphere",
        15,
        Kind::Words,
        1.6,
        "ULP",
    ),
    float(
        "cosine_hemisphere",
        "hemisphere",
        16,
        Kind::Words,
        0.6,
        "ULP",
    ),
    float(
        "cosine_hemisphere_polar",
        "hemisphere",
        17,
        Kind::Words,
        1.6,
        "ULP",
    ),
    float("hemisphere_pdf", "hemisphere", 21, Kind::Float, 0.53, "ULP"),
    float("disk_invert", "disk", 18, Kind::Direction, 128.0, "2^-32"),
    float(
        "hemisphere_invert",
        "hemisphere",
        19,
        Kind::Direction,
        128.0,
        "2^-32",
    ),
    float(
        "hemisphere_polar_invert",
        "hemisphere",
        20,
        Kind::Direction,
        4.0,
        "2^-32",
    ),
    random("hash", "hash", 0),
    random("pcg4d", "hash", 1),
    random("mix4", "hash", 12),
    random("seed", "hash", 2),
    random("philox", "random", 3),
    random("random", "random", 4),
    random("random_fast", "random", 5),
    random("pcg32", "random", 6),
    costly("pcg32_advance", "random", 7),
    random("digital_shift", "owen", 8),
    costly("owen", "owen", 9),
    random("owen_hash", "owen", 10),
    costly("matrix_scramble", "owen", 11),
    net("sobol", "sobol", 0),
    net("pmj02", "pmj02", 1),
    strata("permute", "permute", 0, Kind::Strata),
    strata("stratum", "stratified", 1, Kind::Strata),
    strata("unit_stratum", "stratified", 2, Kind::Strata),
    strata("stratified", "stratified", 3, Kind::Strata),
    strata("latin_hypercube", "stratified", 4, Kind::Strata),
    strata("cmj", "stratified", 5, Kind::CostlyWords),
    strata(
        "radical_inverse_faure",
        "scrambled_radical_inverse",
        6,
        Kind::Digits,
    ),
    strata(
        "radical_inverse_permuted",
        "scrambled_radical_inverse",
        7,
        Kind::Digits,
    ),
    strata(
        "radical_inverse_owen",
        "scrambled_radical_inverse",
        8,
        Kind::Digits,
    ),
    strata(
        "radical_inverse_started",
        "scrambled_radical_inverse",
        9,
        Kind::Digits,
    ),
    strata("halton_scrambled", "halton_scrambled", 10, Kind::Digits),
    strata("lattice", "lattice", 11, Kind::Words),
    strata("korobov", "lattice", 12, Kind::Strata),
    strata("additive", "lattice", 13, Kind::Words),
    domain("domain", "domain", 0),
    domain("domain_child", "domain", 1),
    domain("domain_chain", "domain", 2),
    domain("draw_random", "domain_draw", 3),
    domain("draw_random_fast", "domain_draw", 4),
    domain("draw_pairs", "domain_draw", 5),
    domain("draw_pmj02", "domain_draw", 6),
    domain("draw_latin_hypercube", "domain_draw", 7),
    domain("draw_cmj", "domain_draw", 8),
    domain("draw_lattice", "domain_draw", 9),
    domain("draw_additive", "domain_draw", 10),
    domain("draw_sobol", "domain_sobol", 11),
    domain("draw_sobol_owen", "domain_sobol", 12),
    domain("draw_halton", "domain_halton", 13),
    domain("draw_halton_permuted", "domain_halton", 14),
    domain("draw_halton_started", "domain_halton", 15),
    domain("draw_stratified", "domain_draw", 16),
    domain("draw_korobov", "domain_draw", 17),
    domain("draw_r2", "domain_draw", 18),
    discrete("discrete_divide", "discrete", 0, Kind::CostlyWords),
    discrete("cdf", "discrete", 1, Kind::Words),
    discrete("alias", "discrete", 2, Kind::CostlyWords),
    discrete("reservoir", "discrete", 3, Kind::CostlyWords),
    Function {
        bound: Some(0.6),
        unit: "ULP",
        ..discrete("mis", "mis", 4, Kind::Floats)
    },
    discrete("mis_four", "mis", 5, Kind::Floats),
    discrete("roulette", "mis", 6, Kind::CostlyWords),
    blue_noise("blue_noise", "blue_noise", 0),
    blue_noise("blue_noise_shift", "blue_noise", 1),
    blue_noise("screen_space", "screen_space", 2),
    frame("frame_tangent", 0, 4.0),
    frame("frame_bitangent", 1, 4.0),
    frame("frame_to_world", 2, 4.0),
    frame("frame_to_local", 3, 4.0),
];
