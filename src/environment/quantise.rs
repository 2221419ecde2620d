//! Integer weights to probabilities over 2^32, and the tables that draw by them.

use crate::{Error, Result};
use std::cmp::Ordering;

/// Weights that sum to exactly 2^32, in the proportions of the given ones.
///
/// Each positive weight becomes at least 1, so that what was possible stays possible; the
/// rest is shared out in proportion and rounded by the largest remainders (Hamilton's
/// method), so that no share is off by more than 1. All are 0 where all given ones are.
///
/// # Errors
///
/// [`Error::Arguments`] if there are more than 2^31 weights, or they sum to 2^63 or more.
pub fn quantise(weights: &[u64]) -> Result<Vec<u64>> {
    let total: u128 = weights.iter().map(|&w| u128::from(w)).sum();
    if total >= 1 << 63 {
        let asked = format!("weights that sum to {total}");
        return Err(refused(
            asked,
            "weights sum to less than 2^63",
            "scale them",
        ));
    }
    if weights.len() as u64 > 1 << 31 {
        let asked = format!("{} weights", weights.len());
        return Err(refused(asked, "there are at most 2^31", "give fewer"));
    }
    let positive = weights.iter().filter(|&&w| w > 0).count() as u64;
    if total == 0 {
        return Ok(vec![0; weights.len()]);
    }
    let shared = u128::from((1u64 << 32) - positive);
    let mut left = shared as u64;
    let mut shares = Vec::with_capacity(weights.len());
    let mut remainders = Vec::with_capacity(weights.len());
    for (index, &weight) in weights.iter().enumerate() {
        let product = u128::from(weight) * shared;
        let share = (product / total) as u64;
        left -= share;
        shares.push(share + u64::from(weight > 0));
        if weight > 0 {
            // Largest remainders first, and the first of equal ones.
            remainders.push((!((product % total) as u64), index as u32));
        }
    }
    let left = left as usize;
    if left > 0 && left < remainders.len() {
        remainders.select_nth_unstable(left);
    }
    for &(_, index) in &remainders[..left] {
        shares[index as usize] += 1;
    }
    Ok(shares)
}

fn refused(asked: String, limit: &str, remedy: &str) -> Error {
    Error::Arguments {
        asked,
        limit: limit.into(),
        remedy: remedy.into(),
    }
}

/// Refuses weights of which none is positive.
fn positive(weights: &[u64]) -> Result<()> {
    if weights.iter().any(|&w| w > 0) {
        return Ok(());
    }
    let asked = format!(
        "a table of {} weights, none of which is positive",
        weights.len()
    );
    Err(refused(
        asked,
        "something must be drawn",
        "give one a weight",
    ))
}

/// The table of `corput_cdf`: how many items there are up to the last of positive weight,
/// then the sum of the weights before each item but the first.
///
/// # Errors
///
/// As [`quantise`], and if there is no weight at all.
pub fn cdf_table(weights: &[u64]) -> Result<Vec<u32>> {
    if weights.is_empty() {
        let asked = "a table of no weights".to_owned();
        return Err(refused(asked, "something must be drawn", "give one"));
    }
    let mut words = Vec::with_capacity(weights.len());
    let mut sum = 0u64;
    let mut count = 0;
    for (index, share) in quantise(weights)?.into_iter().enumerate() {
        // What follows the last item of positive weight is never read.
        words.push(sum as u32);
        sum += share;
        if share > 0 {
            count = index as u32 + 1;
        }
    }
    words[0] = count;
    Ok(words)
}

/// The table of `corput_alias_index`: of each item the end of its own part of its bin, in
/// units of 2^-32 of the bin, the item that gets the other part, and its weight.
///
/// A bin holds as many of the 2^32 fractions u as `corput_mulhi(u, count)` sends there,
/// which differs by one between bins where the count is no power of two; since the table is
/// built with exactly these sizes, the probabilities are exact for every count. Vose's
/// method, in integers, leaves nothing over.
///
/// # Errors
///
/// As [`quantise`], and if no weight is positive.
pub fn alias_table(weights: &[u64]) -> Result<Vec<u32>> {
    positive(weights)?;
    let count = weights.len() as u64;
    let mut left = quantise(weights)?;
    let first = |bin: u64| (bin << 32).div_ceil(count);
    let size = |bin: u64| first(bin + 1) - first(bin);
    let mut words = vec![0; 3 * weights.len()];
    let (mut small, mut large) = (Vec::new(), Vec::new());
    for (index, &weight) in left.iter().enumerate() {
        // A weight of 2^32, of the only item that has any, is written as 0.
        words[3 * index + 1] = index as u32;
        words[3 * index + 2] = weight as u32;
        match weight.cmp(&size(index as u64)) {
            Ordering::Less => small.push(index as u32),
            Ordering::Equal => {}
            Ordering::Greater => large.push(index as u32),
        }
    }
    // Where a small one is left, so is a large one: the sizes sum to what the weights do. A
    // large one has more than its own bin holds, hence at least what any bin does.
    while let (Some(&from), Some(to)) = (large.last(), small.pop()) {
        let own = left[to as usize];
        words[3 * to as usize] = (own * count) as u32;
        words[3 * to as usize + 1] = from;
        left[from as usize] -= size(u64::from(to)) - own;
        match left[from as usize].cmp(&size(u64::from(from))) {
            Ordering::Less => {
                large.pop();
                small.push(from);
            }
            Ordering::Equal => {
                large.pop();
            }
            Ordering::Greater => {}
        }
    }
    Ok(words)
}
