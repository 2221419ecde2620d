//! Exact sums for each pixel of a picture, many pixels a dispatch.

use super::points::{BUFFER_BYTES, add, table};
use super::records::{BUSY, BUSY_CPU, FIRST, RECORD, next_chunk, read};
use super::{groups, pipeline, spirv};
use crate::catalog::Raster;
use crate::estimate::{Estimate, Pixels};
use crate::interface::EstimatePush;
use crate::variant::{Plan, column_table, longest_estimate, plan_pixels};
use crate::vulkan::{Access, Buffer, Device, DeviceKind, Pipeline, Timing};
use crate::{Error, Result};
use std::sync::Arc;

/// Pixels of a dispatch at most.
const BATCH: u64 = 1 << 12;

/// Estimates the pixels of a picture.
pub struct PixelEstimator {
    raster: Raster,
    plan: Plan,
    pipeline: Pipeline,
    results: Buffer,
    rows: u32,
    longest: u64,
    chunk: u64,
    device: Arc<Device>,
}

/// What some pixels next to each other tell the kernel, of terms in one unit.
struct Batch {
    pixels: u64,
    first: u64,
    scale: i32,
    columns: Buffer,
    coefficients: Buffer,
}

impl PixelEstimator {
    /// Compiles the pipeline.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Arc<Device>, raster: &Raster) -> Result<Self> {
        Self::with_module(device, raster, None)
    }

    /// The same with other SPIR-V of the kernel's interface: how tests run broken kernels.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn with_module(
        device: &Arc<Device>,
        raster: &Raster,
        words: Option<&[u32]>,
    ) -> Result<Self> {
        let (problem, request) = raster.pixel(0)?;
        let rows = problem.words().len() as u32 / 4;
        let plan = plan_pixels(&request.columns, problem.id(), rows);
        let own = spirv(plan.kernel.name)?;
        let values = plan.specializations.first().map_or(&[][..], Vec::as_slice);
        Ok(Self {
            pipeline: pipeline(device, plan.kernel, words.unwrap_or(&own), values)?,
            results: Buffer::new(device, RECORD, Access::Readback)?,
            rows,
            longest: longest_estimate(&request.columns, problem.id()).into(),
            chunk: FIRST,
            raster: raster.clone(),
            plan,
            device: Arc::clone(device),
        })
    }

    /// The kernel that runs.
    #[must_use]
    pub fn kernel_name(&self) -> &'static str {
        self.plan.kernel.name
    }

    /// The sums of all pixels; `watch` hears of the points done, and may stop.
    ///
    /// # Errors
    /// Those of [`Raster::pixel`], of the device, and of `watch`.
    pub fn run(&mut self, watch: &mut dyn FnMut(u64) -> Result<()>) -> Result<(Pixels, Timing)> {
        let mut all = Vec::new();
        let mut spent = Timing {
            device_ns: Some(0.0),
            host_ns: 0.0,
        };
        let count = self.raster.count();
        while (all.len() as u64) < self.raster.pixels().into() {
            let from = all.len() as u64;
            let batch = self.batch(from as u32, (self.chunk / count).clamp(1, BATCH))?;
            let mut sums = vec![Estimate::new(batch.scale); batch.pixels as usize];
            let mut done = 0;
            while done < count {
                let points = (self.chunk / batch.pixels).max(1).min(count - done);
                let timing = self.dispatch(&batch, done, points, &mut sums)?;
                // A record a point fits.
                let most = BUFFER_BYTES / 4 / RECORD;
                self.chunk = next_chunk(batch.pixels * points, &timing, most);
                add(&mut spent, timing);
                done += points;
                watch(from * count + batch.pixels * done)?;
            }
            all.extend(sums);
        }
        let [width, _] = self.raster.size();
        Ok((Pixels::new(width, all)?, spent))
    }

    /// The words of at most so many pixels from one on.
    fn batch(&self, from: u32, most: u64) -> Result<Batch> {
        let (mut columns, mut coefficients) = (Vec::new(), Vec::new());
        let (mut pixels, mut first, mut scale) = (0, 0, None);
        let end = u64::from(self.raster.pixels()).min(u64::from(from) + most);
        for index in u64::from(from)..end {
            let (problem, request) = self.raster.pixel(index as u32)?;
            let unit = problem.coefficients().scale;
            let mut words = problem.words();
            if words.len() != 4 * self.rows as usize {
                return Err(Error::Arguments {
                    asked: format!("pixel {index} of {}", problem.integrand().name),
                    limit: "the pixels of a picture have parameters of one kind".into(),
                    remedy: "this is a bug: please report it".into(),
                });
            }
            if *scale.get_or_insert(unit) != unit {
                break;
            }
            coefficients.append(&mut words);
            columns.extend(column_table(&request.columns));
            first = request.first;
            pixels += 1;
        }
        Ok(Batch {
            pixels,
            first,
            scale: scale.unwrap_or(0),
            columns: table(&self.device, &columns)?,
            coefficients: table(&self.device, &coefficients)?,
        })
    }

    /// Adds so many points of each pixel.
    fn dispatch(
        &mut self,
        batch: &Batch,
        start: u64,
        points: u64,
        sums: &mut [Estimate],
    ) -> Result<Timing> {
        let busy = match self.device.info().kind {
            DeviceKind::Cpu => BUSY_CPU,
            _ => BUSY,
        };
        let run = (batch.pixels * points).div_ceil(busy);
        let run = run.min(points).min(self.longest).max(1);
        let runs = points.div_ceil(run);
        let invocations = batch.pixels * runs;
        let push = EstimatePush {
            // All fit: first + count <= 2^32, and a dispatch has fewer.
            first: (batch.first + start) as u32,
            count: points as u32,
            run: run as u32,
            invocations: invocations as u32,
            scale: batch.scale as u32,
        };
        if self.results.bytes() < RECORD * invocations {
            let bytes = (RECORD * invocations).next_power_of_two();
            self.results = Buffer::new(&self.device, bytes, Access::Readback)?;
        }
        let buffers = [
            (0, &self.results),
            (1, &batch.columns),
            (2, &batch.coefficients),
        ];
        let groups = groups(self.plan.kernel, invocations as u32);
        let timing = self
            .device
            .run(&self.pipeline, &buffers, &push.bytes(), groups)?;
        let records = read(&mut self.results, invocations, batch.scale)?;
        for (sum, parts) in sums.iter_mut().zip(records.chunks(runs as usize)) {
            for part in parts {
                *sum = sum.merged(*part)?;
            }
        }
        Ok(timing)
    }
}
