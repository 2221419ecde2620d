//! The flips of the nodes over many seeds: fair, and independent in pairs and in fours.
//!
//! A node's flips are a row of bits, one per seed. Where nodes flip independently, the
//! number of ones in the sum (modulo 2) of any rows is binomial with p = 1/2: one test
//! serves single nodes, pairs and fours.

use super::{Scramble, judge, uvec2};
use corput::glam::UVec2;
use corput::reference::hash::seed;
use corput::reference::owen::{digital_shift, matrix_scramble, owen, owen_hash};

/// Levels of the tree: more than one subtree of the exact scramble.
const LEVELS: u32 = 9;
const NODES: usize = (1 << LEVELS) - 1;
const SEEDS: usize = 1 << 14;
/// Chance that a family of tests rejects independent flips.
const SIGNIFICANCE: f64 = 1e-3;

type Row = [u64; SEEDS / 64];

/// Where seed number i comes from.
#[derive(Clone, Copy, Debug)]
enum Along {
    Seed,
    HighSeed,
    Dimension,
}

const ALONG: [Along; 3] = [Along::Seed, Along::HighSeed, Along::Dimension];

/// Rows of all nodes, level after level: node n of the tree whose root is node 1 is row
/// n - 1.
fn rows(scramble: Scramble, along: Along) -> Vec<Row> {
    let mut rows = vec![[0; SEEDS / 64]; NODES];
    for i in 0..SEEDS {
        let (dimension, s) = match along {
            Along::Seed => (3, uvec2(i as u32, 0)),
            Along::HighSeed => (3, uvec2(0, i as u32)),
            Along::Dimension => (i as u32, uvec2(1, 2)),
        };
        for leaf in 0..1u32 << (LEVELS - 1) {
            let x = leaf << (33 - LEVELS);
            let flips = u64::from(x ^ scramble(x, dimension, s));
            for level in 0..LEVELS {
                let node = (1 << level) | (leaf >> (LEVELS - 1 - level));
                let flip = (flips >> (31 - level)) & 1;
                rows[node as usize - 1][i / 64] |= flip << (i % 64);
            }
        }
    }
    rows
}

/// How far the number of ones in the sum of rows is from the half.
fn deviation(rows: &[&Row]) -> u32 {
    let mut ones = 0;
    for word in 0..SEEDS / 64 {
        ones += rows.iter().fold(0, |sum, row| sum ^ row[word]).count_ones();
    }
    ones.abs_diff(SEEDS as u32 / 2)
}

/// The least deviation that `tests` fair rows reach with a chance of at most
/// [`SIGNIFICANCE`], by Sidak's correction and the exact tails of the binomial.
fn limit(tests: usize) -> u32 {
    let each = -f64::exp_m1(f64::ln_1p(-SIGNIFICANCE) / tests as f64);
    // The middle term, by the product of the ratios (2k - 1) / 2k.
    let half = SEEDS / 2;
    let middle: f64 = (1..=half).map(|k| 1.0 - 0.5 / k as f64).product();
    // P(|X - half| >= d) from the middle outwards.
    let (mut tail, mut term, mut d) = (1.0 - middle, middle, 1);
    while tail > each {
        term *= (half - d + 1) as f64 / (half + d) as f64;
        tail -= 2.0 * term;
        d += 1;
    }
    d as u32
}

/// Families of tests.
const FAMILIES: [&str; 4] = ["nodes", "pairs", "fours", "lags"];

/// How many tests of each family reject: single nodes; pairs of nodes; fours p, p ^ a,
/// p ^ b, p ^ a ^ b of one level; a node's flips and its own 1 to 4 seeds later.
fn rejections(name: &str, scramble: Scramble, along: Along) -> [usize; 4] {
    let rows = rows(scramble, along);
    let mut found: [Vec<u32>; 4] = Default::default();
    for (i, row) in rows.iter().enumerate() {
        found[0].push(deviation(&[row]));
        for other in &rows[..i] {
            found[1].push(deviation(&[row, other]));
        }
        for lag in 1..=4 {
            // The last bits have no successor: zeros there deviate by 2 at most.
            let mut later = *row;
            for word in 0..SEEDS / 64 {
                let next = row.get(word + 1).copied().unwrap_or(0);
                later[word] = (row[word] >> lag) | (next << (64 - lag));
            }
            found[3].push(deviation(&[row, &later]));
        }
    }
    for level in 2..LEVELS {
        let nodes = &rows[(1 << level) - 1..(2 << level) - 1];
        for i in 0..4096 {
            let [p, a, b] = [0, 1, 2].map(|k| judge::hash(4 * i + k) as usize % nodes.len());
            if a != b && a != 0 && b != 0 {
                let four = [p, p ^ a, p ^ b, p ^ a ^ b].map(|n| &nodes[n]);
                found[2].push(deviation(&four));
            }
        }
    }
    let mut report = format!("{name} along {along:?}:\n");
    let counts = std::array::from_fn(|family| {
        let deviations = &found[family];
        let limit = limit(deviations.len());
        let worst = deviations.iter().copied().max().unwrap_or(0);
        let rejected = deviations.iter().filter(|d| **d >= limit).count();
        report += &format!(
            "  {}: {rejected} of {} reject, worst {worst}, limit {limit}\n",
            FAMILIES[family],
            deviations.len(),
        );
        rejected
    });
    print!("{report}");
    counts
}

#[test]
fn limits_are_those_of_the_binomial() {
    // scipy.stats.binom.sf(8192 + d - 1, 16384, 0.5) * 2 <= 1 - (1 - 1e-3)**(1 / m).
    for (tests, deviation) in [(1, 212), (511, 305), (130_305, 371)] {
        assert_eq!(limit(tests), deviation, "{tests}");
    }
}

#[test]
fn exact_flips_are_fair_and_independent() {
    for along in ALONG {
        assert_eq!(rejections("owen", owen, along), [0; 4]);
    }
}

#[test]
fn hashed_and_linear_flips_are_fair_and_independent_in_pairs() {
    let hashed: Scramble = |x, d, s| owen_hash(x, seed(s, d, 1));
    let linear: Scramble = |x, d, s| digital_shift(matrix_scramble(x, d, s), seed(s, d, 0));
    for along in ALONG {
        for (name, scramble) in [("owen_hash", hashed), ("matrix and shift", linear)] {
            let [nodes, pairs, fours, lags] = rejections(name, scramble, along);
            assert_eq!([nodes, pairs, lags], [0; 3], "{name}");
            assert!(fours > 0, "{name}");
        }
    }
}

#[test]
fn dependent_flips_are_seen() {
    // One flip per level; no node's own; a bit of two; a block for all prefixes.
    let wrong: [(&str, Scramble, usize); 4] = [
        (
            "digital shift",
            |x, d, s| digital_shift(x, seed(s, d, 0)),
            1,
        ),
        ("matrix without shift", matrix_scramble, 0),
        (
            "unfair",
            |x, d, s| x ^ (owen(x, d, s) & owen(x, d + 1, s)),
            0,
        ),
        (
            "one subtree",
            |x, d, s| {
                let first = x ^ owen(x, d, s);
                let low = (x << 7) ^ owen(x << 7, d + 1, s);
                x ^ (first & 0xfe00_0000) ^ (low >> 7)
            },
            1,
        ),
    ];
    for (name, scramble, family) in wrong {
        assert!(
            rejections(name, scramble, Along::Seed)[family] > 0,
            "{name}"
        );
    }
    let late: fn(u32, u32, UVec2) -> u32 = |x, d, s| owen(x, d, uvec2(s.x / 2, s.y));
    assert!(rejections("a seed twice", late, Along::Seed)[3] > 0);
}
