//! Radical inverses: van der Corput, Halton and Hammersley.

use super::Asked;
use crate::catalog::{Scramble, Sequence};
use crate::interface::{Column, DigitScramble, purpose};
use crate::tables::{LARGEST_PRIME, PRIMES, is_prime, nearest_prime};
use crate::{Error, Result};

pub(super) fn columns(asked: &Asked, warnings: &mut Vec<String>) -> Result<Vec<Column>> {
    let grid = u32::from(asked.sequence == Sequence::Hammersley);
    let bases = match &asked.options.bases {
        Some(bases) => checked(bases)?,
        None => PRIMES[..(asked.dimensions - grid) as usize].to_vec(),
    };
    warn_of_lines(asked, &bases, warnings);
    let mut columns: Vec<Column> = (0..)
        .zip(&bases)
        .map(|(dimension, &base)| column(asked, dimension, base))
        .collect();
    if grid == 1 {
        let at = if asked.options.index_first {
            0
        } else {
            columns.len()
        };
        columns.insert(at, Column::Grid(asked.total));
    }
    Ok(columns)
}

fn column(asked: &Asked, dimension: u32, base: u32) -> Column {
    let (scramble, purpose) = match asked.scramble {
        // Faure's permutations take no seed.
        Scramble::Faure => (DigitScramble::Faure, purpose::PERMUTED_DIGITS),
        Scramble::Permute => (DigitScramble::Permuted, purpose::PERMUTED_DIGITS),
        Scramble::Owen => (DigitScramble::Owen, purpose::NESTED_DIGITS),
        Scramble::Start => (DigitScramble::Started, purpose::START),
        _ if base == 2 => return Column::Reversed,
        _ => return Column::Radical(base),
    };
    Column::Digits {
        base,
        scramble,
        seed: asked.derived(dimension, purpose),
    }
}

/// Two bases walk the diagonal together until N passes their product; permutations that
/// are random part them.
fn warn_of_lines(asked: &Asked, bases: &[u32], warnings: &mut Vec<String>) {
    let mut largest = bases.to_vec();
    largest.sort_unstable_by(|a, b| b.cmp(a));
    let parted = matches!(asked.scramble, Scramble::Permute | Scramble::Owen);
    if let [a, b, ..] = largest[..]
        && !parted
        && asked.total < u64::from(a) * u64::from(b)
    {
        let remedy = match asked.sequence {
            Sequence::Hammersley => "more points, or fewer dimensions",
            _ => "more points, fewer dimensions, or --scramble owen",
        };
        warnings.push(format!(
            "{} points are fewer than {a} x {b} = {}: in these two bases they lie on lines; take \
             {remedy}",
            asked.total,
            u64::from(a) * u64::from(b)
        ));
    }
}

fn checked(bases: &[u64]) -> Result<Vec<u32>> {
    let mut checked = Vec::with_capacity(bases.len());
    for &base in bases {
        if base > u64::from(LARGEST_PRIME) {
            return Err(Error::BaseTooLarge {
                base,
                limit: LARGEST_PRIME,
            });
        }
        if !is_prime(base) {
            return Err(Error::NotPrime {
                base,
                nearest: nearest_prime(base),
            });
        }
        // At most LARGEST_PRIME, hence no bits are lost.
        let base = base as u32;
        if checked.contains(&base) {
            return Err(Error::RepeatedBase { base });
        }
        checked.push(base);
    }
    Ok(checked)
}
