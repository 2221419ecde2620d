//! A validated description of points to make.

use super::{Map, Profile, Sequence};
use crate::interface::Column;
use crate::tables::{LARGEST_PRIME, PRIMES, is_prime, nearest_prime};
use crate::{Error, Result};

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
    /// Hammersley: N; by default first + count.
    pub total: Option<u64>,
    /// Hammersley: k/N first instead of last.
    pub index_first: bool,
    /// Seed of randomisations. The sequences here have none and ignore it.
    pub seed: u64,
    /// Fractions of 2^32 as `u32` in place of floats.
    pub fractions: bool,
    /// A map to apply to each point.
    pub map: Option<&'static Map>,
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
            seed: 0,
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
    map: Option<&Map>,
    dimensions: u32,
    fractions: bool,
    with_pdf: bool,
) -> Result<()> {
    if let Some(map) = map
        && dimensions != Map::DIMENSIONS
    {
        return Err(Error::MapDimensions {
            map: map.name,
            needed: Map::DIMENSIONS,
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
    /// Seed, kept for the record.
    pub seed: u64,
    /// What the words are.
    pub output: Output,
    /// The map, if any.
    pub map: Option<&'static Map>,
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
        let columns = columns(options)?;
        check_map(
            options.map,
            columns.len() as u32,
            options.fractions,
            options.with_pdf,
        )?;
        Ok(Self {
            sequence: options.sequence,
            columns,
            first,
            count,
            seed: options.seed,
            output: if options.fractions {
                Output::Fractions
            } else {
                Output::Floats
            },
            map: options.map,
            with_pdf: options.with_pdf,
            profile: options.profile,
        })
    }

    /// Words of a result row.
    #[must_use]
    pub fn words_per_point(&self) -> u32 {
        match self.map {
            Some(map) => map.coordinates + u32::from(self.with_pdf),
            None => self.columns.len() as u32,
        }
    }
}

fn columns(options: &Options) -> Result<Vec<Column>> {
    let sequence = options.sequence;
    let grid = u64::from(sequence == Sequence::Hammersley);
    if grid == 0 && (options.index_first || options.total.is_some()) {
        return Err(Error::Arguments {
            asked: format!("--index-first or --total with {}", sequence.name()),
            limit: "only hammersley has the coordinate k/N".into(),
            remedy: "drop them, or use hammersley".into(),
        });
    }
    let given = options
        .bases
        .as_ref()
        .map(|bases| bases.len() as u64 + grid);
    if let (Some(given), Some(asked)) = (given, options.dimensions)
        && given != asked
    {
        return Err(Error::Arguments {
            asked: format!("--dims {asked} with bases for {given} dimensions"),
            limit: "each dimension has one base, but for k/N of hammersley".into(),
            remedy: "drop --dims, or give as many bases".into(),
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
            remedy: match sequence {
                Sequence::VanDerCorput => "use halton for more than one".into(),
                _ if dimensions == 0 => "ask for at least one".into(),
                _ => format!("the table of primes ends at {LARGEST_PRIME}; ask for fewer"),
            },
        });
    }
    let mut columns = match &options.bases {
        Some(bases) => checked(bases)?,
        None => PRIMES[..(dimensions - grid) as usize].to_vec(),
    }
    .into_iter()
    .map(|base| match base {
        2 => Column::Reversed,
        _ => Column::Radical(base),
    })
    .collect::<Vec<_>>();
    if grid == 1 {
        let end = options.first + options.count;
        let total = options.total.unwrap_or(end);
        if total < end || total > PERIOD {
            return Err(Error::Arguments {
                asked: format!("--total {total} with points up to {end}"),
                limit: format!("k/N needs k < N, and N at most 2^32 = {PERIOD}"),
                remedy: format!("use --total between {end} and {PERIOD}"),
            });
        }
        let at = if options.index_first {
            0
        } else {
            columns.len()
        };
        columns.insert(at, Column::Grid(total));
    }
    Ok(columns)
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
