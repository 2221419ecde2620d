//! The CPU path: the reference over ranges, on every core, with the bytes of the GPU.

mod column;
mod estimate;
mod integrand;
mod integrand_environment;
mod integrand_scene;
mod irradiance;
mod maps;
mod pairs;
mod pixels;
mod reduce;
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
use crate::catalog::{Engine, Output, Request};
use column::Prepared;

/// Makes the points of a request on the CPU.
#[derive(Clone, Debug)]
pub struct Reference {
    request: Request,
    columns: Vec<Prepared>,
    threads: usize,
}

/// Points of a piece: a few hundred kilobytes, so that progress is seen.
const PIECE: u64 = 1 << 18;

impl Reference {
    /// Prepares a request; threads as many as the machine has cores.
    #[must_use]
    pub fn new(request: &Request) -> Self {
        let columns = request.columns.iter().map(Prepared::new).collect();
        Self {
            request: request.clone(),
            columns,
            threads: std::thread::available_parallelism().map_or(1, usize::from),
        }
    }

    /// Writes the rows of consecutive points, `start` counted from the request's first.
    pub fn fill(&self, start: u64, words: &mut [u32]) {
        let width = self.request.words_per_point() as usize;
        let points = words.len() / width;
        let share = points.div_ceil(self.threads).max(1);
        std::thread::scope(|scope| {
            for (i, part) in words.chunks_mut(share * width).enumerate() {
                scope.spawn(move || {
                    for (j, row) in part.chunks_exact_mut(width).enumerate() {
                        let n = self.request.first + start + (i * share + j) as u64;
                        self.row(n as u32, row);
                    }
                });
            }
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
    fn make(
        &mut self,
        start: u64,
        count: u64,
        take: &mut dyn FnMut(&[u32]) -> Result<()>,
    ) -> Result<()> {
        let width = u64::from(self.request.words_per_point());
        let mut done = 0;
        while done < count {
            let points = (count - done).min((PIECE / width).max(1));
            let mut words = vec![0; (points * width) as usize];
            self.fill(start + done, &mut words);
            take(&words)?;
            done += points;
        }
        Ok(())
    }

    fn chunk(&self) -> u64 {
        PIECE
    }
}
