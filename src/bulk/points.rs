//! Points of columns that are made by blocks, batch after batch of rows.

use super::blocks::{Blocks, Finish, Net, Philox};
use super::column::Prepared;
use super::output::{CLEARED, Rows};
use super::rows::TOGETHER;
use crate::catalog::Output;
use crate::interface::Column;
use fearless_simd::{Level, dispatch};

/// Points of a batch at most: a power of two. Of up to ten columns the words stay in a
/// first-level cache of 32 KiB, of more in the second.
const ROWS: usize = 1 << 9;

/// Words from a column of a batch to the next: 16 more than there are rows, which keep columns
/// out of each other's places in the cache.
pub const STRIDE: usize = ROWS + 16;

/// Columns of a batch that is short.
const NARROW: usize = 8;

/// The columns of points.
#[derive(Clone, Debug)]
pub struct Points {
    groups: Vec<Vec<Source>>,
    width: usize,
    /// A shorter way to rows, where there is one.
    net: Option<Net>,
    /// The vectors that this CPU has, for which the compiler makes each loop once.
    level: Level,
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
            level: Level::new(),
        }
    }

    /// The vectors that loops are made by.
    pub fn level(&self) -> Level {
        self.level
    }

    /// The same by the vectors of another level, which the CPU has.
    #[cfg(test)]
    fn by(mut self, level: Level) -> Self {
        self.level = level;
        self
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
            dispatch!(self.level, _ => net.fill(n, words));
        }
    }

    fn fill_by_columns(&self, n: u64, words: &mut [u32]) {
        let count = words.len() / self.width.max(1);
        let mut rows = Rows::new(words, self.width, self.level);
        self.each(n, count, |batch| rows.put(batch));
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
                dispatch!(self.level, _ => fill(group, index, rows, words));
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
#[inline(always)]
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

/// The levels of this CPU.
#[cfg(test)]
pub fn levels() -> Vec<Level> {
    let best = Level::new();
    let mut levels = vec![Level::baseline(), best];
    #[cfg(target_arch = "x86_64")]
    {
        levels.extend(best.as_sse4_2().map(Level::Sse4_2));
        levels.extend(best.as_avx2().map(Level::Avx2));
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::{DigitScramble, Generator, NetScramble};

    #[test]
    fn words_do_not_depend_on_the_vectors() {
        let seed = [3, 4];
        let net = |scramble| Column::Sobol {
            dimension: 3,
            gray: false,
            scramble,
            seed,
        };
        let random = |generator, dimension| Column::Random {
            generator,
            dimension,
            dimensions: 4,
            seed,
        };
        let digits = |scramble| Column::Digits {
            base: 3,
            scramble,
            seed: 3,
        };
        let columns = [
            Column::Reversed,
            Column::Radical(5),
            Column::Grid(1 << 32),
            digits(DigitScramble::Permuted),
            digits(DigitScramble::Faure),
            net(NetScramble::Matrix),
            net(NetScramble::OwenHash),
            random(Generator::Pcg4d, 2),
            random(Generator::Pcg32, 1),
            random(Generator::Philox, 0),
            random(Generator::Philox, 1),
        ];
        let nets = [net(NetScramble::Shift), Column::Reversed];
        for columns in [&columns[..], &columns[..2], &nets[..]] {
            for output in [Output::Floats, Output::Fractions] {
                let single: Vec<Prepared> = columns.iter().map(Prepared::new).collect();
                let word = |n: u32, column: &Prepared| {
                    let u = column.fraction(n);
                    match output {
                        Output::Fractions => u,
                        Output::Floats => column.unit(u).to_bits(),
                    }
                };
                let (first, count) = (1_000_003u32, 3_001);
                let numbers = first..first + count;
                let wanted: Vec<u32> = numbers
                    .flat_map(|n| single.iter().map(move |column| word(n, column)))
                    .collect();
                for level in levels() {
                    let points = Points::new(columns, 1 << 32, output).by(level);
                    let mut made = vec![0; wanted.len()];
                    points.fill(first.into(), &mut made);
                    assert!(made == wanted, "{level:?}, {columns:?}");
                }
            }
        }
    }
}
