//! Phase functions and microsurfaces.

use super::Killer::Mismatch;
use super::{Mutant, Target, mutant};
use corput::interface::task;

const fn sample(map: &'static str) -> Target {
    Target::Map(map, task::SAMPLE)
}

#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
    mutant("a phase function of twice its density", Mismatch, sample("henyey-greenstein"),
        "corput/henyey_greenstein.glsl", "    pdf = corput_real_multiply(pdf, CorputReal(2734261102u, -35, false));",
        "    pdf = corput_real_multiply(pdf, CorputReal(2734261102u, -34, false));"),
    mutant("backward scattering forward", Mismatch, sample("henyey-greenstein"),
        "corput/henyey_greenstein.glsl", "        z = corput_real_negate(z);", "        z = z;"),
    mutant("1 - z for 1 + z in the pdf of a backward phase function", Mismatch, Target::Map("henyey-greenstein", task::PDF),
        "corput/henyey_greenstein.glsl", "        below = v.above;\n    }\n    CorputReal square",
        "        below = v.below;\n    }\n    CorputReal square"),
    mutant("the pdf of normals without the 4 of reflection", Mismatch, sample("ggx-vndf"),
        "corput/ggx_lobe.glsl", "return corput_real_shift(corput_ggx_over_area(g, corput_ggx_density_of(g, s_square, n_square)), -1);",
        "return corput_real_shift(corput_ggx_over_area(g, corput_ggx_density_of(g, s_square, n_square)), 1);"),
    mutant("a disk without its lerp", Mismatch, sample("ggx-vndf-normal"),
        "corput/ggx_vndf.glsl", "    CorputReal s = corput_real_shift(g.cap_above, -1);\n    CorputReal q = corput_real_multiply(s, less);",
        "    CorputReal s = corput_real_shift(g.cap_above, -1);\n    CorputReal q = less;"),
    mutant("a cap of the whole sphere", Mismatch, sample("ggx-vndf-cap"),
        "corput/ggx_vndf_cap.glsl", "    CorputReal below = corput_real_multiply(corput_real_uint(u.x, -32), g.cap_above);",
        "    CorputReal below = corput_real_uint(u.x, -31);"),
    mutant("the bound without its height", Mismatch, sample("ggx-vndf-bounded"),
        "corput/ggx_vndf_bounded.glsl", "    g.excess = corput_real_multiply(g.view.z, rest);",
        "    g.excess = corput_real_zero();"),
    mutant("a pdf beyond the bounded cap", Mismatch, Target::Map("ggx-vndf-bounded", task::PDF),
        "corput/ggx_lobe.glsl", "if (corput_real_less(h.z, g.wo.z) && corput_real_less(", "if (false && corput_real_less("),
    mutant("D of the other axes", Mismatch, Target::Map("ggx-vndf", task::PDF),
        "corput/ggx.glsl", "CorputReal3(corput_real_multiply(h.x, alpha_y), corput_real_multiply(h.y, alpha_x),",
        "CorputReal3(corput_real_multiply(h.x, alpha_x), corput_real_multiply(h.y, alpha_y),"),
    mutant("an inverse turned by a quarter", Mismatch, Target::Map("ggx-vndf-cap", task::INVERT),
        "corput/ggx_vndf_cap.glsl", "corput_real_turns(y, x)", "corput_real_turns(x, y)"),
    mutant("Beckmann without the cosine", Mismatch, sample("beckmann-normal"),
        "corput/beckmann.glsl", "    CorputReal cube = corput_real_multiply(square, corput_real_sqrt(square));",
        "    CorputReal cube = corput_real_square(square);"),
    mutant("reflection with the pdf of the normal", Mismatch, sample("beckmann"),
        "corput/beckmann.glsl", "        corput_real_shift(wo_h, 2));", "        corput_real_uint(1u, 0));"),
];
