//! Lattices: the embedded one, Korobov's, and the additive recurrence.

use super::Asked;
use crate::catalog::{Scramble, Sequence};
use crate::interface::{Column, purpose};
use crate::tables::{KOROBOV, additive_alphas, lattice_vector};
use crate::{Error, Result};

/// Points for which the generating vector was chosen.
const EMBEDDED: u64 = 1 << 20;

pub(super) fn columns(asked: &Asked) -> Result<Vec<Column>> {
    let purpose = match asked.sequence {
        Sequence::Lattice => purpose::LATTICE,
        Sequence::R2 => purpose::ADDITIVE,
        _ => purpose::KOROBOV,
    };
    let shift = |dimension| match asked.scramble {
        Scramble::Rotate => Some(asked.derived(dimension, purpose)),
        _ => None,
    };
    match asked.sequence {
        Sequence::Lattice => {
            if asked.end > EMBEDDED {
                return Err(Error::Arguments {
                    asked: format!("points of lattice up to {}", asked.end),
                    limit: format!("its generating vector serves 2^20 = {EMBEDDED} points"),
                    remedy: "ask for fewer, or use sobol".into(),
                });
            }
            let vector = lattice_vector();
            Ok(asked.per_dimension(|dimension| Column::Lattice {
                z: vector[dimension as usize],
                shift: shift(dimension).unwrap_or(0),
            }))
        }
        Sequence::R2 => {
            let alphas = additive_alphas(asked.dimensions as usize);
            Ok(asked.per_dimension(|dimension| Column::Additive {
                alpha: alphas[dimension as usize],
                shift: shift(dimension).unwrap_or(0),
            }))
        }
        _ => {
            let (count, generator) = korobov(asked)?;
            let mut z = 1 % u64::from(count);
            let mut columns = Vec::new();
            for dimension in 0..asked.dimensions {
                columns.push(Column::Korobov {
                    // Below the count, which is a word.
                    z: z as u32,
                    count,
                    shift: shift(dimension),
                });
                z = z * generator % u64::from(count);
            }
            Ok(columns)
        }
    }
}

/// Number of points, and the generator below it.
fn korobov(asked: &Asked) -> Result<(u32, u64)> {
    let total = asked.total;
    if let Some(generator) = asked.options.generator {
        let most = total.max(2) - 1;
        if generator == 0 || generator > most {
            return Err(Error::Arguments {
                asked: format!("--generator {generator} for N = {total}"),
                limit: "a generator is 1 to N - 1".into(),
                remedy: format!("choose one of 1 to {most}, or drop --generator"),
            });
        }
        if common_divisor(generator, total) > 1 {
            return Err(Error::Arguments {
                asked: format!("--generator {generator} for N = {total}"),
                limit: "they have a common divisor, so that coordinates would repeat".into(),
                remedy: "choose a generator that is prime to N".into(),
            });
        }
        // A Korobov lattice has at most 2^32 - 1 points.
        return Ok((total as u32, generator));
    }
    if let Some(&(count, generator)) = KOROBOV.iter().find(|row| u64::from(row.0) == total) {
        return Ok((count, u64::from(generator)));
    }
    let below = KOROBOV.iter().rev().find(|row| u64::from(row.0) < total);
    let above = KOROBOV.iter().find(|row| u64::from(row.0) > total);
    let nearest = [below, above].into_iter().flatten();
    let whole = asked.whole_set(nearest.map(|row| u64::from(row.0)));
    let known: Vec<String> = KOROBOV.iter().map(|row| row.0.to_string()).collect();
    Err(Error::Arguments {
        asked: format!("korobov with N = {total} points"),
        limit: format!("generators are published for N = {}", known.join(", ")),
        remedy: whole.map_or_else(
            || "give --generator".into(),
            |whole| format!("{whole}, or give --generator"),
        ),
    })
}

fn common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { common_divisor(b, a % b) }
}
