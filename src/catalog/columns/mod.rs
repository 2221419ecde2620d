//! The columns of what is asked for, or why they cannot be.

mod lattice;
mod net;
mod radical;
mod strata;

use super::request::PERIOD;
use super::{Options, Order, Scramble, Sequence};
use crate::interface::{Column, Generator};
use crate::reference::hash::seed as derived_seed;
use crate::{Error, Result};
use glam::uvec2;

/// Columns, and what to warn of.
pub(super) struct Made {
    pub columns: Vec<Column>,
    pub scramble: Scramble,
    pub warnings: Vec<String>,
}

/// Options with what every sequence settles in the same way.
struct Asked<'a> {
    options: &'a Options,
    sequence: Sequence,
    scramble: Scramble,
    /// Columns; within what the sequence has.
    dimensions: u32,
    /// Index past the last point.
    end: u64,
    /// Points of the whole set.
    total: u64,
    seed: [u32; 2],
}

impl Asked<'_> {
    /// The seed of one word for a dimension.
    fn derived(&self, dimension: u32, purpose: u32) -> u32 {
        derived_seed(uvec2(self.seed[0], self.seed[1]), dimension, purpose)
    }

    fn per_dimension(&self, column: impl Fn(u32) -> Column) -> Vec<Column> {
        (0..self.dimensions).map(column).collect()
    }
}

/// Checks the options of a sequence and lists its columns.
pub(super) fn make(options: &Options) -> Result<Made> {
    let sequence = options.sequence;
    refuse_strangers(options)?;
    let scramble = scramble(options)?;
    let end = options.first + options.count;
    let total = options.total.unwrap_or(end);
    if total < end || total > PERIOD {
        return Err(Error::Arguments {
            asked: format!("--total {total} with points up to {end}"),
            limit: format!(
                "a set has more points than the last index, and at most 2^32 = {PERIOD}"
            ),
            remedy: format!("use --total between {end} and {PERIOD}"),
        });
    }
    let seed = options.seed.unwrap_or(0);
    let asked = Asked {
        options,
        sequence,
        scramble,
        dimensions: dimensions(options)?,
        end,
        total,
        seed: [seed as u32, (seed >> 32) as u32],
    };
    let mut warnings = Vec::new();
    let columns = match sequence {
        Sequence::VanDerCorput | Sequence::Halton | Sequence::Hammersley => {
            radical::columns(&asked, &mut warnings)?
        }
        Sequence::Sobol | Sequence::Pmj02 => net::columns(&asked),
        Sequence::Random => random(&asked, Generator::Philox),
        Sequence::RandomFast => random(&asked, Generator::Pcg4d),
        Sequence::Pcg32 => random(&asked, Generator::Pcg32),
        Sequence::Stratified | Sequence::LatinHypercube | Sequence::MultiJittered => {
            strata::columns(&asked, &mut warnings)?
        }
        Sequence::Lattice | Sequence::Korobov | Sequence::R2 => lattice::columns(&asked)?,
    };
    let random = sequence.scrambles().is_empty() || scramble.is_random();
    if options.seed.is_some() && !random {
        warnings.push(format!(
            "--seed changes nothing: {} is not randomised; add --scramble",
            sequence.name()
        ));
    }
    Ok(Made {
        columns,
        scramble,
        warnings,
    })
}

fn random(asked: &Asked, generator: Generator) -> Vec<Column> {
    asked.per_dimension(|dimension| Column::Random {
        generator,
        dimension,
        dimensions: asked.dimensions,
        seed: asked.seed,
    })
}

/// Refuses options of other sequences.
fn refuse_strangers(options: &Options) -> Result<()> {
    let sequence = options.sequence;
    let radical = matches!(
        sequence,
        Sequence::VanDerCorput | Sequence::Halton | Sequence::Hammersley
    );
    let gridded = matches!(sequence, Sequence::Stratified | Sequence::MultiJittered);
    let strangers = [
        (
            options.bases.is_some() && !radical,
            "--bases",
            "only vdc, halton and hammersley have bases",
        ),
        (
            options.index_first && sequence != Sequence::Hammersley,
            "--index-first",
            "only hammersley has the coordinate k/N",
        ),
        (
            options.total.is_some() && !sequence.is_set(),
            "--total",
            "only sets have a number of points of their own: hammersley, stratified, \
             latin-hypercube, cmj, korobov",
        ),
        (
            options.order == Order::Gray && sequence != Sequence::Sobol,
            "--order gray",
            "only sobol has an order by Gray code",
        ),
        (
            options.grid.is_some() && !gridded,
            "--grid",
            "only stratified and cmj have a grid",
        ),
        (
            options.generator.is_some() && sequence != Sequence::Korobov,
            "--generator",
            "only korobov has a generator",
        ),
    ];
    match strangers.into_iter().find(|(given, ..)| *given) {
        None => Ok(()),
        Some((_, name, limit)) => Err(Error::Arguments {
            asked: format!("{name} with {}", sequence.name()),
            limit: limit.into(),
            remedy: "drop it, or use another sequence".into(),
        }),
    }
}

fn scramble(options: &Options) -> Result<Scramble> {
    let sequence = options.sequence;
    let known = sequence.scrambles();
    match options.scramble {
        None => Ok(sequence.default_scramble(options.seed.is_some())),
        Some(scramble) if known.contains(&scramble) => Ok(scramble),
        Some(scramble) => {
            let names: Vec<&str> = known.iter().map(|s| s.name()).collect();
            let (limit, remedy) = if known.is_empty() {
                let limit = "its points are random already; --seed chooses them".to_owned();
                (limit, "drop --scramble".to_owned())
            } else {
                let limit = format!("{} has {}", sequence.name(), names.join(", "));
                (limit, "choose one of these, or another sequence".to_owned())
            };
            Err(Error::Arguments {
                asked: format!("--scramble {} with {}", scramble.name(), sequence.name()),
                limit,
                remedy,
            })
        }
    }
}

/// Columns, from --dims, --bases and --grid, which must agree.
fn dimensions(options: &Options) -> Result<u32> {
    let sequence = options.sequence;
    let grid = u64::from(sequence == Sequence::Hammersley);
    let bases = options.bases.as_ref().map(|list| list.len() as u64 + grid);
    let cells = options.grid.as_ref().map(|list| list.len() as u64);
    let given = bases.or(cells);
    if let (Some(given), Some(asked)) = (given, options.dimensions)
        && given != asked
    {
        let (what, limit) = if bases.is_some() {
            (
                "bases",
                "each dimension has one base, but for k/N of hammersley",
            )
        } else {
            ("a grid", "a grid has one number of cells per dimension")
        };
        return Err(Error::Arguments {
            asked: format!("--dims {asked} with {what} for {given} dimensions"),
            limit: limit.into(),
            remedy: "drop --dims, or give as many".into(),
        });
    }
    let default = u64::from(sequence.default_dimensions());
    let dimensions = given.or(options.dimensions).unwrap_or(default);
    let (least, limit) = sequence.dimensions();
    if dimensions < u64::from(least) || dimensions > u64::from(limit) {
        return Err(Error::Dimensions {
            sequence: sequence.name(),
            asked: dimensions,
            least,
            limit,
            remedy: remedy(sequence, dimensions, limit),
        });
    }
    // Within the limit, a u32.
    Ok(dimensions as u32)
}

fn remedy(sequence: Sequence, dimensions: u64, limit: u32) -> String {
    match sequence {
        _ if dimensions == 0 => "ask for at least one".into(),
        Sequence::VanDerCorput => "use halton for more than one".into(),
        Sequence::MultiJittered => "use latin-hypercube or stratified for others".into(),
        Sequence::Pmj02 => "use sobol with --scramble owen for others".into(),
        Sequence::Halton | Sequence::Hammersley => format!(
            "the table of primes ends at {}; ask for fewer",
            crate::tables::LARGEST_PRIME
        ),
        Sequence::Sobol => "the table of direction numbers ends there; ask for fewer".into(),
        Sequence::Lattice => "the generating vector ends there; ask for fewer".into(),
        _ => format!("ask for at most {limit}"),
    }
}
