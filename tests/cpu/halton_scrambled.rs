//! Scrambled radical inverses against exact fractions of the judge's digits, the cells that
//! they fill, and what their randomness must be like.

mod significance;

use corput::judge::{self, Scrambled, faure_permutation};
use corput::reference::bits::reverse_bits;
use corput::reference::permute::permute_mix;
use corput::reference::scrambled_radical_inverse::{
    faure_digit, radical_inverse_faure, radical_inverse_owen, radical_inverse_permuted,
    radical_inverse_started,
};
use significance::{critical, deviate};

/// A randomised radical inverse: its twin and its judge, of index, base and seed.
type Pair = (fn(u32, u32, u32) -> u32, fn(u32, u32, u32) -> Scrambled);

const RANDOM: [Pair; 3] = [
    (radical_inverse_permuted, judge::permuted),
    (radical_inverse_owen, judge::owen),
    (radical_inverse_started, judge::started),
];

/// n with Faure's permutations.
fn faure(n: u32, base: u32) -> Scrambled {
    let table = faure_permutation(base);
    let mut x = Scrambled::of(n, base);
    for digit in &mut x.digits {
        *digit = table[*digit as usize];
    }
    x
}

/// Indices around powers of the base, at both ends, and others.
fn indices(base: u32, others: u32) -> impl Iterator<Item = u32> {
    let powers = (1..32).map_while(move |k| base.checked_pow(k));
    let around = powers.flat_map(|power| [power - 1, power, power + 1]);
    let ends = [0, 1, 2, u32::MAX - 1, u32::MAX];
    around.chain(ends).chain((0..others).map(permute_mix))
}

#[test]
fn faure_permutations_are_those_of_the_paper() {
    let table = |base| {
        (0..base)
            .map(|digit| faure_digit(digit, base))
            .collect::<Vec<_>>()
    };
    assert_eq!(table(2), [0, 1]);
    assert_eq!(table(3), [0, 1, 2]);
    assert_eq!(table(4), [0, 2, 1, 3]);
    assert_eq!(table(5), [0, 3, 2, 1, 4]);
    assert_eq!(table(6), [0, 2, 4, 1, 3, 5]);
    assert_eq!(table(7), [0, 2, 5, 3, 1, 4, 6]);
    assert_eq!(table(8), [0, 4, 2, 6, 1, 5, 3, 7]);
    for base in (1..=300).chain([1021, 4096, 8161, 65_534, 65_535]) {
        assert_eq!(table(base), faure_permutation(base), "{base}");
    }
}

#[test]
fn faure_inverses_are_ceilings_of_the_exact_fractions() {
    for base in [
        2, 3, 4, 5, 6, 7, 16, 29, 255, 256, 257, 1625, 1626, 8161, 65_521, 65_535,
    ] {
        for n in indices(base, 300) {
            let truth = faure(n, base).ceil();
            assert_eq!(
                u64::from(radical_inverse_faure(n, base)),
                truth,
                "{n} base {base}"
            );
        }
    }
    for n in indices(2, 1000) {
        assert_eq!(radical_inverse_faure(n, 2), reverse_bits(n));
    }
    // Within 2^-32 of 1: the ceiling would be 2^32.
    for (n, base) in [(4_163_763_246, 29), (4_146_143_185, 73)] {
        assert_eq!(
            (faure(n, base).floor(), radical_inverse_faure(n, base)),
            (u32::MAX.into(), u32::MAX)
        );
    }
}

#[test]
fn random_inverses_are_floors_of_the_exact_fractions() {
    for base in [
        2, 3, 4, 5, 7, 10, 13, 16, 17, 29, 97, 256, 257, 1021, 1627, 8161,
    ] {
        let others = if base < 300 { 60 } else { 3 };
        for (twin, judge) in RANDOM {
            for seed in [0, 0xdead_beef] {
                for n in indices(base, others) {
                    let truth = judge(n, base, seed).floor();
                    assert_eq!(u64::from(twin(n, base, seed)), truth, "{n} {base} {seed}");
                }
            }
        }
    }
}

#[test]
fn what_is_no_base_gives_zero() {
    for base in [0, 1, 65_536, u32::MAX] {
        assert_eq!(radical_inverse_faure(5, base), 0);
        for (twin, _) in RANDOM {
            assert_eq!(twin(5, base, 1), 0);
        }
    }
}

/// How many of the b-adic cells of `blocks` of base^k indices do not hold one point each.
fn missed(base: u32, k: u32, cell: impl Fn(u32) -> u128) -> usize {
    let cells = base.pow(k);
    let blocks = [0, 1, 7, u32::MAX / cells - 1];
    let mut missed = 0;
    for block in blocks {
        let mut held = vec![0u32; cells as usize];
        for n in block * cells..(block + 1) * cells {
            held[cell(n) as usize] += 1;
        }
        missed += held.iter().filter(|&&count| count != 1).count();
    }
    missed
}

#[test]
fn blocks_of_powers_fill_cells() {
    for (base, k) in [
        (2u32, 10),
        (3, 6),
        (5, 4),
        (7, 3),
        (11, 2),
        (97, 1),
        (101, 1),
    ] {
        let cells = u64::from(base.pow(k));
        let at = |u: u32| u128::from((u64::from(u) * cells) >> 32);
        for seed in [1, 2, 3] {
            for (twin, judge) in RANDOM {
                assert_eq!(
                    missed(base, k, |n| judge(n, base, seed).cell(k as usize)),
                    0
                );
                // As fractions of 2^32 too: the few points that could leave do not here.
                assert_eq!(
                    missed(base, k, |n| at(twin(n, base, seed))),
                    0,
                    "{base} {seed}"
                );
            }
        }
        assert_eq!(missed(base, k, |n| faure(n, base).cell(k as usize)), 0);
        // Digits in the wrong order.
        assert!(k == 1 || missed(base, k, |n| u128::from(n % base.pow(k) / base)) > 0);
    }
}

/// Of the largest power of the base, whose indices are where ceilings are exact.
#[test]
fn faure_fractions_never_leave_their_cells() {
    for (base, k, m) in [
        (2, 16, 32),
        (3, 10, 20),
        (5, 7, 13),
        (7, 5, 11),
        (29, 3, 6),
        (97, 2, 4),
    ] {
        let (cells, end) = (u64::from(base).pow(k), u64::from(base).pow(m));
        assert!(end <= 1 << 32 && end * u64::from(base) > 1 << 32);
        for first in [0, cells, end / cells / 2 * cells, end - cells] {
            let mut held = vec![false; cells as usize];
            for n in first..first + cells {
                let u = u64::from(radical_inverse_faure(n as u32, base));
                let at = ((u * cells) >> 32) as usize;
                assert!(!std::mem::replace(&mut held[at], true), "{n} base {base}");
            }
        }
    }
}

#[test]
fn pairs_of_bases_fill_boxes() {
    let (rows, columns) = (16u32, 27u32);
    let at = |u: u32, cells: u32| ((u64::from(u) * u64::from(cells)) >> 32) as u32;
    for first in [0, rows * columns, 1000 * rows * columns] {
        for (twin, _) in RANDOM {
            let mut held = vec![0; (rows * columns) as usize];
            for n in first..first + rows * columns {
                let cell = at(twin(n, 2, 9), rows) * columns + at(twin(n, 3, 9), columns);
                held[cell as usize] += 1;
            }
            assert!(held.iter().all(|&count| count == 1));
        }
    }
}

/// Seeds of a statistical test.
const SEEDS: u32 = 1 << 16;

fn counted(cells: usize, cell: impl Fn(u32) -> u32) -> f64 {
    let mut counts = vec![0; cells];
    for seed in 0..SEEDS {
        counts[cell(seed) as usize] += 1;
    }
    deviate(&counts, f64::from(SEEDS) / cells as f64)
}

fn digit(u: u32, base: u32, position: u32) -> u32 {
    ((u64::from(u) * u64::from(base.pow(position + 1))) >> 32) as u32 % base
}

/// The first digits over seeds, alone, with the next one, and with those of another base.
fn first_digits(twin: fn(u32, u32, u32) -> u32) -> Vec<f64> {
    let mut found = Vec::new();
    for n in [0, 1, 5, 77, u32::MAX] {
        for base in [2, 3, 5, 7, 17] {
            let two = base * base;
            found.push(counted(base as usize, |seed| {
                digit(twin(n, base, seed), base, 0)
            }));
            found.push(counted(two as usize, |seed| {
                ((u64::from(twin(n, base, seed)) * u64::from(two)) >> 32) as u32
            }));
        }
        for (a, b) in [(2, 3), (5, 7), (11, 13), (17, 19)] {
            found.push(counted((a * b) as usize, |seed| {
                digit(twin(n, a, seed), a, 0) * b + digit(twin(n, b, seed), b, 0)
            }));
        }
    }
    found
}

#[test]
fn digits_are_uniform_over_seeds() {
    let found = RANDOM.map(|(twin, _)| first_digits(twin));
    let bound = critical(found.iter().map(Vec::len).sum());
    let worst = found.iter().flatten().copied().fold(0.0, f64::max);
    println!("{worst:.2} of {bound:.2}");
    assert!(worst < bound, "{found:?}");
    // The seed as a multiplier of nothing, and one seed's digits for all bases.
    let fixed = first_digits(|n, base, _| radical_inverse_permuted(n, base, 1));
    assert!(fixed.iter().any(|z| *z > bound));
    let shared = first_digits(|n, base, seed| radical_inverse_permuted(n, base, seed & 7));
    assert!(shared.iter().any(|z| *z > bound));
}

/// Where a 0 in the second digit goes after a first digit of 0, and after one of 1.
fn nested(twin: fn(u32, u32, u32) -> u32) -> Vec<f64> {
    [3u32, 5, 17]
        .map(|base| {
            counted((base * base) as usize, |seed| {
                digit(twin(0, base, seed), base, 1) * base + digit(twin(1, base, seed), base, 1)
            })
        })
        .to_vec()
}

#[test]
fn only_nested_scrambling_depends_on_the_digits_before() {
    let bound = critical(3);
    assert!(nested(radical_inverse_owen).iter().all(|z| *z < bound));
    assert!(nested(radical_inverse_permuted).iter().all(|z| *z > bound));
}

/// The mean of u and of u (u + 2^-32) over seeds, in standard deviations of the mean.
fn moments(twin: fn(u32, u32, u32) -> u32, n: u32, base: u32) -> [f64; 2] {
    let at = |seed| f64::from(twin(n, base, seed)) / 4_294_967_296.0;
    let mean = |f: fn(f64) -> f64| (0..SEEDS).map(|s| f(at(s))).sum::<f64>() / f64::from(SEEDS);
    let root = f64::from(SEEDS).sqrt();
    [
        (mean(|u| u) - 0.5) * 12f64.sqrt() * root,
        (mean(|u| u * u) - 1.0 / 3.0) / (4.0f64 / 45.0).sqrt() * root,
    ]
}

#[test]
fn each_point_is_uniform_over_seeds() {
    let cases: Vec<(u32, u32)> = [0, 3, 1000]
        .iter()
        .flat_map(|&n| [(n, 2), (n, 3), (n, 29)])
        .collect();
    // Two-sided: twice as many tests.
    let bound = critical(RANDOM.len() * cases.len() * 4);
    for (twin, _) in RANDOM {
        for &(n, base) in &cases {
            let z = moments(twin, n, base);
            assert!(
                z.iter().all(|z| z.abs() < bound),
                "{n} {base}: {z:?} of {bound}"
            );
        }
    }
}
