//! The CPU path: the reference over ranges, on every core, with the bytes of the GPU.

mod blocks;
mod column;
mod directions;
mod estimate;
mod integrand;
mod integrand_environment;
mod integrand_scene;
mod irradiance;
mod maps;
mod output;
mod pairs;
mod pixels;
mod points;
mod reduce;
mod rows;
#[cfg(feature = "scenes")]
mod scene;
mod stored;

pub use estimate::estimate;
pub use integrand::integrand_term;
pub use irradiance::{RadianceMap, irradiance_sum, row_edges, sum_scale};
pub use maps::{map_invert, map_pdf, map_sample};
pub use pairs::{
    Columns, MAX_PAIR_DIMENSIONS, NearestWords, l2_from_sum, nearest_words, pair_kind_of,
    pair_scale, pair_sum,
};
pub use pixels::estimate_pixels;
pub use reduce::reduce;
#[cfg(feature = "scenes")]
pub use scene::SceneReference;
pub use stored::Stored;

use crate::Result;
use crate::catalog::{Engine, Output, Request, whole_points};
use column::Prepared;
use directions::Directions;
use output::Rows;
use points::{Batch, Points, STRIDE};
use std::num::NonZero;

/// Makes the points of a request on the CPU.
#[derive(Clone, Debug)]
pub struct Reference {
    request: Request,
    columns: Vec<Prepared>,
    points: Points,
    threads: usize,
    /// The last piece of [`Engine::make`], whose memory the next one takes.
    piece: Vec<u32>,
}

/// Words of a piece: 8 MiB, so that starting threads is a small part of the time, and progress
/// is seen.
const PIECE: u64 = 1 << 21;

/// Fewer words than this are made sooner than a thread starts.
const ALONE: usize = 1 << 12;

impl Reference {
    /// Prepares a request; threads as many as the machine has cores. A column has tables of up to
    /// 100 KiB, which take some 10 µs to make, or a millisecond where digits are permuted.
    #[must_use]
    pub fn new(request: &Request) -> Self {
        let threads = std::thread::available_parallelism().unwrap_or(NonZero::<usize>::MIN);
        Self::with_threads(request, threads)
    }

    /// The same with so many threads. The words do not depend on it.
    #[must_use]
    pub fn with_threads(request: &Request, threads: NonZero<usize>) -> Self {
        let columns = request.columns.iter().map(Prepared::new).collect();
        let output = match &request.map {
            Some(_) => Output::Fractions,
            None => request.output,
        };
        Self {
            request: request.clone(),
            columns,
            points: Points::new(&request.columns, request.count, output),
            threads: threads.get(),
            piece: Vec::new(),
        }
    }

    /// Writes the rows of points that are known to be the request's.
    fn fill_rows(&self, start: u64, words: &mut [u32]) {
        self.parted(start, words, |n, rows| self.fill_part(n, rows));
    }

    /// Writes the rows of consecutive points, `start` counted from the request's first, each value
    /// by itself as the headers compute it: what [`Engine::fill`] must equal. They end with the
    /// request at the latest, and `words` holds whole rows. Slow.
    pub fn fill_singly(&self, start: u64, words: &mut [u32]) {
        let width = self.width();
        self.parted(start, words, |n, rows| {
            for (n, row) in (n..).zip(rows.chunks_exact_mut(width)) {
                self.row(n as u32, row);
            }
        });
    }

    fn width(&self) -> usize {
        self.request.words_per_point() as usize
    }

    /// Calls `fill` with an index and the rows from there on, by all threads.
    fn parted(&self, start: u64, words: &mut [u32], fill: impl Fn(u64, &mut [u32]) + Sync) {
        let width = self.width();
        let threads = if words.len() < ALONE { 1 } else { self.threads };
        let share = (words.len() / width).div_ceil(threads).max(1);
        let first = self.request.first + start;
        let fill = &fill;
        std::thread::scope(|scope| {
            let mut parts = (first..)
                .step_by(share)
                .zip(words.chunks_mut(share * width));
            let own = parts.next();
            for (n, rows) in parts {
                scope.spawn(move || fill(n, rows));
            }
            if let Some((n, rows)) = own {
                fill(n, rows);
            }
        });
    }

    fn fill_part(&self, n: u64, rows: &mut [u32]) {
        let Some(mapping) = &self.request.map else {
            return self.points.fill(n, rows);
        };
        let width = self.width();
        if let Some(directions) = Directions::of(mapping, self.request.profile, width) {
            return self.fill_directions(directions, n, rows);
        }
        self.points.each(n, rows.len() / width, |batch| {
            let rows = rows[batch.start * width..].chunks_exact_mut(width);
            for (i, row) in rows.take(batch.rows).enumerate() {
                let mut u = [0; 3];
                let columns = batch.words[i..].iter().step_by(STRIDE);
                for (u, column) in u.iter_mut().zip(columns).take(self.columns.len()) {
                    *u = *column;
                }
                let sample = map_sample(mapping, self.request.profile, u);
                row.copy_from_slice(&sample[..width]);
            }
        });
    }

    fn fill_directions(&self, directions: Directions, n: u64, words: &mut [u32]) {
        let (width, level) = (self.width(), self.points.level());
        let count = words.len() / width;
        let mut rows = Rows::new(words, width, level);
        let mut samples = [0; 4 * STRIDE];
        self.points.each(n, count, |batch| {
            directions.fill(level, batch, &mut samples);
            rows.put(&Batch {
                words: &samples,
                ..*batch
            });
        });
    }

    fn row(&self, n: u32, row: &mut [u32]) {
        if let Some(mapping) = &self.request.map {
            let mut u = [0; 3];
            for (u, column) in u.iter_mut().zip(&self.columns) {
                *u = column.fraction(n);
            }
            let sample = map_sample(mapping, self.request.profile, u);
            row.copy_from_slice(&sample[..row.len()]);
            return;
        }
        for (word, column) in row.iter_mut().zip(&self.columns) {
            let u = column.fraction(n);
            *word = match self.request.output {
                Output::Fractions => u,
                Output::Floats => column.unit(u).to_bits(),
            };
        }
    }
}

impl Engine for Reference {
    fn count(&self) -> u64 {
        self.request.count
    }

    fn words_per_point(&self) -> u32 {
        self.request.words_per_point()
    }

    fn make(
        &mut self,
        start: u64,
        count: u64,
        take: &mut dyn FnMut(&[u32]) -> Result<()>,
    ) -> Result<()> {
        let width = self.width();
        let mut piece = std::mem::take(&mut self.piece);
        let mut done = 0;
        while done < count {
            let points = (count - done).min(self.chunk());
            // At most PIECE words, or a row.
            piece.resize(points as usize * width, 0);
            self.fill_rows(start + done, &mut piece);
            take(&piece)?;
            done += points;
        }
        self.piece = piece;
        Ok(())
    }

    fn chunk(&self) -> u64 {
        (PIECE / self.width() as u64).max(1)
    }

    /// In place, without a copy: by blocks of indices, at about the speed of memory where a sequence
    /// allows it.
    fn fill(&mut self, start: u64, words: &mut [u32]) -> Result<()> {
        whole_points(self, start, words.len())?;
        self.fill_rows(start, words);
        Ok(())
    }
}
