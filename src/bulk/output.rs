//! Rows that are written batch after batch, into memory that is cleared just before.

use super::points::Batch;
use super::rows::interleave;
use fearless_simd::{Level, dispatch};

/// Words that are cleared before they are written, 16 KiB: the C library clears memory without
/// reading it, which loops over memory cannot, and so long a stretch stays in the cache.
pub const CLEARED: usize = 1 << 12;

/// Consecutive rows of as many words each.
pub struct Rows<'a> {
    words: &'a mut [u32],
    width: usize,
    level: Level,
    cleared: usize,
}

impl<'a> Rows<'a> {
    /// Rows of `width` words, by the vectors of a level.
    pub fn new(words: &'a mut [u32], width: usize, level: Level) -> Self {
        Self {
            words,
            width,
            level,
            cleared: 0,
        }
    }

    /// Writes a batch into its place. Batches come in the order of their rows.
    pub fn put(&mut self, batch: &Batch) {
        let start = batch.start * self.width;
        let end = start + batch.rows * self.width;
        if end > self.cleared {
            let next = (self.cleared + CLEARED).max(end).min(self.words.len());
            self.words[self.cleared..next].fill(0);
            self.cleared = next;
        }
        let rows = &mut self.words[start..end];
        dispatch!(self.level, _ => interleave(batch, self.width, rows));
    }
}
