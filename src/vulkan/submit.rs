//! Submissions: record, submit, wait within bounds, read the clock.

use ash::vk;
use std::sync::PoisonError;
use std::sync::atomic::Ordering;

use super::device::Device;
use super::info::DeviceKind;
use super::{MAX_BATCH, MAX_BINDINGS, descriptor, dispatch, failed};
use crate::error::{Error, Result};

/// The objects that one submission at a time uses again and again.
#[derive(Default)]
pub(super) struct Lane {
    pool: vk::CommandPool,
    commands: vk::CommandBuffer,
    fence: vk::Fence,
    /// Null where the queue has no timestamps; else two for each of [`MAX_BATCH`] dispatches.
    queries: vk::QueryPool,
    /// Room for [`MAX_BATCH`] sets of [`MAX_BINDINGS`] buffers.
    pub(super) descriptors: vk::DescriptorPool,
    /// Whether a barrier ends all that was recorded before it, as on CPUs.
    in_order: bool,
    /// Submitted, and not seen to end.
    pending: bool,
}

/// An end of what is timed.
#[derive(Clone, Copy)]
pub(super) enum Edge {
    Begin,
    End,
}

impl Lane {
    pub(super) fn new(device: &Device) -> Result<Self> {
        let mut lane = Self::default();
        match lane.create(device) {
            Ok(()) => Ok(lane),
            Err(error) => {
                lane.destroy(device.raw());
                Err(error)
            }
        }
    }

    fn create(&mut self, device: &Device) -> Result<()> {
        let raw = device.raw();
        self.in_order = device.info().kind == DeviceKind::Cpu;
        let pool = vk::CommandPoolCreateInfo::default()
            .flags(vk::CommandPoolCreateFlags::TRANSIENT)
            .queue_family_index(device.queue_family());
        // SAFETY: the device is alive and has a queue of this family.
        self.pool = unsafe { raw.create_command_pool(&pool, None) }
            .map_err(failed("vkCreateCommandPool"))?;
        let commands = vk::CommandBufferAllocateInfo::default()
            .command_pool(self.pool)
            .command_buffer_count(1);
        // SAFETY: the pool was just made.
        self.commands = unsafe { raw.allocate_command_buffers(&commands) }
            .map_err(failed("vkAllocateCommandBuffers"))?
            .first()
            .copied()
            .unwrap_or_default();
        // SAFETY: the device is alive.
        self.fence = unsafe { raw.create_fence(&vk::FenceCreateInfo::default(), None) }
            .map_err(failed("vkCreateFence"))?;
        if device.info().limits.timestamp_valid_bits > 0 {
            let queries = vk::QueryPoolCreateInfo::default()
                .query_type(vk::QueryType::TIMESTAMP)
                .query_count(2 * MAX_BATCH as u32);
            // SAFETY: the device is alive, and its queue has timestamps.
            self.queries = unsafe { raw.create_query_pool(&queries, None) }
                .map_err(failed("vkCreateQueryPool"))?;
        }
        let sizes = descriptor::pool_sizes((MAX_BATCH * MAX_BINDINGS) as u32);
        let descriptors = vk::DescriptorPoolCreateInfo::default()
            .max_sets(MAX_BATCH as u32)
            .pool_sizes(&sizes);
        // SAFETY: the device is alive.
        self.descriptors = unsafe { raw.create_descriptor_pool(&descriptors, None) }
            .map_err(failed("vkCreateDescriptorPool"))?;
        Ok(())
    }

    /// Destroys all of it; whatever was not made is null, which is allowed.
    pub(super) fn destroy(self, raw: &ash::Device) {
        // SAFETY: the objects are of this device, and nothing is pending: a device
        // with pending work is never destroyed.
        unsafe {
            raw.destroy_descriptor_pool(self.descriptors, None);
            raw.destroy_query_pool(self.queries, None);
            raw.destroy_fence(self.fence, None);
            raw.destroy_command_pool(self.pool, None);
        }
    }

    /// Reads the clock before or after dispatch number `span`, where there is one.
    ///
    /// # Safety
    /// `commands` is the lane's, recording, `span` is one of those that the submission
    /// was said to have, and before the beginning of any but the first stands a
    /// barrier of all stages.
    pub(super) unsafe fn stamp(
        &self,
        raw: &ash::Device,
        commands: vk::CommandBuffer,
        span: usize,
        end: Edge,
    ) {
        // Once all that was recorded before has ended, which on GPUs the top of the pipe may not
        // wait for. On CPUs a barrier has seen to that, and the top saves llvmpipe a flush, which is
        // most of what lies between two short dispatches.
        let stage = match (end, span) {
            (Edge::Begin, 1..) if self.in_order => vk::PipelineStageFlags::TOP_OF_PIPE,
            _ => vk::PipelineStageFlags::BOTTOM_OF_PIPE,
        };
        let query = 2 * span as u32 + end as u32;
        if self.queries != vk::QueryPool::null() {
            // SAFETY: the caller's, and the queries were reset in these commands.
            unsafe {
                raw.cmd_write_timestamp(commands, stage, self.queries, query);
            }
        }
    }

    /// Waits for the fence within bounds.
    fn wait(&mut self, device: &Device) -> Result<()> {
        let (ended, waited) = device.await_fence(self.fence);
        self.pending = !ended;
        let hung = device.hung.swap(self.pending, Ordering::AcqRel);
        if hung && !self.pending {
            device.destroy_orphans();
        }
        waited
    }
}

impl Device {
    /// Waits for a fence of this device within bounds. Says whether its work has ended, too.
    pub(super) fn await_fence(&self, fence: vk::Fence) -> (bool, Result<()>) {
        let limit = self.wait_limit();
        let bound = u64::try_from(limit.as_nanos()).unwrap_or(u64::MAX);
        // SAFETY: the fence is of this device.
        let waited = unsafe { self.raw().wait_for_fences(&[fence], true, bound) };
        // A lost device has ended everything. Any other failure says nothing of the work.
        let ended = matches!(waited, Ok(()) | Err(vk::Result::ERROR_DEVICE_LOST));
        let waited = waited.map_err(|code| match code {
            vk::Result::TIMEOUT => Error::Timeout {
                call: "vkWaitForFences",
                seconds: limit.as_secs_f64(),
            },
            code => self.heard("vkWaitForFences", code),
        });
        (ended, waited)
    }

    /// Hands commands to the queue, with a fence that is not signalled.
    ///
    /// # Safety
    /// The commands are of this device and complete. They and all that they use live until the
    /// fence signals.
    pub(super) unsafe fn hand_over(
        &self,
        commands: vk::CommandBuffer,
        fence: vk::Fence,
    ) -> Result<()> {
        let buffers = [commands];
        let submission = [vk::SubmitInfo::default().command_buffers(&buffers)];
        let one = self.handing_over.lock();
        let _one = one.unwrap_or_else(PoisonError::into_inner);
        // SAFETY: the caller vouches for the handles; the lock keeps others from the queue.
        unsafe { self.raw().queue_submit(self.queue(), &submission, fence) }
            .map_err(|code| self.heard("vkQueueSubmit", code))
    }

    /// Waits again for work that an earlier wait gave up on. An error too where the device
    /// was lost, since then no memory holds what it should.
    pub(super) fn settle(&self) -> Result<()> {
        self.check_alive()?;
        self.free_stranded();
        if !self.is_hung() {
            return Ok(());
        }
        let mut lane = self.lane.lock().unwrap_or_else(PoisonError::into_inner);
        if lane.pending {
            lane.wait(self)
        } else {
            Ok(())
        }
    }

    /// Records with `fill`, submits and waits. Returns the device's nanoseconds between both
    /// ends of each of so many spans, which `fill` marks by [`Lane::stamp`]; `None` where the
    /// device cannot tell.
    pub(super) fn submit(
        &self,
        spans: usize,
        fill: impl FnOnce(&Lane, vk::CommandBuffer) -> Result<()>,
    ) -> Result<Vec<Option<f64>>> {
        let mut lane = self.lane.lock().unwrap_or_else(PoisonError::into_inner);
        self.check_alive()?;
        self.free_stranded();
        if lane.pending {
            lane.wait(self)?;
        }
        let (raw, commands, queries) = (self.raw(), lane.commands, lane.queries);
        let timed = spans > 0 && queries != vk::QueryPool::null();
        let begin = vk::CommandBufferBeginInfo::default()
            .flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
        // SAFETY: nothing of the lane is pending, the lock keeps others away, and
        // the queries are reset before they are written.
        unsafe {
            raw.reset_command_pool(lane.pool, vk::CommandPoolResetFlags::empty())
                .map_err(failed("vkResetCommandPool"))?;
            raw.begin_command_buffer(commands, &begin)
                .map_err(failed("vkBeginCommandBuffer"))?;
            if timed {
                raw.cmd_reset_query_pool(commands, queries, 0, 2 * spans as u32);
            }
        }
        fill(&lane, commands)?;
        // SAFETY: as above; the command buffer is recording.
        unsafe {
            dispatch::barrier(self, commands);
            raw.end_command_buffer(commands)
                .map_err(failed("vkEndCommandBuffer"))?;
            // Here, and not after the wait: with a fence that is still signalled from an
            // earlier submission the wait would end before the work does.
            raw.reset_fences(&[lane.fence])
                .map_err(failed("vkResetFences"))?;
            self.hand_over(commands, lane.fence)?;
        }
        lane.pending = true;
        lane.wait(self)?;
        match timed {
            true => self.elapsed(queries, spans),
            false => Ok(vec![None; spans]),
        }
    }

    /// Nanoseconds between both timestamps of each span; `None` where they cannot be read.
    fn elapsed(&self, queries: vk::QueryPool, spans: usize) -> Result<Vec<Option<f64>>> {
        let mut ticks = vec![[0u64; 2]; spans];
        // SAFETY: the pool holds so many queries, and the submission that wrote them
        // has ended.
        let read = unsafe {
            self.raw().get_query_pool_results(
                queries,
                0,
                ticks.as_flattened_mut(),
                vk::QueryResultFlags::TYPE_64,
            )
        };
        match read {
            Ok(()) => {}
            Err(code @ vk::Result::ERROR_DEVICE_LOST) => {
                return Err(self.heard("vkGetQueryPoolResults", code));
            }
            Err(_) => return Ok(vec![None; spans]),
        }
        let limits = &self.info().limits;
        let nanoseconds = |[begin, end]: [u64; 2]| {
            let ticks = tick_difference(begin, end, limits.timestamp_valid_bits);
            Some(ticks as f64 * f64::from(limits.timestamp_period_ns))
        };
        Ok(ticks.into_iter().map(nanoseconds).collect())
    }
}

/// `end - begin` of a counter that wraps at `valid_bits`.
fn tick_difference(begin: u64, end: u64, valid_bits: u32) -> u64 {
    let mask = u64::MAX >> 64u32.saturating_sub(valid_bits).min(63);
    end.wrapping_sub(begin) & mask
}

#[cfg(test)]
mod tests {
    use super::tick_difference;

    #[test]
    fn the_clock_may_wrap() {
        assert_eq!(tick_difference(10, 25, 64), 15);
        assert_eq!(tick_difference(u64::MAX, 4, 64), 5);
        assert_eq!(tick_difference((1 << 36) - 1, 4, 36), 5);
        assert_eq!(tick_difference(3 | (7 << 36), 9, 36), 6);
    }
}
