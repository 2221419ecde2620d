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

/// Whether what is reserved stays so, however often the pages of a mapping are written. On file
/// systems that copy on write each time may need space anew, and those of a network may lose a
/// page: whoever writes to a mapping then dies of a signal.
#[cfg(all(target_os = "linux", feature = "gpu"))]
pub(super) fn keeps_space(file: &File) -> bool {
    /// Of ext2 to ext4, XFS, tmpfs and overlays, as `statfs(2)` names them.
    const KINDS: [u32; 4] = [0xef53, 0x5846_5342, 0x0102_1994, 0x794c_7630];
    // The type has 32 bits, whatever the field has.
    rustix::fs::fstatfs(file).is_ok_and(|said| KINDS.contains(&(said.f_type as u32)))
}

#[cfg(not(all(target_os = "linux", feature = "gpu")))]
pub(super) fn keeps_space(_: &File) -> bool {
    false
}
