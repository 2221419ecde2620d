//! Estimates: a count, and exact sums of terms and of their squares. They merge in any
//! grouping to the same bits, and only what is read from them is rounded, once.

mod float_sum;
mod pixels;
mod recorded;
mod wide;

pub use float_sum::{FloatSum, WINDOWS, window_scale};
pub use pixels::Pixels;
pub use recorded::Recorded;
pub use wide::U256;

use crate::{Error, Result};

/// Terms of an estimate at most: up to here no sum overflows.
const MOST: u64 = 1 << 62;

/// Exact sums over the terms of some samples, in units of 2^-scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Estimate {
    count: u64,
    scale: i32,
    sum: i128,
    squares: U256,
}

impl Estimate {
    /// That of no samples.
    #[must_use]
    pub fn new(scale: i32) -> Self {
        Self {
            count: 0,
            scale,
            sum: 0,
            squares: U256::default(),
        }
    }

    /// From the words of a sum, the lowest first: 128 bits in two's complement, and 192.
    #[must_use]
    pub fn from_words(count: u32, scale: i32, total: [u32; 4], squares: [u32; 6]) -> Self {
        let pair = |low: u32, high: u32| u64::from(low) | (u64::from(high) << 32);
        let [a, b, c, d] = total;
        let [s0, s1, s2, s3, s4, s5] = squares;
        Self {
            count: count.into(),
            scale,
            sum: (u128::from(pair(a, b)) | (u128::from(pair(c, d)) << 64)) as i128,
            squares: U256::new([pair(s0, s1), pair(s2, s3), pair(s4, s5), 0]),
        }
    }

    /// From up to 2^32 times the words of [`Self::from_words`], added up word by word: what merging
    /// their estimates gives, sooner. That of no sum which a merge would refuse.
    #[must_use]
    pub fn from_word_sums(count: u64, scale: i32, total: [u64; 4], squares: [u64; 6]) -> Self {
        // Two's complement adds up modulo 2^128, and the sum itself has room in that.
        let sum = (total.into_iter().zip([0, 32, 64, 96])).fold(0u128, |sum, (word, place)| {
            sum.wrapping_add(u128::from(word) << place)
        });
        let mut parts = [0; 4];
        let mut carry = 0u128;
        let (pairs, _) = squares.as_chunks::<2>();
        for (part, [low, high]) in parts.iter_mut().zip(pairs.iter().chain([&[0, 0]])) {
            carry += u128::from(*low) + (u128::from(*high) << 32);
            *part = carry as u64;
            carry >>= 64;
        }
        Self {
            count,
            scale,
            sum: sum as i128,
            squares: U256::new(parts),
        }
    }

    /// From sums that were written down; `None` where no terms have them: more than 2^62 of them,
    /// sums of none, squares below what Cauchy and Schwarz allow, or a scale beyond 4,096.
    #[must_use]
    pub fn from_sums(count: u64, scale: i32, sum: i128, squares: U256) -> Option<Self> {
        let least = U256::square(sum.unsigned_abs());
        squares.checked_mul(count)?.checked_sub(least)?;
        let none = count == 0 && squares != U256::default();
        let possible = count <= MOST && !none && scale.unsigned_abs() <= 4096;
        possible.then_some(Self {
            count,
            scale,
            sum,
            squares,
        })
    }

    /// Both together; `None` for sums of different scales, or of more than 2^62 terms.
    #[must_use]
    pub fn merge(self, other: Self) -> Option<Self> {
        let count = self.count.checked_add(other.count)?;
        if count > MOST || self.scale != other.scale {
            return None;
        }
        Some(Self {
            count,
            scale: self.scale,
            sum: self.sum.checked_add(other.sum)?,
            squares: self.squares.checked_add(other.squares)?,
        })
    }

    /// As [`Self::merge`], where sums of many points, or of two problems, would be a mistake.
    ///
    /// # Errors
    /// [`Error::Arguments`] in place of `None`.
    pub fn merged(self, other: Self) -> Result<Self> {
        self.merge(other).ok_or_else(|| Error::Arguments {
            asked: format!(
                "a sum of {} terms in units of 2^-{} and {} of 2^-{}",
                self.count, self.scale, other.count, other.scale
            ),
            limit: format!("one holds at most {MOST} terms of one unit, and no more than its bits"),
            remedy: "sum fewer points".into(),
        })
    }

    /// Terms.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Terms are in units of 2^-scale.
    #[must_use]
    pub fn scale(&self) -> i32 {
        self.scale
    }

    /// The sum of the terms, in their unit.
    #[must_use]
    pub fn sum(&self) -> i128 {
        self.sum
    }

    /// The sum of the squares of the terms, in units of 2^(-2 scale).
    #[must_use]
    pub fn squares(&self) -> U256 {
        self.squares
    }

    /// The mean, correctly rounded; `None` of no terms.
    #[must_use]
    pub fn mean(&self) -> Option<f64> {
        if self.count == 0 {
            return None;
        }
        let magnitude = U256::from_u128(self.sum.unsigned_abs());
        let mean = magnitude.over(self.count.into(), -self.scale);
        Some(if self.sum < 0 { -mean } else { mean })
    }

    /// The sample variance, with n - 1, correctly rounded; `None` of fewer than two terms.
    #[must_use]
    pub fn variance(&self) -> Option<f64> {
        if self.count < 2 {
            return None;
        }
        // n S2 - S1^2 is at most 2^252, and never negative (Cauchy and Schwarz).
        let (n, less) = (u128::from(self.count), u128::from(self.count - 1));
        let spread = self
            .squares
            .checked_mul(self.count)?
            .checked_sub(U256::square(self.sum.unsigned_abs()))?;
        Some(spread.over(n * less, -2 * self.scale))
    }

    /// sqrt(variance / n): the standard error of the mean of independent samples.
    #[must_use]
    pub fn standard_error(&self) -> Option<f64> {
        Some((self.variance()? / self.count as f64).sqrt())
    }
}
