//! Commands, with all that they use.

use ash::vk;
use std::fmt;
use std::sync::Arc;

use super::descriptor::{self, DescriptorSet};
use super::device::Device;
use super::dispatch;
use super::pipeline::Pipeline;
use super::slice::BufferSlice;
use super::submission::{Submission, Work};
use super::{failed, refused};
use crate::error::Result;

/// A command buffer that is being recorded, and what its commands use, which it keeps alive.
///
/// All that is recorded runs in order, and ends with a barrier: from writes of compute shaders
/// and copies to reads and writes of both, and to reads of the host.
pub struct Recording {
    device: Arc<Device>,
    commands: vk::CommandBuffer,
    /// The pool of commands of our own; null for the caller's.
    pool: vk::CommandPool,
    kept: Kept,
}

/// What commands use.
#[derive(Default)]
pub(super) struct Kept {
    sets: Vec<DescriptorSet>,
    pipelines: Vec<Arc<Pipeline>>,
    slices: Vec<BufferSlice>,
}

impl Recording {
    /// Begins commands of its own, for [`Self::submit`]. Several may be begun and submitted at
    /// a time.
    ///
    /// # Errors
    /// [`Error::Vulkan`](crate::Error::Vulkan) when the driver fails.
    pub fn new(device: &Arc<Device>) -> Result<Self> {
        let mut recording = Self {
            device: Arc::clone(device),
            commands: vk::CommandBuffer::null(),
            pool: vk::CommandPool::null(),
            kept: Kept::default(),
        };
        let raw = device.raw();
        let pool = vk::CommandPoolCreateInfo::default()
            .flags(vk::CommandPoolCreateFlags::TRANSIENT)
            .queue_family_index(device.queue_family());
        // SAFETY: the device is alive and has a queue of this family. On an error below,
        // dropping `recording` destroys the pool.
        recording.pool = unsafe { raw.create_command_pool(&pool, None) }
            .map_err(failed("vkCreateCommandPool"))?;
        let commands = vk::CommandBufferAllocateInfo::default()
            .command_pool(recording.pool)
            .command_buffer_count(1);
        let begin = vk::CommandBufferBeginInfo::default()
            .flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
        // SAFETY: the pool was just made, and so are the commands.
        unsafe {
            recording.commands = raw
                .allocate_command_buffers(&commands)
                .map_err(failed("vkAllocateCommandBuffers"))?
                .first()
                .copied()
                .unwrap_or_default();
            raw.begin_command_buffer(recording.commands, &begin)
                .map_err(failed("vkBeginCommandBuffer"))?;
        }
        Ok(recording)
    }

    /// Records into a command buffer of the caller's, who ends and submits it. Barriers of the
    /// caller's order it with uses of the same buffers before, and with readers other than
    /// compute shaders, copies and the host after: from `COMPUTE_SHADER` and `TRANSFER`,
    /// `SHADER_WRITE` and `TRANSFER_WRITE`.
    ///
    /// # Safety
    /// - `commands` is a command buffer of `device`, in the recording state and outside a render
    ///   pass, while anything is recorded.
    /// - It runs on [`Device::queue`], or ordered by semaphores with all that runs there. A
    ///   queue of another family must be able to compute.
    /// - The recording is dropped after the commands have ended for the last time, or will
    ///   never run (again).
    pub unsafe fn of(device: &Arc<Device>, commands: vk::CommandBuffer) -> Self {
        Self {
            device: Arc::clone(device),
            commands,
            pool: vk::CommandPool::null(),
            kept: Kept::default(),
        }
    }

    /// The device.
    #[must_use]
    pub fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// Hands the commands to the queue and returns at once, where no other thread is doing the
    /// same. Work of one device runs in the order in which it was submitted.
    ///
    /// # Errors
    /// [`Error::Arguments`](crate::Error::Arguments) for commands of the caller's; those of the
    /// device, and then nothing runs.
    pub fn submit(mut self) -> Result<Submission> {
        if self.pool == vk::CommandPool::null() {
            return Err(refused(
                "to submit commands of the caller's",
                "whoever began them ends and submits them",
                "use `Recording::new`, or vkQueueSubmit",
            ));
        }
        self.device.settle()?;
        let raw = self.device.raw();
        // SAFETY: the commands are recording; the device is alive.
        let fence = unsafe {
            raw.end_command_buffer(self.commands)
                .map_err(failed("vkEndCommandBuffer"))?;
            raw.create_fence(&vk::FenceCreateInfo::default(), None)
                .map_err(failed("vkCreateFence"))?
        };
        let work = Work {
            pool: std::mem::take(&mut self.pool),
            fence,
            kept: std::mem::take(&mut self.kept),
        };
        // SAFETY: the commands are complete, and `work` has all that they use until the fence
        // has signalled.
        match unsafe { self.device.hand_over(self.commands, fence) } {
            Ok(()) => Ok(Submission::new(Arc::clone(&self.device), work)),
            Err(error) => {
                work.destroy(raw);
                Err(error)
            }
        }
    }

    /// Records `groups` workgroups, and a barrier.
    pub(crate) fn dispatch(
        &mut self,
        pipeline: &Arc<Pipeline>,
        slices: &[(u32, BufferSlice)],
        push: &[u8],
        groups: u64,
    ) -> Result<()> {
        for (_, slice) in slices {
            self.check(slice)?;
        }
        descriptor::check_owner(&self.device, pipeline, &[])?;
        let ranges: Vec<_> = slices
            .iter()
            .map(|(binding, slice)| (*binding, slice.raw, slice.offset, slice.bytes()))
            .collect();
        let set = DescriptorSet::build(&self.device, pipeline, &ranges)?;
        // SAFETY: the commands are recording, ours or as the caller has promised; set, pipeline
        // and slices are kept until they have ended.
        unsafe {
            dispatch::record(&self.device, self.commands, pipeline, &set, push, groups)?;
            dispatch::barrier(&self.device, self.commands);
        }
        self.kept.sets.push(set);
        self.kept.pipelines.push(Arc::clone(pipeline));
        let slices = slices.iter().map(|(_, slice)| slice.clone());
        self.kept.slices.extend(slices);
        Ok(())
    }

    /// Records a copy of all of a slice to the start of another of as many bytes or more, and a
    /// barrier.
    pub(crate) fn copy(&mut self, from: &BufferSlice, to: &BufferSlice) -> Result<()> {
        self.check(from)?;
        self.check(to)?;
        let region = [vk::BufferCopy {
            src_offset: from.offset,
            dst_offset: to.offset,
            size: from.bytes().min(to.bytes()),
        }];
        // SAFETY: as in `dispatch`; the ranges lie within both.
        unsafe {
            let raw = self.device.raw();
            raw.cmd_copy_buffer(self.commands, from.raw, to.raw, &region);
            dispatch::barrier(&self.device, self.commands);
        }
        self.kept.slices.extend([from.clone(), to.clone()]);
        Ok(())
    }

    /// The slice must be of this very device.
    pub(crate) fn check(&self, slice: &BufferSlice) -> Result<()> {
        if Arc::ptr_eq(slice.device(), &self.device) {
            return Ok(());
        }
        Err(refused(
            format!("a buffer of device {}", slice.device().info().name),
            format!("the commands are of another, {}", self.device.info().name),
            "make both on one device",
        ))
    }
}

impl Drop for Recording {
    fn drop(&mut self) {
        // SAFETY: the commands of the pool were not submitted; null is allowed.
        unsafe { self.device.raw().destroy_command_pool(self.pool, None) };
    }
}

impl fmt::Debug for Recording {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Recording")
            .field("commands", &self.commands)
            .finish_non_exhaustive()
    }
}
