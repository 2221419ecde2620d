//! The mutants: mistakes that a port, a refactoring or a compiler could make.

use corput::catalog::{Map, Options, Scramble, Sequence};

use super::harness::Edit;
use super::harness::Target::{
    self, Function, Generate, Mask, Native, Nearest, Pairs, Portable, Tile,
};

/// What must kill a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Killer {
    /// The linter refuses the module.
    Linter,
    /// Words differ from the reference's.
    Mismatch,
    /// The error exceeds the row's bound.
    Judge,
}

use Killer::{Judge, Linter, Mismatch};

/// A named mistake.
pub struct Mutant {
    /// What is wrong.
    pub name: &'static str,
    /// The edit.
    pub edit: Edit<'static>,
    /// Where it must show.
    pub target: Target,
    /// By what.
    pub killer: Killer,
}

const fn mutant(
    name: &'static str,
    killer: Killer,
    target: Target,
    file: &'static str,
    find: &'static str,
    replace: &'static str,
) -> Mutant {
    Mutant {
        name,
        edit: Edit {
            file,
            find,
            replace,
            times: 1,
        },
        target,
        killer,
    }
}

const fn twice(mut mutant: Mutant) -> Mutant {
    mutant.edit.times = 2;
    mutant
}

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

fn grid() -> Options {
    let mut options = Options::new(Sequence::Hammersley, 1 << 16);
    options.total = Some(3 << 20);
    options.fractions = true;
    options
}

fn disk() -> Options {
    let mut options = Options::new(Sequence::Halton, 1 << 10);
    options.map = Map::from_name("concentric-disk").ok();
    options.with_pdf = true;
    options
}

/// So few points of other sequences that a tile kernel still serves them; the last ones, where
/// a sequence goes on to 2^32.
fn of(sequence: Sequence, scramble: Option<Scramble>) -> Options {
    let mut options = Options::new(sequence, 1 << 15);
    if !sequence.options().contains(&"--total") && sequence != Sequence::Lattice {
        options.first = (1 << 32) - options.count;
    }
    options.scramble = scramble;
    options.seed = Some(0x0123_4567_89ab_cdef);
    options.fractions = true;
    options
}

fn sobol() -> Options {
    of(Sequence::Sobol, Some(Scramble::Shift))
}

fn sobol_owen() -> Options {
    of(Sequence::Sobol, Some(Scramble::Owen))
}

fn sobol_owen_hash() -> Options {
    of(Sequence::Sobol, Some(Scramble::OwenHash))
}

fn pmj02() -> Options {
    of(Sequence::Pmj02, None)
}

fn random() -> Options {
    of(Sequence::Random, None)
}

fn random_fast() -> Options {
    of(Sequence::RandomFast, None)
}

fn pcg32() -> Options {
    of(Sequence::Pcg32, None)
}

fn stratified() -> Options {
    of(Sequence::Stratified, None)
}

fn stratified_floats() -> Options {
    let mut options = of(Sequence::LatinHypercube, None);
    options.count = 33_000;
    options.fractions = false;
    options
}

fn cmj() -> Options {
    of(Sequence::MultiJittered, None)
}

fn lattice() -> Options {
    of(Sequence::Lattice, Some(Scramble::Rotate))
}

fn korobov_floats() -> Options {
    let mut options = of(Sequence::Korobov, Some(Scramble::None));
    options.count = 65_521;
    options.seed = None;
    options.fractions = false;
    options
}

fn r2() -> Options {
    of(Sequence::R2, Some(Scramble::Rotate))
}

fn halton_permuted() -> Options {
    of(Sequence::Halton, Some(Scramble::Permute))
}

fn halton_faure_floats() -> Options {
    let mut options = of(Sequence::Halton, Some(Scramble::Faure));
    options.seed = None;
    options.fractions = false;
    options
}

/// Every mutant.
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
    twice(mutant("a shift by 32", Mismatch, Function("shl64"),
        "corput/fixed.glsl", "s >= 32u", "s > 32u")),
    mutant("packing truncates", Mismatch, Function("cos_sin"),
        "corput/fixed.glsl", " + ((v.m >> 7) & 1u)", ""),
    // Random numbers and scrambles.
    mutant("nine rounds of Philox", Mismatch, Function("philox"),
        "corput/random.glsl", "i < 10u", "i < 9u"),
    mutant("Philox's key bumps swapped", Mismatch, Function("random"),
        "corput/random.glsl", "uvec2(0x9e3779b9u, 0xbb67ae85u)", "uvec2(0xbb67ae85u, 0x9e3779b9u)"),
    mutant("Philox's multipliers swapped", Mismatch, Function("random"),
        "corput/random.glsl",
        "corput_mul64(0xd2511f53u, counter.x);\n        uvec2 b = corput_mul64(0xcd9e8d57u, counter.z)",
        "corput_mul64(0xcd9e8d57u, counter.x);\n        uvec2 b = corput_mul64(0xd2511f53u, counter.z)"),
    twice(mutant("a random number ignores the lowest bits of its dimension", Mismatch, Function("random"),
        "corput/random.glsl", "block[dimension & 3u]", "block.x")),
    mutant("weak bits of the mixer uncovered", Mismatch, Function("random_fast"),
        "corput/hash.glsl", "return v ^ (v >> 16);", "return v;"),
    mutant("no third round of the mixer", Mismatch, Function("seed"),
        "corput/hash.glsl", "v = corput_pcg4d(v);\n    v ^= v >> 16;\n    v.x += v.y * v.w;", "v = corput_pcg4d(v);\n    v ^= v >> 16;"),
    mutant("no carry in PCG32", Mismatch, Function("pcg32"),
        "corput/random.glsl", "return corput_add64(product, increment);", "return product + increment;"),
    mutant("PCG32 drops a cross product", Mismatch, Function("pcg32"),
        "corput/random.glsl", " + state.y * multiplier.x", ""),
    mutant("PCG32's stream is even", Mismatch, Function("pcg32"),
        "corput/random.glsl", "(stream.x << 1) | 1u", "stream.x << 1"),
    mutant("PCG32 jumps by half a distance", Mismatch, Function("pcg32_advance"),
        "corput/random.glsl", "while ((delta.x | delta.y) != 0u)", "while (delta.x != 0u)"),
    mutant("a seed ignores its purpose", Mismatch, Function("seed"),
        "corput/hash.glsl", "uvec4(seed, dimension, purpose)", "uvec4(seed, dimension, 0u)"),
    mutant("one round of pcg4d", Mismatch, Function("pcg4d"),
        "corput/hash.glsl", "v.w += v.y * v.z;\n    v ^= v >> 16;", "v.w += v.y * v.z;\n    return v ^ (v >> 16);"),
    mutant("a shift of the hash off by one", Mismatch, Function("hash"),
        "corput/hash.glsl", "x ^= x >> 11;", "x ^= x >> 12;"),
    mutant("nested scrambling has the purpose of random numbers", Mismatch, Function("owen"),
        "corput/owen.glsl", "uvec4(prefix, subtree, dimension, 1u)", "uvec4(prefix, subtree, dimension, 0u)"),
    mutant("one block for all prefixes of a level", Mismatch, Function("owen"),
        "corput/owen.glsl", "uvec4(prefix, subtree, dimension, 1u)", "uvec4(0u, subtree, dimension, 1u)"),
    mutant("one block for all levels of a prefix", Mismatch, Function("owen"),
        "corput/owen.glsl", "uvec4(prefix, subtree, dimension, 1u)", "uvec4(prefix, 0u, dimension, 1u)"),
    mutant("nested scrambling ignores its seed", Mismatch, Function("owen"),
        "corput/owen.glsl", "uvec4(x >> 4, 4u, dimension, 1u), seed)", "uvec4(x >> 4, 4u, dimension, 1u), uvec2(0u))"),
    mutant("the last subtree off by a level", Mismatch, Function("owen"),
        "corput/owen.glsl", "(x & 15u) << 3) >> 3", "(x & 15u) << 3) >> 2"),
    mutant("a node of level 6 in the wrong word", Mismatch, Function("owen"),
        "corput/owen.glsl", "? block.w : block.z", "? block.z : block.w"),
    mutant("the Owen hash without reversal", Mismatch, Function("owen_hash"),
        "corput/owen.glsl", "    x = corput_reverse_bits(x);\n", ""),
    mutant("an even multiplier in the Owen hash", Mismatch, Function("owen_hash"),
        "corput/owen.glsl", "(seed >> 16) | 1u", "seed >> 16"),
    mutant("the matrix reaches above its diagonal", Mismatch, Function("matrix_scramble"),
        "corput/owen.glsl", "block.x & below", "block.x"),
    mutant("one column for four digits", Mismatch, Function("matrix_scramble"),
        "corput/owen.glsl", "            block = block.yzwx;\n", ""),
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
    // Permutations, strata, scrambled digits, lattices.
    mutant("no cycle walk", Mismatch, Function("permute"),
        "corput/permute.glsl", "outside = x > last;", "outside = false;"),
    mutant("the first key for every round", Mismatch, Function("permute"),
        "corput/permute.glsl", "corput_permute_mix(stream + j * 0x9e3779b9u));", "corput_permute_mix(stream));"),
    mutant("<= for < in ranks", Mismatch, Function("permute"),
        "corput/permute.glsl", "< own ? 1u", "<= own ? 1u"),
    mutant("a permutation of 2^32 rotates by 0", Mismatch, Function("permute"),
        "corput/permute.glsl", "length == 0u ? key : corput_mulhi(key, length)", "corput_mulhi(key, length)"),
    mutant("the next cell's stratum", Mismatch, Function("stratum"),
        "corput/stratified.glsl", "corput_hammersley_start(cell, strata)", "corput_hammersley_start(cell + 1u, strata)"),
    mutant("the jitter is ignored", Mismatch, Function("stratum"),
        "corput/stratified.glsl", "first + corput_mulhi(jitter, end - first)", "first"),
    mutant("2^32 - 1 for 2^32 in the width of a stratum", Mismatch, Function("stratum"),
        "corput/stratified.glsl", "quotient * strata + 1u", "quotient * strata"),
    mutant("floats leave their strata", Mismatch, Function("unit_stratum"),
        "corput/stratified.glsl", "cut + 256u : cut", "cut : cut"),
    mutant("the stride of a jittered grid is ignored", Mismatch, Function("stratified"),
        "corput/stratified.glsl", "n / max(stride, 1u)", "n"),
    mutant("a Latin hypercube in order", Mismatch, Function("latin_hypercube"),
        "corput/stratified.glsl", "corput_stratum(corput_permute(n, count, seed), count, jitter)", "corput_stratum(n, count, jitter)"),
    mutant("rows and columns of a grid swapped", Mismatch, Function("cmj"),
        "corput/stratified.glsl", "row * grid.x + corput_permute(column", "row * grid.y + corput_permute(column"),
    mutant("Faure's middle is counted", Mismatch, Function("radical_inverse_faure"),
        "corput/scrambled_radical_inverse.glsl", "digit -= middle + (b & 1u);", "digit -= middle;"),
    mutant("floor for ceil in Faure's inverse", Mismatch, Function("radical_inverse_faure"),
        "corput/scrambled_radical_inverse.glsl", "scramble == CORPUT_SCRAMBLE_FAURE ? power - 1u : 0u", "0u"),
    mutant("a ceiling of 2^32 wraps", Mismatch, Function("radical_inverse_faure"),
        "corput/scrambled_radical_inverse.glsl", "if (group.w + low.y >= power) {", "if (false) {"),
    mutant("three groups of digits for four", Mismatch, Function("radical_inverse_permuted"),
        "corput/scrambled_radical_inverse.glsl", "power < 1626u ? 4u : 3u", "3u"),
    mutant("groups of digits swapped", Mismatch, Function("radical_inverse_permuted"),
        "corput/scrambled_radical_inverse.glsl", "uvec4(group.yzw, reversed)", "uvec4(group.zyw, reversed)"),
    mutant("the position of a digit is ignored", Mismatch, Function("radical_inverse_permuted"),
        "corput/scrambled_radical_inverse.glsl", "corput_permute_mix(stream + position * 0x9e3779b9u)", "corput_permute_mix(stream)"),
    mutant("the digits before are ignored", Mismatch, Function("radical_inverse_owen"),
        "corput/scrambled_radical_inverse.glsl", "corput_permute_mix(prefix) : 0u", "0u : 0u"),
    mutant("no carry from a random start", Mismatch, Function("radical_inverse_started"),
        "corput/scrambled_radical_inverse.glsl", "corput_mulhi(key, base) + carry", "corput_mulhi(key, base)"),
    mutant("permuted for nested", Mismatch, Function("halton_scrambled"),
        "corput/halton_scrambled.glsl", "return corput_radical_inverse_owen(", "return corput_radical_inverse_permuted("),
    mutant("a lattice in natural order", Mismatch, Function("lattice"),
        "corput/lattice.glsl", "return corput_reverse_bits(n) * z;", "return n * z;"),
    mutant("no carry in the remainder of a product", Mismatch, Function("korobov"),
        "corput/lattice.glsl", "if (carry || remainder >= count)", "if (remainder >= count)"),
    mutant("the low word of alpha is ignored", Mismatch, Function("additive"),
        "corput/lattice.glsl", "n * alpha.y + corput_mulhi(n, alpha.x)", "n * alpha.y"),
    // Nets.
    mutant("Sobol skips the highest bit", Mismatch, Function("sobol"),
        "corput/sobol.glsl", "bit < 32u", "bit < 31u"),
    mutant("a flipped bit of one direction number", Mismatch, Function("sobol"),
        "corput/sobol.glsl", "CORPUT_SOBOL_DIRECTION(dimension, bit) : 0u",
        "CORPUT_SOBOL_DIRECTION(dimension, bit) ^ (bit == 17u ? 0x00000100u : 0u) : 0u"),
    mutant("Gray code of the next bit", Mismatch, Function("sobol"),
        "corput/sobol.glsl", "n ^ (n >> 1)", "n ^ (n >> 2)"),
    mutant("Pascal's triangle lacks a fold", Mismatch, Function("sobol"),
        "corput/pmj02.glsl", "    y ^= (y & 0xccccccccu) >> 2;\n", ""),
    mutant("pmj02 in order", Mismatch, Function("pmj02"),
        "corput/pmj02.glsl", "corput_sobol_pair(corput_pmj02_index(n, seed))", "corput_sobol_pair(n)"),
    mutant("both coordinates of pmj02 scrambled alike", Mismatch, Function("pmj02"),
        "corput/pmj02.glsl", "corput_pmj02_scramble(p.y, 1u, seed)", "corput_pmj02_scramble(p.y, 0u, seed)"),
    mutant("pmj02 ignores its seed", Mismatch, Function("pmj02"),
        "corput/pmj02.glsl", "0x80000000u | which, seed)", "0x80000000u | which, uvec2(0u))"),
    mutant("pmj02 has the numbers of a scrambled Sobol sequence", Mismatch, Function("pmj02"),
        "corput/pmj02.glsl", "0x80000000u | which", "which"),
    // Domains.
    mutant("a child ignores its key", Mismatch, Function("domain_child"),
        "corput/domain.glsl", "uvec4(parent.pattern, key, 0u)", "uvec4(parent.pattern, 0u, 0u)"),
    mutant("a split without its size", Mismatch, Function("domain_chain"),
        "corput/domain.glsl", "child.index * size + branch", "child.index + branch"),
    mutant("a chain ignores its link", Mismatch, Function("domain_chain"),
        "corput/domain.glsl", "uvec4(v.xy, link, 2u)", "uvec4(v.xy, 0u, 2u)"),
    mutant("a domain ignores its frame", Mismatch, Function("domain"),
        "corput/domain.glsl", "uvec4(pixel, frame, seed)", "uvec4(pixel, 0u, seed)"),
    mutant("one seed for all dimensions of a draw", Mismatch, Function("domain"),
        "corput/domain.glsl", "corput_seed(domain.pattern, d, 4u)", "corput_seed(domain.pattern, 0u, 4u)"),
    mutant("the second pair of a draw is the first", Mismatch, Function("draw_pmj02"),
        "corput/domain_draw.glsl", "corput_pmj02(domain.index, other)", "corput_pmj02(domain.index, domain.pattern)"),
    mutant("both pairs of a draw shuffled alike", Mismatch, Function("draw_pairs"),
        "corput/domain_draw.glsl", "uvec2 q = corput_sobol_pair(corput_owen_hash(domain.index, corput_domain_seed(domain, 1u)));",
        "uvec2 q = corput_sobol_pair(corput_owen_hash(domain.index, corput_domain_seed(domain, 0u)));"),
    mutant("a dimension of a draw twice", Mismatch, Function("draw_sobol"),
        "corput/domain_sobol.glsl", "corput_owen_hash(corput_sobol(n, 3u), corput_domain_seed(domain, 4u))",
        "corput_owen_hash(corput_sobol(n, 2u), corput_domain_seed(domain, 4u))"),
    mutant("a draw of Sobol in order", Mismatch, Function("draw_sobol_owen"),
        "corput/domain_sobol.glsl", "uint n = corput_owen(domain.index, 4u, domain.pattern);", "uint n = domain.index;"),
    mutant("a draw of Halton in other primes", Mismatch, Function("draw_halton"),
        "corput/domain_halton.glsl", "corput_radical_inverse_owen(n, CORPUT_PRIME(3u)", "corput_radical_inverse_owen(n, CORPUT_PRIME(2u)"),
    // Columns.
    mutant("a tile stays in its block of 256", Mismatch, Tile(sobol),
        "kernels/column_net.glsl", "(index & 255u) == 0u ? cursor.next_high : cursor.high", "cursor.high"),
    mutant("a block's carry one point late", Mismatch, Tile(sobol),
        "kernels/column_net.glsl", "(index & 255u) == 0u", "(index & 255u) == 1u"),
    mutant("the highest direction number is left out", Mismatch, Tile(sobol),
        "kernels/column_net.glsl", " ^ NET_BIT(block, 23, d.d31);", ";"),
    mutant("directions begin a word late", Mismatch, Generate(sobol),
        "kernels/column_net.glsl", "columns[at + 5u], at + 6u", "columns[at + 5u], at + 7u"),
    mutant("words of a seed swapped", Mismatch, Tile(sobol_owen),
        "kernels/column_net.glsl", "corput_owen(x, c.dimension, uvec2(c.seed_low, c.seed_high))",
        "corput_owen(x, c.dimension, uvec2(c.seed_high, c.seed_low))"),
    mutant("a dimension for a seed", Mismatch, Generate(sobol_owen),
        "kernels/column_net.glsl", "corput_owen(x, c.dimension, uvec2(c.seed_low, c.seed_high))",
        "corput_owen(x, c.seed_low, uvec2(c.dimension, c.seed_high))"),
    mutant("the fast scramble by the shift", Mismatch, Tile(sobol_owen_hash),
        "kernels/column_net.glsl", "corput_owen_hash(x, c.hash)", "corput_owen_hash(x, c.shift)"),
    mutant("x for y in columns of pmj02", Mismatch, Tile(pmj02),
        "kernels/column_net.glsl", "c.dimension == 0u ? p.x : p.y", "p.x"),
    mutant("a column of random numbers ignores its dimension", Mismatch, Tile(random),
        "kernels/column_random.glsl", "corput_random(n, c.dimension,", "corput_random(n, 0u,"),
    mutant("the fast random numbers for the others", Mismatch, Generate(random),
        "kernels/column_random.glsl", "return corput_random(n", "return corput_random_fast(n"),
    mutant("the fast random numbers' seed halved", Mismatch, Tile(random_fast),
        "kernels/column_random.glsl", "corput_random_fast(n, c.dimension, uvec2(c.seed_low, c.seed_high))",
        "corput_random_fast(n, c.dimension, uvec2(c.seed_low, 0u))"),
    mutant("PCG32 one number per point", Mismatch, Tile(pcg32),
        "kernels/column_random.glsl", "corput_mul64(n, c.dimensions)", "uvec2(n, 0u)"),
    mutant("PCG32's numbers below 2^32 alone", Mismatch, Generate(pcg32),
        "kernels/column_random.glsl", "corput_add64(corput_mul64(n, c.dimensions), uvec2(c.dimension, 0u))",
        "uvec2(n * c.dimensions + c.dimension, 0u)"),
    mutant("every axis of a grid with the first one's stride", Mismatch, Tile(stratified),
        "kernels/column_strata.glsl", "corput_stratified(n, c.stride,", "corput_stratified(n, 1u,"),
    mutant("one jitter for all axes", Mismatch, Generate(stratified),
        "kernels/column_strata.glsl", "corput_random_of(n, c.dimension,", "corput_random_of(n, 0u,"),
    mutant("floats of strata cut", Mismatch, Tile(stratified_floats),
        "kernels/column_strata.glsl", "corput_unit_stratum(fraction, c.strata)", "corput_unit_floor(fraction)"),
    mutant("a grid on its side", Mismatch, Tile(cmj),
        "kernels/column_strata.glsl", "uvec2(c.grid_x, c.grid_y)", "uvec2(c.grid_y, c.grid_x)"),
    mutant("a lattice not rotated", Mismatch, Tile(lattice),
        "kernels/column_lattice.glsl", "corput_rotate(corput_lattice(n, c.step_low), c.shift)", "corput_lattice(n, c.step_low)"),
    mutant("the recurrence's step of 32 bits", Mismatch, Tile(r2),
        "kernels/column_lattice.glsl", "uvec2(c.step_low, c.step_high)", "uvec2(0u, c.step_high)"),
    mutant("floats of multiples of 1/N cut", Mismatch, Tile(korobov_floats),
        "kernels/column_lattice.glsl", "c.kind == KOROBOV ? corput_unit_ceil(fraction) : corput_unit_floor(fraction)",
        "corput_unit_floor(fraction)"),
    mutant("kinds of digits swapped", Mismatch, Tile(halton_permuted),
        "kernels/column_digits.glsl", "c.kind == PERMUTED", "c.kind == OWEN"),
    mutant("floats of Faure's inverses cut", Mismatch, Tile(halton_faure_floats),
        "kernels/column_digits.glsl", "c.kind == FAURE && c.base != 2u", "false"),
    mutant("floats of Faure's inverses go up in base 2", Mismatch, Generate(halton_faure_floats),
        "kernels/column_digits.glsl", " && c.base != 2u", ""),
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
    // Pairs of points.
    mutant("the lesser coordinate in L2-star", Mismatch, Pairs,
        "corput/discrepancy.glsl", "corput_scale64(p, max(x, y))", "corput_scale64(p, min(x, y))"),
    mutant("the centred kernel on the wrong side", Mismatch, Pairs,
        "corput/discrepancy.glsl", ">> 31) == 0u ? nearer", ">> 31) != 0u ? nearer"),
    mutant("3/2 for 5/4 in the wrap-around kernel", Mismatch, Pairs,
        "corput/discrepancy.glsl", "corput_add64(p, corput_shr64(p, 2u))", "corput_add64(p, corput_shr64(p, 1u))"),
    mutant("the mixture kernel without its square", Mismatch, Pairs,
        "corput/discrepancy.glsl", "corput_add64(corput_sub64(more, less), corput_shr64(twice, 1u))", "corput_sub64(more, less)"),
    mutant("the low word of a product is lost", Mismatch, Pairs,
        "corput/discrepancy.glsl", "uvec2(corput_mulhi(p.x, f), 0u)", "uvec2(0u)"),
    mutant("a sum of products overflows", Mismatch, Pairs,
        "kernels/pairs.comp", "high = corput_add64(high, uvec2(p.y, 0u));", "high.x += p.y;"),
    mutant("pairs twice in several blocks", Mismatch, Pairs,
        "kernels/pairs.comp", "other < push.end_other", "other < push.count"),
    mutant("a point is its own neighbour", Mismatch, Nearest,
        "kernels/nearest.comp", "max(push.first_other, row + 1u)", "max(push.first_other, row)"),
    mutant("a torus with one way around", Mismatch, Nearest,
        "corput/distance.glsl", "min(x - y, y - x)", "x - y"),
    mutant("a carry lost between squares", Mismatch, Nearest,
        "corput/distance.glsl", "corput_addc(middle.x, low.y)", "uvec2(middle.x, 0u)"),
    mutant("squares compared by their high words", Mismatch, Nearest,
        "corput/distance.glsl", "    return a.x < b.x;", "    return false;"),
    // Dither masks and screen space.
    mutant("ties to the highest row", Mismatch, Mask, "kernels/void_and_cluster.comp",
        "            atomicMin(best_row, best.y);
        }
        barrier();
        uint inverted = 0u - removes;
        for (uint x = lane; x < push.width; x += gl_WorkGroupSize.x) {
            uint at = best_row * push.width + x;",
        "            atomicMin(best_row, ~best.y);
        }
        barrier();
        uint inverted = 0u - removes;
        for (uint x = lane; x < push.width; x += gl_WorkGroupSize.x) {
            uint at = ~best_row * push.width + x;"),
    mutant("a mask does not wrap around", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "return min(d, circumference - d);", "return d;"),
    mutant("the Gaussian is wider", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "across * across + down * down", "(across * across + down * down) * 3u / 4u"),
    mutant("voids filled before clusters are thinned", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "(push.removes >> (pass & 1u))", "(push.removes >> (~pass & 1u))"),
    mutant("an update skipped", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "if (squared < push.terms)", "if (squared < push.terms && change.x + change.y != 5u)"),
    mutant("removal adds energy", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "change.removed ? 0u - energies[squared] : energies[squared]", "energies[squared]"),
    mutant("the row above is not reached", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "for (uint i = 0u; i < count; i++)", "for (uint i = 1u; i < count; i++)"),
    mutant("frames do not repel each other", Mismatch, Mask,
        "kernels/void_and_cluster.comp", "across == 0u ? distance * distance : push.terms", "push.terms"),
    mutant("the lower edge of a rank's part", Mismatch, Function("blue_noise"),
        "corput/blue_noise.glsl", "(2u * rank + 1u) << 15", "(2u * rank) << 15"),
    mutant("a mask's second digit forgotten", Mismatch, Function("blue_noise"),
        "corput/blue_noise.glsl", " + ((high % count) << 16) / count", ""),
    mutant("frames one row apart", Mismatch, Function("blue_noise"),
        "corput/blue_noise.glsl", "frame % size.z * size.y +", "frame % size.z +"),
    mutant("a shift not wrapped", Mismatch, Function("blue_noise_shift"),
        "corput/blue_noise.glsl", "uvec2(pixel.x % size.x +", "uvec2(pixel.x +"),
    mutant("x and y of the Z-order swapped", Mismatch, Function("screen_space"),
        "corput/screen_space.glsl", "corput_screen_space_spread(pixel.x) |", "corput_screen_space_spread(pixel.y) |"),
    mutant("digits shuffled without those above", Mismatch, Function("screen_space"),
        "corput/screen_space.glsl", "((code >> shift) >> 2) & ((1u << (2u * level)) - 1u)", "0u"),
    mutant("a permutation twice", Mismatch, Function("screen_space"),
        "corput/screen_space.glsl", "0xe4u, 0xb4u", "0xe4u, 0xe4u"),
    // The native profile, which has no reference.
    mutant("sine and cosine swapped", Judge, Native("native_polar_disk"),
        "corput/native/disk.glsl", "radius * cos(phi), radius * sin(phi)", "radius * sin(phi), radius * cos(phi)"),
    mutant("pi to two places", Judge, Native("native_cosine_hemisphere_polar"),
        "corput/native/disk.glsl", "6.2831853 *", "6.28 *"),
    mutant("1/pi to two places", Judge, Native("native_cosine_hemisphere"),
        "corput/native/hemisphere.glsl", "* 0.31830989;\n}\n\n// The fractions that give this direction.\nuvec2 corput_native_cosine_hemisphere_invert",
        "* 0.32;\n}\n\n// The fractions that give this direction.\nuvec2 corput_native_cosine_hemisphere_invert"),
];
