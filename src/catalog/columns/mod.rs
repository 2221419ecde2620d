//! The columns of what is asked for, or why they cannot be.

mod lattice;
mod net;
mod radical;
mod strata;

use super::{Options, Order, SEQUENCES, Scramble, Sequence};
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
    /// Options that ask for a whole set of one of these numbers of points, where that can
    /// hold the points asked for.
    fn whole_set(&self, totals: impl IntoIterator<Item = u64>) -> Option<String> {
        let whole = self.options.first == 0 && self.options.total.is_none();
        let option = if whole { "--count" } else { "--total" };
        let fit = totals
            .into_iter()
            .filter(|total| *total >= 1 && (whole || *total >= self.end));
        let fit: Vec<String> = fit.map(|total| total.to_string()).collect();
        match fit[..] {
            [] => None,
            _ => Some(format!("use {option} {}", alternatives(&fit))),
        }
    }

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
    let most = sequence.most_points();
    if total > most && options.total.is_none() {
        return Err(Error::Arguments {
            asked: format!("{} of {total} points", sequence.name()),
            limit: format!("the set has at most {most}"),
            remedy: "ask for fewer, or use sobol".into(),
        });
    }
    if total < end || total > most {
        return Err(Error::Arguments {
            asked: format!("--total {total} with points up to {end}"),
            limit: format!("a set has more points than the last index, and at most {most}"),
            remedy: format!("use --total between {end} and {most}"),
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
        warnings.push(idle_seed(sequence));
    }
    Ok(Made {
        columns,
        scramble,
        warnings,
    })
}

fn idle_seed(sequence: Sequence) -> String {
    let scrambles = sequence.scrambles().iter();
    let random = scrambles.filter(|scramble| scramble.is_random());
    let names: Vec<&str> = random.map(|scramble| scramble.name()).collect();
    let remedy = match names[..] {
        [] => "drop it".to_owned(),
        _ => format!("add --scramble {}", alternatives(&names)),
    };
    format!(
        "--seed changes nothing, as these points of {} are not random; {remedy}",
        sequence.name()
    )
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
    let given = [
        ("--bases", options.bases.is_some()),
        ("--index-first", options.index_first),
        ("--total", options.total.is_some()),
        ("--order gray", options.order == Order::Gray),
        ("--grid", options.grid.is_some()),
        ("--generator", options.generator.is_some()),
    ];
    let stranger = given
        .into_iter()
        .find(|(name, given)| *given && !sequence.options().contains(name));
    let Some((name, _)) = stranger else {
        return Ok(());
    };
    let takers = SEQUENCES
        .iter()
        .filter(|sequence| sequence.options().contains(&name));
    let takers: Vec<&str> = takers.map(|sequence| sequence.name()).collect();
    Err(Error::Arguments {
        asked: format!("{name} with {}", sequence.name()),
        limit: format!("{} has no such option", sequence.name()),
        remedy: format!("drop it, or use {}", alternatives(&takers)),
    })
}

/// "a, b or c".
fn alternatives(names: &[impl AsRef<str>]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, others)) => format!("{} or {last}", others.join(", ")),
        None => String::new(),
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
