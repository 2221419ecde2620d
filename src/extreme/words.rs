//! Exact sums as words, which devices must equal, and what is read from them.

use crate::estimate::{Estimate, FloatSum, U256};

/// The sum of an estimate in four words, then the sum of its squares in eight.
pub(super) fn estimate_words(estimate: &Estimate) -> Vec<u32> {
    let sum = estimate.sum() as u128;
    let sums = [sum as u64, (sum >> 64) as u64];
    halves(sums.into_iter().chain(estimate.squares().parts()))
}

/// The estimate of these words; `None` of too few.
pub(super) fn estimate_of(words: &[u32], count: u64, scale: i32) -> Option<Estimate> {
    let parts: Vec<u64> = words.chunks_exact(2).map(whole).collect();
    let &[low, high, a, b, c, d] = parts.as_slice() else {
        return None;
    };
    let sum = u128::from(low) | (u128::from(high) << 64);
    Estimate::from_sums(count, scale, sum as i128, U256::new([a, b, c, d]))
}

/// The sum of floats, rounded to a double, in two words, then all of it in twelve.
pub(super) fn float_sum_words(sum: &FloatSum) -> Vec<u32> {
    let value = sum.value().to_bits();
    halves(std::iter::once(value).chain(sum.words()))
}

/// The double of two words.
pub(super) fn double(pair: &[u32]) -> f64 {
    f64::from_bits(whole(pair))
}

fn whole(pair: &[u32]) -> u64 {
    pair.iter()
        .rev()
        .fold(0, |high, &low| (high << 32) | u64::from(low))
}

fn halves(words: impl Iterator<Item = u64>) -> Vec<u32> {
    words
        .flat_map(|word| [word as u32, (word >> 32) as u32])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bulk::reduce;

    #[test]
    fn sums_come_back_from_their_words() {
        let squares = U256::new([1, 2, 3, 1 << 40]);
        for sum in [0, 1, -1, i128::MAX >> 16, i128::MIN >> 16] {
            let one = Estimate::from_sums(9, 31, sum, squares).expect("within its range");
            let words = estimate_words(&one);
            assert_eq!(words.len(), 12);
            assert_eq!(estimate_of(&words, 9, 31), Some(one));
            assert_eq!(estimate_of(&words[1..], 9, 31), None);
        }
        let sum = reduce(&[1e30, 1.0, -1e30]).expect("three terms");
        let words = float_sum_words(&sum);
        assert_eq!((double(&words[..2]), words.len()), (1.0, 14));
    }
}
