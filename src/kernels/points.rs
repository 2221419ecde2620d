//! Points of a request in a buffer on the device, chunk by chunk.

use super::way::Way;
use super::{groups, spirv};
use crate::Result;
use crate::catalog::{Output, Profile, Request};
use crate::interface::WorkPush;
use crate::variant::{FusedMap, LONGEST_RUN, Plan, Work, general, plan};
use crate::vulkan::{Access, Buffer, BufferSlice, Device, DeviceKind, Recording, Timing};
use std::sync::Arc;

/// Bytes of a result buffer at most: well below the 128 MiB that the smallest drivers
/// allow, and a multiple of every tile.
pub(super) const BUFFER_BYTES: u64 = 64 << 20;

/// The kernel of a request and the buffer that it fills.
pub(super) struct Points {
    request: Request,
    way: Arc<Way>,
    /// For points from an index on that `way` does not allow; made at first use.
    unaligned: Option<Arc<Way>>,
    results: Buffer,
    /// Of recorded work: whole invocations, of which a copy takes what is asked.
    tail: Option<Buffer>,
    device: Arc<Device>,
    limit: u64,
}

impl Points {
    /// `access` says whether the host will read the results; `most` is a limit of points
    /// besides that of the buffer.
    pub(super) fn new(
        device: &Arc<Device>,
        request: &Request,
        plan: Plan,
        words: &[u32],
        access: Access,
        most: u64,
    ) -> Result<Self> {
        let point_bytes = 4 * u64::from(request.words_per_point());
        // Whole invocations: a tile each, or four words. Those of shorter tiles may end past
        // whole ones of the longest.
        let unit = u64::from(plan.tile.max(4)) * point_bytes;
        let most = BUFFER_BYTES.min(most * point_bytes) / unit * unit;
        let wanted = (request.count * point_bytes).next_multiple_of(unit);
        let bytes = wanted.min(most.max(unit));
        let even = plan.tiles.iter().all(|tile| *tile == plan.tile);
        let spare = match plan.aligned {
            // For the kernel of points that begin elsewhere.
            2.. => u64::from(LONGEST_RUN) * point_bytes,
            _ if even => 0,
            _ => unit,
        };
        let results = Buffer::new(device, bytes + spare, access)?;
        Ok(Self {
            request: request.clone(),
            way: Arc::new(Way::new(device, plan, words)?),
            unaligned: None,
            results,
            tail: None,
            device: Arc::clone(device),
            limit: bytes / point_bytes,
        })
    }

    /// The kernel that runs.
    pub(super) fn kernel_name(&self) -> &'static str {
        self.way.plan.kernel.name
    }

    /// Points that one dispatch can make.
    pub(super) fn limit(&self) -> u64 {
        self.limit
    }

    /// Points that an invocation makes, or four words.
    pub(super) fn tile(&self) -> u64 {
        u64::from(self.way.plan.tile.max(4))
    }

    /// The device.
    pub(super) fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// The buffer.
    pub(super) fn results(&mut self) -> &mut Buffer {
        &mut self.results
    }

    /// Makes up to [`Self::limit`] points, `start` counted from the request's first.
    pub(super) fn dispatch(&mut self, start: u64, points: u64) -> Result<Timing> {
        let way = self.way(start)?;
        let buffers: Vec<_> = std::iter::once((0, &self.results))
            .chain(way.table.iter().map(|table| (1, table)))
            .collect();
        let mut total = Timing {
            device_ns: Some(0.0),
            host_ns: 0.0,
        };
        for (pipeline, unit) in way.parts() {
            let (push, groups) = self.call(&way, start, self.invocations(points, unit));
            add(
                &mut total,
                self.device.run(pipeline, &buffers, &push, groups)?,
            );
        }
        Ok(total)
    }

    /// Records the same, into the buffer.
    pub(super) fn record(
        &mut self,
        recording: &mut Recording,
        start: u64,
        points: u64,
    ) -> Result<BufferSlice> {
        let way = self.way(start)?;
        let results = self.results.whole();
        for (pipeline, unit) in way.parts() {
            let call = self.call(&way, start, self.invocations(points, unit));
            way.record(recording, pipeline, &results, call)?;
        }
        Ok(results)
    }

    /// Records the same, into all of a slice and nothing besides: whole invocations there, and
    /// the points that these leave over by way of a copy.
    pub(super) fn record_into(
        &mut self,
        recording: &mut Recording,
        start: u64,
        points: u64,
        target: &BufferSlice,
    ) -> Result<()> {
        let way = self.way(start)?;
        let mut whole = points;
        for (pipeline, unit) in way.parts() {
            let invocations = self.work(points, unit) / unit.unwrap_or(4);
            whole = whole.min(match unit {
                Some(tile) => invocations * tile,
                None => 4 * invocations / self.width(),
            });
            let call = self.call(&way, start, invocations as u32);
            way.record(recording, pipeline, target, call)?;
        }
        let left = points - whole;
        if left == 0 {
            return Ok(());
        }
        let row = 4 * self.width();
        // Fewer than a tile are left, and invocations end within the next.
        let tile = match self.way.plan.aligned {
            2.. => u64::from(LONGEST_RUN),
            _ => self.tile(),
        };
        let bytes = 2 * tile * row;
        let tail = tail(&mut self.tail, &self.device, bytes)?;
        for (pipeline, unit) in way.parts() {
            let call = self.call(&way, start + whole, self.invocations(left, unit));
            way.record(recording, pipeline, &tail, call)?;
        }
        recording.copy(
            &tail.part(0, left * row),
            &target.part(whole * row, left * row),
        )
    }

    /// How to make points from `start` on: where the kernel does not allow that index, by that of
    /// devices without 64-bit integers.
    fn way(&mut self, start: u64) -> Result<Arc<Way>> {
        let first = self.request.first + start;
        if first.is_multiple_of(self.way.plan.aligned.into()) {
            return Ok(Arc::clone(&self.way));
        }
        if let Some(way) = &self.unaligned {
            return Ok(Arc::clone(way));
        }
        let plan = plan(&Work {
            int64: false,
            ..work(&self.device, &self.request)
        });
        let words = module(&plan)?;
        let way = Arc::new(Way::new(&self.device, plan, &words)?);
        Ok(Arc::clone(self.unaligned.insert(way)))
    }

    /// Invocations that make so many points, the last of them perhaps more.
    fn invocations(&self, points: u64, unit: Option<u64>) -> u32 {
        // They fit: first + count <= 2^32.
        self.work(points, unit).div_ceil(unit.unwrap_or(4)) as u32
    }

    /// What invocations divide: points, or their words.
    fn work(&self, points: u64, unit: Option<u64>) -> u64 {
        match unit {
            Some(_) => points,
            None => points * self.width(),
        }
    }

    /// Push constants and groups.
    fn call(&self, way: &Way, start: u64, invocations: u32) -> (Vec<u8>, u64) {
        let push = WorkPush {
            first: (self.request.first + start) as u32,
            invocations,
            stride: 1,
        };
        (push.bytes(), groups(way.plan.kernel, invocations))
    }

    fn width(&self) -> u64 {
        self.request.words_per_point().into()
    }
}

/// The buffer for what whole invocations leave over, made at first use.
pub(super) fn tail(
    kept: &mut Option<Buffer>,
    device: &Arc<Device>,
    bytes: u64,
) -> Result<BufferSlice> {
    let tail = match kept {
        Some(tail) => tail,
        none => none.insert(Buffer::new(device, bytes, Access::DeviceOnly)?),
    };
    Ok(tail.whole())
}

/// Adds the time of a further dispatch.
pub(super) fn add(total: &mut Timing, timing: Timing) {
    total.host_ns += timing.host_ns;
    total.device_ns = total.device_ns.zip(timing.device_ns).map(|(a, b)| a + b);
}

/// A buffer of these words.
pub(super) fn table(device: &Arc<Device>, words: &[u32]) -> Result<Buffer> {
    let bytes: &[u8] = bytemuck::cast_slice(words);
    let mut table = Buffer::new(device, bytes.len() as u64, Access::Upload)?;
    table.write(0, bytes)?;
    Ok(table)
}

/// The kernel for a request on a device.
pub(super) fn choose(device: &Device, request: &Request, choice: Choice) -> Plan {
    let work = work(device, request);
    match choice {
        Choice::General if work.map.is_none() => general(&work),
        Choice::WithoutInt64 => plan(&Work {
            int64: false,
            ..work
        }),
        _ => plan(&work),
    }
}

/// Which kernel makes the points.
#[derive(Clone, Copy)]
pub(super) enum Choice {
    /// The fastest.
    Usual,
    /// The general one, if there is no map.
    General,
    /// The fastest of those that need no 64-bit integers.
    WithoutInt64,
}

/// A request on a device in plain words.
fn work<'a>(device: &Device, request: &'a Request) -> Work<'a> {
    Work {
        columns: &request.columns,
        first: request.first,
        points: request.count,
        fractions: request.output == Output::Fractions,
        map: request.map.as_ref().map(|mapping| FusedMap {
            id: mapping.map().id,
            coordinates: mapping.map().coordinates,
            with_pdf: request.with_pdf,
        }),
        native: request.profile == Profile::Native,
        cpu: device.info().kind == DeviceKind::Cpu,
        int64: device.has_int64(),
    }
}

/// The points of a request whose map has a kernel of its own: their fractions.
pub(super) fn fractions(request: &Request) -> Request {
    let mut points = request.clone();
    points.map = None;
    points.with_pdf = false;
    points.output = Output::Fractions;
    points
}

/// The SPIR-V of a plan.
pub(super) fn module(plan: &Plan) -> Result<Vec<u32>> {
    spirv(plan.kernel.name)
}
