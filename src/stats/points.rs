//! Points in the unit cube.

use super::refused;
use crate::error::Result;

/// What the coordinates were before they became `f64`, which holds each of them exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Fractions of 2^32.
    U32,
    /// IEEE single.
    F32,
    /// IEEE double.
    F64,
}

impl Source {
    /// `u32 / 2^32`, `f32` or `f64`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::U32 => "u32 / 2^32",
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }
}

/// At least one point of at least one coordinate, all of them in [0, 1).
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    columns: usize,
    values: Vec<f64>,
    source: Source,
}

impl Points {
    /// Points of `columns` coordinates, row after row.
    ///
    /// # Errors
    /// [`crate::Error::Arguments`] for no values, a last row that is not full, and for the
    /// first value that is not in [0, 1).
    pub fn new(columns: usize, values: Vec<f64>, source: Source) -> Result<Self> {
        if columns == 0 || values.is_empty() {
            return Err(refused(
                "no points",
                "measures take at least one point of one coordinate",
                "give at least one",
            ));
        }
        if !values.len().is_multiple_of(columns) {
            return Err(refused(
                format!("{} values as points of {columns} coordinates", values.len()),
                "the last point lacks some",
                "give whole points",
            ));
        }
        // A NaN is in no range.
        if let Some(at) = values.iter().position(|value| !(0.0..1.0).contains(value)) {
            let (row, column) = (at / columns, at % columns);
            let remedy = if values[at].is_finite() {
                "scale them; unsigned integers of 32 bits are taken as fractions of 2^32"
            } else {
                "replace what is not finite"
            };
            return Err(refused(
                format!("row {row}, column {column} is {}", values[at]),
                "coordinates must be in [0, 1)",
                remedy,
            ));
        }
        Ok(Self {
            columns,
            values,
            source,
        })
    }

    /// Number of points.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.values.len() / self.columns
    }

    /// Coordinates of a point.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// All coordinates, point after point.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// What they were made from.
    #[must_use]
    pub fn source(&self) -> Source {
        self.source
    }

    /// Point after point.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.values.chunks_exact(self.columns)
    }

    /// One coordinate of every point.
    ///
    /// # Errors
    /// [`crate::Error::Arguments`] for a dimension that the points do not have.
    pub fn column(&self, dimension: usize) -> Result<Vec<f64>> {
        self.check(dimension)?;
        Ok(self.iter().map(|point| point[dimension]).collect())
    }

    /// Two coordinates of every point: the projection to a pair of dimensions.
    ///
    /// # Errors
    /// [`crate::Error::Arguments`] for a dimension that the points do not have.
    pub fn pairs(&self, first: usize, second: usize) -> Result<Vec<[f64; 2]>> {
        self.check(first)?;
        self.check(second)?;
        let pair = |point: &[f64]| [point[first], point[second]];
        Ok(self.iter().map(pair).collect())
    }

    fn check(&self, dimension: usize) -> Result<()> {
        if dimension < self.columns {
            return Ok(());
        }
        Err(refused(
            format!("dimension {dimension}"),
            format!("the points have dimensions 0 to {}", self.columns - 1),
            "choose one of those",
        ))
    }
}
