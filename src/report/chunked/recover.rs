//! What of a partial file is as its journal says.

use super::journal::Journal;
use crate::error::{Error, Result};
use crate::report::hexadecimal;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};

/// Bytes that are read at a time.
const BLOCK: usize = 1 << 20;

/// How far a partial file goes.
pub(super) struct Recovered {
    /// Bytes of the header and the sound chunks.
    pub(super) position: u64,
    /// Hash of those.
    pub(super) whole: Sha256,
    /// Sound chunks.
    pub(super) chunks: usize,
}

/// Reads the header and every chunk of the journal again, to the first that is not what it was:
/// a power cut may take what was written, whatever a disk said of it. None where not even the
/// header is sound. `watch` hears how many of how many bytes are read, and may stop it.
pub(super) fn recover(
    file: &mut File,
    journal: &Journal,
    header: &[u8],
    watch: &mut dyn FnMut(u64, u64) -> Result<()>,
    failed: &dyn Fn(io::Error) -> Error,
) -> Result<Option<Recovered>> {
    file.seek(SeekFrom::Start(0)).map_err(failed)?;
    let length = file.metadata().map_err(failed)?.len();
    let mut found = vec![0; header.len()];
    if length < header.len() as u64 {
        return Ok(None);
    }
    file.read_exact(&mut found).map_err(failed)?;
    if found != header {
        return Ok(None);
    }
    let mut sound = Recovered {
        position: header.len() as u64,
        whole: Sha256::new_with_prefix(header),
        chunks: 0,
    };
    let total = journal.data();
    let mut block = vec![0; BLOCK];
    for chunk in journal.chunks() {
        if length - sound.position < chunk.bytes {
            break;
        }
        let (mut whole, mut own) = (sound.whole.clone(), Sha256::new());
        let mut done = 0;
        while done < chunk.bytes {
            let part = &mut block[..(chunk.bytes - done).min(BLOCK as u64) as usize];
            file.read_exact(part).map_err(failed)?;
            own.update(&*part);
            whole.update(&*part);
            done += part.len() as u64;
            watch(sound.position - header.len() as u64 + done, total)?;
        }
        if hexadecimal(&own.finalize()) != chunk.sha256 {
            break;
        }
        sound.whole = whole;
        sound.position += chunk.bytes;
        sound.chunks += 1;
    }
    Ok(Some(sound))
}
