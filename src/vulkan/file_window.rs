//! A window of a file as a storage buffer.

use std::fmt;
use std::fs::File;
use std::sync::Arc;

use super::device::Device;
use super::import;
use super::mapping::Mapping;
use super::memory::Block;
use super::refused;
use crate::error::Result;

/// A part of a file that the device writes in place, without a copy: mapped, and imported as the
/// memory of a storage buffer.
///
/// It stays mapped until this and all work that was given a [slice](Self::slice) of it are gone.
/// Then, and not before, what the device wrote can be read from the file, and synced: a driver
/// that holds pages tells the system that they were written when it lets go of them. Nothing
/// may shorten the file meanwhile, as to write past its end kills the process. For Linux.
pub struct FileWindow {
    device: Arc<Device>,
    main: Arc<Block>,
    bytes: u64,
}

impl FileWindow {
    /// Maps `bytes` of a file, which is open to read and write, from byte `offset` on. That is a
    /// multiple of the size of a page, and the disk has the space of all of it already: of a
    /// file with holes the disk may be found full when the device writes. Costs the mapping of
    /// each page, and calls of the driver.
    ///
    /// # Errors
    /// Any of them is a refusal, after which a [`Buffer`](super::Buffer) does the same:
    /// [`Error::Arguments`](crate::Error::Arguments) where device, file or system cannot do it,
    /// [`Error::Vulkan`](crate::Error::Vulkan) where the driver fails. A device of the caller's
    /// has no windows.
    pub fn new(device: &Arc<Device>, file: &Arc<File>, offset: u64, bytes: u64) -> Result<Self> {
        device.settle()?;
        let length = import::offered(device, bytes)?.length(bytes);
        let mapping = Mapping::new(file, offset, length).map_err(|fault| {
            refused(
                format!("a window of {bytes} bytes of a file from {offset} on"),
                format!("the system does not map it ({fault})"),
                "make a buffer, and write what it holds to the file",
            )
        })?;
        Ok(Self {
            device: Arc::clone(device),
            main: Arc::new(Block::import(device, mapping, bytes)?),
            bytes,
        })
    }

    /// Its length.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// The device that writes there.
    #[must_use]
    pub fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// Lets go of the file, after which it has what the device wrote.
    ///
    /// # Errors
    /// [`Error::Arguments`](crate::Error::Arguments) where something may still write there: work
    /// that was given a slice, or a device that has not ended in time. The memory then stays
    /// mapped until that is over.
    pub fn close(self) -> Result<()> {
        let Self {
            device,
            main,
            bytes,
        } = self;
        let alone = Arc::into_inner(main).map(drop).is_some();
        if alone && !device.is_hung() {
            return Ok(());
        }
        Err(refused(
            format!("to close a window of {bytes} bytes of a file"),
            "work that may still write there has not ended",
            "wait for its submissions first, and drop their slices",
        ))
    }

    /// The memory, which work in flight may still use.
    pub(super) fn memory(&self) -> Arc<Block> {
        Arc::clone(&self.main)
    }
}

impl fmt::Debug for FileWindow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FileWindow")
            .field("bytes", &self.bytes)
            .finish_non_exhaustive()
    }
}
