//! Points chunk by chunk, into memory that is used again.

use super::{Engine, check_points};
use crate::{Error, Result};
use std::iter::FusedIterator;
use std::ops::Range;

/// Consecutive points of a request, so many a chunk; the last one may be shorter.
///
/// The words are the same on the CPU and on every device, and in chunks of any length.
/// [`Self::next_words`] lends each chunk from memory that it allocates once. As an iterator it
/// gives vectors that the caller keeps, one allocation each. Neither copies what
/// `bulk::Reference` makes; from a device each word is copied once.
///
/// An error ends it; else [`Iterator::size_hint`] is exact, where a `usize` holds the number.
///
/// ```
/// use corput::bulk::Reference;
/// use corput::catalog::{Chunks, Options, Request, Sequence};
///
/// let request = Request::new(&Options::new(Sequence::Halton, 1000))?;
/// let mut engine = Reference::new(&request);
///
/// // Points 100 to 999 of 2 dimensions, 256 at a time.
/// let mut chunks = Chunks::new(&mut engine, 100..1000, 256)?;
/// let mut sum = 0.0;
/// while let Some(words) = chunks.next_words() {
///     sum += words?.iter().map(|word| f32::from_bits(*word)).sum::<f32>();
/// }
/// assert!((sum / 1800.0 - 0.5).abs() < 1e-2);
///
/// let lengths = Chunks::new(&mut engine, 100..1000, 256)?.map(|words| Ok(words?.len()));
/// assert_eq!(lengths.collect::<corput::Result<Vec<_>>>()?, [512, 512, 512, 264]);
/// # Ok::<(), corput::Error>(())
/// ```
#[derive(Debug)]
pub struct Chunks<'a, E: ?Sized> {
    engine: &'a mut E,
    points: Range<u64>,
    rows: u64,
    words: Vec<u32>,
}

impl<'a, E: Engine + ?Sized> Chunks<'a, E> {
    /// The points of a range, counted from the request's first, `rows` a chunk. Nothing is made
    /// or allocated before the first chunk is asked for. [`Engine::chunk`] is a good number.
    ///
    /// # Errors
    /// [`Error::ZeroCount`] for chunks of none; [`Error::Arguments`] for points that the request
    /// does not have.
    pub fn new(engine: &'a mut E, points: Range<u64>, rows: u64) -> Result<Self> {
        if rows == 0 {
            return Err(Error::ZeroCount {
                what: "the number of points in a chunk",
            });
        }
        let length = points.end.saturating_sub(points.start);
        check_points(engine.count(), points.start, length)?;
        Ok(Self {
            engine,
            points,
            rows,
            words: Vec::new(),
        })
    }

    /// The words of the next chunk, row after row; none after the last, and after an error.
    ///
    /// # Errors
    /// [`Error::Arguments`] where a chunk does not fit into memory; those of the device.
    pub fn next_words(&mut self) -> Option<Result<&[u32]>> {
        let start = self.points.start;
        let points = self.rows.min(self.points.end.saturating_sub(start));
        if points == 0 {
            return None;
        }
        match self.make(start, points) {
            Ok(()) => {
                self.points.start += points;
                Some(Ok(&self.words))
            }
            Err(error) => {
                self.points.start = self.points.end;
                Some(Err(error))
            }
        }
    }

    fn make(&mut self, start: u64, points: u64) -> Result<()> {
        let words = points.saturating_mul(self.engine.words_per_point().into());
        let words = usize::try_from(words).unwrap_or(usize::MAX);
        self.words.truncate(words);
        let missing = words - self.words.len();
        if self.words.try_reserve_exact(missing).is_err() {
            return Err(Error::Arguments {
                asked: format!("chunks of {points} points, of {words} words"),
                limit: "memory has no room for one".into(),
                remedy: "ask for fewer points a chunk".into(),
            });
        }
        self.words.resize(words, 0);
        self.engine.fill(start, &mut self.words)
    }
}

impl<E: Engine + ?Sized> Iterator for Chunks<'_, E> {
    type Item = Result<Vec<u32>>;

    fn next(&mut self) -> Option<Self::Item> {
        let made = self.next_words()?.map(|_| ());
        Some(made.map(|()| std::mem::take(&mut self.words)))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let points = self.points.end.saturating_sub(self.points.start);
        // Up to 2^32, which has no `usize` of 32 bits.
        let chunks = usize::try_from(points.div_ceil(self.rows)).ok();
        (chunks.unwrap_or(usize::MAX), chunks)
    }
}

impl<E: Engine + ?Sized> ExactSizeIterator for Chunks<'_, E> {}

impl<E: Engine + ?Sized> FusedIterator for Chunks<'_, E> {}
