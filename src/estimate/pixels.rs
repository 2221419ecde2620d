//! Estimates of the pixels of a picture.

use super::Estimate;
use crate::{Error, Result};

/// An estimate for each pixel, row by row from the upper left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    width: u32,
    estimates: Vec<Estimate>,
}

impl Pixels {
    /// Rows of so many pixels.
    ///
    /// # Errors
    /// [`Error::Arguments`] for rows that are not whole.
    pub fn new(width: u32, estimates: Vec<Estimate>) -> Result<Self> {
        if width == 0 || !estimates.len().is_multiple_of(width as usize) {
            return Err(Error::Arguments {
                asked: format!("{} estimates in rows of {width} pixels", estimates.len()),
                limit: "a picture has whole rows".into(),
                remedy: "give an estimate for each pixel".into(),
            });
        }
        Ok(Self { width, estimates })
    }

    /// Both together, pixel by pixel: of other points of the same picture, in any order.
    ///
    /// # Errors
    /// [`Error::Arguments`] for pictures of different sizes, and as [`Estimate::merged`].
    pub fn merged(self, other: &Self) -> Result<Self> {
        if self.size() != other.size() {
            let [[a, b], [c, d]] = [self.size(), other.size()];
            return Err(Error::Arguments {
                asked: format!("a picture of {a} x {b} pixels and one of {c} x {d}"),
                limit: "only pictures of one size merge".into(),
                remedy: "estimate both in one size".into(),
            });
        }
        let width = self.width;
        let pairs = self.estimates.into_iter().zip(&other.estimates);
        let estimates = pairs.map(|(a, b)| a.merged(*b)).collect::<Result<_>>()?;
        Ok(Self { width, estimates })
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.estimates.len() as u32 / self.width]
    }

    /// All of them.
    #[must_use]
    pub fn estimates(&self) -> &[Estimate] {
        &self.estimates
    }

    /// Mean, sample variance and number of terms of each pixel; NaN where there is none.
    pub fn moments(&self) -> impl Iterator<Item = [f64; 3]> {
        self.estimates.iter().map(|one| {
            let [mean, variance] = [one.mean(), one.variance()].map(|x| x.unwrap_or(f64::NAN));
            [mean, variance, one.count() as f64]
        })
    }
}
