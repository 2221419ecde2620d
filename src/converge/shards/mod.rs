//! A study in shards, on several machines that share a folder.
//!
//! Each shard measures the items whose number in the study is its own modulo how many shards
//! there are, and keeps them in a file of its own, `cells-I-of-N.jsonl`: one line that says of
//! which study they are, then a line for each, as it is finished. A shard that was killed goes
//! on from there. [`Gathered`] takes the files of all shards together.

mod description;
mod file;
mod gathered;

pub use file::open_shard;
pub use gathered::{Gathered, Lacking};

use super::item::items;
use super::{Engine, Kept, Study, Watch};
use crate::Result;
use crate::catalog::Shard;

/// What a shard did with one of its cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Done {
    /// Integrand, estimator where there is a choice, and sampler.
    pub cell: String,
    /// Whether it was measured now, and not kept before.
    pub anew: bool,
}

/// How many items a study has for its shards: its cells, and a reference for each integrand whose
/// integral is not known.
///
/// # Errors
/// Those of a reference that cannot be: [`Error::Arguments`](crate::Error::Arguments).
pub fn item_count(study: &Study) -> Result<u64> {
    Ok(items(study)?.len() as u64)
}

/// Measures the cells of a shard on a device, whose name and driver `device` has. Those that
/// [`open_shard`] found are taken, whatever device measured them; new ones are kept as soon as
/// they are finished.
///
/// # Errors
/// Those of the device and of `watch`; cells that were finished before are kept.
pub fn run_shard(
    engine: &Engine,
    study: &Study,
    shard: Shard,
    device: &str,
    kept: &mut Kept,
    watch: &mut Watch<'_>,
) -> Result<Vec<Done>> {
    let all = items(study)?;
    let own = (0..)
        .zip(&all)
        .filter(|(number, _)| shard.is_dealt(*number));
    let own: Vec<_> = own.map(|(_, item)| item).collect();
    let total = own.len() as u64;
    let mut done = Vec::new();
    for (number, item) in (0..).zip(own) {
        let name = item.name();
        let measured = item.cell(engine, device, Some(kept), &mut || {
            watch(&name, number, total)
        })?;
        watch(&name, number + 1, total)?;
        done.push(Done {
            cell: name,
            anew: measured.anew,
        });
    }
    Ok(done)
}
