//! Solid angles and plane figures.

use super::Killer::Mismatch;
use super::{Mutant, Target, mutant};
use corput::interface::task;

const fn sample(map: &'static str) -> Target {
    Target::Map(map, task::SAMPLE)
}

#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
    mutant("a sphere of half the radius", Mismatch, sample("uniform-sphere"),
        "corput/sphere.glsl", "corput_real_shift(corput_real_sqrt(square), 1);", "corput_real_sqrt(square);"),
    mutant("a cone of twice its pdf", Mismatch, sample("cone"),
        "corput/cone.glsl", "corput_real_divide(corput_real_uint(2734261102u, -34), h)", "corput_real_divide(corput_real_uint(2734261102u, -33), h)"),
    mutant("a cone without the missing half of its radius", Mismatch, sample("cone"),
        "corput/cone.glsl", "corput_real_sqrt(corput_real_multiply(versine, rest))", "corput_real_sqrt(corput_real_shift(versine, 1))"),
    mutant("the inverse of a cone by the axis alone", Mismatch, Target::Map("cone", task::INVERT),
        "corput/sphere.glsl", "    if (corput_real_less(z, corput_real_uint(1u, -1))) {", "    if (corput_real_less(z, corput_real_uint(2u, 0))) {"),
    mutant("lights seen under their edge", Mismatch, Target::Map("sphere-light", task::PREPARE),
        "corput/sphere_light.glsl", "corput_real_add(square, root)", "corput_real_add(square, square)"),
    mutant("a disk without the cosine", Mismatch, sample("disk-light"),
        "corput/disk_light.glsl", "corput_real_multiply(corput_real_square(light.radius), light.height)", "corput_real_square(light.radius)"),
    mutant("a triangle folded at the wrong edge", Mismatch, sample("triangle"),
        "corput/triangle.glsl", "    if (y > x) {\n        return uvec3", "    if (y < x) {\n        return uvec3"),
    mutant("a polygon of the area of its circle", Mismatch, sample("regular-polygon"),
        "corput/regular_polygon.glsl", "corput_real_multiply(corput_angle_sine(half_side), cosine));\n    return", "corput_angle_sine(half_side));\n    return"),
    mutant("an annulus without its root", Mismatch, sample("annulus"),
        "corput/annulus.glsl", "corput_real_sqrt(corput_real_add(corput_real_square(i), part))", "corput_real_add(corput_real_square(i), part)"),
    mutant("the exponent for its successor", Mismatch, sample("cosine-power-hemisphere"),
        "corput/cosine_power.glsl", "corput_real_complement(u.x)), lobe.next)", "corput_real_complement(u.x)), corput_real_max(lobe.n, corput_real_uint(1u, 0)))"),
    mutant("a power of the cosine without its norm", Mismatch, Target::Map("cosine-power-hemisphere", task::PDF),
        "corput/cosine_power.glsl", "corput_real_multiply(lobe.next, CorputReal(2734261102u, -34, false))", "CorputReal(2734261102u, -34, false)"),
    mutant("the logarithm by z alone", Mismatch, Target::Map("cosine-power-hemisphere", task::INVERT),
        "corput/cosine_power.glsl", "    if (corput_real_less(versine, corput_real_uint(1u, -2))) {", "    if (corput_real_less(versine, corput_real_zero())) {"),
];
