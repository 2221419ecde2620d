//! Space on the disk before the data comes.

use std::fs::File;
use std::io;

/// Reserves a range of the file, so that a full disk is an error before the work and not after
/// it. False on file systems that cannot do so, which take the data as it comes.
#[cfg(all(target_os = "linux", feature = "gpu"))]
pub(super) fn allocate(file: &File, offset: u64, length: u64) -> io::Result<bool> {
    use rustix::fs::{FallocateFlags, fallocate};
    use rustix::io::Errno;
    if length == 0 {
        return Ok(true);
    }
    loop {
        return match fallocate(file, FallocateFlags::empty(), offset, length) {
            Ok(()) => Ok(true),
            Err(Errno::OPNOTSUPP | Errno::NOSYS | Errno::INVAL) => Ok(false),
            Err(Errno::INTR) => continue,
            Err(errno) => Err(errno.into()),
        };
    }
}

#[cfg(not(all(target_os = "linux", feature = "gpu")))]
pub(super) fn allocate(_: &File, _: u64, _: u64) -> io::Result<bool> {
    Ok(false)
}
