//! A column by blocks of consecutive indices: what a block shares is found once, the rest is
//! a table, and what is left is a loop that the compiler vectorises. The words are those of
//! [`Prepared`], which says what they are.

#[cfg(test)]
mod broken;
mod counter;
mod digits;
mod linear;
mod net;
mod philox;
mod runs;
mod tile;

pub use net::Net;
pub use philox::Philox;

use super::column::{Prepared, Rounding};
use crate::catalog::Output;
use crate::interface::{Column, DigitScramble, Generator};
use counter::Counter;
use linear::Linear;
use tile::Tile;

/// A column with the tables of its blocks.
#[derive(Clone, Debug)]
pub struct Blocks {
    form: Form,
    finish: Finish,
}

/// How values of consecutive indices are made.
#[derive(Clone, Debug)]
enum Form {
    Linear(Box<Linear>),
    Tile(Box<Tile>),
    Counter(Counter),
    /// Each by itself.
    Single(Prepared),
}

/// What becomes of a fraction.
#[derive(Clone, Copy, Debug)]
pub enum Finish {
    Fraction,
    Float(Rounding),
}

impl Finish {
    /// That of a column.
    pub fn of(column: &Prepared, output: Output) -> Self {
        match output {
            Output::Fractions => Self::Fraction,
            Output::Floats => Self::Float(column.rounding()),
        }
    }
}

/// Evaluates an expression with the finish as a closure, so that each has loops of its own.
macro_rules! finished {
    ($finish:expr, |$f:ident| $call:expr) => {{
        use $crate::bulk::column::Rounding;
        use $crate::reference::{stratified, unit};
        // As `unit_ceil`, with its minimum of floats, which SSE2 has.
        const BELOW_ONE: f32 = 1.0 - 0.5 * f32::EPSILON;
        match $finish {
            Finish::Fraction => {
                let $f = |u: u32| u;
                $call
            }
            Finish::Float(Rounding::Down) => {
                let $f = |u: u32| unit::unit_floor(u).to_bits();
                $call
            }
            Finish::Float(Rounding::Up) => {
                let $f = |u: u32| {
                    let k = (u >> 8) + u32::from(u & 0xff != 0);
                    let x = k as f32 * (0.5 * f32::EPSILON);
                    (if x < BELOW_ONE { x } else { BELOW_ONE }).to_bits()
                };
                $call
            }
            Finish::Float(Rounding::Within(strata)) => {
                let $f = move |u: u32| stratified::unit_stratum(u, strata).to_bits();
                $call
            }
        }
    }};
}
use finished;

impl Blocks {
    /// Prepares a column for about `count` values, of a point of `width` columns: tables are
    /// made where they are worth it.
    pub fn new(column: &Column, count: u64, width: usize, finish: Finish) -> Self {
        Self {
            form: form(column, count, width),
            finish,
        }
    }

    /// Writes the words of consecutive indices from n on, which do not go past 2^32.
    #[inline(always)]
    pub fn fill(&self, n: u64, words: &mut [u32]) {
        finished!(self.finish, |finish| match &self.form {
            Form::Linear(linear) => linear.fill(n, words, finish),
            Form::Tile(tile) => tile.fill(n, words, finish),
            Form::Counter(counter) => counter.fill(n, words, finish),
            Form::Single(column) => {
                for (n, word) in (n..).zip(words) {
                    *word = finish(column.fraction(n as u32));
                }
            }
        })
    }
}

fn form(column: &Column, count: u64, width: usize) -> Form {
    let linear = |linear| Form::Linear(Box::new(linear));
    let tile = match *column {
        Column::Reversed => return linear(Linear::reversed(width)),
        Column::Lattice { z, shift } => return linear(Linear::lattice(z, shift, width)),
        Column::Sobol {
            dimension,
            gray,
            scramble,
            seed,
        } => return linear(Linear::sobol(dimension, gray, scramble, seed, width)),
        Column::Radical(base) => digits::plain(base, count),
        Column::Digits {
            base,
            scramble,
            seed,
        } => match scramble {
            DigitScramble::Faure => digits::faure(base, count),
            DigitScramble::Permuted => digits::permuted(base, seed, count),
            DigitScramble::Started => digits::started(base, seed, count),
            // A digit's permutation depends on all below it.
            DigitScramble::Owen => None,
        },
        Column::Grid(total) => Tile::grid(1, total, 0, count),
        Column::Korobov {
            z,
            count: total,
            shift,
        } => Tile::grid(z, written(total), shift.unwrap_or(0), count),
        Column::Additive { alpha, shift } => {
            return Form::Counter(Counter::Additive { alpha, shift });
        }
        Column::Random {
            generator: Generator::Pcg4d,
            dimension,
            seed,
            ..
        } => return Form::Counter(Counter::Pcg4d { dimension, seed }),
        Column::Random {
            generator: Generator::Pcg32,
            dimension,
            dimensions,
            seed,
        } => return Form::Counter(Counter::pcg32(dimension, dimensions, seed)),
        _ => None,
    };
    tile.map_or_else(
        || Form::Single(Prepared::new(column)),
        |tile| Form::Tile(Box::new(tile)),
    )
}

/// A count of which 2^32 is written as 0.
fn written(count: u32) -> u64 {
    match count {
        0 => 1 << 32,
        count => u64::from(count),
    }
}
