//! Storage buffers.

use ash::vk;
use std::fmt;
use std::sync::Arc;

use super::device::Device;
use super::memory::{Block, Purpose};
use super::refused;
use crate::error::Result;

/// Most bytes that one staged write copies at a time.
const WRITE_CHUNK: u64 = 64 << 20;

/// How the host uses a buffer. Every buffer can be written and read; this says
/// what to make fast.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// The host writes, the device reads.
    Upload,
    /// The device writes, the host reads.
    Readback,
    /// The host hardly ever looks: it reads and writes by way of a copy.
    DeviceOnly,
}

/// A storage buffer with memory of its own; a new one holds anything at all.
///
/// Where host and device share memory it is mapped, and reads and writes touch
/// it in place. Elsewhere they go through a staging buffer, made at first use
/// and as large as the largest read.
pub struct Buffer {
    device: Arc<Device>,
    main: Arc<Block>,
    staging: Option<Block>,
    bytes: u64,
}

impl Buffer {
    /// Makes a buffer of `bytes`.
    ///
    /// # Errors
    /// [`Error::Arguments`](crate::Error::Arguments) for 0 bytes, or for more
    /// than the device binds or allocates at once;
    /// [`Error::Vulkan`](crate::Error::Vulkan) when memory runs out.
    pub fn new(device: &Arc<Device>, bytes: u64, access: Access) -> Result<Self> {
        let asked = || format!("a buffer of {bytes} bytes");
        let most = device.info().limits.max_storage_buffer_range;
        if bytes == 0 {
            return Err(refused(
                asked(),
                "the least is 1",
                "ask for at least one byte",
            ));
        }
        if bytes > most {
            let limit = format!(
                "device {} binds at most {most} bytes at once",
                device.info().name
            );
            return Err(refused(asked(), limit, "use a smaller one, several times"));
        }
        let purpose = match access {
            Access::Upload => Purpose::Upload,
            Access::Readback => Purpose::Readback,
            Access::DeviceOnly => Purpose::DeviceOnly,
        };
        // Whole words, so that all of it can be filled with zeros.
        let main = Block::new(device, bytes.next_multiple_of(4), purpose)?;
        Ok(Self {
            device: Arc::clone(device),
            main: Arc::new(main),
            staging: None,
            bytes,
        })
    }

    /// The bytes that were asked for.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// The handle, for command buffers and descriptor sets of the caller.
    #[must_use]
    pub fn raw(&self) -> vk::Buffer {
        self.main.raw
    }

    /// The device that the buffer belongs to.
    #[must_use]
    pub fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// Whether reads and writes touch the buffer in place, without a copy.
    #[must_use]
    pub fn is_mapped(&self) -> bool {
        self.main.is_mapped()
    }

    /// Writes `data` at byte `offset`.
    ///
    /// # Errors
    /// [`Error::Arguments`](crate::Error::Arguments) past the end of the buffer, or while a
    /// [slice](super::BufferSlice) of it is in use; [`Error::Vulkan`](crate::Error::Vulkan) or
    /// [`Error::Timeout`](crate::Error::Timeout) when a copy fails.
    pub fn write(&mut self, offset: u64, data: &[u8]) -> Result<()> {
        let length = data.len() as u64;
        self.check_range("write", offset, length)?;
        self.device.settle()?;
        let main = self.exclusive("write")?;
        if main.is_mapped() {
            return main.fill(offset, length, |bytes| bytes.copy_from_slice(data));
        }
        let mut at = offset;
        for chunk in data.chunks(WRITE_CHUNK as usize) {
            let length = chunk.len() as u64;
            let to = self.main.raw;
            let staging = self.stage(length)?;
            staging.fill(0, length, |bytes| bytes.copy_from_slice(chunk))?;
            let (from, device) = (staging.raw, &self.device);
            copy(
                device,
                from,
                to,
                vk::BufferCopy {
                    src_offset: 0,
                    dst_offset: at,
                    size: length,
                },
            )?;
            at += length;
        }
        Ok(())
    }

    /// Shows `length` bytes at byte `offset` to `f`, and returns what it returns.
    ///
    /// # Errors
    /// As for [`Buffer::write`].
    pub fn read<R>(&mut self, offset: u64, length: u64, f: impl FnOnce(&[u8]) -> R) -> Result<R> {
        self.check_range("read", offset, length)?;
        self.device.settle()?;
        let main = self.exclusive("read")?;
        if length == 0 {
            return Ok(f(&[]));
        }
        if main.is_mapped() {
            return Ok(f(main.mapped(offset, length)?));
        }
        let from = self.main.raw;
        let to = self.stage(length)?.raw;
        let region = vk::BufferCopy {
            src_offset: offset,
            dst_offset: 0,
            size: length,
        };
        copy(&self.device, from, to, region)?;
        Ok(f(self.stage(length)?.mapped(0, length)?))
    }

    /// Fills the buffer with zeros.
    ///
    /// # Errors
    /// As for [`Buffer::write`].
    pub fn fill_zero(&mut self) -> Result<()> {
        self.device.settle()?;
        let length = self.bytes;
        let main = self.exclusive("fill")?;
        if main.is_mapped() {
            return main.fill(0, length, |bytes| bytes.fill(0));
        }
        let (device, raw) = (&self.device, self.main.raw);
        let filled = device.submit(0, |_, commands| {
            // SAFETY: the command buffer is recording, and the buffer, which is a
            // transfer destination, lives until the submission has ended.
            unsafe {
                device
                    .raw()
                    .cmd_fill_buffer(commands, raw, 0, vk::WHOLE_SIZE, 0)
            };
            Ok(())
        });
        filled.map(|_| ())
    }

    /// The staging buffer, of at least `length` bytes.
    fn stage(&mut self, length: u64) -> Result<&mut Block> {
        if self
            .staging
            .as_ref()
            .is_some_and(|staging| staging.bytes() < length)
        {
            self.staging = None;
        }
        match &mut self.staging {
            Some(staging) => Ok(staging),
            none => Ok(none.insert(Block::new(&self.device, length, Purpose::Staging)?)),
        }
    }

    /// The memory, which work in flight may still use.
    pub(super) fn memory(&self) -> Arc<Block> {
        Arc::clone(&self.main)
    }

    /// The memory, if nobody else uses it.
    fn exclusive(&mut self, verb: &str) -> Result<&mut Block> {
        let asked = || format!("to {verb} a buffer of {} bytes", self.bytes);
        let limit = "work that was recorded or submitted still has a slice of it";
        let remedy = "wait for the submission first, and drop its slices";
        Arc::get_mut(&mut self.main).ok_or_else(|| refused(asked(), limit, remedy))
    }

    pub(super) fn check_range(&self, verb: &str, offset: u64, length: u64) -> Result<()> {
        if offset
            .checked_add(length)
            .is_some_and(|end| end <= self.bytes)
        {
            return Ok(());
        }
        Err(refused(
            format!("to {verb} {length} bytes at {offset}"),
            format!("the buffer has {} bytes", self.bytes),
            "stay inside",
        ))
    }
}

impl fmt::Debug for Buffer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Buffer")
            .field("bytes", &self.bytes)
            .field("mapped", &self.is_mapped())
            .finish_non_exhaustive()
    }
}

fn copy(device: &Device, from: vk::Buffer, to: vk::Buffer, region: vk::BufferCopy) -> Result<()> {
    let copied = device.submit(0, |_, commands| {
        // SAFETY: the command buffer is recording; both buffers live until the
        // submission has ended, and the region lies within both.
        unsafe { device.raw().cmd_copy_buffer(commands, from, to, &[region]) };
        Ok(())
    });
    copied.map(|_| ())
}
