//! Rows to where bytes only flow: standard output, a pipe, a device.

use super::encode::Encoder;
use super::place::{Place, failed};
use crate::error::Result;
use std::io::Write;
use std::path::Path;

/// Small writes are gathered up to about this many bytes.
const BLOCK: usize = 1 << 20;

/// Words that are encoded between looks at the size of the block.
const WORDS: usize = 1 << 14;

pub(super) struct Stream {
    place: Place,
    block: Vec<u8>,
    bytes: u64,
}

impl Stream {
    pub(super) fn new(place: Place, encoder: &Encoder) -> Self {
        Self {
            place,
            block: encoder.header(),
            bytes: 0,
        }
    }

    /// Writes words, the first of which is the array's word `at`.
    pub(super) fn write(
        &mut self,
        encoder: &Encoder,
        at: u64,
        words: &[u32],
        path: &Path,
    ) -> Result<()> {
        for (part, words) in words.chunks(WORDS).enumerate() {
            encoder.append(at + (part * WORDS) as u64, words, &mut self.block);
            if self.block.len() >= BLOCK {
                self.pass_on(path)?;
            }
        }
        Ok(())
    }

    /// Writes the rest, and returns the number of bytes in all.
    pub(super) fn finish(mut self, encoder: &Encoder, path: &Path) -> Result<u64> {
        self.block.extend_from_slice(encoder.footer());
        self.pass_on(path)?;
        let flushed = self.place.flush();
        flushed.map_err(|source| failed("write", path, source))?;
        Ok(self.bytes)
    }

    fn pass_on(&mut self, path: &Path) -> Result<()> {
        let written = self.place.write_all(&self.block);
        written.map_err(|source| failed("write", path, source))?;
        self.bytes += self.block.len() as u64;
        self.block.clear();
        Ok(())
    }
}
