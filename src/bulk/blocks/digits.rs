//! Tiles of radical inverses: a block of b^k indices shares all digits but k.

use super::tile::{Share, Tile};
use crate::reference::fixed::mulhi;
use crate::reference::permute::{permute, permute_key, permute_mix};
use crate::reference::radical_inverse::{Base, radical_inverse_table};
use crate::reference::scrambled_radical_inverse::{faure_digit, radical_inverse_faure};
use crate::variant::radical_base;

/// Places of a block at most: 32 KiB of tables.
const LARGEST_BLOCK: u64 = 1 << 12;

/// The digits above those of a table, mirrored: X is their fraction of 2^32, rounded up with
/// what makes the quotient a ceiling, or down.
#[derive(Clone, Debug)]
pub enum High {
    /// As they are, up.
    Plain(Base),
    /// By Faure's permutations, up.
    Faure(u32),
    /// Each by a permutation of its position, down.
    Permuted(Permuted),
}

/// A number of a fixed number of digits, each permuted.
#[derive(Clone, Debug)]
pub struct Permuted {
    base: u64,
    /// The permutations, from that of the lowest digit up.
    tables: Vec<u32>,
    /// What is added to the number of the block.
    start: u64,
    /// The base to the number of digits.
    modulus: u64,
}

impl High {
    /// X for a block, where the tile has this divisor.
    pub fn numerator(&self, block: u64, divisor: u64) -> u64 {
        // Blocks of indices below 2^32.
        let number = block as u32;
        match self {
            Self::Plain(base) => u64::from(radical_inverse_table(number, *base)) + divisor - 1,
            Self::Faure(base) => u64::from(radical_inverse_faure(number, *base)) + divisor - 1,
            Self::Permuted(permuted) => permuted.fraction(block),
        }
    }
}

impl Permuted {
    fn fraction(&self, block: u64) -> u64 {
        let mut number = (block + self.start) % self.modulus;
        let mut mirrored = 0;
        for table in self.tables.chunks_exact(self.base as usize) {
            mirrored = mirrored * self.base + u64::from(table[(number % self.base) as usize]);
            number /= self.base;
        }
        ((u128::from(mirrored) << 32) / u128::from(self.modulus)) as u64
    }
}

/// Digits of a block's places for `count` values: the number of digits, and of places; `None`
/// where fewer than two blocks are wanted.
fn block(base: u32, count: u64) -> Option<(u32, u64)> {
    let limit = LARGEST_BLOCK.min(count / 2);
    let powers = (1..).map_while(|k| Some((k, u64::from(base).checked_pow(k)?)));
    powers.take_while(|(_, power)| *power <= limit).last()
}

/// The lowest digits of a place, mirrored, each by the table of its position.
fn mirror(mut place: u64, digits: u32, base: u32, digit: impl Fn(u32, u64) -> u32) -> u64 {
    let base = u64::from(base);
    (0..digits).fold(0, |mirrored, position| {
        let low = digit(position, place % base);
        place /= base;
        mirrored * base + u64::from(low)
    })
}

/// The radical inverse.
pub fn plain(base: u32, count: u64) -> Option<Tile> {
    let (digits, places) = block(base, count)?;
    let share = Share::Digits(High::Plain(radical_base(base)));
    Some(Tile::new(places, places, 0, share, |place| {
        mirror(place, digits, base, |_, digit| digit as u32)
    }))
}

/// With Faure's permutations.
pub fn faure(base: u32, count: u64) -> Option<Tile> {
    let (digits, places) = block(base, count)?;
    let share = Share::Digits(High::Faure(base));
    let table: Vec<u32> = (0..base).map(|digit| faure_digit(digit, base)).collect();
    Some(Tile::new(places, places, 0, share, |place| {
        mirror(place, digits, base, |_, digit| table[digit as usize])
    }))
}

/// Digits of the scrambled radical inverses that round down: whole groups.
fn all_digits(base: u32) -> u32 {
    let base = radical_base(base);
    base.digits * if base.power < 1626 { 4 } else { 3 }
}

/// The key of a position.
fn key(base: u32, seed: u32, position: u32) -> u32 {
    let stream = permute_mix(permute_key(seed, base));
    permute_mix(stream.wrapping_add(position.wrapping_mul(0x9e37_79b9)))
}

/// With a random permutation for each position of a digit.
pub fn permuted(base: u32, seed: u32, count: u64) -> Option<Tile> {
    let (digits, places) = block(base, count)?;
    let tables: Vec<u32> = (0..all_digits(base))
        .flat_map(|position| {
            let key = key(base, seed, position);
            (0..base).map(move |digit| permute(digit, base, key))
        })
        .collect();
    let (low, high) = tables.split_at((digits * base) as usize);
    let share = Share::Digits(High::Permuted(Permuted {
        base: u64::from(base),
        tables: high.to_vec(),
        start: 0,
        modulus: u64::from(base).pow(all_digits(base) - digits),
    }));
    Some(Tile::new(places, places, 0, share, |place| {
        mirror(place, digits, base, |position, digit| {
            low[(position * base) as usize + digit as usize]
        })
    }))
}

/// From a random start on: the index is added to its digits.
pub fn started(base: u32, seed: u32, count: u64) -> Option<Tile> {
    let (digits, places) = block(base, count)?;
    let above = all_digits(base) - digits;
    let start = (0..all_digits(base)).rev().fold(0, |start, position| {
        start * u64::from(base) + u64::from(mulhi(key(base, seed, position), base))
    });
    let share = Share::Digits(High::Permuted(Permuted {
        base: u64::from(base),
        tables: (0..above).flat_map(|_| 0..base).collect(),
        start: start / places,
        modulus: u64::from(base).pow(above),
    }));
    Some(Tile::new(places, places, start % places, share, |place| {
        mirror(place, digits, base, |_, digit| digit as u32)
    }))
}
