//! Discrete distributions, environment maps and combined techniques.

use super::Killer::{Linter, Mismatch};
use super::{Mutant, mutant};
use crate::harness::Target::{Function, Map};
use corput::interface::task::{INVERT, PDF, SAMPLE};

#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
    mutant("<= for < in the search of a CDF", Mismatch, Function("cdf"),
        "corput/discrete.glsl", "if (u < CORPUT_DISCRETE(first + middle))", "if (u <= CORPUT_DISCRETE(first + middle))"),
    mutant("items without weight at the end", Mismatch, Function("cdf"),
        "corput/discrete.glsl", "index == 0u || index >= CORPUT_DISCRETE(first) ?", "index == 0u ?"),
    mutant("the lower edge for the middle of a part", Mismatch, Function("cdf"),
        "corput/discrete.glsl", "uvec2(0x80000000u, part), width)", "uvec2(0u, part), width)"),
    mutant("a digit's guess corrected once", Mismatch, Function("discrete_divide"),
        "corput/discrete.glsl", "k < 2u", "k < 1u"),
    mutant("an alias entry off by one", Mismatch, Function("alias"),
        "corput/discrete.glsl", "uint other = CORPUT_DISCRETE(at + 1u);", "uint other = (CORPUT_DISCRETE(at + 1u) + 1u) % count;"),
    mutant("the alias part begins at its bin's start", Mismatch, Function("alias"),
        "corput/discrete.glsl", "place -= mine ? 0u : own;", ""),
    mutant("<= for < in a reservoir", Mismatch, Function("reservoir"),
        "corput/discrete.glsl", "place.y == 0u && place.x < weight", "place.y == 0u && place.x <= weight"),
    mutant("the total before the item", Mismatch, Function("reservoir"),
        "corput/discrete.glsl", "corput_discrete_scale(total, u);\n    if", "corput_discrete_scale(r.total, u);\n    if"),
    mutant("the power heuristic without squares", Mismatch, Function("mis"),
        "corput/mis.glsl", "CorputReal b = corput_real_square(corput_mis_term(count_b, pdf_b));", "CorputReal b = corput_mis_term(count_b, pdf_b);"),
    mutant("heuristics by native floats", Linter, Function("mis"),
        "corput/mis.glsl", "CorputReal a = corput_mis_term(count_a, pdf_a);\n    CorputReal b = corput_mis_term(count_b, pdf_b);\n    return corput_real_float(corput_real_divide(a, corput_real_add(a, b)));",
        "return pdf_a / (pdf_a + pdf_b);"),
    mutant("deltas as large finite pdfs", Mismatch, Function("mis"),
        "corput/mis.glsl", "bits == 0x7f800000u ? 4096 : 0", "0"),
    mutant("four techniques without the last", Mismatch, Function("mis_four"),
        "corput/mis.glsl", "CorputReal w = corput_real_square(corput_mis_term(counts.w, pdfs.w));", "CorputReal w = corput_real_zero();"),
    mutant("<= for < in roulette", Mismatch, Function("roulette"),
        "corput/mis.glsl", "if (u < survival) {", "if (u <= survival) {"),
    mutant("roulette without its weight", Mismatch, Function("roulette"),
        "corput/mis.glsl", "corput_real_divide(corput_real_uint(1u, 32), kept)", "corput_real_uint(1u, 0)"),
    // Environment maps.
    mutant("a pdf without 1/solid angle", Mismatch, Map("environment", SAMPLE),
        "corput/environment.glsl", "corput_real_divide(turn, corput_real_wide(extent, -62))", "turn"),
    mutant("1/(2 pi) of 24 bits", Mismatch, Map("environment", PDF),
        "corput/environment.glsl", "2734261102u", "2734261248u"),
    mutant("z rounded into the next row", Mismatch, Map("environment", SAMPLE),
        "corput/environment.glsl", "corput_envmap_order(CORPUT_ENVMAP_EDGE(row + 1u)) + 1u);", "corput_envmap_order(CORPUT_ENVMAP_EDGE(row + 1u)));"),
    mutant("azimuths up to the column's end", Mismatch, Map("environment", SAMPLE),
        "corput/environment.glsl", "clamp(place.x, margin, ~margin)", "place.x"),
    mutant("the lower pole by a difference", Mismatch, Map("environment", SAMPLE),
        "corput/environment.glsl", "below ? up : down", "down"),
    mutant("rows drawn at the pole itself", Mismatch, Map("environment", SAMPLE),
        "corput/environment.glsl", "    down = corput_add64(down, corput_shr64(extent, 33u));\n", ""),
    mutant("the caps of the row above", Mismatch, Map("environment-alias", SAMPLE),
        "corput/environment.glsl", "uint at = size.y + 2u * row;", "uint at = size.y + 2u * max(row, 1u) - 2u;"),
    mutant("x and y of the place swapped", Mismatch, Map("environment-alias", SAMPLE),
        "corput/environment.glsl", "texel, u.yz)", "texel, u.zy)"),
    mutant("inverses from the upper edge below the equator", Mismatch, Map("environment", INVERT),
        "corput/environment.glsl", "uvec2(across, below ? ~fraction : fraction)", "uvec2(across, fraction)"),
];
