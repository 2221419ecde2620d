//! Objects that were dropped while submitted work may still use them.

use ash::vk;
use std::sync::PoisonError;

use super::device::Device;
use super::kept::Compiled;
use super::mapping::Mapping;

/// What is destroyed once nothing that was submitted uses it any more; null handles where
/// nothing was made.
pub(super) enum Orphan {
    Block(vk::Buffer, vk::DeviceMemory, Option<Mapping>),
    Pipeline(Compiled),
    Descriptors(vk::DescriptorPool),
}

impl Orphan {
    fn destroy(self, device: &ash::Device) {
        // SAFETY: every submission was waited for, and no one else has these handles. Null
        // handles are allowed. Freeing memory unmaps it, destroying a pool frees its sets.
        unsafe {
            match self {
                Self::Block(buffer, memory, backing) => {
                    device.destroy_buffer(buffer, None);
                    device.free_memory(memory, None);
                    // Nothing of the device leads there any more.
                    drop(backing);
                }
                Self::Pipeline(compiled) => compiled.destroy(device),
                Self::Descriptors(pool) => device.destroy_descriptor_pool(pool, None),
            }
        }
    }
}

impl Device {
    /// Destroys an object, at once or, where a wait has ended before its work, later.
    pub(super) fn discard(&self, orphan: Orphan) {
        if self.is_hung() {
            let mut orphans = self.orphans.lock().unwrap_or_else(PoisonError::into_inner);
            orphans.push(orphan);
        } else {
            orphan.destroy(self.raw());
        }
    }

    /// Destroys what was kept; nothing submitted may be running.
    pub(super) fn destroy_orphans(&self) {
        let mut orphans = self.orphans.lock().unwrap_or_else(PoisonError::into_inner);
        for orphan in orphans.drain(..) {
            orphan.destroy(self.raw());
        }
    }
}
