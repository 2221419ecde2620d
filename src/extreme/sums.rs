//! Sums of which floats lose terms, and the variance under a large mean.

use super::case::{Case, Measure, Reading, Source, Subject, Truth};
use super::integrals::{Points, estimated};
use crate::Result;
use crate::catalog::Sequence;
use crate::check::mix;
use std::sync::Arc;

/// The sum of these floats: exact on every device, in groups of any size.
fn sum(number: u32, input: &str, (terms, group): (Vec<f32>, u32), naive: f64, truth: f64) -> Case {
    Case::of(
        number,
        input,
        &[naive],
        Reading {
            first: 0,
            measure: Measure::Double,
        },
        Truth {
            values: vec![truth],
            source: Source::Integers,
        },
        0.0,
        Subject::Sum {
            terms: Arc::from(terms),
            group,
        },
    )
}

/// Invocations of a group where their number is not what the case is about.
const GROUP: u32 = 64;

fn in_order(terms: &[f32]) -> f64 {
    terms.iter().sum::<f32>().into()
}

/// What comes of a tree of groups: sums of so many neighbours until one is left.
fn tree(terms: &[f32], group: usize) -> f32 {
    let mut level = terms.to_vec();
    while level.len() > 1 {
        level = level.chunks(group).map(|part| part.iter().sum()).collect();
    }
    level.first().copied().unwrap_or(0.0)
}

/// Terms that are lost beside a large one, or among each other.
pub(super) fn swallowed() -> Vec<Case> {
    let mut ones = vec![1.0; 1 << 18];
    // A sum of as many ones as float counts.
    ones[0] = 16_777_216.0;
    let stalled = in_order(&ones);
    let truth = f64::from((1 << 24) + (1 << 18) - 1);
    let alternating: Vec<f32> = (0..20_000)
        .map(|i| match i % 4 {
            0 => 1e30,
            2 => -1e30,
            _ => 1.0,
        })
        .collect();
    let lost = in_order(&alternating);
    let mut tiny = vec![f32::from_bits(1); 1 << 14];
    // Below half a unit of this.
    tiny[0] = f32::from_bits(1 << 26);
    let smallest = f64::from(f32::from_bits(1));
    let kept = f64::from(f32::from_bits(1 << 26)) + ((1 << 14) - 1) as f64 * smallest;
    let drowned = in_order(&tiny);
    vec![
        sum(
            42,
            "2^24 and 2^18 - 1 ones after it",
            (ones, GROUP),
            stalled,
            truth,
        ),
        sum(
            42,
            "10,000 ones between 1e30 and -1e30 in turn",
            (alternating, GROUP),
            lost,
            10_000.0,
        ),
        sum(
            42,
            "2^14 - 1 of the smallest denormal after the float of bits 2^26",
            (tiny, GROUP),
            drowned,
            kept,
        ),
    ]
}

/// Floats are added in another order by every size of a group.
pub(super) fn grouped() -> Vec<Case> {
    let terms: Vec<f32> = (0..20_011)
        .map(|i| (mix(i) >> 8) as f32 / 16_777_216.0)
        .collect();
    // 39 bits in all.
    let truth: f64 = terms.iter().map(|&x| f64::from(x)).sum();
    [32u32, 64, 128, 256, 512, 1024]
        .map(|group| {
            sum(
                43,
                &format!("20,011 fractions in groups of {group}"),
                (terms.clone(), group),
                tree(&terms, group as usize).into(),
                truth,
            )
        })
        .into()
}

/// Squares of the mean have no room for the variance.
pub(super) fn variances() -> Result<Vec<Case>> {
    let (offset, count) = (288_675, 1u64 << 16);
    let n = count as f64;
    let (mut total, mut squares) = (0f32, 0f32);
    for k in 0..count {
        let value = (f64::from(offset) + k as f64 / n) as f32;
        total += value;
        squares += value * value;
    }
    let naive = f64::from(squares) / n - (f64::from(total) / n).powi(2);
    let points = Points::plain(Sequence::VanDerCorput, count);
    let case = estimated(
        44,
        format!("variance of 2^16 values under a mean of 10^6 deviations, {offset} + x"),
        &format!("offset:offset={offset}"),
        points,
        naive,
    )?;
    // Multiples of 1 / n from 0 on.
    Ok(vec![case.variance((n + 1.0) / (12.0 * n), 1e-15)])
}
