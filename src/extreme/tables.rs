//! Tables of weights: bins beside a hot one, what is left of a fraction, and edges.

use super::case::{Case, Source};
use super::elementary::unit;
use crate::Result;
use crate::environment::{alias_table, cdf_table, quantise};
use crate::reference::discrete::{alias_rest, cdf};
use glam::uvec2;
use std::collections::BTreeSet;

pub(super) fn tables() -> Result<Vec<Case>> {
    let mut cases = vec![steps(12)?, steps(20)?];
    cases.extend([rests()?, edges()?]);
    Ok(cases)
}

/// Beside one hot bin a float CDF has no steps left; every bin keeps its own here.
fn steps(bits: u32) -> Result<Case> {
    let count = 1usize << bits;
    let weights: Vec<u64> = (0..count)
        .map(|i| if i == count / 2 { 1_000_000_000 } else { 1 })
        .collect();
    let total: f64 = weights.iter().map(|&w| w as f64).sum();
    let (mut sum, mut lost) = (0f32, 0);
    for &weight in &weights {
        let next = sum + (weight as f64 / total) as f32;
        lost += usize::from(next == sum);
        sum = next;
    }
    let exact = quantise(&weights)?;
    let empty = exact.iter().filter(|&&w| w == 0).count();
    let share = |n: usize| n as f64 / count as f64;
    // A table that does not sum to 2^32 draws from no distribution.
    let ours = match exact.iter().sum::<u64>() {
        0x1_0000_0000 => share(empty),
        _ => f64::INFINITY,
    };
    Ok(Case::host(
        35,
        format!("CDF of 2^{bits} bins, one 1e9 times the others: share of empty bins"),
        [share(lost), ours],
        Source::Integers,
        0.0,
    ))
}

/// What is left of a float fraction after a bin of 2^20 is 4 bits.
fn rests() -> Result<Case> {
    let count = 1u32 << 20;
    let table = alias_table(&vec![1; count as usize])?;
    let (mut naive, mut ours) = (BTreeSet::new(), BTreeSet::new());
    for i in 0..4096u32 {
        // Fractions of the last bin, which is 2^-20 wide.
        let u = uvec2(!i, i.wrapping_mul(0x9e37_79b9));
        let scaled = (unit(u.x) * count as f32).fract();
        naive.insert((scaled * 4096.0) as u32);
        ours.insert(alias_rest(0, count, u, &table) >> 20);
    }
    let missing = |seen: usize| 1.0 - seen as f64 / 4096.0;
    Ok(Case::host(
        38,
        "rest of a fraction in an alias table of 2^20 bins: share of 4096 cells without one",
        [missing(naive.len()), missing(ours.len())],
        Source::Integers,
        // Random cells, as many as there are: 1/e of them stay empty.
        0.4,
    ))
}

/// A fraction that meets an edge, and tails of weight 0.
fn edges() -> Result<Case> {
    let weights = [0u64, 1, 0, 0, 1, 0, 2, 0, 0];
    let table = cdf_table(&weights)?;
    let float: Vec<f32> = weights
        .iter()
        .scan(0f32, |sum, &w| {
            *sum += w as f32 / 4.0;
            Some(*sum)
        })
        .collect();
    let edges = [
        0u32,
        1 << 30,
        1 << 31,
        u32::MAX,
        (1 << 30) - 1,
        (1 << 31) - 1,
    ];
    let empty = |bin: usize| usize::from(weights.get(bin).is_none_or(|&w| w == 0));
    let (mut naive, mut ours) = (0, 0);
    for u in edges {
        let found = float.iter().position(|&c| unit(u) <= c);
        naive += empty(found.unwrap_or(weights.len() - 1));
        ours += empty(cdf(0, u, &table).index as usize);
    }
    let share = |n: usize| n as f64 / edges.len() as f64;
    Ok(Case::host(
        39,
        "CDF with empty bins, u at its edges: share drawn from empty bins",
        [share(naive), share(ours)],
        Source::Integers,
        0.0,
    ))
}
