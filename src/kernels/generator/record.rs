//! Points into buffers, in commands of our own or of the caller's.

use super::super::points::tail;
use super::Generator;
use crate::catalog::check_points;
use crate::vulkan::{BufferSlice, Recording, Submission};
use crate::{Error, Result};

/// Points at a time of which the last are mapped aside: so many rows of input end where every
/// device can bind the next.
pub(super) const ASIDE: u64 = 64;

impl Generator {
    /// Hands the making of up to [`Self::limit`] points to the device, `start` counted from the
    /// request's first, and returns at once. They are written row after row from the start of
    /// `target` on, 4 bytes a word, and nothing else is. See [`Self::record`].
    ///
    /// ```no_run
    /// # use corput::{catalog::Request, kernels::Generator, vulkan::{Access, Buffer, Device}};
    /// # fn both(device: &std::sync::Arc<Device>, request: &Request) -> corput::Result<()> {
    /// let mut generator = Generator::new(device, request)?;
    /// let mut one = Buffer::new(device, 4096, Access::Readback)?;
    /// let mut two = Buffer::new(device, 4096, Access::Readback)?;
    /// // 512 points of two words each; both are in flight.
    /// let mut first = generator.submit(0, 512, &one.slice(0, 4096)?)?;
    /// let mut second = generator.submit(512, 512, &two.slice(0, 4096)?)?;
    /// first.wait()?;
    /// one.read(0, 4096, |bytes| println!("{bytes:?}"))?;
    /// second.wait()?;
    /// two.read(0, 4096, |bytes| println!("{bytes:?}"))?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::record`]; nothing runs then.
    pub fn submit(&mut self, start: u64, count: u64, target: &BufferSlice) -> Result<Submission> {
        let mut recording = Recording::new(self.points.device())?;
        self.record(&mut recording, start, count, target)?;
        recording.submit()
    }

    /// Records the same into commands, perhaps of the caller's. One dispatch makes all points, or
    /// one for every four columns of wide rows, or every 8 or 16; a map that has a kernel of its own takes another.
    /// `examples/own_buffer.rs` has commands and a buffer of its own.
    ///
    /// Whole invocations write `target`, and what they leave over, fewer points than one makes,
    /// comes by way of a copy. Several may be in flight: they share what lies between, in order.
    ///
    /// Where the device also draws a desktop, [`Engine::chunk`](crate::catalog::Engine::chunk) points at a time are enough.
    ///
    /// # Errors
    /// [`Error::ZeroCount`]; [`Error::Arguments`] for points that the request does not have, more
    /// than the limit, fewer bytes than they take, or objects of another device: nothing is
    /// recorded then. Those of the device, after which the commands are not to be run.
    pub fn record(
        &mut self,
        recording: &mut Recording,
        start: u64,
        count: u64,
        target: &BufferSlice,
    ) -> Result<()> {
        let row = 4 * self.width;
        self.check(start, count, row, target)?;
        recording.check(target)?;
        recording.check(&self.points.results().whole())?;
        let target = target.part(0, count * row);
        let Some(mapped) = &mut self.mapped else {
            return self.points.record_into(recording, start, count, &target);
        };
        let input = self.points.record(recording, start, count)?;
        let whole = if count.is_multiple_of(4) {
            count
        } else {
            count / ASIDE * ASIDE
        };
        let mapper = &mapped.mapper;
        mapper.record(recording, &input, &target, (whole / 4) as u32)?;
        let left = count - whole;
        if left == 0 {
            return Ok(());
        }
        let device = self.points.device();
        let aside = tail(&mut mapped.tail, device, ASIDE * row)?;
        let skipped = 4 * mapped.taken * whole;
        let rest = input.part(skipped, input.bytes() - skipped);
        mapper.record(recording, &rest, &aside, left.div_ceil(4) as u32)?;
        let bytes = left * row;
        recording.copy(&aside.part(0, bytes), &target.part(whole * row, bytes))
    }

    fn check(&self, start: u64, count: u64, row: u64, target: &BufferSlice) -> Result<()> {
        if count == 0 {
            return Err(Error::ZeroCount {
                what: "the number of points",
            });
        }
        check_points(self.count, start, count)?;
        if count > self.limit {
            return Err(self.too_many(count));
        }
        check_room(count, row, target)
    }
}

/// That a slice is long enough for so many rows.
pub(super) fn check_room(count: u64, row: u64, target: &BufferSlice) -> Result<()> {
    if count
        .checked_mul(row)
        .is_some_and(|bytes| bytes <= target.bytes())
    {
        return Ok(());
    }
    Err(Error::Arguments {
        asked: format!("{count} points of {row} bytes"),
        limit: format!("the buffer's slice has {} bytes", target.bytes()),
        remedy: "give a larger one, or ask for fewer".into(),
    })
}
