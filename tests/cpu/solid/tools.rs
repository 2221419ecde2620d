//! What the tests of the distributions share.

use corput::glam::{UVec2, uvec2};
use corput::reference::permute::permute_mix as mix;

/// A fraction of 2^32 as a number.
pub fn unit(u: u32) -> f64 {
    f64::from(u) / 4_294_967_296.0
}

/// Fractions at the ends and in the middle, and others between them.
pub fn fractions() -> Vec<u32> {
    let ends = (0..32).flat_map(|k| [1u32 << k, (1u32 << k) - 1, 0u32.wrapping_sub(1 << k)]);
    let mut list: Vec<u32> = ends.chain((0..40).map(mix)).collect();
    list.sort_unstable();
    list.dedup();
    list
}

/// Pairs of [`fractions`].
pub fn grid() -> Vec<UVec2> {
    let list = fractions();
    let pairs = list
        .iter()
        .flat_map(|&x| list.iter().map(move |&y| uvec2(x, y)));
    pairs.collect()
}

/// Random pairs of fractions.
pub fn random(count: u32) -> impl Iterator<Item = UVec2> {
    (0..count).map(|i| uvec2(mix(2 * i), mix(2 * i + 1)))
}

/// The distance of two fractions of a turn.
pub fn turn_distance(a: u32, b: u32) -> f64 {
    unit(a.wrapping_sub(b).min(b.wrapping_sub(a)))
}

/// The truth of one extreme case.
#[derive(Debug)]
pub struct Truth {
    pub row: u32,
    pub map: String,
    pub parameters: Vec<f64>,
    pub u: UVec2,
    pub quantity: String,
    pub value: f64,
}

/// The committed truth of one map.
pub fn truth(map: &str) -> Vec<Truth> {
    let text = include_str!("../../data/solid_truth.csv");
    let numbers = |list: &str| -> Vec<f64> {
        let words = list.split_whitespace();
        words.map(|word| word.parse().expect("a number")).collect()
    };
    let lines = text.lines().map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        let u = numbers(fields[3]);
        Truth {
            row: fields[0].parse().expect("a row"),
            map: fields[1].to_owned(),
            parameters: numbers(fields[2]),
            u: uvec2(u[0] as u32, u[1] as u32),
            quantity: fields[4].to_owned(),
            value: fields[5].parse().expect("a value"),
        }
    });
    let found: Vec<Truth> = lines.filter(|truth| truth.map == map).collect();
    assert!(!found.is_empty(), "no truth of {map}");
    found
}

/// The error of a result relative to the truth; infinite for an infinity or NaN.
pub fn relative(got: f64, truth: f64) -> f64 {
    let error = (got - truth).abs() / truth.abs();
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Prints the row of an extreme case, and demands that ours is right and the common formula
/// is not, if it is said to fail.
pub fn extreme(row: u32, input: &str, naive: f64, ours: f64, threshold: f64) {
    println!("| {row} | {input} | {naive:.1e} | {ours:.1e} | {threshold:.0e} |");
    assert!(ours <= threshold, "row {row}, {input}: {ours:e}");
}
