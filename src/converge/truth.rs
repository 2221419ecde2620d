//! What the means of an integrand are compared with.

use super::cell::Engine;
use super::floor::floor;
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
        let arithmetic = floor(&row.problem).total();
        if let Some(value) = row.problem.known_truth() {
            // Means are rounded to `f64`.
            let rounding = f64::EPSILON * value.abs();
            return Ok(Self::stated(value, arithmetic + rounding));
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
        let cell = engine.measure(&larger, row, sampler, watch)?;
        let means: Vec<f64> = cell
            .points
            .iter()
            .flat_map(|point| point.means.clone())
            .collect();
        let n = means.len() as f64;
        let value = means.iter().sum::<f64>() / n;
        let squares: f64 = means.iter().map(|mean| (mean - value).powi(2)).sum();
        Ok(Self {
            value,
            arithmetic,
            uncertainty: Some(1.96 * (squares / (n - 1.0) / n).sqrt()),
        })
    }

    /// The least error that can be told from none.
    #[must_use]
    pub fn floor(&self) -> f64 {
        self.arithmetic + self.uncertainty.unwrap_or(0.0)
    }
}
