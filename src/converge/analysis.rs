//! What a cell's means and times come to: errors with intervals, a slope, times to errors.

mod reached;

pub use reached::Reached;

use super::cell::{Cell, Point};
use super::counts::SlopeCounts;
use super::hits::{ENOUGH, ENOUGH_OF_ONE, Rarity, missed};
use super::statistics::{Interval, Statistic, fit, median, quantile, slope};
use super::truth::Truth;

/// Errors below so many floors say nothing of the sampler.
pub(super) const ABOVE_FLOOR: f64 = 10.0;

/// Counts from which on a slope is fitted: below, the first digits of a sequence decide.
pub(super) const SLOPE_FROM: u64 = 64;

/// A cell in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysis {
    /// How replicates come to one error.
    pub statistic: Statistic,
    /// Whether the sampler is random; if not, errors have no interval.
    pub random: bool,
    /// By count, rising.
    pub errors: Vec<ErrorAt>,
    /// The slope over the counts from 64 on whose hits are not few, and whose errors are
    /// above ten floors; its ends are those of the value where the sampler is not random.
    pub slope: Option<Interval>,
    /// Whether `slope` has an interval.
    pub slope_has_interval: bool,
    /// Which counts it is of.
    pub slope_counts: SlopeCounts,
    /// Means that are not finite.
    pub not_finite: u64,
}

/// The error at a count, in the integrand's unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorAt {
    /// Points.
    pub count: u64,
    /// The error, with its interval; both ends are the value where the sampler is not random.
    pub error: Interval,
    /// The mean over the replicates, less the truth.
    pub bias: f64,
    /// The standard error of that; 0 of one replicate.
    pub bias_error: f64,
    /// Time of a replicate on the device in seconds: the median, and the quartiles.
    pub seconds: Interval,
    /// The same with the host's work, the median.
    pub host_seconds: f64,
    /// Whether it is above ten floors.
    pub above_floor: bool,
    /// Points of all replicates on which the error hangs; `None` where that is not known.
    pub hits: Option<f64>,
    /// Fewer are few: 100, and 100/32 of a single run.
    pub enough: f64,
    /// Whether the mean over the replicates is off by more than they differ: all missed the same.
    pub missed: bool,
}

impl ErrorAt {
    /// Whether so few points speak for the error that its interval is too narrow.
    #[must_use]
    pub fn few_hits(&self) -> bool {
        self.missed || self.hits.is_some_and(|hits| hits < self.enough)
    }
}

impl Analysis {
    /// Of a cell; `rarity` is that of its integrand and estimator, if it is known. A median does
    /// not hang on rare terms, and heeds none.
    #[must_use]
    pub fn new(
        cell: &Cell,
        truth: &Truth,
        random: bool,
        statistic: Statistic,
        rarity: Option<Rarity>,
    ) -> Self {
        let rarity = rarity.filter(|_| statistic == Statistic::Rmse);
        let errors: Vec<Vec<f64>> = cell
            .points
            .iter()
            .map(|point| {
                finite(&point.means)
                    .map(|mean| mean - truth.value)
                    .collect()
            })
            .collect();
        let at: Vec<ErrorAt> = cell
            .points
            .iter()
            .zip(&errors)
            .map(|(point, errors)| {
                let at = error_at(point, errors, truth, statistic);
                ErrorAt {
                    hits: rarity.map(|rarity| rarity.hits(point.count, errors.len())),
                    enough: if random { ENOUGH } else { ENOUGH_OF_ONE },
                    missed: statistic == Statistic::Rmse
                        && missed(
                            at.bias,
                            at.bias_error,
                            errors.len(),
                            ABOVE_FLOOR * truth.floor(),
                        ),
                    ..at
                }
            })
            .collect();
        let fitted = |one: &ErrorAt| one.above_floor && one.count >= SLOPE_FROM && !one.few_hits();
        let counts: Vec<u64> = at
            .iter()
            .filter(|one| fitted(one))
            .map(|one| one.count)
            .collect();
        let kept: Vec<&[f64]> = at
            .iter()
            .zip(&errors)
            .filter(|(one, _)| fitted(one))
            .map(|(_, errors)| errors.as_slice())
            .collect();
        let bare = || {
            let values = kept.iter().map(|errors| statistic.of(errors));
            fit(&counts, values).map(exact)
        };
        let with_interval = slope(&counts, &kept, statistic).filter(|_| random);
        Self {
            statistic,
            random,
            slope_counts: SlopeCounts::of(&at),
            errors: at,
            slope: with_interval.or_else(bare),
            slope_has_interval: with_interval.is_some(),
            not_finite: cell.points.iter().map(not_finite).sum(),
        }
    }

    /// Whether an error at a number of points has too few hits: by the measured count that is the
    /// nearest above.
    #[must_use]
    pub fn few_hits_at(&self, count: f64) -> bool {
        let above = self.errors.iter().find(|one| one.count as f64 >= count);
        above.is_some_and(ErrorAt::few_hits)
    }
}

fn error_at(point: &Point, errors: &[f64], truth: &Truth, statistic: Statistic) -> ErrorAt {
    let n = errors.len() as f64;
    let bias = errors.iter().sum::<f64>() / n;
    let spread: f64 = errors.iter().map(|error| (error - bias).powi(2)).sum();
    let error = statistic
        .interval(errors)
        .unwrap_or_else(|| exact(statistic.of(errors)));
    ErrorAt {
        count: point.count,
        error,
        bias,
        bias_error: if n > 1.0 {
            (spread / (n - 1.0) / n).sqrt()
        } else {
            0.0
        },
        seconds: Interval {
            value: 1e-9 * median(point.device_ns.clone()),
            low: 1e-9 * quantile(point.device_ns.clone(), 0.25),
            high: 1e-9 * quantile(point.device_ns.clone(), 0.75),
        },
        host_seconds: 1e-9 * median(point.host_ns.clone()),
        above_floor: error.value > ABOVE_FLOOR * truth.floor(),
        hits: None,
        enough: ENOUGH,
        missed: false,
    }
}

fn exact(value: f64) -> Interval {
    Interval {
        value,
        low: value,
        high: value,
    }
}

fn finite(means: &[f64]) -> impl Iterator<Item = f64> {
    means.iter().copied().filter(|mean| mean.is_finite())
}

fn not_finite(point: &Point) -> u64 {
    (point.means.len() - finite(&point.means).count()) as u64
}

#[cfg(test)]
mod tests;
