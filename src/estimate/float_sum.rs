//! The exact sum of floats.

use super::Estimate;
use crate::{Error, Result};

/// Windows of 32 exponents, which together have all of `f32`.
pub const WINDOWS: usize = 8;

/// Terms of a window are in units of 2^-scale.
#[must_use]
pub const fn window_scale(window: usize) -> i32 {
    150 - 32 * window as i32
}

/// The sum of floats without any rounding: exact sums of those of each window of exponents. They
/// merge in any grouping to the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FloatSum {
    windows: [Estimate; WINDOWS],
    special: u64,
}

impl Default for FloatSum {
    fn default() -> Self {
        Self {
            windows: std::array::from_fn(|window| Estimate::new(window_scale(window))),
            special: 0,
        }
    }
}

impl FloatSum {
    /// With the sum over some terms in a window, of which so many are infinite or NaN.
    ///
    /// # Errors
    /// As [`Estimate::merged`]: for sums of another unit, or of more than 2^62 terms, and for more
    /// special ones than there are terms.
    pub fn with(mut self, window: usize, sum: Estimate, special: u64) -> Result<Self> {
        let found = self.windows.get_mut(window);
        let place = found.ok_or_else(|| Error::Arguments {
            asked: format!("the sum of window {window} of exponents"),
            limit: format!("floats have {WINDOWS}"),
            remedy: "count them from 0".into(),
        })?;
        *place = place.merged(sum)?;
        // Each is seen in every window.
        if window == 0 {
            self.special = self.special.saturating_add(special);
        }
        self.sound()
    }

    fn sound(self) -> Result<Self> {
        if self.special > self.count() {
            return Err(Error::Arguments {
                asked: format!("a sum with {} infinite or NaN terms", self.special),
                limit: format!("it has {} terms in all", self.count()),
                remedy: "count the special ones among the terms".into(),
            });
        }
        Ok(self)
    }

    /// Both together.
    ///
    /// # Errors
    /// As [`Self::with`].
    pub fn merged(self, other: Self) -> Result<Self> {
        let mut windows = other.windows.into_iter().enumerate();
        windows.try_fold(self, |all, (window, sum)| {
            all.with(window, sum, other.special)
        })
    }

    /// Terms, the infinite and NaN among them.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.windows[0].count()
    }

    /// Terms that are infinite or NaN, and not in the sum.
    #[must_use]
    pub fn special(&self) -> u64 {
        self.special
    }

    /// The sums of the windows, and of their squares.
    #[must_use]
    pub fn windows(&self) -> &[Estimate; WINDOWS] {
        &self.windows
    }

    /// The sum in units of 2^-150: 384 bits in two's complement, the lowest word first.
    #[must_use]
    pub fn words(&self) -> [u64; 6] {
        let mut words = [0u64; 6];
        for (window, sum) in self.windows.iter().enumerate() {
            // 128 bits, from a half of a word on, and their sign above.
            let sum = sum.sum();
            let (low, high) = match window % 2 {
                0 => (sum as u128, sum >> 127),
                _ => ((sum << 32) as u128, sum >> 96),
            };
            let parts = [
                low as u64,
                (low >> 64) as u64,
                high as u64,
                (sum >> 127) as u64,
            ];
            let (mut carry, sign) = (0u128, (sum >> 127) as u64);
            for (i, word) in words.iter_mut().enumerate().skip(window / 2) {
                let part = parts.get(i - window / 2).copied().unwrap_or(sign);
                carry += u128::from(*word) + u128::from(part);
                *word = carry as u64;
                carry >>= 64;
            }
        }
        words
    }

    /// The sum, rounded once to the nearest, ties to even.
    #[must_use]
    pub fn value(&self) -> f64 {
        let words = self.words();
        let negative = words[5] >> 63 == 1;
        let mut carry = negative;
        let magnitude = words.map(|word| {
            let (word, over) = match negative {
                true => (!word).overflowing_add(carry.into()),
                false => (word, false),
            };
            carry = over;
            word
        });
        let Some(top) = magnitude.iter().rposition(|word| *word != 0) else {
            return 0.0;
        };
        let at = |i: usize| magnitude.get(i).copied().unwrap_or(0);
        // The highest 64 bits, and whether any is set below.
        let shift = at(top).leading_zeros();
        let below = if top > 0 { at(top - 1) } else { 0 };
        let pair = (u128::from(at(top)) << 64 | u128::from(below)) << shift;
        let rest = pair as u64 != 0
            || magnitude
                .iter()
                .take(top.saturating_sub(1))
                .any(|w| *w != 0);
        let head = (pair >> 64) as u64 | u64::from(rest);
        // 11 of the 64 bits are rounded off, all of which the last one stands for.
        let value = head as f64 * f64::powi(2.0, 64 * top as i32 - shift as i32 - 150);
        if negative { -value } else { value }
    }
}
