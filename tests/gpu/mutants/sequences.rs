//! Random numbers, permutations, strata, scrambles, lattices, nets, domains and their columns.

use corput::catalog::{Options, Scramble, Sequence};

use super::Killer::Mismatch;
use super::{Mutant, mutant, twice};
use crate::harness::Target::{Function, Generate, Tile, Wide};

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

fn van_der_corput() -> Options {
    of(Sequence::VanDerCorput, None)
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

fn halton() -> Options {
    let mut options = of(Sequence::Halton, None);
    options.seed = None;
    options
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

#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
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
        "corput/owen.glsl", "corput_owen_hash_reversed(corput_reverse_bits(x), seed)", "corput_owen_hash_reversed(x, seed)"),
    mutant("an even multiplier in the Owen hash", Mismatch, Function("owen_hash"),
        "corput/owen.glsl", "(seed >> 16) | 1u", "seed >> 16"),
    mutant("the matrix reaches above its diagonal", Mismatch, Function("matrix_scramble"),
        "corput/owen.glsl", "block.x & below", "block.x"),
    mutant("one column for four digits", Mismatch, Function("matrix_scramble"),
        "corput/owen.glsl", "            block = block.yzwx;\n", ""),
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
    mutant("the first two directions swapped", Mismatch, Generate(sobol),
        "kernels/column_net.glsl", "Directions(b.z, b.w, c.x,", "Directions(b.w, b.z, c.x,"),
    mutant("words of a seed swapped", Mismatch, Tile(sobol_owen),
        "kernels/column_net.glsl", "uvec2(low, high)", "uvec2(high, low)"),
    mutant("a dimension for a seed", Mismatch, Generate(sobol_owen),
        "kernels/column_net.glsl", "corput_owen(x, dimension, uvec2(low, high))",
        "corput_owen(x, low, uvec2(dimension, high))"),
    mutant("the fast scramble by the shift", Mismatch, Tile(sobol_owen_hash),
        "kernels/column_net.glsl", "corput_owen_hash_reversed(x, hash)", "corput_owen_hash_reversed(x, shift)"),
    mutant("x for y in columns of pmj02", Mismatch, Tile(pmj02),
        "kernels/column_net.glsl", "c.dimension == 0u ? p.x : p.y", "p.x"),
    mutant("a column of random numbers ignores its dimension", Mismatch, Tile(random),
        "kernels/column_random.glsl", "corput_random(n, c.dimension,", "corput_random(n, 0u,"),
    mutant("the fast random numbers for the others", Mismatch, Generate(random),
        "kernels/column_random.glsl", "value = corput_random(n", "value = corput_random_fast(n"),
    mutant("the fast random numbers' seed halved", Mismatch, Tile(random_fast),
        "kernels/column_random.glsl", "corput_random_fast(n, c.dimension, seed)",
        "corput_random_fast(n, c.dimension, uvec2(seed.x, 0u))"),
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
        "kernels/column_lattice.glsl", "corput_rotate(value, c.shift)", "value"),
    mutant("the recurrence's step of 32 bits", Mismatch, Tile(r2),
        "kernels/column_lattice.glsl", "uvec2(c.step_low, c.step_high)", "uvec2(0u, c.step_high)"),
    mutant("floats of multiples of 1/N cut", Mismatch, Tile(korobov_floats),
        "kernels/column_lattice.glsl", "c.kind == KOROBOV ? corput_unit_ceil(fraction) : corput_unit_floor(fraction)",
        "corput_unit_floor(fraction)"),
    mutant("a tile of permuted digits stays in its block", Mismatch, Tile(halton_permuted),
        "kernels/column_digits.glsl", "cursor.high = cursor.next_high;", ""),
    mutant("the 1 of a block's number not carried", Mismatch, Tile(halton_permuted),
        "kernels/column_digits.glsl", "        n = rest;\n    }\n    uvec2 y", "        n = rest;\n        carried = false;\n    }\n    uvec2 y"),
    mutant("a digit of the next block by the weight of another", Mismatch, Tile(halton_permuted),
        "kernels/column_digits.glsl", "corput_divide_by(weight, b.base_magic, b.base_shift)", "weight"),
    mutant("a block's digits from the first position on", Mismatch, Tile(halton_permuted),
        "kernels/column_digits.glsl", "uint position = c.low;", "uint position = 0u;"),
    mutant("the next block's digits for a block's", Mismatch, Tile(halton_permuted),
        "kernels/column_digits.glsl", "digits_divided(own.w, y.x, b)", "digits_divided(next.w, y.x, b)"),
    mutant("every column's places are the first one's", Mismatch, Tile(halton_permuted),
        "kernels/column_digits.glsl", "places[c.places + place]", "places[place]"),
    mutant("what two divisions leave does not carry", Mismatch, Tile(halton_permuted),
        "kernels/column_digits.glsl", "(rest >= c.base.power ? 1u : 0u)", "0u"),
    mutant("a kernel without a loop starts without a bit", Mismatch, Wide(sobol),
        "kernels/column_net.glsl", "NET_BIT(index, 5, d.d5) ^ ", ""),
    mutant("a step by another direction", Mismatch, Wide(sobol),
        "kernels/column_net.glsl", "NET_BIT(CHANGED(p), 2, COLUMN##c##_D2)", "NET_BIT(CHANGED(p), 2, COLUMN##c##_D3)"),
    mutant("a step by the bits of the next point", Mismatch, Wide(van_der_corput),
        "kernels/column_radical.glsl", "corput_van_der_corput(uint(p) ^ (uint(p) + 1u))", "corput_van_der_corput(uint(p) + 1u)"),
    mutant("a pair of a tile's words twice", Mismatch, Wide(halton),
        "kernels/generate_eight.comp", "words[w + 6u], words[w + 7u]", "words[w + 4u], words[w + 5u]"),
    mutant("tiles that begin in each other", Mismatch, Wide(halton),
        "kernels/generate_eight.comp", "i * (TILE / POINTS) * STORES", "i * (TILE / POINTS - 1u) * STORES"),
    mutant("a pair of words twice", Mismatch, Wide(random),
        "kernels/generate_wide.comp", "PAIR(8 * (s) + 4)", "PAIR(8 * (s) + 2)"),
    mutant("floats of Faure's inverses cut", Mismatch, Tile(halton_faure_floats),
        "kernels/column_digits.glsl", "c.kind == FAURE && c.base.base != 2u", "false"),
    mutant("floats of Faure's inverses go up in base 2", Mismatch, Generate(halton_faure_floats),
        "kernels/column_digits.glsl", " && c.base.base != 2u", ""),
];
