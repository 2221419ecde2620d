//! The bytes of a file that somebody else wrote.

use std::fs::File;
use std::io;

/// Bytes that are read at a time: few, so that they are still in the cache of the core when they
/// are hashed.
const BLOCK: usize = 1 << 17;

/// Shows a part of a file to `take`, block by block. The file's own position stays.
pub(super) fn read(
    file: &File,
    mut offset: u64,
    mut bytes: u64,
    mut take: impl FnMut(&[u8]),
) -> io::Result<()> {
    let mut block = vec![0; BLOCK.min(usize::try_from(bytes).unwrap_or(BLOCK))];
    while bytes > 0 {
        let part = &mut block[..bytes.min(BLOCK as u64) as usize];
        read_at(file, part, offset)?;
        take(part);
        offset += part.len() as u64;
        bytes -= part.len() as u64;
    }
    Ok(())
}

#[cfg(unix)]
fn read_at(file: &File, into: &mut [u8], offset: u64) -> io::Result<()> {
    std::os::unix::fs::FileExt::read_exact_at(file, into, offset)
}

/// No file has extents there.
#[cfg(not(unix))]
fn read_at(_: &File, _: &mut [u8], _: u64) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}
