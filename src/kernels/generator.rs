//! Points, or samples of a map over them, chunk by chunk.

mod file;
mod place;
mod record;

use super::Mapper;
use super::points::{BUFFER_BYTES, Choice, Points, add, choose, fractions, module};
use crate::catalog::{Engine, Request, check_points};
use crate::interface::task;
use crate::variant::Plan;
use crate::vulkan::{Access, Buffer, Device, Timing};
use crate::{Error, Result};
use std::sync::Arc;

/// Words of the first dispatch: short on the slowest device.
const FIRST_WORDS: u64 = 1 << 16;

/// A dispatch should take about this long: far below the 0.5 s after which desktops
/// take a driver for hung.
const TARGET_NS: f64 = 1e8;

/// Makes the points of a request on a device: into memory of the host by
/// [`fill`](Engine::fill), [`make`](Engine::make) or
/// [`Chunks`](crate::catalog::Chunks), and into buffers by [`Self::submit`], [`Self::record`] and,
/// as many as one likes, [`Self::place`]; into a file by [`Self::write_windows`].
pub struct Generator {
    width: u64,
    count: u64,
    points: Points,
    mapped: Option<Mapped>,
    limit: u64,
    chunk: u64,
}

/// A map that runs after the kernel of the points, and the buffer of its samples.
struct Mapped {
    mapper: Mapper,
    results: Buffer,
    /// Words of its input.
    taken: u64,
    /// Of recorded work: samples of which a copy takes what is asked.
    tail: Option<Buffer>,
}

impl Generator {
    /// Prepares a request: picks the kernels, compiles the pipelines, allocates.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Arc<Device>, request: &Request) -> Result<Self> {
        Self::choose(device, request, Choice::Usual)
    }

    /// The same with the kernel that a device without 64-bit integers gets.
    ///
    /// # Errors
    /// Those of the device.
    pub fn without_int64(device: &Arc<Device>, request: &Request) -> Result<Self> {
        Self::choose(device, request, Choice::WithoutInt64)
    }

    /// The same with the general kernel, which every other must equal. A request whose map
    /// is part of the kernel of its points has none; it gets its usual kernel.
    ///
    /// # Errors
    /// Those of the device.
    pub fn general(device: &Arc<Device>, request: &Request) -> Result<Self> {
        Self::choose(device, request, Choice::General)
    }

    fn choose(device: &Arc<Device>, request: &Request, choice: Choice) -> Result<Self> {
        let apart = request.map.as_ref().filter(|m| !m.map().group.fused());
        let Some(mapping) = apart else {
            let plan = choose(device, request, choice);
            let words = module(&plan)?;
            return Self::with_module(device, request, plan, &words);
        };
        let mapper = Mapper::new(
            device,
            mapping,
            request.with_pdf,
            request.profile,
            task::SAMPLE,
        )?;
        let width = u64::from(request.words_per_point());
        let inner = fractions(request);
        let plan = choose(device, &inner, choice);
        let words = module(&plan)?;
        let most = BUFFER_BYTES / (4 * width);
        let points = Points::new(device, &inner, plan, &words, Access::DeviceOnly, most)?;
        let results = Buffer::new(device, points.limit() * 4 * width, Access::Readback)?;
        let mapped = Mapped {
            mapper,
            results,
            taken: u64::from(inner.words_per_point()),
            tail: None,
        };
        Ok(Self::start(points, request, Some(mapped)))
    }

    /// A request that one kernel serves, with other SPIR-V of the same interface: how tests
    /// run broken kernels. Points at an index that the plan does not allow come from a stock
    /// kernel all the same.
    ///
    /// # Errors
    /// Those of the device.
    pub fn with_module(
        device: &Arc<Device>,
        request: &Request,
        plan: Plan,
        words: &[u32],
    ) -> Result<Self> {
        let points = Points::new(
            device,
            request,
            plan,
            words,
            Access::Readback,
            u64::MAX >> 8,
        )?;
        Ok(Self::start(points, request, None))
    }

    fn start(points: Points, request: &Request, mapped: Option<Mapped>) -> Self {
        let width = u64::from(request.words_per_point());
        let limit = points.limit().min(request.count);
        let first = (FIRST_WORDS / width).next_multiple_of(points.tile());
        Self {
            width,
            count: request.count,
            points,
            mapped,
            limit,
            chunk: first.min(limit),
        }
    }

    /// The device.
    #[must_use]
    pub fn device(&self) -> &Arc<Device> {
        self.points.device()
    }

    /// The kernel that makes the points.
    #[must_use]
    pub fn kernel_name(&self) -> &'static str {
        self.points.kernel_name()
    }

    /// Points that one dispatch can make.
    #[must_use]
    pub fn limit(&self) -> u64 {
        self.limit
    }

    /// What the last dispatch made, before a map that has a kernel of its own.
    #[must_use]
    pub fn results(&mut self) -> &Buffer {
        self.points.results()
    }

    /// Makes up to [`Self::limit`] points, `start` counted from the request's first; the
    /// results stay in the buffer. The time is that of all dispatches they take.
    ///
    /// # Errors
    /// [`Error::Arguments`] for points that the request does not have, and for more than the limit;
    /// those of the device.
    pub fn dispatch(&mut self, start: u64, points: u64) -> Result<Timing> {
        check_points(self.count, start, points)?;
        if points > self.limit {
            return Err(self.too_many(points));
        }
        let mut total = self.points.dispatch(start, points)?;
        if let Some(mapped) = &self.mapped {
            let input = self.points.results();
            add(
                &mut total,
                mapped.mapper.dispatch(input, &mapped.results, points)?,
            );
        }
        Ok(total)
    }

    fn too_many(&self, points: u64) -> Error {
        Error::Arguments {
            asked: format!("{points} points of {} bytes", 4 * self.width),
            limit: format!("{} are made at a time", self.limit),
            remedy: "ask several times".into(),
        }
    }

    /// Brings the chunk nearer to what the device makes in a tenth of a second, after a
    /// dispatch of `points` took so long.
    pub fn adapt(&mut self, points: u64, timing: &Timing) {
        let spent = timing.device_ns.unwrap_or(timing.host_ns).max(1.0);
        // At most fourfold at a time; whole tiles.
        let ideal = points as f64 * (TARGET_NS / spent).min(4.0);
        let tile = self.points.tile();
        let chunk = (ideal as u64 / tile * tile).max(tile);
        self.chunk = chunk.min(self.limit);
    }

    /// The first `points` rows of the last dispatch.
    ///
    /// # Errors
    /// Those of the device.
    pub fn read<R>(&mut self, points: u64, take: impl FnOnce(&[u32]) -> R) -> Result<R> {
        let results = match &mut self.mapped {
            Some(mapped) => &mut mapped.results,
            None => self.points.results(),
        };
        results.read(0, 4 * points * self.width, |bytes| {
            match bytemuck::try_cast_slice(bytes) {
                Ok(words) => take(words),
                // A mapping is aligned to 64 bytes at least; a copy serves any other.
                Err(_) => take(&bytemuck::pod_collect_to_vec(bytes)),
            }
        })
    }
}

impl Engine for Generator {
    fn count(&self) -> u64 {
        self.count
    }

    fn words_per_point(&self) -> u32 {
        self.width as u32
    }

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
