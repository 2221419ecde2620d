//! Points of a request in a buffer on the device, chunk by chunk.

use super::{groups, pipeline, spirv};
use crate::Result;
use crate::catalog::{Output, Profile, Request};
use crate::interface::WorkPush;
use crate::variant::{FusedMap, Plan, Work, general, plan};
use crate::vulkan::{Access, Buffer, Device, DeviceKind, Pipeline, Timing};
use std::sync::Arc;

/// Bytes of a result buffer at most: well below the 128 MiB that the smallest drivers
/// allow, and a multiple of every tile.
pub(super) const BUFFER_BYTES: u64 = 64 << 20;

/// The kernel of a request and the buffer that it fills.
pub(super) struct Points {
    request: Request,
    plan: Plan,
    pipelines: Vec<Pipeline>,
    results: Buffer,
    table: Option<Buffer>,
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
        let pipelines = plan
            .specializations
            .iter()
            .map(|values| pipeline(device, plan.kernel, words, values))
            .collect::<Result<Vec<_>>>()?;
        let point_bytes = 4 * u64::from(request.words_per_point());
        // Whole invocations: a tile each, or four words. Those of shorter tiles may end past
        // whole ones of the longest.
        let unit = u64::from(plan.tile.max(4)) * point_bytes;
        let most = BUFFER_BYTES.min(most * point_bytes) / unit * unit;
        let wanted = (request.count * point_bytes).next_multiple_of(unit);
        let bytes = wanted.min(most.max(unit));
        let even = plan.tiles.iter().all(|tile| *tile == plan.tile);
        let spare = if even { 0 } else { unit };
        let results = Buffer::new(device, bytes + spare, access)?;
        let table = match &plan.table {
            Some(words) => Some(table(device, words)?),
            None => None,
        };
        Ok(Self {
            request: request.clone(),
            plan,
            pipelines,
            results,
            table,
            device: Arc::clone(device),
            limit: bytes / point_bytes,
        })
    }

    /// The kernel that runs.
    pub(super) fn kernel_name(&self) -> &'static str {
        self.plan.kernel.name
    }

    /// Points that one dispatch can make.
    pub(super) fn limit(&self) -> u64 {
        self.limit
    }

    /// Points that an invocation makes, or four words.
    pub(super) fn tile(&self) -> u64 {
        u64::from(self.plan.tile.max(4))
    }

    /// The buffer.
    pub(super) fn results(&mut self) -> &mut Buffer {
        &mut self.results
    }

    /// Makes up to [`Self::limit`] points, `start` counted from the request's first.
    pub(super) fn dispatch(&self, start: u64, points: u64) -> Result<Timing> {
        let words = points * u64::from(self.request.words_per_point());
        let mut buffers = vec![(0, &self.results)];
        if let Some(table) = &self.table {
            buffers.push((1, table));
        }
        let mut total = Timing {
            device_ns: Some(0.0),
            host_ns: 0.0,
        };
        let tiles = self.plan.tiles.iter().map(|tile| Some(u64::from(*tile)));
        for (pipeline, tile) in self.pipelines.iter().zip(tiles.chain([None])) {
            // They fit: first + count <= 2^32.
            let invocations = tile.map_or(words.div_ceil(4), |tile| points.div_ceil(tile)) as u32;
            let push = WorkPush {
                first: (self.request.first + start) as u32,
                invocations,
                stride: 1,
            };
            let groups = groups(self.plan.kernel, invocations);
            add(
                &mut total,
                self.device.run(pipeline, &buffers, &push.bytes(), groups)?,
            );
        }
        Ok(total)
    }
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
pub(super) fn choose(device: &Device, request: &Request, always_general: bool) -> Plan {
    let mapping = request.map.as_ref();
    let work = Work {
        columns: &request.columns,
        points: request.count,
        fractions: request.output == Output::Fractions,
        map: mapping.map(|mapping| FusedMap {
            id: mapping.map().id,
            coordinates: mapping.map().coordinates,
            with_pdf: request.with_pdf,
        }),
        native: request.profile == Profile::Native,
        cpu: device.info().kind == DeviceKind::Cpu,
    };
    if always_general && mapping.is_none() {
        general(&work)
    } else {
        plan(&work)
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
