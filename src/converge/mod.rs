//! Error against run time: samplers on integrands of known value, in replicates, timed on
//! the device.
//!
//! A [`Study`] names integrands, samplers and counts; [`run`] measures each pair of the first
//! two, a cell, and [`Results`] says how the error falls with points and with time. Sums are
//! exact, so a study gives the same errors on every device; the times are the device's.

mod analysis;
mod cell;
mod counts;
mod file;
mod floor;
mod hits;
mod kept;
mod monotone;
#[cfg(feature = "images")]
mod report;
mod results;
mod statistics;
mod student;
mod study;
mod summary;
mod truth;

pub use analysis::{Analysis, ErrorAt, Reached};
pub use cell::{Cell, Engine, Point};
pub use counts::SlopeCounts;
pub use file::{DEFAULT, parse, read};
pub use floor::{Floor, floor};
pub use hits::Rarity;
pub use kept::{Kept, key};
#[cfg(feature = "images")]
pub use report::{check_folder, write};
pub use results::{Results, SCHEMA, Series, Setting};
pub use statistics::{Interval, Statistic, fit, median, quantile, slope};
pub use study::{Row, Settings, Study, rows};
pub use summary::{Standing, standings};
pub use truth::Truth;

use crate::Result;
use crate::catalog::Sampler;

/// Hears of each cell and dispatch: the cell's name, cells done, and all cells. Its error
/// stops the study between dispatches.
pub type Watch<'a> = dyn FnMut(&str, u64, u64) -> Result<()> + 'a;

/// Measures a study. Cells that `kept` has from the same program are taken from there, and new
/// ones go there as soon as they are finished.
///
/// # Errors
/// Those of the device and of `watch`; cells that were finished before are in `kept`.
pub fn run(
    engine: &Engine,
    study: &Study,
    setting: Setting,
    mut kept: Option<&mut Kept>,
    watch: &mut Watch<'_>,
) -> Result<Results> {
    let total = study.cells() as u64;
    let mut series = Vec::new();
    for row in study.rows() {
        let mut stop = || watch(&row.name, series.len() as u64, total);
        let truth = Truth::of(engine, study, row, &mut stop)?;
        let mut cells: Vec<(Sampler, Cell)> = Vec::new();
        for &sampler in &row.samplers {
            let name = format!("{}, {}", row.name, sampler.name());
            let key = key(study, row, sampler, &setting.device);
            let program = engine.program(study, row, sampler)?;
            let known = kept
                .as_mut()
                .and_then(|kept| kept.get(&key, &program))
                .filter(|cell| cell.fits(study, sampler));
            let cell = match known {
                Some(cell) => cell,
                None => {
                    let done = (series.len() + cells.len()) as u64;
                    let mut stop = || watch(&name, done, total);
                    let cell = engine.measure(study, row, sampler, &mut stop)?;
                    if let Some(kept) = &mut kept {
                        kept.add(&key, &program, &cell)?;
                    }
                    cell
                }
            };
            cells.push((sampler, cell));
            watch(&name, (series.len() + cells.len()) as u64, total)?;
        }
        let independent = cells.iter().filter(|(sampler, _)| sampler.is_independent());
        let rarity = Rarity::of(independent.map(|(_, cell)| cell), &truth);
        let made = cells
            .into_iter()
            .map(|(sampler, cell)| Series::new(row, sampler, truth, cell, rarity));
        series.extend(made);
    }
    Ok(Results { setting, series })
}
