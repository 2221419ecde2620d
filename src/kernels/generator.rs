//! Points, or samples of a map over them, chunk by chunk.

use super::{groups, pipeline, spirv};
use crate::Result;
use crate::catalog::{Engine, Output, Profile, Request};
use crate::interface::WorkPush;
use crate::variant::{Plan, Work, general, plan};
use crate::vulkan::{Access, Buffer, Device, DeviceKind, Pipeline, Timing};
use std::sync::Arc;

/// Bytes of the result buffer at most: well below the 128 MiB that the smallest drivers
/// allow, and a multiple of every tile.
const BUFFER_BYTES: u64 = 64 << 20;

/// Words of the first dispatch: short on the slowest device.
const FIRST_WORDS: u64 = 1 << 16;

/// A dispatch should take about this long: far below the 0.5 s after which desktops
/// take a driver for hung.
const TARGET_NS: f64 = 1e8;

/// Makes the points of a request on a device.
pub struct Generator {
    request: Request,
    plan: Plan,
    pipelines: Vec<Pipeline>,
    results: Buffer,
    table: Option<Buffer>,
    device: Arc<Device>,
    limit: u64,
    chunk: u64,
}

impl Generator {
    /// Prepares a request: picks the kernel, compiles the pipeline, allocates.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Arc<Device>, request: &Request) -> Result<Self> {
        Self::with_plan(device, request, plan(&work(device, request)))
    }

    /// The same with the general kernel, which every other must equal. A request with
    /// a map has none; it gets its usual kernel.
    ///
    /// # Errors
    /// Those of the device.
    pub fn general(device: &Arc<Device>, request: &Request) -> Result<Self> {
        let work = work(device, request);
        let plan = if request.map.is_some() {
            plan(&work)
        } else {
            general(&work)
        };
        Self::with_plan(device, request, plan)
    }

    fn with_plan(device: &Arc<Device>, request: &Request, plan: Plan) -> Result<Self> {
        let words = spirv(plan.kernel.name)?;
        Self::with_module(device, request, plan, &words)
    }

    /// The same with other SPIR-V of the same interface: how tests run broken kernels.
    ///
    /// # Errors
    /// Those of the device.
    pub fn with_module(
        device: &Arc<Device>,
        request: &Request,
        plan: Plan,
        words: &[u32],
    ) -> Result<Self> {
        let pipelines = plan
            .specializations
            .iter()
            .map(|values| pipeline(device, plan.kernel, words, values))
            .collect::<Result<Vec<_>>>()?;
        let point_bytes = 4 * u64::from(request.words_per_point());
        // Whole invocations: a tile each, or four words.
        let unit = u64::from(plan.tile.max(4)) * point_bytes;
        let most = BUFFER_BYTES.min(device.info().limits.max_storage_buffer_range) / unit * unit;
        let wanted = (request.count * point_bytes).next_multiple_of(unit);
        let bytes = wanted.min(most);
        let results = Buffer::new(device, bytes, Access::Readback)?;
        let table = match &plan.table {
            Some(words) => {
                let bytes: &[u8] = bytemuck::cast_slice(words);
                let mut table = Buffer::new(device, bytes.len() as u64, Access::Upload)?;
                table.write(0, bytes)?;
                Some(table)
            }
            None => None,
        };
        let limit = bytes / point_bytes;
        let tile = u64::from(plan.tile.max(4));
        let first = (FIRST_WORDS * 4 / point_bytes).next_multiple_of(tile);
        Ok(Self {
            request: request.clone(),
            plan,
            pipelines,
            results,
            table,
            device: Arc::clone(device),
            limit,
            chunk: first.min(limit),
        })
    }

    /// The kernel that runs.
    #[must_use]
    pub fn kernel_name(&self) -> &'static str {
        self.plan.kernel.name
    }

    /// Points that one dispatch can make.
    #[must_use]
    pub fn limit(&self) -> u64 {
        self.limit
    }

    /// Makes up to [`Self::limit`] points, `start` counted from the request's first; the
    /// results stay in the buffer. The time is that of all dispatches they take.
    ///
    /// # Errors
    /// Those of the device.
    pub fn dispatch(&mut self, start: u64, points: u64) -> Result<Timing> {
        let words = points * u64::from(self.request.words_per_point());
        let invocations = match self.plan.tile {
            0 => words.div_ceil(4),
            tile => points.div_ceil(u64::from(tile)),
        } as u32;
        let push = WorkPush {
            // Both fit: first + count <= 2^32.
            first: (self.request.first + start) as u32,
            invocations,
            stride: 1,
        };
        let mut buffers = vec![(0, &self.results)];
        if let Some(table) = &self.table {
            buffers.push((1, table));
        }
        let groups = groups(self.plan.kernel, invocations);
        let mut total = Timing {
            device_ns: Some(0.0),
            host_ns: 0.0,
        };
        for pipeline in &self.pipelines {
            let timing = self.device.run(pipeline, &buffers, &push.bytes(), groups)?;
            total.host_ns += timing.host_ns;
            total.device_ns = total.device_ns.zip(timing.device_ns).map(|(a, b)| a + b);
        }
        Ok(total)
    }

    /// Brings the chunk nearer to what the device makes in a tenth of a second, after a
    /// dispatch of `points` took so long.
    pub fn adapt(&mut self, points: u64, timing: &Timing) {
        let spent = timing.device_ns.unwrap_or(timing.host_ns).max(1.0);
        // At most fourfold at a time; whole tiles.
        let ideal = points as f64 * (TARGET_NS / spent).min(4.0);
        let tile = u64::from(self.plan.tile.max(4));
        let chunk = (ideal as u64 / tile * tile).max(tile);
        self.chunk = chunk.min(self.limit);
    }

    /// The first `points` rows of the last dispatch.
    ///
    /// # Errors
    /// Those of the device.
    pub fn read<R>(&mut self, points: u64, take: impl FnOnce(&[u32]) -> R) -> Result<R> {
        let bytes = 4 * points * u64::from(self.request.words_per_point());
        self.results
            .read(0, bytes, |bytes| match bytemuck::try_cast_slice(bytes) {
                Ok(words) => take(words),
                // A mapping is aligned to 64 bytes at least; a copy serves any other.
                Err(_) => take(&bytemuck::pod_collect_to_vec(bytes)),
            })
    }
}

fn work<'a>(device: &Device, request: &'a Request) -> Work<'a> {
    Work {
        columns: &request.columns,
        points: request.count,
        fractions: request.output == Output::Fractions,
        map: request.map.map(|map| (map.id, request.with_pdf)),
        native: request.profile == Profile::Native,
        cpu: device.info().kind == DeviceKind::Cpu,
    }
}

impl Engine for Generator {
    fn make(
        &mut self,
        start: u64,
        count: u64,
        take: &mut dyn FnMut(&[u32]) -> Result<()>,
    ) -> Result<()> {
        let mut done = 0;
        while done < count {
            let points = (count - done).min(self.chunk);
            let timing = self.dispatch(start + done, points)?;
            self.read(points, &mut *take)??;
            done += points;
            self.adapt(points, &timing);
        }
        Ok(())
    }

    fn chunk(&self) -> u64 {
        self.chunk
    }
}
