//! How many points an error hangs on.
//!
//! The mean square of an error comes of the variance of the terms, and where few terms make
//! that, few points tell of it: replicates that met none look better than they are, all alike,
//! and so does the interval that is drawn from them.

use super::cell::{Cell, Point};
use super::student;
use super::truth::Truth;

/// With fewer effective hits of all replicates an interval is too narrow: bootstrap intervals
/// of 32 replicates hold the error in 8 of 10 studies at 10 to 50 hits, in 9 from 100 on.
pub(super) const ENOUGH: f64 = 100.0;

/// A single run has no interval. It is to be met by as many as each of 32 replicates then is.
pub(super) const ENOUGH_OF_ONE: f64 = ENOUGH / 32.0;

/// The share of studies in which a mean without bias is within Student's interval.
pub(super) const SURE: f64 = 0.9999;

/// What share of the points of an estimator an error hangs on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rarity {
    /// The share, 0 to 1: the reciprocal of the kurtosis of the terms, which is 1/p where a share
    /// p of the terms is alike and the others are 0.
    pub share: f64,
}

impl Rarity {
    /// Of an integrand with an estimator, by what samplers of independent points gave at their
    /// largest counts: the least share. `None` without any, since points of nets meet what there
    /// is more evenly than chance, and the spread of their variances tells of no hits.
    #[must_use]
    pub fn of<'a>(cells: impl Iterator<Item = &'a Cell>, truth: &Truth) -> Option<Self> {
        let shares = cells.filter_map(|cell| share(cell.points.last()?, truth));
        let share = shares.reduce(f64::min)?;
        Some(Self { share })
    }

    /// Effective hits of so many replicates of so many points: one of a sampler that is not
    /// random.
    #[must_use]
    pub fn hits(&self, count: u64, replicates: usize) -> f64 {
        self.share * count as f64 * replicates as f64
    }
}

/// Mean squares of terms about their mean, replicate by replicate, spread as numbers of hits do:
/// by one over the hits of a replicate. `None` of fewer than two replicates.
fn share(point: &Point, truth: &Truth) -> Option<f64> {
    let pairs = point.means.iter().zip(&point.variances);
    let finite = pairs.filter(|(mean, variance)| mean.is_finite() && variance.is_finite());
    let found: Vec<(f64, f64)> = finite.map(|(mean, variance)| (*mean, *variance)).collect();
    if found.len() < 2 {
        return None;
    }
    let n = found.len() as f64;
    let centre = found.iter().map(|(mean, _)| mean).sum::<f64>() / n;
    let squares = found
        .iter()
        .map(|(mean, variance)| variance + (mean - centre).powi(2));
    let squares: Vec<f64> = squares.collect();
    let level = squares.iter().sum::<f64>() / n;
    if !level.is_finite() {
        return None;
    }
    if level == 0.0 {
        // All terms are alike: right, or without a hit.
        let right = (centre - truth.value).abs() <= truth.floor();
        return Some(if right { 1.0 } else { 0.0 });
    }
    let spread = squares.iter().map(|one| (one / level - 1.0).powi(2));
    let spread = spread.sum::<f64>() / (n - 1.0);
    Some((1.0 / (spread * point.count as f64)).min(1.0))
}

/// Whether a mean of so many replicates, of this bias and standard error, is off beyond chance
/// and what is allowed: random samplers have no bias, so that what replicates agree on is an error
/// that none of them shows.
pub(super) fn missed(bias: f64, error: f64, replicates: usize, allowed: f64) -> bool {
    match replicates.checked_sub(1) {
        None | Some(0) => false,
        Some(degrees) => {
            let chance = student::two_sided(SURE, degrees as u32) * error;
            bias.abs() > chance + allowed
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::statistics::Statistic;
    use super::*;
    use crate::reference::random::random;
    use glam::UVec2;

    const REPLICATES: u32 = 32;
    const COUNT: u64 = 1 << 12;

    /// Replicates of terms that are 1/p with chance p and else 0, so that their mean is 1.
    fn point(p: f64, study: u32) -> Point {
        let limit = (p * 4_294_967_296.0) as u32;
        let mean = |r: u32| {
            let met = |i: u32| random(i, r, UVec2::new(study, 3)) < limit;
            (0..COUNT as u32).filter(|i| met(*i)).count() as f64 / COUNT as f64 / p
        };
        let means: Vec<f64> = (0..REPLICATES).map(mean).collect();
        let n = COUNT as f64;
        // Of m = p k/n: (k/p^2 - n m^2) / (n - 1).
        let variance = |m: &f64| (n * m / p - n * m * m) / (n - 1.0);
        Point {
            count: COUNT,
            variances: means.iter().map(variance).collect(),
            means,
            device_ns: vec![1.0],
            host_ns: vec![1.0],
        }
    }

    #[test]
    fn the_share_is_that_of_the_hits() {
        let truth = Truth::stated(1.0, 1e-9);
        for p in [1e-4, 1e-3, 1e-2] {
            let found = share(&point(p, 1), &truth).unwrap();
            // 32 replicates tell a spread to a quarter.
            assert!((0.4 * p..2.5 * p).contains(&found), "{p}: {found}");
        }
        let alike = |mean: f64| Point {
            means: vec![mean; 8],
            variances: vec![0.0; 8],
            ..point(0.5, 1)
        };
        assert_eq!(share(&alike(1.0), &truth), Some(1.0), "every term is right");
        assert_eq!(share(&alike(0.0), &truth), Some(0.0), "none was hit");
        let one = Point {
            means: vec![1.0],
            variances: vec![1.0],
            ..point(0.5, 1)
        };
        assert_eq!(share(&one, &truth), None);
    }

    /// What the limit is for: the error lies above the interval in 39 of 100 studies at 1 effective
    /// hit, in 26 at 10, in 9 at 400.
    #[test]
    fn intervals_of_few_hits_are_too_narrow() {
        let below = |hits: f64| {
            let p = hits / (f64::from(REPLICATES) * COUNT as f64);
            let error = ((1.0 - p) / p / COUNT as f64).sqrt();
            let short = |study: &u32| {
                let means = point(p, *study).means;
                let errors: Vec<f64> = means.iter().map(|mean| mean - 1.0).collect();
                Statistic::Rmse.interval(&errors).unwrap().high < error
            };
            (0..200).filter(short).count()
        };
        let found = [1.0, 0.1 * ENOUGH, 4.0 * ENOUGH].map(below);
        let [one, ten, many] = found;
        assert!(one > 55 && ten > 36 && many < 32, "{found:?} of 200");
    }
}
