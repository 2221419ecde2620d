//! The twin of the kernel of pictures: exact sums for pixels, on every core.

use super::column::Prepared;
use super::estimate::run;
use crate::Result;
use crate::catalog::Raster;
use crate::estimate::Estimate;
use std::ops::Range;
use std::panic::resume_unwind;

/// Exact sums over all points of each of some pixels of a picture.
///
/// # Errors
/// Those of [`Raster::pixel`].
pub fn estimate_pixels(raster: &Raster, pixels: Range<u32>) -> Result<Vec<Estimate>> {
    let one = |index: u32| -> Result<Estimate> {
        let (problem, request) = raster.pixel(index)?;
        let columns: Vec<Prepared> = request.columns.iter().map(Prepared::new).collect();
        run(&problem, &columns, request.first, request.count)
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from) as u32;
    let share = (pixels.len() as u32).div_ceil(threads).max(1);
    std::thread::scope(|scope| {
        let begins = pixels.clone().step_by(share as usize);
        let parts: Vec<_> = begins
            .map(|begin| {
                let end = begin.saturating_add(share).min(pixels.end);
                scope.spawn(move || (begin..end).map(one).collect::<Result<Vec<_>>>())
            })
            .collect();
        let mut all = Vec::with_capacity(pixels.len());
        for part in parts {
            // A panic of a thread is a bug, and one here too.
            all.extend(part.join().unwrap_or_else(|panic| resume_unwind(panic))?);
        }
        Ok(all)
    })
}
