//! What a study measures, one after another: cells, and references for integrals that are not
//! known.

use super::cell::{Cell, Engine, program};
use super::kept::{Kept, key};
use super::study::{Row, Study};
use super::truth::reference;
use crate::Result;
use crate::catalog::Sampler;
use std::borrow::Cow;

/// A sampler on an integrand, at the counts of a study.
pub(super) struct Item<'a> {
    row: &'a Row,
    sampler: Sampler,
    /// The study itself, or that of a reference.
    study: Cow<'a, Study>,
}

/// A cell, and the device that measured it with its driver.
pub(super) struct Measured {
    pub device: String,
    pub cell: Cell,
    /// Whether it was not kept before.
    pub anew: bool,
}

/// All items in the study's order: for each of its integrands the reference, if it needs one,
/// and a cell for each sampler.
pub(super) fn items(study: &Study) -> Result<Vec<Item<'_>>> {
    let mut all = Vec::new();
    for row in study.rows() {
        all.extend(reference(study, row)?.map(|(larger, sampler)| Item {
            row,
            sampler,
            study: Cow::Owned(larger),
        }));
        all.extend(row.samplers.iter().map(|&sampler| Item {
            row,
            sampler,
            study: Cow::Borrowed(study),
        }));
    }
    Ok(all)
}

impl Item<'_> {
    /// Whether it is no cell of the study's own.
    pub fn is_reference(&self) -> bool {
        matches!(self.study, Cow::Owned(_))
    }

    /// Integrand, estimator where there is a choice, and sampler.
    pub fn name(&self) -> String {
        let sampler = match self.is_reference() {
            true => "reference".to_owned(),
            false => self.sampler.name(),
        };
        match self.row.problem.estimator() {
            None => format!("{}, {sampler}", self.row.name),
            Some(estimator) => format!("{}, {estimator}, {sampler}", self.row.name),
        }
    }

    /// As [`key`].
    pub fn key(&self, device: Option<&str>) -> String {
        key(&self.study, self.row, self.sampler, device)
    }

    /// As [`Engine::program`], of any device of a CPU or of any other.
    pub fn program(&self, cpu: bool) -> Result<String> {
        program(&self.study, self.row, self.sampler, cpu)
    }

    /// As [`Cell::fits`].
    pub fn fits(&self, cell: &Cell) -> bool {
        cell.fits(&self.study, self.sampler)
    }

    /// What was kept of it by this program, or else what a device now measures, and then is kept.
    pub fn cell(
        &self,
        engine: &Engine,
        device: &str,
        kept: Option<&mut Kept>,
        watch: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Measured> {
        let measured = |cell: Cell| Measured {
            device: device.to_owned(),
            cell,
            anew: true,
        };
        let Some(kept) = kept else {
            let cell = engine.measure(&self.study, self.row, self.sampler, watch)?;
            return Ok(measured(cell));
        };
        let key = self.key(kept.keyed_by(device));
        let program = engine.program(&self.study, self.row, self.sampler)?;
        if let Some(line) = kept.line(&key, &program, |cell| self.fits(cell)) {
            return Ok(Measured {
                device: line.device.clone().unwrap_or_else(|| device.to_owned()),
                cell: line.cell.clone(),
                anew: false,
            });
        }
        let cell = engine.measure(&self.study, self.row, self.sampler, watch)?;
        kept.add(&key, &program, &cell)?;
        Ok(measured(cell))
    }
}
