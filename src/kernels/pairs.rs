//! Sums and searches over pairs of points.

use super::{constant, groups, kernel, pipeline, spirv};
use crate::Result;
use crate::interface::{Kernel, PairsPush};
use crate::vulkan::{Access, Buffer, Device, Pipeline};
use std::sync::Arc;

/// Points on the device, and a kernel over their pairs.
pub struct Pairs {
    kernel: &'static Kernel,
    pipeline: Pipeline,
    words: Buffer,
    count: u32,
    dimensions: u32,
    device: Arc<Device>,
}

/// Told how many pairs are done, out of how many.
pub type Progress<'a> = &'a mut dyn FnMut(u64, u64) -> Result<()>;

/// Iterations of an invocation's loops at most: llvmpipe ends them after 65,535.
const ITERATIONS: u32 = 60_000;

/// Coordinates of pairs that the first dispatch looks at: short on the slowest device.
const FIRST_STEPS: u64 = 1 << 20;

/// And any dispatch at most.
const MAX_STEPS: u64 = 1 << 30;

/// Rows of a dispatch at most: 16 MiB of results.
const MAX_ROWS: u64 = 1 << 20;

/// Seconds that a dispatch is to take.
const GOAL: std::ops::Range<f64> = 0.02..0.2;

impl Pairs {
    /// Points as fractions of 2^32, `count` of each of `dimensions` columns, for sums of
    /// the products of a `KIND`.
    ///
    /// # Errors
    /// Those of the device.
    pub fn sums(device: &Arc<Device>, words: &[u32], dimensions: u32, kind: u32) -> Result<Self> {
        let module = spirv("pairs")?;
        Self::with_module(device, "pairs", words, dimensions, kind, &module)
    }

    /// The same for the search for the nearest.
    ///
    /// # Errors
    /// Those of the device.
    pub fn nearest(
        device: &Arc<Device>,
        words: &[u32],
        dimensions: u32,
        toroidal: bool,
    ) -> Result<Self> {
        let module = spirv("nearest")?;
        let choice = u32::from(toroidal);
        Self::with_module(device, "nearest", words, dimensions, choice, &module)
    }

    /// Either kernel, by name and with the value of its constant, with other SPIR-V of the
    /// same interface: how tests run broken kernels.
    ///
    /// # Errors
    /// Those of the device.
    pub fn with_module(
        device: &Arc<Device>,
        name: &str,
        words: &[u32],
        dimensions: u32,
        choice: u32,
        module: &[u32],
    ) -> Result<Self> {
        let row = kernel(name)?;
        let constants: Vec<(u32, u32)> = ["KIND", "TOROIDAL"]
            .into_iter()
            .filter_map(|name| constant(row, name, choice))
            .collect();
        let bytes: &[u8] = bytemuck::cast_slice(words);
        let mut buffer = Buffer::new(device, bytes.len() as u64, Access::Upload)?;
        buffer.write(0, bytes)?;
        Ok(Self {
            kernel: row,
            pipeline: pipeline(device, row, module, &constants)?,
            words: buffer,
            count: words.len() as u32 / dimensions.max(1),
            dimensions,
            device: Arc::clone(device),
        })
    }

    /// The sum over all pairs, in units of 2^-`scale`.
    ///
    /// # Errors
    /// Those of the device and of `progress`.
    pub fn sum(&self, scale: u32, progress: Progress) -> Result<u128> {
        let mut sum = 0;
        let mut take = |_: u32, [a, b, c, d]: [u32; 4]| {
            let low = u128::from(a) | u128::from(b) << 32;
            let high = u128::from(c) | u128::from(d) << 32;
            sum += low + (high << 32);
        };
        self.run(scale, &mut take, progress)?;
        Ok(sum)
    }

    /// Shows the nearest of the later points to each point, block by block of those:
    /// row, squared distance in units of 2^-64 (low word first) and the other's row.
    ///
    /// # Errors
    /// Those of the device and of `progress`.
    pub fn search(
        &self,
        take: &mut dyn FnMut(u32, [u32; 3], u32),
        progress: Progress,
    ) -> Result<()> {
        let mut some = |row: u32, [a, b, c, other]: [u32; 4]| {
            if other != u32::MAX {
                take(row, [a, b, c], other);
            }
        };
        self.run(0, &mut some, progress)
    }

    /// Runs over all pairs, by rows and by blocks of later points.
    fn run(
        &self,
        scale: u32,
        take: &mut dyn FnMut(u32, [u32; 4]),
        progress: Progress,
    ) -> Result<()> {
        let block = (ITERATIONS / (self.dimensions + 1)).clamp(1, 4096);
        let work = u64::from(block) * u64::from(self.dimensions.max(1));
        let mut steps = FIRST_STEPS;
        let most = MAX_ROWS.min(u64::from(self.count.max(1)));
        let mut results = Buffer::new(&self.device, 16 * most, Access::Readback)?;
        let total = u64::from(self.count) * u64::from(self.count.saturating_sub(1)) / 2;
        let (mut first_other, mut done) = (1, 0);
        while first_other < self.count {
            let end_other = first_other.saturating_add(block).min(self.count);
            // Later rows have no later point in this block.
            let end_row = end_other - 1;
            let mut first_row = 0;
            while first_row < end_row {
                let fits = (steps / work).clamp(64.min(most), most) as u32;
                let rows = fits.min(end_row - first_row);
                let push = PairsPush {
                    first_row,
                    rows,
                    first_other,
                    end_other,
                    count: self.count,
                    dimensions: self.dimensions,
                    scale,
                };
                let timing = self.device.run(
                    &self.pipeline,
                    &[(0, &results), (1, &self.words)],
                    &push.bytes(),
                    groups(self.kernel, rows),
                )?;
                results.read(0, 16 * u64::from(rows), |bytes| {
                    let found = bytemuck::pod_collect_to_vec::<u8, [u32; 4]>(bytes);
                    for (row, words) in (first_row..).zip(found) {
                        take(row, words);
                    }
                })?;
                let later = |row: u32| u64::from(end_other - first_other.max(row + 1));
                done += (first_row..first_row + rows).map(later).sum::<u64>();
                first_row += rows;
                let seconds = timing.device_ns.unwrap_or(timing.host_ns) * 1e-9;
                if seconds < GOAL.start {
                    steps = (2 * steps).min(MAX_STEPS);
                } else if seconds > GOAL.end {
                    steps = (steps / 2).max(1);
                }
                progress(done, total)?;
            }
            first_other = end_other;
        }
        Ok(())
    }
}
