//! Columns linear in the index: values of an aligned block of 2^k indices are one value of the
//! block, exclusive or one of a table.

use super::runs::runs;
use crate::interface::{Column, NetScramble};
use crate::reference::lattice::rotate;
use crate::reference::owen::{owen, owen_hash_reversed};
use crate::variant::{LinearNet, linear_net};
use glam::UVec2;

/// A column linear in the index, but for what follows.
#[derive(Clone, Debug)]
pub struct Linear {
    /// What the low bits of the index contribute, for each value of them.
    table: Vec<u32>,
    /// What its other bits contribute.
    high: Vec<u32>,
    shift: u32,
    then: Then,
}

/// What follows the linear part.
#[derive(Clone, Copy, Debug)]
enum Then {
    Nothing,
    Owen { dimension: u32, seed: UVec2 },
    OwenHash { seed: u32 },
    Product { z: u32, shift: u32 },
}

/// A column that is linear in the index and nothing else.
pub fn purely_linear(column: &Column) -> Option<LinearNet> {
    match *column {
        Column::Reversed => Some(REVERSED),
        Column::Sobol {
            dimension,
            gray,
            scramble: scramble @ (NetScramble::None | NetScramble::Shift | NetScramble::Matrix),
            seed,
        } => Some(linear_net(dimension, gray, scramble, UVec2::from(seed))),
        _ => None,
    }
}

/// Bits of the index that a table is for: 4 KiB, or 256 bytes where there are many columns.
fn table_bits(width: usize) -> usize {
    if width <= 64 { 10 } else { 6 }
}

impl Linear {
    fn new(net: &LinearNet, width: usize, then: Then) -> Self {
        let (low, high) = net.directions.split_at(table_bits(width));
        let mut table = vec![0];
        for direction in low {
            table.extend_from_within(..);
            let half = table.len() / 2;
            table[half..].iter_mut().for_each(|x| *x ^= direction);
        }
        Self {
            table,
            high: high.to_vec(),
            shift: net.shift,
            then,
        }
    }

    /// A coordinate of the Sobol sequence.
    pub fn sobol(
        dimension: u32,
        gray: bool,
        scramble: NetScramble,
        seed: [u32; 2],
        width: usize,
    ) -> Self {
        let seed = UVec2::from(seed);
        let net = linear_net(dimension, gray, scramble, seed);
        let then = match scramble {
            NetScramble::None | NetScramble::Shift | NetScramble::Matrix => Then::Nothing,
            NetScramble::Owen => Then::Owen { dimension, seed },
            NetScramble::OwenHash => Then::OwenHash { seed: net.hash },
        };
        Self::new(&net, width, then)
    }

    /// The van der Corput sequence.
    pub fn reversed(width: usize) -> Self {
        Self::new(&REVERSED, width, Then::Nothing)
    }

    /// A coordinate of an embedded lattice.
    pub fn lattice(z: u32, shift: u32, width: usize) -> Self {
        Self::new(&REVERSED, width, Then::Product { z, shift })
    }

    /// What the points of a block share.
    fn base(&self, block: u64) -> u32 {
        let bit =
            |(i, direction): (usize, &u32)| direction & (((block >> i) & 1) as u32).wrapping_neg();
        let bits = self.high.iter().enumerate().map(bit);
        bits.fold(self.shift, |base, x| base ^ x)
    }

    /// Writes the words of consecutive indices from n on.
    #[inline(always)]
    pub fn fill(&self, n: u64, words: &mut [u32], finish: impl Fn(u32) -> u32 + Copy) {
        match self.then {
            Then::Nothing => self.each(n, words, finish),
            Then::Owen { dimension, seed } => {
                self.each(n, words, |x| finish(owen(x, dimension, seed)));
            }
            Then::OwenHash { seed } => {
                // Products and the reversal of bits are vectorised apart, not together.
                let hash = |x| owen_hash_reversed(x, seed).reverse_bits();
                self.each(n, words, hash);
                for word in words {
                    *word = finish(word.reverse_bits());
                }
            }
            Then::Product { z, shift } => {
                self.each(n, words, |x| finish(rotate(x.wrapping_mul(z), shift)));
            }
        }
    }

    #[inline(always)]
    fn each(&self, n: u64, words: &mut [u32], value: impl Fn(u32) -> u32) {
        for (block, place, run) in runs(n, self.table.len(), words) {
            let base = self.base(block);
            for (word, low) in run.iter_mut().zip(&self.table[place..]) {
                *word = value(base ^ low);
            }
        }
    }
}

#[cfg(test)]
impl Linear {
    /// Makes one entry wrong.
    pub fn break_table(&mut self, place: usize) {
        self.table[place] ^= 1 << 9;
    }
}

/// The bits of the index in reverse order.
const REVERSED: LinearNet = {
    let mut directions = [0; 32];
    let mut bit = 0;
    while bit < 32 {
        directions[bit] = 1 << (31 - bit);
        bit += 1;
    }
    LinearNet {
        directions,
        shift: 0,
        hash: 0,
    }
};
