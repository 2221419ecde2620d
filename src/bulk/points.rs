//! Points of columns that are made by blocks, batch after batch of rows.

use super::blocks::{Blocks, Finish, Net, Philox};
use super::column::Prepared;
use super::rows::{TOGETHER, interleave};
use crate::catalog::Output;
use crate::interface::Column;

/// Points of a batch at most: a power of two. Of up to ten columns the words stay in a
/// first-level cache of 32 KiB, of more in the second.
const ROWS: usize = 1 << 9;

/// Words from a column of a batch to the next: 16 more than there are rows, which keep columns
/// out of each other's places in the cache.
pub const STRIDE: usize = ROWS + 16;

/// Words that are cleared before they are written, 16 KiB: the C library clears memory without
/// reading it, which loops over memory cannot, and so long a stretch stays in the cache.
const CLEARED: usize = 1 << 12;

/// Columns of a batch that is short.
const NARROW: usize = 8;

/// The columns of points.
#[derive(Clone, Debug)]
pub struct Points {
    groups: Vec<Vec<Source>>,
    width: usize,
    /// A shorter way to rows, where there is one.
    net: Option<Net>,
}

/// What makes one column, or several.
#[derive(Clone, Debug)]
enum Source {
    Column(Box<Blocks>),
    Philox(Philox),
}

/// Some columns of consecutive points.
pub struct Batch<'a> {
    /// The first of the points, from the first that was asked for.
    pub start: usize,
    /// Points.
    pub rows: usize,
    /// The first of the columns.
    pub first: usize,
    /// The words, each column [`STRIDE`] after the one before it.
    pub words: &'a [u32],
}

impl Points {
    /// Prepares columns for about `count` points.
    pub fn new(columns: &[Column], count: u64, output: Output) -> Self {
        let width = columns.len();
        let groups = columns.chunks(TOGETHER);
        let finish = |column| Finish::of(&Prepared::new(column), output);
        Self {
            net: columns
                .first()
                .and_then(|first| Net::of(columns, finish(first))),
            groups: groups
                .map(|group| sources(group, count, width, output))
                .collect(),
            width,
        }
    }

    /// Writes the rows of consecutive points from index n on, which do not go past 2^32.
    pub fn fill(&self, n: u64, words: &mut [u32]) {
        let Some(net) = &self.net else {
            return self.fill_by_columns(n, words);
        };
        let stretch = (CLEARED / self.width).max(1);
        let stretches = words.chunks_mut(stretch * self.width);
        for (n, words) in (n..).step_by(stretch).zip(stretches) {
            words.fill(0);
            net.fill(n, words);
        }
    }

    fn fill_by_columns(&self, n: u64, words: &mut [u32]) {
        let mut cleared = 0;
        self.each(n, words.len() / self.width.max(1), |batch| {
            let start = batch.start * self.width;
            let end = start + batch.rows * self.width;
            if end > cleared {
                let next = (cleared + CLEARED).max(end).min(words.len());
                words[cleared..next].fill(0);
                cleared = next;
            }
            interleave(batch, self.width, &mut words[start..end]);
        });
    }

    /// Hands the columns of consecutive points from index n on to `take`.
    pub fn each(&self, n: u64, count: usize, take: impl FnMut(&Batch)) {
        // Clearing the room for many columns takes longer than a short fill of few.
        if self.width <= NARROW {
            self.each_in(&mut [0; NARROW * STRIDE], n, count, take);
        } else {
            self.each_in(&mut [0; TOGETHER * STRIDE], n, count, take);
        }
    }

    fn each_in(&self, words: &mut [u32], n: u64, count: usize, mut take: impl FnMut(&Batch)) {
        let mut start = 0;
        while start < count {
            let index = n + start as u64;
            // Batches begin where blocks of 2^k do.
            let rows = (ROWS - index as usize % ROWS).min(count - start);
            for (first, group) in (0..).step_by(TOGETHER).zip(&self.groups) {
                fill(group, index, rows, words);
                take(&Batch {
                    start,
                    rows,
                    first,
                    words,
                });
            }
            start += rows;
        }
    }
}

fn sources(columns: &[Column], count: u64, width: usize, output: Output) -> Vec<Source> {
    let mut sources = Vec::new();
    let mut rest = columns;
    while let Some(column) = rest.first() {
        let finish = Finish::of(&Prepared::new(column), output);
        let source = match Philox::of(rest, finish) {
            Some(philox) => Source::Philox(philox),
            None => Source::Column(Box::new(Blocks::new(column, count, width, finish))),
        };
        rest = &rest[source.width()..];
        sources.push(source);
    }
    sources
}

/// Writes `rows` words of each column.
fn fill(sources: &[Source], n: u64, rows: usize, words: &mut [u32]) {
    let mut columns = words;
    for source in sources {
        let (own, others) = columns.split_at_mut(source.width() * STRIDE);
        match source {
            Source::Column(blocks) => blocks.fill(n, &mut own[..rows]),
            Source::Philox(philox) => philox.fill(n, rows, own),
        }
        columns = others;
    }
}

impl Source {
    fn width(&self) -> usize {
        match self {
            Self::Column(_) => 1,
            Self::Philox(philox) => philox.width(),
        }
    }
}
