//! A sampler on an integrand, with what it comes to.

use super::analysis::Analysis;
use super::cell::Cell;
use super::hits::Rarity;
use super::item::Measured;
use super::statistics::Statistic;
use super::study::Row;
use super::truth::Truth;
use crate::catalog::Sampler;

/// A cell with its name and what it comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// The integrand, with its parameters, as it was named.
    pub integrand: String,
    /// What it is, in a line.
    pub summary: &'static str,
    /// Its estimator, where it has a choice.
    pub estimator: Option<&'static str>,
    /// Its dimensions.
    pub dimensions: u32,
    /// The sampler.
    pub sampler: String,
    /// The device that measured it, with its driver.
    pub device: String,
    /// What its means are compared with.
    pub truth: Truth,
    /// Means and times.
    pub cell: Cell,
    /// What they come to.
    pub analysis: Analysis,
}

impl Series {
    /// Of a cell; `rarity` is that of the row.
    pub(super) fn new(
        row: &Row,
        sampler: Sampler,
        truth: Truth,
        Measured { device, cell, .. }: Measured,
        rarity: Option<Rarity>,
    ) -> Self {
        let statistic = match row.problem.integrand().finite_variance {
            true => Statistic::Rmse,
            false => Statistic::MedianAbsolute,
        };
        Self {
            integrand: row.name.clone(),
            summary: row.problem.integrand().summary,
            estimator: row.problem.estimator(),
            dimensions: row.problem.dimensions(),
            sampler: sampler.name(),
            device,
            analysis: Analysis::new(&cell, &truth, sampler.is_random(), statistic, rarity),
            truth,
            cell,
        }
    }

    /// The sampler, and the estimator where there is a choice.
    #[must_use]
    pub fn label(&self) -> String {
        match self.estimator {
            None => self.sampler.clone(),
            Some(estimator) => format!("{}, {estimator}", self.sampler),
        }
    }

    /// What errors are relative to: |truth|, or 1 where it is 0.
    #[must_use]
    pub fn scale(&self) -> f64 {
        match self.truth.value.abs() {
            0.0 => 1.0,
            scale => scale,
        }
    }
}
