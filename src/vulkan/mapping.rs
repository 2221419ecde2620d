//! A part of a file in memory.

use std::fs::File;
use std::io;
use std::ptr::NonNull;
use std::sync::Arc;

/// Pages that are shared with a file, which stays open. No reference to them is ever made: the
/// device writes them, and other processes may.
#[cfg_attr(
    not(target_os = "linux"),
    allow(dead_code, reason = "there is none elsewhere")
)]
pub(super) struct Mapping {
    at: NonNull<u8>,
    bytes: usize,
    _file: Arc<File>,
}

// SAFETY: it is an address that only devices and the system look behind.
unsafe impl Send for Mapping {}
// SAFETY: as above.
unsafe impl Sync for Mapping {}

impl Mapping {
    /// Where it begins.
    pub(super) fn at(&self) -> NonNull<u8> {
        self.at
    }

    /// Its length.
    pub(super) fn bytes(&self) -> u64 {
        self.bytes as u64
    }
}

#[cfg(target_os = "linux")]
mod system {
    use super::*;
    use rustix::io::Errno;
    use rustix::mm::{Advice, MapFlags, ProtFlags, madvise, mmap, munmap};

    impl Mapping {
        /// Maps `bytes` of a file from byte `offset` on, both of whole pages.
        pub(in super::super) fn new(file: &Arc<File>, offset: u64, bytes: u64) -> io::Result<Self> {
            let length = usize::try_from(bytes).map_err(|_| io::ErrorKind::InvalidInput)?;
            let access = ProtFlags::READ | ProtFlags::WRITE;
            // SAFETY: the system chooses the address, so that nothing of ours lies there.
            let at = unsafe {
                mmap(
                    std::ptr::null_mut(),
                    length,
                    access,
                    MapFlags::SHARED,
                    file,
                    offset,
                )
            }?;
            let mapping = Self {
                at: NonNull::new(at.cast()).ok_or(io::ErrorKind::InvalidInput)?,
                bytes: length,
                _file: Arc::clone(file),
            };
            // SAFETY: the pages are the mapping's, and none changes what it holds.
            match unsafe { madvise(at, length, Advice::LinuxPopulateWrite) } {
                // Before Linux 5.14 pages come when they are touched.
                Ok(()) | Err(Errno::INVAL | Errno::NOSYS) => Ok(mapping),
                // What is no error here, as on a full disk, is a signal to whoever writes there.
                Err(errno) => Err(errno.into()),
            }
        }
    }

    impl Drop for Mapping {
        fn drop(&mut self) {
            // SAFETY: the range is that of the mapping, to which nothing leads any more: what
            // the device made of it was destroyed.
            let _ = unsafe { munmap(self.at.as_ptr().cast(), self.bytes) };
        }
    }
}

#[cfg(not(target_os = "linux"))]
impl Mapping {
    /// Refuses: windows of files are for Linux.
    pub(super) fn new(_: &Arc<File>, _: u64, _: u64) -> io::Result<Self> {
        Err(io::ErrorKind::Unsupported.into())
    }
}
