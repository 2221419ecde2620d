//! Rows of columns that are all linear in the index: those of an aligned block of 2^k indices
//! are one row of the block, exclusive or those of a table, so that no column is moved into
//! rows.

use super::linear::purely_linear;
use super::runs::runs;
use super::{Finish, finished};
use crate::interface::Column;

/// The tables of a point's columns.
#[derive(Clone, Debug)]
pub struct Net {
    width: usize,
    /// The rows of what the low bits of the index contribute, for each value of them.
    table: Vec<u32>,
    /// The rows of what each other bit contributes.
    high: Vec<u32>,
    /// What every row has besides.
    shift: Vec<u32>,
    finish: Finish,
}

/// Words of a table at most: 16 KiB.
const TABLE: usize = 1 << 12;

/// Columns at most, so that a table has 64 rows at least.
const WIDEST: usize = 64;

/// Words of rows that are equal, and long enough for a loop over them.
const LOOP: usize = 256;

impl Net {
    /// Columns of one rounding; `None` where one is not linear, or where they are too many.
    pub fn of(columns: &[Column], finish: Finish) -> Option<Self> {
        let width = columns.len();
        if !(1..=WIDEST).contains(&width) {
            return None;
        }
        let nets = columns.iter().map(purely_linear);
        let nets = nets.collect::<Option<Vec<_>>>()?;
        let rows = |bit: usize| nets.iter().map(move |net| net.directions[bit]);
        let bits = (TABLE / width).ilog2() as usize;
        let mut table = vec![0; width];
        for bit in 0..bits {
            let lower = table.len();
            table.extend_from_within(..);
            let directions = rows(bit).cycle();
            for (word, direction) in table[lower..].iter_mut().zip(directions) {
                *word ^= direction;
            }
        }
        Some(Self {
            width,
            table,
            high: (bits..32).flat_map(rows).collect(),
            shift: nets.iter().map(|net| net.shift).collect(),
            finish,
        })
    }

    /// Writes the rows of consecutive points from index n on.
    #[inline(always)]
    pub fn fill(&self, n: u64, words: &mut [u32]) {
        finished!(self.finish, |finish| self.each(n, words, finish));
    }

    #[inline(always)]
    fn each(&self, n: u64, words: &mut [u32], finish: impl Fn(u32) -> u32) {
        let mut equal = [0; LOOP];
        let equal = &mut equal[..LOOP / self.width * self.width];
        for (block, place, run) in runs(n * self.width as u64, self.table.len(), words) {
            self.base(block, &mut equal[..self.width]);
            for at in self.width..equal.len() {
                equal[at] = equal[at - self.width];
            }
            let table = self.table[place..].chunks(equal.len());
            for (words, table) in run.chunks_mut(equal.len()).zip(table) {
                for ((word, low), base) in words.iter_mut().zip(table).zip(&*equal) {
                    *word = finish(base ^ low);
                }
            }
        }
    }

    /// What the rows of a block share.
    fn base(&self, block: u64, row: &mut [u32]) {
        row.copy_from_slice(&self.shift);
        for (bit, directions) in self.high.chunks_exact(self.width).enumerate() {
            if (block >> bit) & 1 != 0 {
                for (word, direction) in row.iter_mut().zip(directions) {
                    *word ^= direction;
                }
            }
        }
    }
}

#[cfg(test)]
impl Net {
    /// Makes one entry wrong.
    pub fn break_table(&mut self, place: usize) {
        self.table[place] ^= 1 << 9;
    }
}
