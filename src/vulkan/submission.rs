//! Work that was submitted and is not waited for at once.

use ash::vk;
use std::fmt;
use std::sync::{Arc, PoisonError};

use super::device::Device;
use super::recording::Kept;
use crate::error::Result;

/// Work in flight, with all that it uses. Any number may be in flight at a time.
///
/// Dropping it waits as [`Self::wait`] does. Where that wait ends before the work, what the work
/// uses is freed once it has ended and the device is used again; if the device is not, all of it
/// is left to the end of the process.
#[must_use = "dropping it waits for the work"]
pub struct Submission {
    device: Arc<Device>,
    work: Work,
    ended: bool,
}

/// The objects of one submission; null handles where there are none.
#[derive(Default)]
pub(super) struct Work {
    pub(super) pool: vk::CommandPool,
    pub(super) fence: vk::Fence,
    pub(super) kept: Kept,
}

/// Work of a submission that was dropped before it ended. It holds its device, so that this is
/// not destroyed under it.
pub(super) struct Stranded {
    _device: Arc<Device>,
    work: Work,
}

impl Work {
    /// Destroys all of it; nothing of it may be running.
    pub(super) fn destroy(self, raw: &ash::Device) {
        // SAFETY: the objects are of this device, and what was submitted has ended. Null
        // handles are allowed.
        unsafe {
            raw.destroy_fence(self.fence, None);
            raw.destroy_command_pool(self.pool, None);
        }
    }
}

impl Submission {
    pub(super) fn new(device: Arc<Device>, work: Work) -> Self {
        Self {
            device,
            work,
            ended: false,
        }
    }

    /// Whether the work has ended, without a wait. Once it has, what it used is free: a
    /// [`Buffer`](super::Buffer) can be read.
    ///
    /// # Errors
    /// [`Error::Vulkan`](crate::Error::Vulkan) when the device was lost, or cannot tell.
    pub fn is_done(&mut self) -> Result<bool> {
        if !self.ended {
            // SAFETY: the fence is of this device, and alive.
            let status = unsafe { self.device.raw().get_fence_status(self.work.fence) };
            match status {
                Ok(done) => self.end(done),
                Err(code) => {
                    // A lost device has ended everything.
                    self.end(code == vk::Result::ERROR_DEVICE_LOST);
                    return Err(self.device.heard("vkGetFenceStatus", code));
                }
            }
        }
        self.device.check_alive()?;
        Ok(self.ended)
    }

    /// Waits for the work to end. Once it has, what it used is free, and waiting again is too.
    ///
    /// # Errors
    /// [`Error::Timeout`](crate::Error::Timeout) past [`Device::wait_limit`], after which it can
    /// be waited for again; [`Error::Vulkan`](crate::Error::Vulkan) when the device was lost, or
    /// the wait fails.
    pub fn wait(&mut self) -> Result<()> {
        if !self.ended {
            let (ended, waited) = self.device.await_fence(self.work.fence);
            self.end(ended);
            waited?;
        }
        self.device.check_alive()
    }

    /// The fence, which signals once the work has ended: for vkWaitForFences, alone or among
    /// others. It lives as long as the submission; do not reset, submit or destroy it.
    #[must_use]
    pub fn fence(&self) -> vk::Fence {
        self.work.fence
    }

    fn end(&mut self, ended: bool) {
        self.ended = ended;
        if ended {
            self.work.kept = Kept::default();
        }
    }
}

impl Drop for Submission {
    fn drop(&mut self) {
        // What fails here is known by `ended`.
        let _ = self.wait();
        let work = std::mem::take(&mut self.work);
        if self.ended {
            work.destroy(self.device.raw());
        } else {
            let stranded = self.device.stranded.lock();
            let mut stranded = stranded.unwrap_or_else(PoisonError::into_inner);
            stranded.push(Stranded {
                _device: Arc::clone(&self.device),
                work,
            });
        }
    }
}

impl Device {
    /// Destroys what dropped submissions left behind, of those that have ended meanwhile.
    pub(super) fn free_stranded(&self) {
        let mut stranded = self.stranded.lock().unwrap_or_else(PoisonError::into_inner);
        if stranded.is_empty() {
            return;
        }
        let has_ended = |one: &Stranded| {
            // SAFETY: the fence is of this device, and alive.
            let status = unsafe { self.raw().get_fence_status(one.work.fence) };
            matches!(status, Ok(true) | Err(vk::Result::ERROR_DEVICE_LOST))
        };
        let (ended, running) = std::mem::take(&mut *stranded)
            .into_iter()
            .partition(has_ended);
        *stranded = running;
        drop(stranded);
        for one in ended {
            one.work.destroy(self.raw());
        }
    }
}

impl fmt::Debug for Submission {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Submission")
            .field("ended", &self.ended)
            .finish_non_exhaustive()
    }
}
