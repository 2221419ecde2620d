//! Radical inverses, conversions, wide integers, elementary functions, maps and the frame.

use corput::catalog::{Map, Mapping, Options, Sequence};
use corput::interface::task;

use super::Killer::{Judge, Linter, Mismatch};
use super::{Mutant, mutant, twice};
use crate::harness::Target::{self, Function, Generate, Native, NativeElementary, Portable, Tile};

fn points(bases: &[u64], fractions: bool) -> Options {
    let mut options = Options::new(Sequence::Halton, 1 << 16);
    options.first = 3_486_784_401 - 40;
    options.bases = Some(bases.to_vec());
    options.fractions = fractions;
    options
}

fn fractions() -> Options {
    points(&[3, 5, 8161], true)
}

fn floats() -> Options {
    points(&[2, 3], false)
}

/// A row of two parts that share a column, of as many words as tiles are worth.
fn ragged() -> Options {
    let mut options = Options::new(Sequence::Halton, 1 << 20);
    options.dimensions = Some(7);
    options
}

fn grid() -> Options {
    let mut options = Options::new(Sequence::Hammersley, 1 << 16);
    options.total = Some(3 << 20);
    options.fractions = true;
    options
}

fn disk() -> Options {
    let mut options = Options::new(Sequence::Halton, 1 << 10);
    let map = Map::from_name("concentric-disk");
    options.map = map.and_then(|map| Mapping::new(map, &[])).ok();
    options.with_pdf = true;
    options
}

#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
    // Rounding of fractions.
    mutant("floor for ceil in the radical inverse", Mismatch, Function("radical_inverse"),
        "corput/radical_inverse.glsl", "corput_addc(y, power - 1u)", "uvec2(y, 0u)"),
    mutant("floor for ceil in the radical inverse from a table", Mismatch, Generate(fractions),
        "corput/radical_inverse.glsl", "corput_addc(y, b.power - 1u)", "uvec2(y, 0u)"),
    twice(mutant("floor for ceil in the odometer", Mismatch, Tile(fractions),
        "corput/odometer.glsl", " / b.power + 0xffffu", " / b.power")),
    mutant("floor for ceil in k/N", Mismatch, Function("hammersley"),
        "corput/hammersley.glsl", "p.fraction + (p.remainder != 0u ? 1u : 0u)", "p.fraction"),
    mutant("> for >= in the long division of k/N", Mismatch, Function("hammersley"),
        "corput/hammersley.glsl", "carry || remainder >= count", "carry || remainder > count"),
    mutant("> for >= in the step of k/N", Mismatch, Function("hammersley"),
        "corput/hammersley.glsl", "count != 0u && remainder >= count", "count != 0u && remainder > count"),
    mutant("no carry in the step of k/N", Mismatch, Tile(grid),
        "corput/hammersley.glsl", "p.fraction + step.fraction + (carry ? 1u : 0u)", "p.fraction + step.fraction"),
    // Reals.
    mutant("no guard bits in a difference", Mismatch, Function("real_add"),
        "corput/real.glsl", "uint(clamp(large.e - small.e, 0, 63)));", "uint(clamp(large.e - small.e, 0, 63))) & uvec2(0u, 0xffffffffu);"),
    mutant("a quotient without its residual", Mismatch, Function("real_multiply"),
        "corput/real.glsl", "uvec2(low, 0u)", "uvec2(0u)"),
    mutant("a reciprocal of one iteration less", Mismatch, Function("real_multiply"),
        "corput/real.glsl", "corput_mulhi(m, x)), 30u).x << 1;", "0x40000000u), 30u).x << 1;"),
    mutant("no odd exponents in the root", Mismatch, Function("real_sqrt"),
        "corput/real.glsl", "+ ((square.m & odd) << 17)", ""),
    mutant("no saturation of floats", Mismatch, Function("real_float"),
        "corput/real.glsl", "min(0x7f7fffffu, corput_pack_bits(CorputScaled(a.m, clamp(a.e, -157, 97))));", "corput_pack_bits(CorputScaled(a.m, clamp(a.e, -157, 97)));"),
    mutant("magnitudes for signed numbers in min", Mismatch, Function("real_min"),
        "corput/real.glsl", "uint larger = uint(corput_real_smaller(b, a));", "uint larger = smaller;"),
    mutant("the vector product the other way round", Mismatch, Function("real_vector"),
        "corput/real_vector.glsl", "corput_real_multiply(v.y, w.z), corput_real_multiply(v.z, w.y)", "corput_real_multiply(v.z, w.y), corput_real_multiply(v.y, w.z)"),
    // Maps of points in memory.
    mutant("the first fraction for the second", Mismatch, Target::Map("cosine-hemisphere", task::SAMPLE),
        "kernels/map_main.glsl", "points[at + 1u]", "points[at]"),
    mutant("the pdf of another map", Mismatch, Target::Map("uniform-hemisphere", task::PDF),
        "kernels/map_hemisphere.glsl", "return floatBitsToUint(MAP_FUNCTION(uniform_hemisphere_pdf)(d));",
        "return floatBitsToUint(MAP_FUNCTION(cosine_hemisphere_pdf)(d));"),
    mutant("columns for rows in the inverse", Mismatch, Target::Map("polar-disk", task::INVERT),
        "kernels/map_hemisphere.glsl", "(polar_disk_invert)(d.xy)", "(polar_disk_invert)(d.yx)"),
    // Floats from fractions.
    mutant("2^-32 float(u) in unit_floor", Mismatch, Function("unit"),
        "corput/unit.glsl", "float(u >> 8) * 5.9604644775390625e-8", "float(u) * 2.3283064365386963e-10"),
    mutant("2^-32 float(u) in unit_ceil", Mismatch, Function("unit"),
        "corput/unit.glsl", "float(min(k, 0xffffffu)) * 5.9604644775390625e-8", "float(u) * 2.3283064365386963e-10"),
    mutant("2^-32 float(u) in a map", Linter, Function("uniform_hemisphere"),
        "corput/hemisphere.glsl", "        corput_pack(z, false));\n}\n\n// 1/(2 pi)",
        "        float(u.x) * 2.3283064365386963e-10);\n}\n\n// 1/(2 pi)"),
    mutant("no min(..., 2^24 - 1) in unit_ceil", Mismatch, Function("unit"),
        "corput/unit.glsl", "float(min(k, 0xffffffu))", "float(k)"),
    mutant("unit_floor for unit_ceil in base 3", Mismatch, Tile(floats),
        "kernels/column_radical.glsl", "c.kind == REVERSED ? corput_unit_floor(fraction) : corput_unit_ceil(fraction)", "corput_unit_floor(fraction)"),
    mutant("an index through float", Linter, Tile(floats),
        "corput/radical_inverse.glsl", "return corput_reverse_bits(n);", "return corput_reverse_bits(uint(float(n)));"),
    // Digits.
    mutant("digits of a group not reversed", Mismatch, Generate(fractions),
        "corput/radical_inverse.glsl",
        "    uint reversed = 0u;\n    for (uint i = 0u; i < b.digits; i++) {",
        "    uint reversed = group;\n    for (uint i = 0u; i < 0u; i++) {"),
    mutant("two digits swapped", Mismatch, Function("radical_inverse"),
        "corput/radical_inverse.glsl", "group = uvec4(group.yzw, reversed);", "group = uvec4(group.zyw, reversed);"),
    mutant("the odometer stays in its block", Mismatch, Tile(fractions),
        "corput/odometer.glsl", "wrapped ? o.next_quotient : o.quotient", "o.quotient"),
    mutant("the odometer's second digit does not carry", Mismatch, Tile(fractions),
        "corput/odometer.glsl", "first + second - b.power", "first - b.power"),
    // Wide integers.
    mutant("no carry", Mismatch, Function("mul64"),
        "corput/fixed.glsl", "return uvec2(sum, carry);", "return uvec2(sum, 0u);"),
    mutant("no carry, portable", Mismatch, Portable("add64"),
        "corput/fixed.glsl", "sum < a ? 1u : 0u", "0u"),
    mutant("no borrow", Mismatch, Function("add64"),
        "corput/fixed.glsl", "return uvec2(difference, borrow);", "return uvec2(difference, 0u);"),
    mutant("the portable mulhi lacks its cross term", Mismatch, Portable("mul64"),
        "corput/fixed.glsl", " + (cross >> 16)", ""),
    twice(mutant("a shift by less than 32", Mismatch, Function("shl64"),
        "corput/fixed.glsl", "uint whole = 0u - (s >> 5);", "uint whole = 0u;")),
    mutant("a shift by 0 that keeps the other word", Mismatch, Function("shl64"),
        "corput/fixed.glsl", "((low >> 1) >> (31u - part))", "(low >> (31u - part))"),
    mutant("packing truncates", Mismatch, Function("cos_sin"),
        "corput/fixed.glsl", " + ((v.m >> 7) & 1u)", ""),
    // Elementary functions.
    mutant("a native square root", Linter, Function("sqrt"),
        "corput/elementary.glsl",
        "return uintBitsToFloat((((exponent + odd) >> 1) << 23) + (62u << 23) + (s >> 1) + (s & 1u));", "return sqrt(x);"),
    mutant("a native division", Linter, Function("divide"),
        "corput/elementary.glsl", "uint q = corput_seed_divide(a, b);", "uint q = uint(float(a) / float(b) * 16777216.0);"),
    mutant("a native sine", Linter, Function("polar_disk"),
        "corput/disk.glsl", "corput_pack(corput_scaled_mul(radius, phi.sine), phi.sine_negative)", "sin(uintBitsToFloat(u.y))"),
    mutant("the root is cut, not rounded", Mismatch, Function("sqrt"),
        "corput/elementary.glsl", "(s >> 1) + (s & 1u))", "(s >> 1))"),
    mutant("the quotient's sticky bit is lost", Mismatch, Function("divide"),
        "corput/elementary.glsl", "(r != 0 ? 1u : 0u)", "0u"),
    mutant("the product's sticky bits are lost", Mismatch, Function("multiply"),
        "corput/elementary.glsl", "(sticky != 0u ? 1u : 0u)", "0u"),
    mutant("the seed of fixed-point quotients may be too large", Mismatch, Function("ratio"),
        "corput/elementary.glsl", "32767.875)", "32768.0)"),
    mutant("a coefficient of the sine 2^12 units off", Mismatch, Function("cos_sin"),
        "corput/elementary.glsl", "346799334u", "346803430u"),
    mutant("a coefficient of the cosine 2^12 units off", Mismatch, Function("cos_sin"),
        "corput/elementary.glsl", "1324675879u", "1324679975u"),
    mutant("a coefficient of the arc tangent 2^12 units off", Mismatch, Function("atan2"),
        "corput/elementary.glsl", "546849516u", "546853612u"),
    mutant("octants swapped", Mismatch, Function("cos_sin"),
        "corput/elementary.glsl", "if (swapped) {", "if (!swapped) {"),
    mutant("no rounding to the nearest quarter turn", Mismatch, Function("cos_sin"),
        "corput/elementary.glsl", "(u + 0x20000000u) >> 30", "u >> 30"),
    mutant("quadrants mirrored", Mismatch, Function("atan2"),
        "corput/elementary.glsl", "angle = 0x40000000u - angle;", "angle = 0x40000000u + angle;"),
    // Maps.
    twice(mutant("1/pi one unit off", Mismatch, Tile(disk),
        "corput/disk.glsl", "0x3ea2f983u", "0x3ea2f984u")),
    mutant("1/(2 pi) one unit off", Mismatch, Function("uniform_hemisphere"),
        "corput/hemisphere.glsl", "0x3e22f983u", "0x3e22f982u"),
    mutant("1/pi of 24 bits", Mismatch, Function("cosine_hemisphere"),
        "corput/hemisphere.glsl", "2734261102u", "2734261248u"),
    mutant("x and y of the concentric map swapped", Mismatch, Function("concentric_disk"),
        "corput/disk.glsl", "x_large ? near : far", "x_large ? far : near"),
    mutant("~u for 1 - u", Mismatch, Function("cosine_hemisphere_polar"),
        "corput/hemisphere.glsl", "corput_sqrt_fraction(0u - u.x)", "corput_sqrt_fraction(~u.x)"),
    mutant("an inverse on the wrong side", Mismatch, Function("disk_invert"),
        "corput/disk.glsl", "negative ? 0x80000000u - a", "!negative ? 0x80000000u - a"),
    mutant("pdfs below the normal floats", Mismatch, Function("hemisphere_pdf"),
        "corput/hemisphere.glsl", "bits < 0x01800000u", "bits < 0x00800000u"),
    mutant("a pdf by a float compare", Linter, Function("hemisphere_pdf"),
        "corput/hemisphere.glsl", "z <= 0x7f800000u || z == 0x80000000u", "direction.z >= 0.0"),
    // The frame.
    mutant("fma in the frame", Linter, Function("frame_to_world"),
        "corput/frame.glsl", "CORPUT_PRECISE float abc = ab + c;", "float abc = fma(v.z, w.z, ab);"),
    mutant("dot in the frame", Linter, Function("frame_to_local"),
        "corput/frame.glsl", "CORPUT_PRECISE float abc = ab + c;", "float abc = dot(v, w);"),
    mutant("the frame keeps tiny components", Mismatch, Function("frame_tangent"),
        "corput/frame.glsl", "< 0x2b800000u ? 0.0 : x", "< 0x2b800000u ? x : x"),
    mutant("the frame's sums in another order", Mismatch, Function("frame_to_world"),
        "corput/frame.glsl", "float ab = a + b;\n    CORPUT_PRECISE float abc = ab + c;",
        "float bc = b + c;\n    CORPUT_PRECISE float abc = a + bc;"),
    // Kernels.
    mutant("the second half of a tile's store repeats the first", Mismatch, Tile(floats),
        "kernels/generate_tile.comp", "results[at + 1u] = uvec4(p[2].xy, p[3].xy);", "results[at + 1u] = uvec4(p[0].xy, p[1].xy);"),
    mutant("a part of a row in place of another", Mismatch, Tile(ragged),
        "kernels/generate_tile.comp", " + FIRST_COLUMN;", ";"),
    mutant("a column of a ragged row that no part stores", Mismatch, Tile(ragged),
        "kernels/generate_tile.comp", "if (k >= SKIPPED)", "if (k > SKIPPED)"),
    mutant("words of a ragged row beside their places", Mismatch, Tile(ragged),
        "kernels/generate_tile.comp", "[(word + k) % 4u]", "[k]"),
    // The native profile, which has no reference.
    mutant("sine and cosine swapped", Judge, Native("native_polar_disk"),
        "corput/native/disk.glsl", "radius * cos(phi), radius * sin(phi)", "radius * sin(phi), radius * cos(phi)"),
    mutant("pi to two places", Judge, Native("native_cosine_hemisphere_polar"),
        "corput/native/disk.glsl", "6.2831853 *", "6.28 *"),
    mutant("a native quotient 8 ULP off", Judge, NativeElementary("divide"),
        "kernels/function.comp", "x / y)", "x / y * 1.000001)"),
    mutant("a native root 8 ULP off", Judge, NativeElementary("sqrt"),
        "kernels/function.comp", "corput_sqrt(p), sqrt(p)", "corput_sqrt(p), sqrt(p) * 1.000001"),
    mutant("a native product 2 ULP off", Judge, NativeElementary("multiply"),
        "kernels/function.comp", "x * y)", "x * y * 1.0000003)"),
    mutant("a native sine of pi to three places", Judge, NativeElementary("cos_sin"),
        "kernels/function.comp", "6.2831853 *", "6.282 *"),
    mutant("a native arc tangent 2^-10 off", Judge, NativeElementary("atan2"),
        "kernels/function.comp", "corput_native_turns(vec2(x, y))", "corput_native_turns(vec2(x, y)) * 1.001"),
    mutant("a native binary logarithm 2^-20 off", Judge, NativeElementary("log2"),
        "kernels/function.comp", "corput_log2(p), log2(p))", "corput_log2(p), log2(p) + 1e-6)"),
    mutant("a term less of the native logarithm's series", Judge, NativeElementary("negative_log"),
        "corput/native/free_flight.glsl", "0.33333334 + x * (0.25", "0.33333334 + x * (0.24"),
    mutant("a native logarithm 2^-20 off", Judge, NativeElementary("log"),
        "kernels/function.comp", "corput_log(p), log(p))", "corput_log(p), log(p) + 1e-6)"),
    mutant("1/pi to two places", Judge, Native("native_cosine_hemisphere"),
        "corput/native/hemisphere.glsl", "* 0.31830989;\n}\n\n// The fractions that give this direction.\nuvec2 corput_native_cosine_hemisphere_invert",
        "* 0.32;\n}\n\n// The fractions that give this direction.\nuvec2 corput_native_cosine_hemisphere_invert"),
];
