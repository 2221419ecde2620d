//! The Sobol sequence against SciPy, against the recurrence by a slow judge, and its
//! nets; pmj02.

mod nets;

use corput::interface::{Column, NetScramble};
use corput::judge;
use corput::reference::hash::seed as derived_seed;
use corput::reference::owen::{digital_shift, matrix_scramble, owen, owen_hash};
use corput::reference::pmj02::{pmj02, pmj02_index, sobol_pair};
use corput::reference::random::random;
use corput::reference::sobol::{gray, sobol};
use corput::tables::{SOBOL_DIMENSIONS, sobol_directions, sobol_initial};
use corput::variant::column_words;
use glam::{UVec2, uvec2};
use nets::{is_net, wrong_intervals};

/// Columns of the second part of the SciPy file.
fn scipy_columns() -> Vec<u32> {
    (0..SOBOL_DIMENSIONS).step_by(97).chain([21_200]).collect()
}

fn scipy() -> Vec<u32> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/sobol_scipy.bin");
    let bytes = std::fs::read(path).expect("tests/data/sobol_scipy.bin");
    let words = bytes.as_chunks::<4>().0.iter();
    words.map(|word| u32::from_le_bytes(*word)).collect()
}

/// Points that differ from SciPy's.
fn differing(directions: impl Fn(u32) -> [u32; 32]) -> usize {
    let words = scipy();
    let (few, many) = words.split_at(10 * 1024);
    let columns = scipy_columns();
    assert_eq!(many.len(), 40 * columns.len());
    let mut wrong = 0;
    for dimension in 0..10 {
        let v = directions(dimension);
        for n in 0..1024 {
            wrong += usize::from(sobol(gray(n), &v) != few[(10 * n + dimension) as usize]);
        }
    }
    for (at, dimension) in columns.iter().enumerate() {
        let v = directions(*dimension);
        for n in 0..40 {
            let want = many[n as usize * columns.len() + at];
            wrong += usize::from(sobol(gray(n), &v) != want);
        }
    }
    wrong
}

#[test]
fn points_are_those_of_scipy() {
    assert_eq!(differing(sobol_directions), 0);
    // One bit of one direction number of one dimension is seen.
    let flipped = |dimension| {
        let mut v = sobol_directions(dimension);
        v[3] ^= u32::from(dimension == 21_200) << 28;
        v
    };
    assert!(differing(flipped) > 0);
}

#[test]
fn direction_numbers_satisfy_the_recurrence() {
    for dimension in 0..SOBOL_DIMENSIONS {
        let v = sobol_directions(dimension);
        let Some((polynomial, initial)) = sobol_initial(dimension) else {
            assert_eq!(dimension, 0);
            continue;
        };
        assert_eq!(polynomial & 1, 1, "constant coefficient of {dimension}");
        assert_eq!(initial.len() as u32, polynomial.ilog2());
        assert_eq!(
            v,
            judge::sobol_directions(polynomial, &initial),
            "{dimension}"
        );
    }
    assert_eq!(sobol_initial(SOBOL_DIMENSIONS), None);
    // Rows (d, s, a, m) of the paper's table.
    assert_eq!(sobol_initial(1), Some((0b11, vec![1])));
    assert_eq!(sobol_initial(2), Some((0b111, vec![1, 3])));
    assert_eq!(sobol_initial(3), Some((0b1011, vec![1, 3, 1])));
    assert_eq!(sobol_initial(4), Some((0b1101, vec![1, 1, 1])));
    assert_eq!(sobol_initial(5), Some((0b10011, vec![1, 1, 3, 3])));
}

#[test]
fn golden_values_of_joe_and_kuo() {
    let point = |n: u32| -> Vec<f64> {
        let x = |d| sobol(gray(n), &sobol_directions(d));
        (0..10).map(|d| f64::from(x(d)) / 4_294_967_296.0).collect()
    };
    let second = [0.75, 0.25, 0.25, 0.25, 0.75, 0.75, 0.25, 0.75, 0.75, 0.75];
    let fourth = [
        0.375, 0.375, 0.625, 0.875, 0.375, 0.125, 0.375, 0.875, 0.875, 0.625,
    ];
    assert_eq!(point(2), second);
    assert_eq!(point(4), fourth);
}

/// Each dimension alone is a (0,1)-sequence, so the matrix of its directions has a unit
/// diagonal, and no two dimensions are the same.
#[test]
fn every_dimension_is_a_net_of_its_own() {
    let mut seen = std::collections::HashSet::new();
    for dimension in 0..SOBOL_DIMENSIONS {
        let v = sobol_directions(dimension);
        for (i, direction) in v.iter().enumerate() {
            assert_eq!(direction.trailing_zeros() as usize, 31 - i, "{dimension}");
        }
        assert!(seen.insert(v), "{dimension} stands twice");
    }
}

#[test]
fn the_pair_is_the_first_two_dimensions() {
    let (x, y) = (sobol_directions(0), sobol_directions(1));
    for bit in 0..32 {
        assert_eq!(sobol_pair(1 << bit), uvec2(x[bit], y[bit]), "bit {bit}");
    }
    for n in (0..1 << 16).map(|i: u32| i.wrapping_mul(0x9e37_79b9)) {
        assert_eq!(sobol_pair(n), uvec2(sobol(n, &x), sobol(n, &y)), "{n}");
    }
}

const SEEDS: [UVec2; 3] = [uvec2(0, 0), uvec2(2, 0), uvec2(0xdead_beef, 0x0123_4567)];

#[test]
fn scrambled_pairs_keep_every_elementary_interval() {
    for seed in SEEDS {
        for m in 0..=16 {
            let points = |first: u32| -> Vec<[u32; 2]> {
                (first..=first + ((1 << m) - 1))
                    .map(|n| pmj02(n, seed).into())
                    .collect()
            };
            // Prefixes, and aligned blocks far out.
            for first in [0, 5 << m, (u32::MAX >> m) << m] {
                assert!(is_net(&points(first), m), "{seed} 2^{m} from {first}");
            }
        }
        for (name, scramble) in [
            ("none", &(|x, _| x) as &dyn Fn(u32, u32) -> u32),
            ("shift", &|x, d| digital_shift(x, 0x1234_5678 ^ d)),
            ("matrix", &|x, d| matrix_scramble(x, d, seed)),
            ("owen", &|x, d| owen(x, d, seed)),
            ("owen-hash", &|x, d| owen_hash(x, seed.x ^ (d + 1))),
        ] {
            for m in 0..=16 {
                let points: Vec<[u32; 2]> = (0..1 << m)
                    .map(|n| {
                        let p = sobol_pair(n);
                        [scramble(p.x, 0), scramble(p.y, 1)]
                    })
                    .collect();
                assert!(is_net(&points, m), "{name} {seed} 2^{m}");
            }
        }
    }
}

#[test]
fn what_is_no_net_is_seen() {
    // A rotation of real numbers spoils what a digital shift keeps.
    let rotated: Vec<[u32; 2]> = (0..256)
        .map(|n| sobol_pair(n).into())
        .map(|[x, y]: [u32; 2]| [x.wrapping_add(0x1234_5678), y])
        .collect();
    assert!(wrong_intervals(&rotated, 8) > 0);
    // A block that is not aligned.
    let shifted: Vec<[u32; 2]> = (3..259).map(|n| sobol_pair(n).into()).collect();
    assert!(wrong_intervals(&shifted, 8) > 0);
    // A shuffle of the whole index would be no prefix of blocks.
    let bits: Vec<u32> = (0..256).map(|n: u32| n.wrapping_mul(0x9e37_79b9)).collect();
    let scattered: Vec<[u32; 2]> = bits.iter().map(|n| sobol_pair(*n).into()).collect();
    assert!(wrong_intervals(&scattered, 8) > 0);
}

#[test]
fn the_shuffle_keeps_aligned_blocks() {
    for seed in SEEDS {
        for m in [1, 4, 8] {
            for block in [0u32, 1, 77] {
                let first = block << m;
                let mut found: Vec<u32> = (first..first + (1 << m))
                    .map(|n| pmj02_index(n, seed))
                    .collect();
                found.sort_unstable();
                let start = found[0];
                assert_eq!(start % (1 << m), 0, "{seed} 2^{m} {block}");
                assert!(
                    (start..).zip(&found).all(|(a, b)| a == *b),
                    "{seed} 2^{m} {block}"
                );
            }
        }
    }
}

/// What the kernels fold into direction numbers is what the headers do one by one.
#[test]
fn folded_directions_are_the_scrambles() {
    for dimension in [0, 1, 2, 77, 21_200] {
        for by_gray in [false, true] {
            let seed = [7, 9];
            let words = column_words(
                Column::Sobol {
                    dimension,
                    gray: by_gray,
                    scramble: NetScramble::Matrix,
                    seed,
                },
                0,
            );
            let folded: [u32; 32] = words[6..].try_into().expect("32 numbers");
            for n in (0..1 << 10).map(|i: u32| i.wrapping_mul(0x9e37_79b9) ^ i) {
                let index = if by_gray { gray(n) } else { n };
                let x = sobol(index, &sobol_directions(dimension));
                let want = matrix_scramble(x, dimension, UVec2::from(seed));
                assert_eq!(sobol(n, &folded), want, "{dimension} {by_gray} {n}");
            }
        }
    }
}

#[test]
fn gray_order_has_the_same_prefixes() {
    for m in 0..12 {
        let mut found: Vec<u32> = (0..1 << m).map(gray).collect();
        found.sort_unstable();
        assert!(found.iter().copied().eq(0..1 << m));
    }
    for n in 0..1 << 12 {
        assert_eq!((gray(n) ^ gray(n + 1)).count_ones(), 1);
    }
}

/// Slope of log2 of the mean squared error of the integral of (x + y)^2 against log2 of
/// the number of points, by least squares over 2^4 to 2^10 points and 64 seeds.
fn slope(point: impl Fn(u32, UVec2) -> [u32; 2]) -> f64 {
    let exponents: Vec<f64> = (4..=10).map(f64::from).collect();
    let errors = (4..=10).map(|m| {
        let squares = (0..64).map(|replicate| {
            let seed = uvec2(replicate, 0x5eed);
            let values = (0..1u32 << m).map(|n| {
                let unit = |u| (f64::from(u) + 0.5) / 4_294_967_296.0;
                let [x, y] = point(n, seed);
                (unit(x) + unit(y)).powi(2)
            });
            (values.sum::<f64>() / f64::from(1u32 << m) - 7.0 / 6.0).powi(2)
        });
        (squares.sum::<f64>() / 64.0).log2()
    });
    let errors: Vec<f64> = errors.collect();
    let mean = |list: &[f64]| list.iter().sum::<f64>() / list.len() as f64;
    let (x, y) = (mean(&exponents), mean(&errors));
    let pairs = || exponents.iter().zip(&errors);
    pairs().map(|(a, b)| (a - x) * (b - y)).sum::<f64>()
        / pairs().map(|(a, _)| (a - x).powi(2)).sum::<f64>()
}

/// Owen 1997: of smooth functions the variance under nested scrambling falls like n^-3, up
/// to a logarithm. Of random points it is n^-1, and of a digital shift n^-2.
#[test]
fn scrambled_nets_converge_as_theory_says() {
    let scrambled = |scramble: &dyn Fn(u32, u32, UVec2) -> u32| {
        slope(|n, seed| {
            let p = sobol_pair(n);
            [scramble(p.x, 0, seed), scramble(p.y, 1, seed)]
        })
    };
    let exact = scrambled(&|x, d, seed| owen(x, d, seed));
    let hash = scrambled(&|x, d, seed| owen_hash(x, derived_seed(seed, d, 1)));
    let pmj = slope(|n, seed| pmj02(n, seed).into());
    let shifted = scrambled(&|x, d, seed| digital_shift(x, derived_seed(seed, d, 0)));
    let random = slope(|n, seed| [random(n, 0, seed), random(n, 1, seed)]);
    println!(
        "owen {exact:.2}, hash {hash:.2}, pmj02 {pmj:.2}, shift {shifted:.2}, random {random:.2}"
    );
    for slope in [exact, hash, pmj] {
        assert!((-3.2..-2.6).contains(&slope), "{slope}");
    }
    assert!((-2.3..-1.7).contains(&shifted), "{shifted}");
    assert!((-1.3..-0.7).contains(&random), "{random}");
}
