//! Hashes of a file while it is read.

use crate::report::{Sidecar, hexadecimal};
use sha2::{Digest, Sha256};

/// The hashes of a file that is read, against those of its sidecar.
pub(super) struct Hashes {
    sidecar: Sidecar,
    whole: Sha256,
    /// Of the chunk at work: its hash, its bytes so far, its number.
    chunk: Sha256,
    length: u64,
    number: usize,
    wrong: Option<usize>,
}

impl Hashes {
    pub(super) fn new(sidecar: &Sidecar) -> Self {
        Self {
            sidecar: sidecar.clone(),
            whole: Sha256::new(),
            chunk: Sha256::new(),
            length: 0,
            number: 0,
            wrong: None,
        }
    }

    /// Takes bytes outside the chunks.
    pub(super) fn frame(&mut self, bytes: &[u8]) {
        self.whole.update(bytes);
    }

    /// Takes the next bytes of the chunks.
    pub(super) fn data(&mut self, mut bytes: &[u8]) {
        self.whole.update(bytes);
        while let Some(chunk) = self.sidecar.chunks.get(self.number)
            && !bytes.is_empty()
        {
            let left = chunk
                .bytes
                .saturating_sub(self.length)
                .min(bytes.len() as u64);
            let (now, later) = bytes.split_at(left as usize);
            self.chunk.update(now);
            self.length += left;
            bytes = later;
            if self.length >= chunk.bytes {
                if hexadecimal(&self.chunk.finalize_reset()) != chunk.sha256 {
                    self.wrong.get_or_insert(self.number);
                }
                self.number += 1;
                self.length = 0;
            }
        }
    }

    /// What is wrong, if anything is.
    pub(super) fn finish(self) -> Option<String> {
        let (sidecar, sha256) = (self.sidecar, hexadecimal(&self.whole.finalize()));
        if let Some(number) = self.wrong {
            return Some(format!(
                "chunk {number} has not the SHA-256 that its sidecar says"
            ));
        }
        if self.number != sidecar.chunks.len() {
            return Some("its sidecar has other chunks".into());
        }
        (sha256 != sidecar.sha256).then(|| {
            format!(
                "its SHA-256 is {sha256}, and {} by its sidecar",
                sidecar.sha256
            )
        })
    }
}
