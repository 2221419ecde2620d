//! The CPU path: the reference over ranges, on every core, with the bytes of the GPU.

mod column;
mod irradiance;
mod pairs;
mod stored;

pub use irradiance::{RadianceMap, irradiance_sum, row_edges, sum_scale};
pub use pairs::{
    Columns, MAX_PAIR_DIMENSIONS, NearestWords, l2_from_sum, nearest_words, pair_kind_of,
    pair_scale, pair_sum,
};
pub use stored::Stored;

use crate::Result;
use crate::catalog::{Engine, Map, Output, Profile, Request};
use crate::interface::map;
use crate::reference::native::{disk as native_disk, hemisphere as native_hemisphere};
use crate::reference::{disk, hemisphere};
use column::Prepared;
use glam::{UVec2, Vec2, Vec3, uvec2};

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
        if let Some(map) = self.request.map {
            let u = uvec2(self.columns[0].fraction(n), self.columns[1].fraction(n));
            let sample = match self.request.profile {
                Profile::Exact => exact(map, u),
                Profile::Native => native(map, u),
            };
            for (word, value) in row.iter_mut().zip(sample) {
                *word = value.to_bits();
            }
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

/// Coordinates and pdf in the exact profile: (x, y, pdf, 0) of a disk, (x, y, z, pdf) of
/// a hemisphere.
#[must_use]
pub fn exact(which: &Map, u: UVec2) -> [f32; 4] {
    match which.id {
        map::CONCENTRIC_DISK => planar(disk::concentric_disk(u), disk::concentric_disk_pdf()),
        map::POLAR_DISK => planar(disk::polar_disk(u), disk::polar_disk_pdf()),
        map::UNIFORM_HEMISPHERE => {
            let d = hemisphere::uniform_hemisphere(u);
            spatial(d, hemisphere::uniform_hemisphere_pdf(d))
        }
        map::COSINE_HEMISPHERE => {
            let d = hemisphere::cosine_hemisphere(u);
            spatial(d, hemisphere::cosine_hemisphere_pdf(d))
        }
        _ => {
            let d = hemisphere::cosine_hemisphere_polar(u);
            spatial(d, hemisphere::cosine_hemisphere_polar_pdf(d))
        }
    }
}

/// The same in the native profile, with this CPU's functions.
#[must_use]
pub fn native(which: &Map, u: UVec2) -> [f32; 4] {
    let disk_pdf = std::f32::consts::FRAC_1_PI;
    match which.id {
        map::CONCENTRIC_DISK => planar(native_disk::native_concentric_disk(u), disk_pdf),
        map::POLAR_DISK => planar(native_disk::native_polar_disk(u), disk_pdf),
        map::UNIFORM_HEMISPHERE => {
            let d = native_hemisphere::native_uniform_hemisphere(u);
            spatial(d, native_hemisphere::native_uniform_hemisphere_pdf(d))
        }
        map::COSINE_HEMISPHERE => {
            let d = native_hemisphere::native_cosine_hemisphere(u);
            spatial(d, native_hemisphere::native_cosine_hemisphere_pdf(d))
        }
        _ => {
            let d = native_hemisphere::native_cosine_hemisphere_polar(u);
            spatial(d, native_hemisphere::native_cosine_hemisphere_polar_pdf(d))
        }
    }
}

fn planar(p: Vec2, pdf: f32) -> [f32; 4] {
    [p.x, p.y, pdf, 0.0]
}

fn spatial(d: Vec3, pdf: f32) -> [f32; 4] {
    [d.x, d.y, d.z, pdf]
}
