//! Points of columns that are made by blocks, batch after batch of rows.

use super::blocks::{Blocks, Finish, Philox};
use super::column::Prepared;
use super::rows::{TOGETHER, interleave};
use crate::catalog::Output;
use crate::interface::Column;

/// Words of a batch, column by column: so few that they stay in the first-level cache.
const BATCH: usize = 1 << 12;

/// Rows of a batch at most.
const ROWS: usize = 1 << 10;

/// Words between the columns of a batch besides its rows, which keep the columns out of each
/// other's places in the cache.
const PAD: usize = 16;

/// The columns of points.
#[derive(Clone, Debug)]
pub struct Points {
    groups: Vec<Vec<Source>>,
    width: usize,
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
    /// The words, each column `stride` after the one before it.
    pub words: &'a [u32],
    /// Words from column to column.
    pub stride: usize,
}

impl Points {
    /// Prepares columns for about `count` points.
    pub fn new(columns: &[Column], count: u64, output: Output) -> Self {
        let width = columns.len();
        let groups = columns.chunks(TOGETHER);
        Self {
            groups: groups
                .map(|group| sources(group, count, width, output))
                .collect(),
            width,
        }
    }

    /// Writes the rows of consecutive points from index n on, which do not go past 2^32.
    pub fn fill(&self, n: u64, words: &mut [u32]) {
        if let ([group], 1) = (&self.groups[..], self.width) {
            let count = words.len();
            return fill(group, n, count, count.max(1), words);
        }
        self.each(n, words.len() / self.width.max(1), |batch| {
            let rows = &mut words[batch.start * self.width..][..batch.rows * self.width];
            interleave(batch, self.width, rows);
        });
    }

    /// Hands the columns of consecutive points from index n on to `take`.
    pub fn each(&self, n: u64, count: usize, mut take: impl FnMut(&Batch)) {
        let mut words = [0; BATCH + TOGETHER * PAD];
        let most = (BATCH / self.width.clamp(1, TOGETHER)).min(ROWS);
        // Batches begin where blocks of 2^k do.
        let most = 1 << most.ilog2();
        let stride = most + PAD;
        let mut start = 0;
        while start < count {
            let index = n + start as u64;
            let rows = (most - index as usize % most).min(count - start);
            for (first, group) in (0..).step_by(TOGETHER).zip(&self.groups) {
                fill(group, index, rows, stride, &mut words);
                take(&Batch {
                    start,
                    rows,
                    first,
                    words: &words,
                    stride,
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

/// Writes `rows` words of each column, `stride` apart.
fn fill(sources: &[Source], n: u64, rows: usize, stride: usize, words: &mut [u32]) {
    let mut rest = words;
    for source in sources {
        let taken = (source.width() * stride).min(rest.len());
        let (own, others) = rest.split_at_mut(taken);
        match source {
            Source::Column(blocks) => blocks.fill(n, &mut own[..rows]),
            Source::Philox(philox) => philox.fill(n, rows, stride, own),
        }
        rest = others;
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
