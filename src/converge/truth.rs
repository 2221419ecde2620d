//! What the means of an integrand are compared with.

use super::cell::{Cell, Engine};
use super::floor::floor;
use super::student;
use super::study::{Row, Settings, Study};
use crate::Result;
use crate::catalog::{Sampler, Scramble, Sequence};

/// The integral, and how far it can be trusted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Truth {
    /// The integral.
    pub value: f64,
    /// What the arithmetic of the terms leaves.
    pub arithmetic: f64,
    /// Half the 95 % interval of a reference that was measured; `None` of a stated integral.
    pub uncertainty: Option<f64>,
}

/// A reference has so many times the points of the largest count.
const MORE: u64 = 16;

impl Truth {
    /// An integral that is known.
    #[must_use]
    pub fn stated(value: f64, arithmetic: f64) -> Self {
        Self {
            value,
            arithmetic,
            uncertainty: None,
        }
    }

    /// The integral of a row: as its integrand states it, or else the mean of the study's
    /// replicates of Owen-scrambled Sobol points at sixteen times the largest count.
    ///
    /// # Errors
    /// Those of the device and of `watch`.
    pub fn of(
        engine: &Engine,
        study: &Study,
        row: &Row,
        watch: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Self> {
        let measured = reference(study, row)?
            .map(|(larger, sampler)| engine.measure(&larger, row, sampler, watch));
        Ok(Self::judged(row, measured.transpose()?.as_ref()))
    }

    /// The same, of what the [`reference`] gave if there is one.
    pub(super) fn judged(row: &Row, reference: Option<&Cell>) -> Self {
        let arithmetic = floor(&row.problem).total();
        if let Some(value) = row.problem.known_truth() {
            // Means are rounded to `f64`.
            let rounding = f64::EPSILON * value.abs();
            return Self::stated(value, arithmetic + rounding);
        }
        let points = reference.iter().flat_map(|cell| &cell.points);
        let means: Vec<f64> = points.flat_map(|point| point.means.clone()).collect();
        Self::measured(&means, arithmetic)
    }

    /// The mean of independent means, two or more, with Student's interval.
    #[must_use]
    pub fn measured(means: &[f64], arithmetic: f64) -> Self {
        let n = means.len() as f64;
        let value = means.iter().sum::<f64>() / n;
        let squares: f64 = means.iter().map(|mean| (mean - value).powi(2)).sum();
        let degrees = means.len().saturating_sub(1).max(1) as u32;
        let t = student::two_sided(0.95, degrees);
        Self {
            value,
            arithmetic,
            uncertainty: Some(t * (squares / (n - 1.0) / n).sqrt()),
        }
    }

    /// The least error that can be told from none.
    #[must_use]
    pub fn floor(&self) -> f64 {
        self.arithmetic + self.uncertainty.unwrap_or(0.0)
    }
}

/// What is to be measured for an integral that is not known: the study of it, and its sampler.
pub(super) fn reference(study: &Study, row: &Row) -> Result<Option<(Study, Sampler)>> {
    if row.problem.known_truth().is_some() {
        return Ok(None);
    }
    let most = study.counts().iter().copied().max().unwrap_or(1);
    let count = most.saturating_mul(MORE).min(1 << 32);
    let sampler = Sampler::new(Sequence::Sobol, Some(Scramble::OwenHash))?;
    let larger = Study::new(
        vec![Row {
            samplers: vec![sampler],
            ..row.clone()
        }],
        Settings {
            min_count: count,
            max_count: count,
            replicates: study.replicates(),
            // None of the seeds that it judges.
            seed: study.seed().wrapping_add(1 << 32),
            targets: Vec::new(),
        },
    )?;
    Ok(Some((larger, sampler)))
}

#[cfg(test)]
mod tests {
    use super::Truth;
    use crate::reference::random::random;
    use glam::UVec2;

    /// 4 means, as few replicates as anyone takes: 95 of 100 intervals hold the integral, within
    /// four standard errors of 2000 trials; those of the normal quantile hold it in 85.
    #[test]
    fn the_interval_of_few_replicates_holds_the_integral() {
        let normal = |index: u32| {
            let uniform = |k| f64::from(random(index, k, UVec2::new(9, 9))) / 4_294_967_296.0;
            (0..12).map(uniform).sum::<f64>() - 6.0
        };
        let trials = 2000;
        let held = (0..trials).filter(|trial| {
            let means: Vec<f64> = (0..4).map(|r| normal(4 * trial + r)).collect();
            let truth = Truth::measured(&means, 0.0);
            truth.value.abs() <= truth.uncertainty.unwrap_or(0.0)
        });
        let held = held.count();
        assert!((1861..=1939).contains(&held), "{held} of {trials}");
    }
}
