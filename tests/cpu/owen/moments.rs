//! Scrambled points over 1,024 seeds: mean and variance of each point, the correlation of
//! pairs against theory, and none across dimensions.

use super::{Scramble, p_value, uvec2};
use corput::reference::hash::{hash, seed};
use corput::reference::owen::{digital_shift, matrix_scramble, owen, owen_hash};

const SEEDS: u32 = 1024;
const DIMENSIONS: [u32; 3] = [0, 1, 21_200];
/// Chance that all tests of one scramble reject a perfect one.
const SIGNIFICANCE: f64 = 1e-3;

/// Edges, pairs that share 1 to 20 digits, and others.
fn points() -> Vec<u32> {
    let x = 0x9e37_79b9;
    let shared = [1, 2, 3, 5, 8, 13, 20].map(|digits| x ^ (0x8000_0000u32 >> digits));
    let others = (1..6).map(hash);
    [0, u32::MAX, x]
        .into_iter()
        .chain(shared)
        .chain(others)
        .collect()
}

/// Correlation of two points whose flips are independent in pairs: of the digits from the
/// highest, those in common stay in common, the next always differs, and the rest are
/// independent. Digit j carries 3 / 4^j of the variance 1/12.
fn nested(x: u32, y: u32) -> f64 {
    let common = (x ^ y).leading_zeros() as i32;
    1.0 - 7.0 * f64::powi(0.25, common + 1)
}

/// Correlation of two points that one shift moves: digits stay equal, or different.
fn shifted(x: u32, y: u32) -> f64 {
    let sign = |j: u32| {
        if (x ^ y) >> (32 - j) & 1 == 0 {
            3.0
        } else {
            -3.0
        }
    };
    (1..=32).map(|j| sign(j) * f64::powi(0.25, j as i32)).sum()
}

/// The p-value of the mean of a sample, where `expected` is its expectation, by its own
/// spread.
fn mean(sample: &[f64], expected: f64) -> f64 {
    let n = sample.len() as f64;
    let mean = sample.iter().sum::<f64>() / n;
    let spread = sample.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
    p_value::normal((mean - expected) / (spread / n).sqrt())
}

/// The kinds of tests that reject, each once.
fn rejections(
    name: &str,
    scramble: Scramble,
    correlation: fn(u32, u32) -> f64,
) -> Vec<&'static str> {
    let points = points();
    // Centred values of each point in each dimension, over the seeds.
    let value = |x, d, i| (f64::from(scramble(x, d, uvec2(i, 0))) + 0.5) / f64::powi(2.0, 32) - 0.5;
    let values = |x: u32, d: u32| (0..SEEDS).map(|i| value(x, d, i)).collect::<Vec<f64>>();
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect::<Vec<f64>>();
    let mut found: Vec<(&'static str, f64)> = Vec::new();
    let mut first: Vec<Vec<f64>> = Vec::new();
    for dimension in DIMENSIONS {
        let all: Vec<Vec<f64>> = points.iter().map(|x| values(*x, dimension)).collect();
        for (i, a) in all.iter().enumerate() {
            found.push(("mean", mean(a, 0.0)));
            found.push(("variance", mean(&product(a, a), 1.0 / 12.0)));
            for (j, b) in all[..i].iter().enumerate() {
                let expected = correlation(points[i], points[j]) / 12.0;
                found.push(("pairs", mean(&product(a, b), expected)));
            }
            if let Some(b) = first.get(i) {
                found.push(("dimensions", mean(&product(a, b), 0.0)));
            }
        }
        if first.is_empty() {
            first = all;
        }
    }
    let limit = -f64::exp_m1(f64::ln_1p(-SIGNIFICANCE) / found.len() as f64);
    let least = found.iter().map(|(_, p)| *p).fold(1.0, f64::min);
    // A spread of zero gives no p-value: that rejects as well.
    let mut kinds: Vec<&str> = found
        .iter()
        .filter(|(_, p)| p.is_nan() || *p < limit)
        .map(|(kind, _)| *kind)
        .collect();
    println!(
        "{name}: {} of {} reject below {limit:.1e}, least p {least:.1e}",
        kinds.len(),
        found.len()
    );
    kinds.sort_unstable();
    kinds.dedup();
    kinds
}

const LINEAR: Scramble = |x, d, s| digital_shift(matrix_scramble(x, d, s), seed(s, d, 0));
const HASHED: Scramble = |x, d, s| owen_hash(x, seed(s, d, 1));
const SHIFTED: Scramble = |x, d, s| digital_shift(x, seed(s, d, 0));

#[test]
fn moments_are_those_of_theory() {
    assert_eq!(rejections("owen", owen, nested), [""; 0]);
    assert_eq!(rejections("owen_hash", HASHED, nested), [""; 0]);
    assert_eq!(rejections("matrix and shift", LINEAR, nested), [""; 0]);
    assert_eq!(rejections("digital shift", SHIFTED, shifted), [""; 0]);
}

#[test]
fn wrong_moments_are_seen() {
    let unshifted = rejections("matrix alone", matrix_scramble, nested);
    assert!(unshifted.contains(&"mean") && unshifted.contains(&"variance"));
    assert_eq!(
        rejections("a shift as if nested", SHIFTED, nested),
        ["pairs"]
    );
    assert_eq!(rejections("nested as if a shift", owen, shifted), ["pairs"]);
    let same: Scramble = |x, _, s| owen(x, 0, s);
    assert_eq!(rejections("dimensions alike", same, nested), ["dimensions"]);
    let narrow: Scramble = |x, d, s| owen(x, d, s) / 8 * 7 + (1 << 28);
    assert!(rejections("seven eighths", narrow, nested).contains(&"variance"));
}
