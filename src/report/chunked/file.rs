//! The producer's side of a file of chunks.

mod extents;

use super::journal::Journal;
use super::pipeline::{Output, PIECE, Pipeline, Role, Written};
use super::recover::recover;
use super::sidecar::{self, Origin, Sidecar};
use super::{JOURNAL, Keeping, PARTIAL, beside};
use crate::error::{Error, Result};
use crate::report::encode::Encoder;
use crate::report::hexadecimal;
use crate::report::place::{cannot_create, failed, sync_folder};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::fs::{self, File, OpenOptions};
use std::io::{self, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Words that are encoded between looks at the size of a buffer, and room for their bytes.
const WORDS: u64 = 1 << 14;
const ROOM: usize = 1 << 20;

/// A file that is being written. Dropped unfinished, it keeps what it may.
pub(in crate::report) struct Chunked {
    encoder: Encoder,
    /// The name as the user gave it, without symbolic links, and while it is not finished.
    asked: PathBuf,
    real: PathBuf,
    partial: PathBuf,
    file: Arc<File>,
    description: Value,
    device: String,
    /// Rows of a chunk, and those that an earlier run left.
    rows: u64,
    start: u64,
    keeps: bool,
    piece: Vec<u8>,
    pipeline: Option<Pipeline>,
    written: Option<Written>,
}

impl Chunked {
    /// Opens the partial file of `real`, which messages call `asked`. `keeping` is none for a
    /// file of which nothing may stay behind. `watch` hears how many of how many bytes of an
    /// earlier run are checked, and may stop that.
    pub(in crate::report) fn open(
        asked: &Path,
        real: PathBuf,
        encoder: Encoder,
        origin: Origin,
        keeping: Option<Keeping>,
        watch: &mut dyn FnMut(u64, u64) -> Result<()>,
    ) -> Result<Self> {
        let rows = keeping.unwrap_or_default().rows(&encoder.layout)?;
        sidecar::check_free(&Sidecar::path_of(&real))?;
        let partial = beside(&real, PARTIAL);
        let description = sidecar::description(&origin, &encoder, rows);
        let mut journal = Journal::open(beside(&real, JOURNAL), asked)?;
        let resume = keeping.is_some_and(|keeping| keeping.resume);
        let known = resume && journal.load(&description, asked)?;
        let opened = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(!known)
            .open(&partial);
        let mut file = match opened {
            Ok(file) => file,
            Err(source) => {
                // What an earlier run left is still there for the next try.
                if !known {
                    journal.remove();
                }
                return Err(cannot_create(asked, &partial, &source));
            }
        };
        let header = encoder.header();
        let failed = |source| failed("open the partial file of", asked, source);
        let sound = match known {
            false => None,
            true => recover(&mut file, &journal, &header, watch, &failed).map_err(|cause| {
                let kept = journal.chunks().len() as u64 * rows;
                kept_after(cause, kept, encoder.layout.rows, &partial)
            })?,
        };
        let (position, whole, chunks) = match sound {
            Some(sound) => {
                journal.keep(sound.chunks).map_err(failed)?;
                (sound.position, sound.whole, sound.chunks as u64)
            }
            None => {
                journal.begin(&description).map_err(failed)?;
                (0, Sha256::new(), 0)
            }
        };
        file.set_len(position).map_err(failed)?;
        file.seek(SeekFrom::Start(position)).map_err(failed)?;
        let file = Arc::new(file);
        let output = Output {
            file: Arc::clone(&file),
            path: partial.clone(),
            journal,
            position,
            whole,
            sizes: encoder
                .row_bytes()
                .map(|row| (row * rows, row * encoder.layout.rows)),
        };
        let mut chunked = Self {
            start: (chunks * rows).min(encoder.layout.rows),
            pipeline: Some(Pipeline::start(output).map_err(failed)?),
            encoder,
            asked: asked.to_owned(),
            real,
            partial,
            file,
            description,
            device: origin.device,
            rows,
            keeps: keeping.is_some(),
            piece: Vec::new(),
            written: None,
        };
        if position == 0 {
            chunked.piece = header;
            chunked.send(Role::Frame)?;
        }
        Ok(chunked)
    }

    /// Rows that an earlier run left.
    pub(in crate::report) fn start(&self) -> u64 {
        self.start
    }

    /// Words from the array's word `at` to the end of its chunk.
    pub(in crate::report) fn chunk_left(&self, at: u64) -> u64 {
        let chunk = self.rows * u64::from(self.encoder.layout.columns);
        chunk - at % chunk
    }

    /// Takes words, the first of which is the array's word `at`.
    pub(in crate::report) fn write(&mut self, mut at: u64, mut words: &[u32]) -> Result<()> {
        let total = self.encoder.layout.rows * u64::from(self.encoder.layout.columns);
        while !words.is_empty() {
            let left = self.chunk_left(at);
            let fit = WORDS.min(left).min(words.len() as u64);
            let (now, later) = words.split_at(fit as usize);
            if self.piece.capacity() == 0 {
                // No more than the rest of a small file.
                let rest = (total - at).saturating_mul(self.encoder.layout.element.bytes());
                self.piece.reserve(rest.min(PIECE as u64) as usize);
            }
            self.encoder.append(at, now, &mut self.piece);
            at += fit;
            words = later;
            if at == total {
                self.send(Role::Last)?;
            } else if fit == left {
                self.send(Role::End)?;
            } else if self.piece.len() + ROOM > PIECE {
                self.send(Role::Inside)?;
            }
        }
        Ok(())
    }

    /// Completes the file: all bytes to the disk, then its sidecar, then its name. Returns its
    /// length and its hash.
    pub(in crate::report) fn finish(&mut self) -> Result<(u64, String)> {
        if !self.encoder.footer().is_empty() {
            self.piece = self.encoder.footer().to_vec();
            self.send(Role::Frame)?;
        }
        self.stop()?;
        let Some(mut written) = self.written.take() else {
            return Err(self.died());
        };
        let named = self.name(&mut written);
        if named.is_err() {
            self.written = Some(written);
            return named;
        }
        written.output.journal.remove();
        named
    }

    fn name(&self, written: &mut Written) -> Result<(u64, String)> {
        let output = &written.output;
        let synced = output.file.sync_all();
        synced.map_err(|source| failed("sync", &self.asked, source))?;
        let bytes = output.position;
        let sha256 = hexadecimal(&output.whole.clone().finalize());
        let chunks: Vec<_> = output.journal.chunks().chain(&written.last).collect();
        let document = sidecar::document(
            self.description.clone(),
            &self.device,
            bytes,
            &chunks,
            &sha256,
        );
        let described = sidecar::save(&self.real, &document)?;
        if let Err(source) = fs::rename(&self.partial, &self.real) {
            described.take_back();
            return Err(failed("rename the finished file to", &self.asked, source));
        }
        let synced = sync_folder(&self.real);
        synced.map_err(|source| failed("sync the folder of", &self.asked, source))?;
        Ok((bytes, sha256))
    }

    /// Ends an unfinished file. The error comes back with what is kept, if anything is.
    pub(in crate::report) fn abandon(&mut self, cause: Error) -> Error {
        match self.settle() {
            Some(kept) => kept_after(cause, kept, self.encoder.layout.rows, &self.partial),
            None => cause,
        }
    }

    /// Keeps what may stay, and says how many rows that are, or removes all.
    fn settle(&mut self) -> Option<u64> {
        // What failed is known to the caller, or to nobody.
        let _ = self.stop();
        let Output {
            file,
            path,
            journal,
            ..
        } = self.written.take()?.output;
        let chunks = journal.chunks().len() as u64;
        drop(file);
        if self.keeps && chunks > 0 && path.exists() {
            if Arc::strong_count(&self.file) > 1 {
                // A device that hangs may still write to an extent, and must not find it gone:
                // until the process ends neither the file is shortened nor the lock given back.
                std::mem::forget(journal);
            } else {
                // The rest is not to be taken up, and a full disk can use its space.
                let _ = self
                    .file
                    .set_len(self.encoder.header().len() as u64 + journal.data());
            }
            return Some(chunks * self.rows);
        }
        let _ = fs::remove_file(&path);
        journal.remove();
        None
    }

    fn send(&mut self, role: Role) -> Result<()> {
        let piece = std::mem::take(&mut self.piece);
        let sent = self.pipeline.as_mut().and_then(|one| one.send(piece, role));
        match sent {
            Some(empty) => {
                self.piece = empty;
                Ok(())
            }
            None => self.stop().and(Err(self.died())),
        }
    }

    /// Waits for the threads; their error is told once.
    fn stop(&mut self) -> Result<()> {
        if let Some(pipeline) = self.pipeline.take() {
            let written = pipeline.finish();
            self.written = Some(written.map_err(|source| failed("write", &self.asked, source))?);
        }
        match self
            .written
            .as_mut()
            .and_then(|written| written.error.take())
        {
            Some(source) => Err(failed("write", &self.asked, source)),
            None => Ok(()),
        }
    }

    fn died(&self) -> Error {
        failed(
            "write",
            &self.asked,
            io::Error::other("its writer has ended"),
        )
    }
}

impl Drop for Chunked {
    fn drop(&mut self) {
        self.settle();
    }
}

fn kept_after(cause: Error, kept: u64, total: u64, partial: &Path) -> Error {
    Error::Kept {
        cause: Box::new(cause),
        kept,
        total,
        path: partial.to_owned(),
    }
}
