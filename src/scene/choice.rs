//! A choice among several by their weights, in integers.

use crate::environment::quantise;
use crate::{Error, Result};

/// An item that can be chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// Its number among the weights.
    pub index: u32,
    /// The least fraction of 2^32 that chooses it; it goes on to the next item's.
    pub begin: u32,
    /// Its probability, rounded to the nearest.
    pub probability: f32,
}

/// A choice: fractions of 2^32 to items, by a comparison with each item's begin.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The items of positive weight, in order. The first begins at 0.
    pub shares: Vec<Share>,
}

impl Choice {
    /// The most items that a kernel compares with one by one; more are searched for in a table
    /// of [`Self::words`].
    pub const CHAIN: usize = 16;

    /// The choice of weights that [`Needs`](super::Needs) has checked. Probabilities are
    /// multiples of 2^-32 and at least that for any positive weight; but for what those take
    /// from the others they are off by 2^-32 at most.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a weight that is negative or not finite, none above 0, or more
    /// than 2^31.
    pub fn new(weights: &[f64]) -> Result<Self> {
        let largest = weights.iter().copied().fold(0.0, f64::max);
        let fine = |weight: &f64| weight.is_finite() && *weight >= 0.0;
        if largest <= 0.0 || !weights.iter().all(fine) {
            return Err(Error::Arguments {
                asked: format!("a choice among {} weights", weights.len()),
                limit: "weights are finite, none is below 0, and one at least is above".into(),
                remedy: "mend them".into(),
            });
        }
        // As many bits each as leave the sum of all below 2^63.
        let bits = 62 - weights.len().next_power_of_two().trailing_zeros();
        let scale = |weight: &f64| match weight / largest * 2f64.powi(bits as i32) {
            // What is possible stays so.
            scaled if *weight > 0.0 => (scaled.round() as u64).max(1),
            _ => 0,
        };
        let scaled: Vec<u64> = weights.iter().map(scale).collect();
        let mut begin = 0u64;
        let mut shares = Vec::new();
        for (index, share) in (0..).zip(quantise(&scaled)?) {
            if share > 0 {
                shares.push(Share {
                    index,
                    begin: begin as u32,
                    probability: (share as f64 / 2f64.powi(32)) as f32,
                });
            }
            begin += share;
        }
        Ok(Self { shares })
    }

    /// The item that a fraction chooses.
    #[must_use]
    pub fn draw(&self, u: u32) -> Share {
        let behind = self.shares.partition_point(|share| share.begin <= u);
        let found = self.shares.get(behind.saturating_sub(1));
        // There is one at least, and the first begins at 0.
        found.copied().unwrap_or(Share {
            index: 0,
            begin: 0,
            probability: 1.0,
        })
    }

    /// The table for a kernel: begin, index and bits of the probability of each item. None of
    /// so few items that it needs no table.
    #[must_use]
    pub fn words(&self) -> Vec<u32> {
        if self.shares.len() <= Self::CHAIN {
            return Vec::new();
        }
        let word = |share: &Share| [share.begin, share.index, share.probability.to_bits()];
        self.shares.iter().flat_map(word).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_share_is_drawn_by_its_fractions() {
        let choice = Choice::new(&[0.0, 1.0, 1.0, 0.0, 2.0, 0.0]).unwrap();
        let found: Vec<(u32, u32, f32)> = choice
            .shares
            .iter()
            .map(|share| (share.index, share.begin, share.probability))
            .collect();
        assert_eq!(found, [(1, 0, 0.25), (2, 1 << 30, 0.25), (4, 1 << 31, 0.5)]);
        for (u, index) in [
            (0, 1),
            ((1 << 30) - 1, 1),
            (1 << 30, 2),
            (1 << 31, 4),
            (u32::MAX, 4),
        ] {
            assert_eq!(choice.draw(u).index, index, "{u}");
        }
        assert!(choice.words().is_empty());
    }

    #[test]
    fn extreme_weights_keep_their_chance() {
        let choice = Choice::new(&[1e300, 1e-300, 5e-324]).unwrap();
        assert_eq!(choice.shares.len(), 3);
        assert_eq!(choice.draw(u32::MAX).index, 2);
        assert_eq!(choice.draw(choice.shares[2].begin - 1).index, 1);
        assert_eq!(choice.draw(choice.shares[1].begin - 1).index, 0);
        let many = Choice::new(&vec![1e-3; 1000]).unwrap();
        assert_eq!(many.words().len(), 3000);
        let sum: f64 = many.shares.iter().map(|s| f64::from(s.probability)).sum();
        assert!((sum - 1.0).abs() < 1e-4);
    }

    #[test]
    fn small_weights_keep_their_proportion() {
        let small = 1.999 * 2f64.powi(-31);
        let mut weights = vec![small; 65_536];
        weights[0] = 1.0;
        let choice = Choice::new(&weights).unwrap();
        let share = f64::from(choice.shares[1].begin) / 2f64.powi(32);
        // Each of the small ones has 1 or 2 of 2^32, and 1.999 by right.
        let right = 1.0 / (1.0 + 65_535.0 * small);
        assert!(
            (share - right).abs() < 65_536.0 * 2f64.powi(-32),
            "{share} {right}"
        );
    }

    #[test]
    fn weights_that_are_none_are_refused() {
        for weights in [
            &[][..],
            &[0.0],
            &[-1.0, 2.0],
            &[f64::NAN, 1.0],
            &[f64::INFINITY],
        ] {
            assert!(Choice::new(weights).is_err(), "{weights:?}");
        }
    }
}
