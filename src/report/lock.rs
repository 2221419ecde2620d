//! Locks that keep two processes from one file.

use std::fs::{File, TryLockError};
use std::io;

/// Takes the lock of an open file, which ends with it. False where another process has it. Some
/// network file systems have no locks; there nobody is kept away.
pub(crate) fn try_lock(file: &File) -> io::Result<bool> {
    match file.try_lock() {
        Ok(()) => Ok(true),
        Err(TryLockError::WouldBlock) => Ok(false),
        Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => Ok(true),
        Err(TryLockError::Error(error)) => Err(error),
    }
}
