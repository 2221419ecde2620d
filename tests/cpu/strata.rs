//! Strata: one sample in each, exactly, as fractions and as floats, for any number of them.

use corput::judge;
use corput::reference::permute::{permute_key, permute_mix};
use corput::reference::stratified::{cmj, latin_hypercube, stratified, stratum, unit_stratum};
use corput::tables::{composite_neighbours, is_prime, nearly_equal_factors};
use glam::{UVec2, uvec2};

/// Numbers of strata, 2^32 among them.
const STRATA: [u64; 18] = [
    1,
    2,
    3,
    5,
    7,
    10,
    255,
    256,
    257,
    1000,
    65_535,
    1_000_000,
    16_777_213,
    16_777_216,
    (1 << 31) + 1,
    3_000_000_019,
    (1 << 32) - 1,
    1 << 32,
];

const JITTERS: [u32; 6] = [0, 1, 0x7fff_ffff, 0x8000_0000, 0xdead_beef, u32::MAX];

/// Cells from both ends and between.
fn cells(strata: u64) -> impl Iterator<Item = u64> {
    let spread = (0..400).map(move |i| u64::from(permute_mix(i)) % strata);
    (0..strata.min(50))
        .chain(strata.saturating_sub(50)..strata)
        .chain(spread)
}

#[test]
fn a_fraction_lies_where_the_exact_quotients_say() {
    for strata in STRATA {
        for cell in cells(strata) {
            for jitter in JITTERS {
                let got = stratum(cell as u32, strata as u32, jitter);
                assert_eq!(u64::from(got), judge::stratum(cell, strata, jitter));
                let at = (u128::from(got) * u128::from(strata)) >> 32;
                assert_eq!(
                    at,
                    u128::from(cell),
                    "{strata}: {got:#x} jitter {jitter:#x}"
                );
            }
        }
    }
    assert_eq!(stratum(0, 1, 0x1234_5678), 0x1234_5678);
}

/// The stratum of a float, exactly: 24 bits times the number of strata.
fn float_cell(x: f32, strata: u64) -> u64 {
    let k = (f64::from(x) * 16_777_216.0) as u64;
    assert!(x < 1.0 && k as f64 == f64::from(x) * 16_777_216.0);
    (k * strata) >> 24
}

#[test]
fn floats_keep_their_strata_up_to_2_to_the_24() {
    for strata in STRATA {
        let mut left = 0;
        for cell in cells(strata) {
            for jitter in JITTERS {
                let u = stratum(cell as u32, strata as u32, jitter);
                let x = unit_stratum(u, strata as u32);
                // max(u >> 8, ceil(2^24 cell / strata)), the definition.
                let edge = (cell << 24).div_ceil(strata);
                let k = u64::from(u >> 8).max(edge).min((1 << 24) - 1);
                assert_eq!(f64::from(x), k as f64 / 16_777_216.0, "{strata}: {u:#x}");
                left += u64::from(float_cell(x, strata) != cell);
            }
        }
        // Above 2^24 floats are too few.
        assert!(
            left == 0 || strata > 1 << 24,
            "{strata}: {left} floats left"
        );
    }
}

#[test]
fn every_24_bit_float_is_the_cut_of_its_fractions() {
    for strata in [3u32, 7, 1000, 1_000_003] {
        for k in 0..1u32 << 24 {
            let (first, last) = (k << 8, (k << 8) | 0xff);
            for u in [first, last] {
                let cell = (u64::from(u) * u64::from(strata)) >> 32;
                let edge = (cell << 24).div_ceil(u64::from(strata));
                let truth = u64::from(k).max(edge) as f64 / 16_777_216.0;
                assert_eq!(
                    f64::from(unit_stratum(u, strata)),
                    truth,
                    "{u:#x} of {strata}"
                );
            }
        }
    }
}

/// How many of `strata` strata do not hold exactly one of these.
fn not_one(strata: u32, at: impl Iterator<Item = u64>) -> usize {
    let mut held = vec![0u32; strata as usize];
    for cell in at {
        held[cell as usize] += 1;
    }
    held.iter().filter(|&&count| count != 1).count()
}

fn jitter(n: u32, dimension: u32) -> u32 {
    permute_key(dimension, n)
}

fn fraction_cell(u: u32, strata: u32) -> u64 {
    (u64::from(u) * u64::from(strata)) >> 32
}

#[test]
fn each_stratum_holds_one_point() {
    for count in [1u32, 2, 3, 7, 16, 17, 1000, 1_000_000] {
        let plain = |n| stratified(n, 1, count, jitter(n, 0));
        let shuffled = |n| latin_hypercube(n, count, 5, jitter(n, 1));
        let wide = u64::from(count);
        for point in [&plain as &dyn Fn(u32) -> u32, &shuffled] {
            assert_eq!(
                not_one(count, (0..count).map(|n| fraction_cell(point(n), count))),
                0
            );
            let floats = (0..count).map(|n| float_cell(unit_stratum(point(n), count), wide));
            assert_eq!(not_one(count, floats), 0, "{count} as floats");
        }
    }
    // What the integers are for: (n + jitter) / count in floats leaves strata empty.
    let naive = (0..1_000_000u32).map(|n| {
        let jitter = (jitter(n, 0) >> 8) as f32 / 16_777_216.0;
        let x = ((n as f32 + jitter) / 1e6).min(1.0 - f32::EPSILON / 2.0);
        (f64::from(x) * 1e6) as u64
    });
    assert!(not_one(1_000_000, naive) > 1000);
}

#[test]
fn jittered_grids_hold_one_point_per_cell() {
    for [a, b, c] in [[4u32, 3, 5], [7, 1, 2], [16, 16, 1]] {
        let at = (0..a * b * c).map(|n| {
            let x = fraction_cell(stratified(n, 1, a, jitter(n, 0)), a);
            let y = fraction_cell(stratified(n, a, b, jitter(n, 1)), b);
            let z = fraction_cell(stratified(n, a * b, c, jitter(n, 2)), c);
            x + u64::from(a) * (y + u64::from(b) * z)
        });
        assert_eq!(not_one(a * b * c, at), 0, "{a} x {b} x {c}");
    }
}

fn cmj_point(n: u32, grid: UVec2, seed: u32) -> UVec2 {
    cmj(n, grid, seed, uvec2(jitter(n, seed), jitter(!n, seed)))
}

#[test]
fn multi_jittered_sets_hold_one_point_per_cell_row_and_column() {
    let mut grids = vec![[1, 1], [1, 7], [7, 1], [32, 32], [250, 40], [1000, 1000]];
    grids.extend((2..=9).flat_map(|a| (2..=9).map(move |b| [a, b])));
    for [a, b] in grids {
        for seed in [1, 2, u32::MAX] {
            let points: Vec<UVec2> = (0..a * b)
                .map(|n| cmj_point(n, uvec2(a, b), seed))
                .collect();
            let cell = |p: &UVec2| fraction_cell(p.x, a) + u64::from(a) * fraction_cell(p.y, b);
            assert_eq!(
                not_one(a * b, points.iter().map(cell)),
                0,
                "cells of {a} x {b}"
            );
            for axis in 0..2 {
                let one = |p: &UVec2| fraction_cell(p[axis], a * b);
                assert_eq!(
                    not_one(a * b, points.iter().map(one)),
                    0,
                    "axis {axis}: {a} x {b}"
                );
            }
        }
    }
}

#[test]
fn multi_jittered_sets_are_those_of_whole_permutations() {
    for [a, b] in [[3usize, 5], [16, 17], [40, 25]] {
        for seed in [0, 9, 0x8000_0001] {
            let keys = [0, 1, 2].map(|role| permute_key(seed, role));
            for n in 0..a * b {
                let wanted = judge::cmj(n, [a, b], keys, [n as u32 * 77, u32::MAX - n as u32]);
                let jitter = uvec2(n as u32 * 77, u32::MAX - n as u32);
                let got = cmj(n as u32, uvec2(a as u32, b as u32), seed, jitter);
                assert_eq!([u64::from(got.x), u64::from(got.y)], wanted);
            }
        }
    }
}

/// All sets of d factors of n, by trying everything.
fn all_factors(n: u64, d: usize, least: u64) -> Vec<Vec<u64>> {
    if d == 1 {
        return if n >= least { vec![vec![n]] } else { vec![] };
    }
    (least..=n)
        .filter(|f| n.is_multiple_of(*f))
        .flat_map(|f| {
            let mut rest = all_factors(n / f, d - 1, f);
            rest.iter_mut().for_each(|list| list.insert(0, f));
            rest
        })
        .collect()
}

#[test]
fn grids_are_as_square_as_divisors_allow() {
    for n in (1..=200).chain([360, 720, 1001, 1024, 5040]) {
        for d in 1..=5 {
            let got = nearly_equal_factors(n, d);
            assert_eq!((got.len(), got.iter().product::<u64>()), (d, n));
            assert!(got.is_sorted_by(|a, b| a >= b));
            let ratio = got[0] as f64 / got[d - 1] as f64;
            for other in all_factors(n, d, 1) {
                let bound = other[d - 1] as f64 / other[0] as f64;
                let sums = got.iter().sum::<u64>() <= other.iter().sum::<u64>();
                assert!(
                    ratio < bound || (ratio == bound && sums),
                    "{n}: {got:?} {other:?}"
                );
            }
        }
    }
    assert_eq!(nearly_equal_factors(1_000_000, 2), [1000, 1000]);
    assert_eq!(nearly_equal_factors(1 << 32, 5), [128, 128, 64, 64, 64]);
    assert_eq!(nearly_equal_factors(7, 3), [7, 1, 1]);
    assert_eq!(nearly_equal_factors(4_294_967_291, 2), [4_294_967_291, 1]);
    // The most divisors below 2^32, many dimensions, and the ends of the domain.
    assert_eq!(
        nearly_equal_factors(3_491_888_400, 6)
            .iter()
            .product::<u64>(),
        3_491_888_400
    );
    assert_eq!(nearly_equal_factors(1 << 20, 40).iter().sum::<u64>(), 60);
    assert_eq!(
        (nearly_equal_factors(0, 2), nearly_equal_factors(12, 0)),
        (vec![0, 0], vec![])
    );
}

#[test]
fn neighbours_of_primes_are_composite() {
    for n in 0..2000 {
        match composite_neighbours(n) {
            None => assert!(n <= 4 || !is_prime(n)),
            Some([below, above]) => {
                assert!(n > 4 && is_prime(n));
                assert!(below == 4 || !is_prime(below), "{n}");
                assert!(!is_prime(above) && above - below == 2, "{n}");
            }
        }
    }
}
