//! A validated description of points to make.

use super::columns::{self, Made};
use super::{Mapping, Order, Profile, Scramble, Sequence};
use crate::interface::Column;
use crate::{Error, Result};
use std::ops::Range;

/// Length of every sequence.
const PERIOD: u64 = 1 << 32;

/// What is asked for, unchecked; [`Request::new`] checks it.
#[derive(Clone, Debug)]
pub struct Options {
    /// The sequence.
    pub sequence: Sequence,
    /// Points to make.
    pub count: u64,
    /// Index of the first point.
    pub first: u64,
    /// Columns; by default the number of bases, or the sequence's default.
    pub dimensions: Option<u64>,
    /// Bases in place of the first primes.
    pub bases: Option<Vec<u64>>,
    /// Points of the whole set, of which the request may be a part; by default first +
    /// count. Only sets have it: Hammersley's N, strata, Korobov lattices.
    pub total: Option<u64>,
    /// Hammersley: k/N first instead of last.
    pub index_first: bool,
    /// Seed of randomisations; 0 by default.
    pub seed: Option<u64>,
    /// How to randomise the sequence; by default as
    /// [`Sequence::default_scramble`] says.
    pub scramble: Option<Scramble>,
    /// Sobol: the order.
    pub order: Order,
    /// Strata: cells along each axis, in place of factors of the total.
    pub grid: Option<Vec<u64>>,
    /// Korobov: the generator, in place of that of the table.
    pub generator: Option<u64>,
    /// Fractions of 2^32 as `u32` in place of floats.
    pub fractions: bool,
    /// A map to apply to each point.
    pub map: Option<Mapping>,
    /// Append the map's pdf.
    pub with_pdf: bool,
    /// Whose functions the map uses.
    pub profile: Profile,
}

impl Options {
    /// `count` points of a sequence, everything else by default.
    #[must_use]
    pub fn new(sequence: Sequence, count: u64) -> Self {
        Self {
            sequence,
            count,
            first: 0,
            dimensions: None,
            bases: None,
            total: None,
            index_first: false,
            seed: None,
            scramble: None,
            order: Order::Natural,
            grid: None,
            generator: None,
            fractions: false,
            map: None,
            with_pdf: false,
            profile: Profile::Exact,
        }
    }
}

/// What a result word is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// `u32` fractions of 2^32.
    Fractions,
    /// `f32`, as bits.
    Floats,
}

/// Checks that points of so many dimensions can be mapped and written as asked.
///
/// # Errors
/// A refusal that says what was asked, what the limit is and what to do.
pub fn check_map(
    map: Option<&Mapping>,
    dimensions: u32,
    fractions: bool,
    with_pdf: bool,
) -> Result<()> {
    if let Some(map) = map.map(Mapping::map)
        && dimensions != map.dimensions
    {
        return Err(Error::MapDimensions {
            map: map.name,
            needed: map.dimensions,
            given: dimensions,
        });
    }
    if map.is_some() && fractions {
        return Err(Error::Arguments {
            asked: "--fractions with --map".into(),
            limit: "a map's results are floats; only points have fractions".into(),
            remedy: "drop one of the two".into(),
        });
    }
    if with_pdf && map.is_none() {
        return Err(Error::Arguments {
            asked: "--with-pdf without --map".into(),
            limit: "only maps have a pdf; that of the points is 1".into(),
            remedy: "add --map NAME".into(),
        });
    }
    Ok(())
}

/// Points to make, as [`Request::new`] checks them. Whoever changes a member answers for
/// the combination.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Request {
    /// The sequence.
    pub sequence: Sequence,
    /// Its columns.
    pub columns: Vec<Column>,
    /// Index of the first point.
    pub first: u64,
    /// Number of points; first + count <= 2^32.
    pub count: u64,
    /// How the sequence is randomised.
    pub scramble: Scramble,
    /// Seed.
    pub seed: u64,
    /// What may disappoint although it is right, a sentence each.
    pub warnings: Vec<String>,
    /// What the words are.
    pub output: Output,
    /// The map, if any.
    pub map: Option<Mapping>,
    /// Whether the pdf follows the coordinates.
    pub with_pdf: bool,
    /// Whose functions the map uses.
    pub profile: Profile,
}

/// Something that makes the points of a request.
pub trait Engine {
    /// Hands the words of `count` points from the request's point `start` on to `take`,
    /// row after row, in one or several pieces. `start` counts from the request's first.
    ///
    /// # Errors
    /// Those of the device, and those of `take`.
    fn make(
        &mut self,
        start: u64,
        count: u64,
        take: &mut dyn FnMut(&[u32]) -> Result<()>,
    ) -> Result<()>;

    /// A good number of points for the next call: small enough for short waits.
    fn chunk(&self) -> u64;

    /// [`Engine::make`] for a range of points, by calls of [`Engine::chunk`] points.
    ///
    /// # Errors
    /// As there.
    fn make_range(
        &mut self,
        points: Range<u64>,
        take: &mut dyn FnMut(&[u32]) -> Result<()>,
    ) -> Result<()> {
        let mut done = points.start;
        while done < points.end {
            let count = self.chunk().clamp(1, points.end - done);
            self.make(done, count, take)?;
            done += count;
        }
        Ok(())
    }
}

impl Request {
    /// Checks options.
    ///
    /// # Errors
    /// A refusal that says what was asked, what the limit is and what to do.
    pub fn new(options: &Options) -> Result<Self> {
        let Options { first, count, .. } = *options;
        if count == 0 {
            return Err(Error::ZeroCount { what: "--count" });
        }
        if first.checked_add(count).is_none_or(|end| end > PERIOD) {
            return Err(Error::IndexRange { first, count });
        }
        let Made {
            columns,
            scramble,
            warnings,
        } = columns::make(options)?;
        check_map(
            options.map.as_ref(),
            columns.len() as u32,
            options.fractions,
            options.with_pdf,
        )?;
        Ok(Self {
            sequence: options.sequence,
            columns,
            first,
            count,
            scramble,
            seed: options.seed.unwrap_or(0),
            warnings,
            output: if options.fractions {
                Output::Fractions
            } else {
                Output::Floats
            },
            map: options.map.clone(),
            with_pdf: options.with_pdf,
            profile: options.profile,
        })
    }

    /// Words of a result row.
    #[must_use]
    pub fn words_per_point(&self) -> u32 {
        match &self.map {
            Some(mapping) => mapping.map().coordinates + u32::from(self.with_pdf),
            None => self.columns.len() as u32,
        }
    }
}
