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
mod item;
mod kept;
mod line;
mod monotone;
#[cfg(feature = "images")]
mod report;
mod results;
mod series;
mod shards;
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
pub use results::{Results, SCHEMA, Setting};
pub use series::Series;
pub use shards::{Done, Gathered, Lacking, item_count, open_shard, run_shard};
pub use statistics::{Interval, Statistic, fit, median, quantile, slope};
pub use study::{Row, Settings, Study, rows};
pub use summary::{Standing, comparable, standings};
pub use truth::Truth;

use crate::Result;
use item::items;

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
    let mut done = 0;
    let mut cells = Vec::new();
    for item in items(study)? {
        let name = item.name();
        let mut stop = || watch(&name, done, total);
        cells.push(item.cell(engine, &setting.device, kept.as_deref_mut(), &mut stop)?);
        if !item.is_reference() {
            done += 1;
            watch(&name, done, total)?;
        }
    }
    Ok(Results::of(study, setting, cells))
}
