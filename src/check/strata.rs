//! Permutations, strata, scrambled digits and lattices: what a device must give, and the
//! arguments to try.

use super::inputs::mix;
use crate::reference::{
    halton_scrambled, lattice, lattice_vector, permute, scrambled_radical_inverse, stratified,
};
use glam::{UVec2, uvec2};

/// `evaluate_strata.comp`, line by line; `None` for a name that it does not have.
pub fn reference(name: &str, a: [u32; 4]) -> Option<[u32; 4]> {
    let [x, y, z, w] = a;
    let one = |value: u32| [value, 0, 0, 0];
    let stratum = |u: u32| [u, stratified::unit_stratum(u, y).to_bits(), 0, 0];
    Some(match name {
        "permute" => [permute::permute(x, y, z), permute::permute_key(z, w), 0, 0],
        "stratum" => stratum(stratified::stratum(x, y, w)),
        "unit_stratum" => stratum(z),
        "stratified" => stratum(stratified::stratified(z, (w >> 8) & 0xfff, y, w)),
        "latin_hypercube" => stratum(stratified::latin_hypercube(x, y, z, w)),
        "cmj" => multi_jittered(a),
        "radical_inverse_faure" => [
            scrambled_radical_inverse::radical_inverse_faure(x, y),
            scrambled_radical_inverse::faure_digit(x % y.max(1), y),
            0,
            0,
        ],
        "radical_inverse_permuted" => {
            one(scrambled_radical_inverse::radical_inverse_permuted(x, y, z))
        }
        "radical_inverse_owen" => one(scrambled_radical_inverse::radical_inverse_owen(x, y, z)),
        "radical_inverse_started" => {
            one(scrambled_radical_inverse::radical_inverse_started(x, y, z))
        }
        "halton_scrambled" => [
            halton_scrambled::halton_faure(x, y),
            halton_scrambled::halton_permuted(x, y, z),
            halton_scrambled::halton_owen(x, y, z),
            halton_scrambled::halton_started(x, y, z),
        ],
        "lattice" => [
            lattice::lattice(x, y),
            lattice::lattice(x, lattice_vector::lattice_vector(y % 260)),
            lattice::rotate(x, y),
            0,
        ],
        "korobov" => one(lattice::korobov(x, z.checked_rem(y).unwrap_or(z), y)),
        "additive" => one(lattice::additive(x, uvec2(y, z))),
        _ => return None,
    })
}

fn multi_jittered([x, y, z, w]: [u32; 4]) -> [u32; 4] {
    let shift = (y & 3) * 8;
    let grid = uvec2(y >> (31 - shift), z >> (7 + shift)).max(UVec2::ONE);
    let point = stratified::cmj(x % (grid.x * grid.y), grid, z, uvec2(w, y));
    [point.x, point.y, grid.x, grid.y]
}

/// k < N and two words, for all kinds of N; N = 2^32 is written as 0.
pub fn strata() -> Vec<[u32; 4]> {
    let mut list = Vec::new();
    let counts = (1..=40).chain([
        64,
        65,
        97,
        255,
        256,
        257,
        1000,
        1021,
        4093,
        65_521,
        65_536,
        1_000_000,
        (1 << 24) - 1,
        1 << 24,
        (1 << 24) + 1,
        (1 << 31) - 1,
        1 << 31,
        (1 << 31) + 1,
        3_000_000_019,
        (1u64 << 32) - 1,
        1 << 32,
    ]);
    for count in counts {
        let ends = (0..64).chain(count.saturating_sub(64)..count);
        let random = (0..256).map(|i| u64::from(mix(i)) % count);
        for (i, k) in (0u32..).zip(ends.chain(random).filter(|k| *k < count)) {
            let word = mix(i ^ (count as u32) << 12);
            let jitter = match i % 8 {
                0 => 0,
                1 => u32::MAX,
                _ => mix(word),
            };
            list.push([k as u32, count as u32, word, jitter]);
        }
    }
    list
}

/// Small, high and edge indices in bases of all sizes, what is no base among them.
pub fn digits() -> Vec<[u32; 4]> {
    let mut list = Vec::new();
    let bases = (0..=41).chain([
        97,
        127,
        251,
        255,
        256,
        257,
        1021,
        1625,
        1626,
        1627,
        4096,
        8161,
        32_768,
        65_521,
        65_535,
        65_536,
        u32::MAX,
    ]);
    for base in bases {
        let powers = (0..32).map_while(|k| base.checked_pow(k));
        let around = powers.flat_map(|power| [power.wrapping_sub(1), power, power.wrapping_add(1)]);
        let ends = (0..16).chain([4_163_763_246, u32::MAX - 1, u32::MAX]);
        let random = (0..256).map(|i| mix(i ^ base << 10));
        for (i, n) in (0..).zip(around.chain(ends).chain(random)) {
            list.push([n, base, mix(i ^ base << 16), 0]);
        }
    }
    list
}
