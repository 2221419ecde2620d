//! Free flight, normal distributions and pixel filters.

use super::Killer::{Linter, Mismatch};
use super::{Mutant, mutant};
use crate::harness::Target::Map;
use corput::interface::task::{INVERT, PDF, SAMPLE};

#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
    mutant("sigma t for t", Mismatch, Map("exponential", SAMPLE),
        "corput/free_flight.glsl", "corput_real_divide(corput_real_negative_log(u), rate)", "corput_real_multiply(corput_real_negative_log(u), rate)"),
    mutant("no sigma in the density", Mismatch, Map("exponential", PDF),
        "corput/free_flight.glsl", "corput_real_float(corput_real_multiply(rate, decay))", "corput_real_float(decay)"),
    mutant("a fraction cut, not rounded", Mismatch, Map("exponential", INVERT),
        "corput/free_flight.glsl", "corput_real_add(mass, corput_real_uint(1u, -33))", "mass"),
    mutant("a native exponential in a map", Linter, Map("exponential", PDF),
        "corput/free_flight.glsl", "return corput_real_float(corput_real_multiply(rate, decay));", "return sigma * exp(-sigma * t);"),
    mutant("sigma for sigma^2", Mismatch, Map("normal-pair", SAMPLE),
        "corput/gaussian.glsl", "corput_real_divide(density, corput_real_square(sigma))", "corput_real_divide(density, sigma)"),
    mutant("the first fraction for both coordinates", Mismatch, Map("normal-pair", SAMPLE),
        "corput/gaussian.glsl", "corput_real_normal_quantile(u[i])", "corput_real_normal_quantile(u.x)"),
    mutant("no 2 in the radius of the polar method", Mismatch, Map("box-muller", SAMPLE),
        "corput/gaussian.glsl", "corput_real_shift(corput_real_negative_log(u.x), 1)", "corput_real_negative_log(u.x)"),
    mutant("no 2 in the inverse of the polar method", Mismatch, Map("box-muller", INVERT),
        "corput/gaussian.glsl", "corput_real_shift(square, -1)", "square"),
    mutant("the box as wide as its radius", Linter, Map("filter-box", SAMPLE),
        "corput/filter.glsl", "return CorputFilterSample(p, corput_gaussian_area_pdf(corput_real_uint(1u, -2), r));", "return CorputFilterSample(0.5 * p, 0.0);"),
    mutant("a box for the tent", Mismatch, Map("filter-tent", SAMPLE),
        "corput/filter.glsl", "corput_real_divide(corput_real_uint(share, -32), corput_real_add(corput_real_uint(1u, 0), height))", "corput_real_uint(share, -32)"),
    mutant("the other side", Mismatch, Map("filter-tent", INVERT),
        "corput/filter.glsl", "0x7fffffffu - half_u", "0x80000000u - half_u"),
    mutant("the whole mass for that within the edge", Mismatch, Map("filter-gaussian", PDF),
        "corput/filter.glsl", "corput_real_multiply(f.sigma, corput_real_shift(f.mass, 1))", "f.sigma"),
    mutant("nothing beyond the edge", Mismatch, Map("filter-gaussian", SAMPLE),
        "corput/filter.glsl", "corput_real_add(f.tail, rest)", "rest"),
    mutant("four steps less of Newton's method", Mismatch, Map("filter-blackman-harris", SAMPLE),
        "corput/filter_blackman_harris.glsl", "i < 5u", "i < 1u"),
    mutant("the edge's mass from the middle", Mismatch, Map("filter-blackman-harris", INVERT),
        "corput/filter_blackman_harris.glsl", "corput_real_subtract(corput_real_uint(1u, 0), share)", "share"),
    mutant("a window over its radius alone", Mismatch, Map("filter-blackman-harris", PDF),
        "corput/filter_blackman_harris.glsl", "corput_real_uint(1u, -2);\n    for (uint i = 0u; i < 2u; i++) {\n        density", "corput_real_uint(1u, 0);\n    for (uint i = 0u; i < 2u; i++) {\n        density"),
    mutant("a lobe of the other sign of its cube", Mismatch, Map("filter-mitchell", SAMPLE),
        "corput/filter_mitchell.glsl", "    if (part == 3u) {\n        c3 = corput_real_negate(c3);", "    if (part == 3u) {\n        c3 = c3;"),
    mutant("the filter for its magnitude", Mismatch, Map("filter-mitchell", SAMPLE),
        "corput/filter_mitchell.glsl", "corput_real_add(corput_real_uint(3u, 0), corput_real_shift(lobe, 1))", "corput_real_uint(3u, 0)"),
    mutant("the lobe from the centre", Mismatch, Map("filter-mitchell", INVERT),
        "corput/filter_mitchell.glsl", "        if (at.part == 3u) {\n            share = corput_real_negate(share);", "        if (at.part == 5u) {\n            share = corput_real_negate(share);"),
];
