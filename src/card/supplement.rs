//! What a whole card has besides the rows of the check: the catalogue of extreme inputs, and
//! statistics.

use super::{Statistic, statistics};
use crate::check::Further;
use crate::extreme;
use crate::vulkan::Device;
use crate::{Error, Result};
use std::sync::Arc;

/// Both of them.
#[derive(Clone, Debug)]
pub struct Supplement {
    /// Extreme inputs.
    pub catalogue: Vec<extreme::Row>,
    /// Statistics.
    pub statistics: Vec<Statistic>,
}

impl Supplement {
    /// Measures both on a device: seconds, and what its driver takes to compile.
    ///
    /// # Errors
    /// Those of the device.
    pub fn measure(device: &Arc<Device>) -> Result<Self> {
        Ok(Self {
            catalogue: extreme::run(device)?,
            statistics: statistics::statistics(device)?,
        })
    }

    /// Each of either as a case of JUnit's.
    #[must_use]
    pub fn cases(&self) -> Vec<Further> {
        let statistic = |one: &Statistic| Further {
            class: "statistics",
            name: format!("{}: {}", one.of, one.what),
            failure: (!one.passes())
                .then(|| format!("{} is not {} to {}", one.value, one.least, one.most)),
            skipped: None,
        };
        let inputs = self.catalogue.iter().map(extreme::Row::further);
        inputs
            .chain(self.statistics.iter().map(statistic))
            .collect()
    }

    /// Rows of either that failed.
    #[must_use]
    pub fn failures(&self) -> usize {
        let inputs = self.catalogue.iter().filter(|row| row.failure.is_some());
        let statistics = self.statistics.iter().filter(|one| !one.passes());
        inputs.count() + statistics.count()
    }

    /// `Ok` where none failed.
    ///
    /// # Errors
    /// [`Error::CheckFailed`].
    pub fn result(&self) -> Result<()> {
        match self.failures() {
            0 => Ok(()),
            failures => Err(Error::CheckFailed {
                failures,
                total: self.catalogue.len() + self.statistics.len(),
            }),
        }
    }
}
