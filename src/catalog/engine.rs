//! What makes points, on a device or on the CPU.

use crate::{Error, Result};
use std::ops::Range;

/// Something that makes the points of a request.
pub trait Engine {
    /// Points of the request.
    fn count(&self) -> u64;

    /// Words of a point.
    fn words_per_point(&self) -> u32;

    /// Hands the words of `count` points from the request's point `start` on to `take`,
    /// row after row, in one or several pieces. `start` counts from the request's first.
    ///
    /// # Errors
    /// Those of the device, and those of `take`.
    fn make(
        &mut self,
        start: u64,
        count: u64,
        take: &mut dyn FnMut(&[u32]) -> Result<()>,
    ) -> Result<()>;

    /// A good number of points for the next call: small enough for short waits.
    fn chunk(&self) -> u64;

    /// [`Engine::make`] for a range of points, by calls of [`Engine::chunk`] points.
    ///
    /// # Errors
    /// As there.
    fn make_range(
        &mut self,
        points: Range<u64>,
        take: &mut dyn FnMut(&[u32]) -> Result<()>,
    ) -> Result<()> {
        let mut done = points.start;
        while done < points.end {
            let count = self.chunk().clamp(1, points.end - done);
            self.make(done, count, take)?;
            done += count;
        }
        Ok(())
    }

    /// Writes the rows of consecutive points, `start` counted from the request's first, into
    /// `words`, which holds whole rows: what floats have as bits, or fractions. A device makes
    /// them in as many dispatches as [`Self::chunk`] says, and each is copied once.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a part of a row, for points that the request does not have, and of
    /// an engine that makes more or fewer words; those of the device, after which `words` may hold some of the points.
    fn fill(&mut self, start: u64, words: &mut [u32]) -> Result<()> {
        let points = whole_points(self, start, words.len())?;
        let asked = words.len();
        let (mut rest, mut given) = (words, 0);
        self.make(start, points, &mut |piece| {
            let all = std::mem::take(&mut rest);
            let (words, after) = all.split_at_mut(piece.len().min(all.len()));
            words.copy_from_slice(&piece[..words.len()]);
            rest = after;
            given += piece.len();
            Ok(())
        })?;
        if given == asked {
            return Ok(());
        }
        Err(Error::Arguments {
            asked: format!("{asked} words of an engine"),
            limit: format!("it made {given}"),
            remedy: "mend its `make`, which gives all points that it is asked for".into(),
        })
    }
}

/// The points that so many words hold from point `start` on.
///
/// # Errors
/// Those of [`Engine::fill`] that are not the device's.
pub fn whole_points<E: Engine + ?Sized>(engine: &E, start: u64, words: usize) -> Result<u64> {
    let width = u64::from(engine.words_per_point()).max(1);
    let words = words as u64;
    if !words.is_multiple_of(width) {
        return Err(Error::Arguments {
            asked: format!("to fill {words} words with points of {width}"),
            limit: "points are whole".into(),
            remedy: format!("give a slice of {} words", words / width * width),
        });
    }
    let points = words / width;
    check_points(engine.count(), start, points)?;
    Ok(points)
}

/// That a request of `count` points has these.
///
/// # Errors
/// [`Error::Arguments`].
pub fn check_points(count: u64, start: u64, points: u64) -> Result<()> {
    if start.checked_add(points).is_some_and(|end| end <= count) {
        return Ok(());
    }
    Err(Error::Arguments {
        asked: format!("{points} points from point {start} of a request on"),
        limit: format!("the request has {count}"),
        remedy: "ask for fewer, or make a request of more".into(),
    })
}
