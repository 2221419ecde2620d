//! Random numbers by Philox for up to four columns, which share the generator's blocks.

use super::super::points::STRIDE;
use super::{Finish, finished};
use crate::interface::{Column, Generator};

/// Neighbouring columns of one block.
#[derive(Clone, Debug)]
pub struct Philox {
    /// The number of the block: dimension / 4.
    block: u32,
    seed: [u32; 2],
    /// The word of the block that each column is.
    words: Vec<usize>,
    finish: Finish,
}

/// Indices that go side by side.
const LANES: usize = 16;

/// The place of a column in Philox: block, seed and word.
fn place(column: &Column) -> Option<(u32, [u32; 2], usize)> {
    match *column {
        Column::Random {
            generator: Generator::Philox,
            dimension,
            seed,
            ..
        } => Some((dimension >> 2, seed, (dimension & 3) as usize)),
        _ => None,
    }
}

impl Philox {
    /// The columns at the front that share a block; `None` where the first is of another
    /// generator.
    pub fn of(columns: &[Column], finish: Finish) -> Option<Self> {
        let (block, seed, _) = place(columns.first()?)?;
        let shared = columns.iter().map_while(|column| {
            let (own, key, word) = place(column)?;
            (own == block && key == seed).then_some(word)
        });
        Some(Self {
            block,
            seed,
            words: shared.take(4).collect(),
            finish,
        })
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.words.len()
    }

    /// Writes the words of `count` indices from n on, each column [`STRIDE`] words after the one
    /// before it.
    #[inline(always)]
    pub fn fill(&self, n: u64, count: usize, columns: &mut [u32]) {
        finished!(self.finish, |finish| {
            for start in (0..count).step_by(LANES) {
                let first = (n as u32).wrapping_add(start as u32);
                let numbers = philox(first, self.block, self.seed);
                for (column, &word) in columns.chunks_mut(STRIDE).zip(&self.words) {
                    let made = numbers[word].map(|number| finish(number as u32));
                    let into = &mut column[start..count];
                    match into.first_chunk_mut::<LANES>() {
                        Some(into) => *into = made,
                        None => into.copy_from_slice(&made[..into.len()]),
                    }
                }
            }
        })
    }
}

#[cfg(test)]
impl Philox {
    /// Takes the words of another block.
    pub fn break_block(&mut self) {
        self.block += 1;
    }
}

/// The blocks of consecutive counters from n on, word by word. Words stand in the lower halves
/// of lanes, whose upper halves no product reads.
#[inline(always)]
fn philox(n: u32, block: u32, [mut k, mut l]: [u32; 2]) -> [[u64; LANES]; 4] {
    let low = |x: u64| x & 0xffff_ffff;
    let mut x: [u64; LANES] = std::array::from_fn(|i| u64::from(n.wrapping_add(i as u32)));
    let mut y = [u64::from(block); LANES];
    let mut z = [0; LANES];
    let mut w = [0; LANES];
    for _ in 0..10 {
        for i in 0..LANES {
            let a = 0xd251_1f53 * low(x[i]);
            let b = 0xcd9e_8d57 * low(z[i]);
            x[i] = (b >> 32) ^ y[i] ^ u64::from(k);
            z[i] = (a >> 32) ^ w[i] ^ u64::from(l);
            y[i] = b;
            w[i] = a;
        }
        k = k.wrapping_add(0x9e37_79b9);
        l = l.wrapping_add(0xbb67_ae85);
    }
    [x, y, z, w]
}
