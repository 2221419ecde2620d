//! The CPU's twin of the kernels over pairs of points, and what their sums mean.

use crate::Result;
use crate::interface::pair_kind;
use crate::reference::discrepancy as factors;
use crate::reference::distance::{add_square, apart, apart_toroidal, less96};
use crate::reference::fixed::shl64;
use crate::stats::{L2, L2Value, Nearest, Points, Source, l2_from_pairs};
use glam::{UVec2, UVec3, uvec2};

/// Points as fractions of 2^32, one column of coordinates after the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Columns {
    words: Vec<u32>,
    count: u32,
    dimensions: u32,
    exact: bool,
}

/// A nearest pair: the squared distance in units of 2^-64 (x low), and its rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NearestWords {
    /// Squared distance.
    pub square: UVec3,
    /// The two points, the lower first.
    pub rows: [u32; 2],
}

impl NearestWords {
    /// Whether this pair comes before another: by distance, then by rows.
    #[must_use]
    pub fn before(&self, other: &Self) -> bool {
        less96(self.square, other.square) || (self.square == other.square && self.rows < other.rows)
    }

    /// Puts a pair in the place of `best` if it comes before.
    pub fn keep(best: &mut Option<Self>, row: u32, square: [u32; 3], other: u32) {
        let found = Self {
            square: UVec3::from_array(square),
            rows: [row, other],
        };
        if best.is_none_or(|best| found.before(&best)) {
            *best = Some(found);
        }
    }

    /// The distance, rounded, and the rows.
    #[must_use]
    pub fn nearest(&self) -> Nearest {
        let UVec3 { x, y, z } = self.square;
        let square = u128::from(x) | u128::from(y) << 32 | u128::from(z) << 64;
        Nearest {
            distance: (square as f64).sqrt() / 4_294_967_296.0,
            rows: self.rows.map(|row| row as usize),
        }
    }
}

/// Coordinates of a point at most: products keep 32 bits below the binary point.
pub const MAX_PAIR_DIMENSIONS: usize = 30;

impl Columns {
    /// Points, rounded down to multiples of 2^-32 where they are none.
    ///
    /// # Errors
    /// [`crate::Error::Arguments`] for more than 30 coordinates, or 2^32 points or more.
    pub fn new(points: &Points) -> Result<Self> {
        let count = u32::try_from(points.rows()).ok();
        let Some(count) = count.filter(|_| points.columns() <= MAX_PAIR_DIMENSIONS) else {
            return Err(crate::Error::Arguments {
                asked: format!("{} x {} points", points.rows(), points.columns()),
                limit: format!(
                    "sums in integers take fewer than 2^32 points of up to {MAX_PAIR_DIMENSIONS} \
                     dimensions"
                ),
                remedy: "use `--device cpu`, which sums in floating point".into(),
            });
        };
        let scaled = |x: f64| x * 4_294_967_296.0;
        let column = |k: usize| points.iter().map(move |point| scaled(point[k]) as u32);
        Ok(Self {
            words: (0..points.columns()).flat_map(column).collect(),
            count,
            dimensions: points.columns() as u32,
            exact: points.values().iter().all(|x| scaled(*x).fract() == 0.0),
        })
    }

    /// All words.
    #[must_use]
    pub fn words(&self) -> &[u32] {
        &self.words
    }

    /// Number of points.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Coordinates of a point.
    #[must_use]
    pub fn dimensions(&self) -> u32 {
        self.dimensions
    }

    /// Whether every coordinate was a multiple of 2^-32.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.exact
    }

    fn word(&self, k: u32, row: u32) -> u32 {
        self.words[k as usize * self.count as usize + row as usize]
    }

    /// The points that the words stand for.
    fn points(&self) -> Result<Points> {
        let value = |row: u32, k: u32| f64::from(self.word(k, row)) / 4_294_967_296.0;
        let rows = (0..self.count).flat_map(|row| (0..self.dimensions).map(move |k| (row, k)));
        let values = rows.map(|(row, k)| value(row, k)).collect();
        Points::new(self.dimensions as usize, values, Source::U32)
    }
}

/// The value of `KIND` for a discrepancy, the largest value of its kernel, and how many
/// units a factor may be off.
fn constants(kind: L2) -> (u32, f64, f64) {
    match kind {
        L2::Star => (pair_kind::STAR, 1.0, 1.0),
        L2::Centred => (pair_kind::CENTRED, 1.5, 1.0),
        L2::WrapAround => (pair_kind::WRAP_AROUND, 1.5, 3.0),
        L2::Mixture => (pair_kind::MIXTURE, 1.875, 7.0),
        L2::Modified => (pair_kind::MODIFIED, 2.0, 1.0),
    }
}

/// The value of `KIND` for a discrepancy.
#[must_use]
pub fn pair_kind_of(kind: L2) -> u32 {
    constants(kind).0
}

/// The scale of products in so many dimensions: the largest stays below 2^62.
#[must_use]
pub fn pair_scale(kind: L2, dimensions: u32) -> u32 {
    let bits = f64::from(dimensions) * constants(kind).1.log2();
    62 - bits.ceil() as u32
}

/// The sum of the products over all pairs, in units of 2^-scale.
#[must_use]
pub fn pair_sum(kind: L2, columns: &Columns, scale: u32) -> u128 {
    let factor: fn(UVec2, u32, u32) -> UVec2 = match kind {
        L2::Star => factors::star_factor,
        L2::Centred => factors::centred_factor,
        L2::WrapAround => factors::wrap_around_factor,
        L2::Mixture => factors::mixture_factor,
        L2::Modified => factors::modified_factor,
    };
    let mut sum = 0;
    for row in 0..columns.count {
        for other in row + 1..columns.count {
            let mut p = shl64(uvec2(1, 0), scale);
            for k in 0..columns.dimensions {
                p = factor(p, columns.word(k, row), columns.word(k, other));
            }
            sum += u128::from(p.x) | u128::from(p.y) << 32;
        }
    }
    sum
}

/// The discrepancy from that sum. Its error bound adds what products in fixed point lose
/// to that of the rest; it is the discrepancy of the points as their words have them.
///
/// # Errors
/// None that the words of points could cause.
pub fn l2_from_sum(kind: L2, columns: &Columns, sum: u128, scale: u32) -> Result<L2Value> {
    let (_, most, units) = constants(kind);
    let unit = f64::powi(0.5, scale as i32);
    let dimensions = columns.dimensions as i32;
    // A factor's loss grows by the factors after it.
    let lost = units * f64::from(dimensions) * most.powi(dimensions - 1) * unit;
    let points = columns.points()?;
    Ok(l2_from_pairs(&points, kind, sum as f64 * unit, lost))
}

/// The nearest pair; `None` for a single point.
#[must_use]
pub fn nearest_words(columns: &Columns, toroidal: bool) -> Option<NearestWords> {
    let distance = if toroidal { apart_toroidal } else { apart };
    let mut best = None;
    for row in 0..columns.count {
        for other in row + 1..columns.count {
            let mut square = UVec3::ZERO;
            for k in 0..columns.dimensions {
                let d = distance(columns.word(k, row), columns.word(k, other));
                square = add_square(square, d);
            }
            NearestWords::keep(&mut best, row, square.to_array(), other);
        }
    }
    best
}
