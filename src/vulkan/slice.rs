//! A part of a storage buffer, of this module's or of the caller's.

use ash::vk;
use std::fmt;
use std::sync::Arc;

use super::buffer::Buffer;
use super::device::Device;
use super::file_window::FileWindow;
use super::memory::Block;
use super::refused;
use crate::error::Result;

/// A part of a storage buffer, for work that is recorded or submitted.
///
/// That of a [`Buffer`] keeps its memory alive, and keeps the host away from it: the buffer can
/// be read and written again once the slice and what was made of it have been dropped.
#[derive(Clone)]
pub struct BufferSlice {
    device: Arc<Device>,
    pub(super) raw: vk::Buffer,
    pub(super) offset: u64,
    bytes: u64,
    /// Null of a buffer of the caller's.
    _memory: Option<Arc<Block>>,
}

impl BufferSlice {
    /// `bytes` from byte `offset` on of a buffer that the caller owns. The offset is a multiple
    /// of `minStorageBufferOffsetAlignment` ([`Limits::storage_offset_alignment`], at most 256).
    ///
    /// # Errors
    /// [`Error::Arguments`] for no bytes, or for an offset that the device cannot bind.
    ///
    /// # Safety
    /// - The buffer is of `device`, has memory, and was made with `STORAGE_BUFFER` and
    ///   `TRANSFER_DST`; the range lies within it.
    /// - It lives until all work that was given the slice has ended.
    /// - Other work and the host use the range before or after that work, never during it.
    /// - A buffer of exclusive sharing belongs to the family of the queue that runs the work.
    ///
    /// [`Limits::storage_offset_alignment`]: super::Limits::storage_offset_alignment
    /// [`Error::Arguments`]: crate::Error::Arguments
    pub unsafe fn from_raw(
        device: &Arc<Device>,
        buffer: vk::Buffer,
        offset: u64,
        bytes: u64,
    ) -> Result<Self> {
        let slice = Self {
            device: Arc::clone(device),
            raw: buffer,
            offset,
            bytes,
            _memory: None,
        };
        slice.checked()
    }

    /// Bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// The device.
    #[must_use]
    pub fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// The same, if it can be bound.
    fn checked(self) -> Result<Self> {
        let alignment = self.device.info().limits.storage_offset_alignment.max(1);
        let asked = || format!("{} bytes of a buffer from {} on", self.bytes, self.offset);
        if self.bytes == 0 {
            let remedy = "ask for at least one byte";
            return Err(refused(asked(), "the least is 1", remedy));
        }
        if !self.offset.is_multiple_of(alignment) {
            let name = &self.device.info().name;
            let limit = format!("device {name} binds storage buffers at multiples of {alignment}");
            return Err(refused(asked(), limit, "move the offset"));
        }
        Ok(self)
    }

    /// A part of it that lies within it and is bound at multiples of 256, or only copied.
    pub(crate) fn part(&self, offset: u64, bytes: u64) -> Self {
        Self {
            offset: self.offset + offset,
            bytes,
            ..self.clone()
        }
    }
}

impl Buffer {
    /// A part of the buffer for work that is recorded or submitted; see [`BufferSlice`]. The
    /// offset is a multiple of what the device says, which is 256 at most.
    ///
    /// # Errors
    /// [`Error::Arguments`](crate::Error::Arguments) for no bytes, past the end of the buffer,
    /// or for an offset that the device cannot bind.
    pub fn slice(&self, offset: u64, bytes: u64) -> Result<BufferSlice> {
        self.check_range("take", offset, bytes)?;
        self.whole().part(offset, bytes).checked()
    }

    /// All of it.
    pub(crate) fn whole(&self) -> BufferSlice {
        BufferSlice {
            device: Arc::clone(self.device()),
            raw: self.raw(),
            offset: 0,
            bytes: self.bytes(),
            _memory: Some(self.memory()),
        }
    }
}

impl FileWindow {
    /// All of it, for work that is recorded or submitted. What is made of the slice keeps the
    /// file mapped.
    #[must_use]
    pub fn slice(&self) -> BufferSlice {
        let main = self.memory();
        BufferSlice {
            device: Arc::clone(self.device()),
            raw: main.raw,
            offset: 0,
            bytes: self.bytes(),
            _memory: Some(main),
        }
    }
}

impl fmt::Debug for BufferSlice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("BufferSlice")
            .field("offset", &self.offset)
            .field("bytes", &self.bytes)
            .finish_non_exhaustive()
    }
}
