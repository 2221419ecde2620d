//! Columns whose value is a quotient: with X of the block, `floor((2^32 s + X) / c)` is
//! `q + floor(X / c)`, and 1 more where the remainders add up to c; q and the remainder of
//! 2^32 s by c come from a table. For radical inverses s are the mirrored low digits and X
//! those above; for k/N it is the k of the block, and s what is added to it.

use super::digits::High;
use super::runs::runs;

/// The tables of a column.
#[derive(Clone, Debug)]
pub struct Tile {
    /// floor(2^32 s / c) for each place in a block.
    quotients: Vec<u32>,
    /// 2^32 s modulo c, ordered as signed words are: SSE2 compares no others.
    remainders: Vec<i32>,
    /// c.
    divisor: u64,
    /// What is added to the index.
    start: u64,
    share: Share,
    /// Whether the ceiling may reach 2^32, for which 2^32 - 1 stands; otherwise values are
    /// modulo 2^32.
    saturates: bool,
    /// The largest quotient and a carry.
    largest: u64,
}

/// What gives a block its X.
#[derive(Clone, Debug)]
pub enum Share {
    /// The digits above those of the table.
    Digits(High),
    /// k = n z modulo N of the block's first index, by the step of k from block to block; a
    /// shift is added to every value.
    Grid { step: u64, shift: u32 },
}

/// A word that compares signed as x does unsigned.
fn signed(x: u32) -> i32 {
    (x ^ 0x8000_0000) as i32
}

/// Points of a block of a grid: 8 KiB of tables.
const GRID_BLOCK: u64 = 1 << 10;

impl Tile {
    /// A tile of c places, where `numerator` gives the s of each.
    pub fn new(
        places: u64,
        divisor: u64,
        start: u64,
        share: Share,
        numerator: impl Fn(u64) -> u64,
    ) -> Self {
        let scaled = (0..places).map(|place| numerator(place) << 32);
        let (quotients, remainders): (Vec<u32>, _) = scaled
            .map(|x| ((x / divisor) as u32, signed((x % divisor) as u32)))
            .unzip();
        let largest = quotients
            .iter()
            .max()
            .map_or(0, |&most| u64::from(most) + 1);
        Self {
            quotients,
            remainders,
            divisor,
            start,
            saturates: matches!(share, Share::Digits(_)),
            share,
            largest,
        }
    }

    /// `ceil(2^32 k / total)` with k = n z modulo total, plus `shift`; `None` where fewer
    /// than two blocks are wanted.
    pub fn grid(z: u32, total: u64, shift: u32, count: u64) -> Option<Self> {
        if count < 2 * GRID_BLOCK {
            return None;
        }
        let z = u64::from(z);
        let step = GRID_BLOCK * z % total;
        let share = Share::Grid { step, shift };
        Some(Self::new(GRID_BLOCK, total, 0, share, |place| {
            place * z % total
        }))
    }

    /// Writes the words of consecutive indices from n on.
    #[inline(always)]
    pub fn fill(&self, n: u64, words: &mut [u32], finish: impl Fn(u32) -> u32) {
        for (block, place, run) in runs(n + self.start, self.quotients.len(), words) {
            let (x, shift) = match &self.share {
                Share::Digits(high) => (high.numerator(block, self.divisor), 0),
                Share::Grid { step, shift } => {
                    // Both factors are below 2^32, and the product's k below the divisor.
                    let k = block * step % self.divisor;
                    ((k << 32) + self.divisor - 1, *shift)
                }
            };
            let whole = x / self.divisor;
            // 1 to c; c is below 2^32, or x % c is c - 1.
            let carry = signed((self.divisor - x % self.divisor) as u32);
            let table = self.quotients[place..]
                .iter()
                .zip(&self.remainders[place..]);
            let pairs = run.iter_mut().zip(table);
            if self.saturates && whole + self.largest > u64::from(u32::MAX) {
                for (word, (quotient, remainder)) in pairs {
                    let value = quotient.saturating_add(whole as u32);
                    *word = finish(value.saturating_add(u32::from(*remainder >= carry)));
                }
                continue;
            }
            let whole = (whole as u32).wrapping_add(shift);
            for (word, (quotient, remainder)) in pairs {
                let value = quotient.wrapping_add(whole);
                *word = finish(value.wrapping_add(u32::from(*remainder >= carry)));
            }
        }
    }
}

#[cfg(test)]
impl Tile {
    /// Makes one quotient wrong, or one remainder so wrong that it always or never carries.
    pub fn break_table(&mut self, place: usize, remainder: bool) {
        if remainder {
            let reached = self.remainders[place] == i32::MIN;
            self.remainders[place] = if reached { i32::MAX } else { i32::MIN };
        } else {
            self.quotients[place] += 1;
        }
    }
}
