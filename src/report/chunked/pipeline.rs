//! Beside whoever makes the data: one thread writes it, and one hashes the whole.
//!
//! Buffers go round, from the producer to the writer, to the hasher and back, so that memory
//! does not grow and each waits for the slowest.

use super::Chunk;
use super::allocate::allocate;
use super::journal::Journal;
use crate::report::hexadecimal;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::{Builder, JoinHandle};

/// Bytes of a buffer.
pub(super) const PIECE: usize = 16 << 20;

/// Buffers in all.
const BUFFERS: usize = 4;

/// Where the bytes of a buffer belong.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// Before or after the chunks.
    Frame,
    /// In a chunk.
    Inside,
    /// The end of a chunk.
    End,
    /// The end of the last chunk, which needs no line in the journal: the file has its name soon.
    Last,
}

/// What the writer works on.
pub(super) struct Output {
    pub(super) file: File,
    /// Its name while it is not finished.
    pub(super) path: PathBuf,
    pub(super) journal: Journal,
    /// Bytes written.
    pub(super) position: u64,
    /// Hash of those.
    pub(super) whole: Sha256,
    /// Bytes of a chunk, where all but the last have as many, and of all data.
    pub(super) sizes: Option<(u64, u64)>,
}

/// What is there at the end.
pub(super) struct Written {
    pub(super) output: Output,
    /// The last chunk, once it is written.
    pub(super) last: Option<Chunk>,
    pub(super) error: Option<io::Error>,
}

/// The threads at work.
pub(super) struct Pipeline {
    pieces: SyncSender<(Vec<u8>, Role)>,
    free: Receiver<Vec<u8>>,
    made: usize,
    writer: JoinHandle<Written>,
    hasher: JoinHandle<Sha256>,
}

impl Pipeline {
    pub(super) fn start(output: Output) -> io::Result<Self> {
        let (pieces, to_write) = sync_channel(BUFFERS);
        let (written, to_hash) = sync_channel(BUFFERS);
        let (emptied, free) = channel();
        let whole = output.whole.clone();
        let hasher = Builder::new()
            .name("hash".into())
            .spawn(move || hash(whole, &to_hash, &emptied))?;
        let writer = Builder::new()
            .name("write".into())
            .spawn(move || write(output, &to_write, &written))?;
        Ok(Self {
            pieces,
            free,
            made: 1,
            writer,
            hasher,
        })
    }

    /// Passes a buffer on, and returns an empty one; none where the writer has failed.
    pub(super) fn send(&mut self, piece: Vec<u8>, role: Role) -> Option<Vec<u8>> {
        self.pieces.send((piece, role)).ok()?;
        if self.made < BUFFERS {
            self.made += 1;
            return Some(Vec::new());
        }
        self.free.recv().ok()
    }

    /// Waits for all that was sent.
    pub(super) fn finish(self) -> io::Result<Written> {
        drop(self.pieces);
        let died = |_| io::Error::other("a thread that writes it has died");
        let mut written = self.writer.join().map_err(died)?;
        written.output.whole = self.hasher.join().map_err(died)?;
        Ok(written)
    }
}

fn hash(mut whole: Sha256, pieces: &Receiver<Vec<u8>>, free: &Sender<Vec<u8>>) -> Sha256 {
    for mut piece in pieces {
        whole.update(&piece);
        piece.clear();
        // The producer is gone at the end.
        let _ = free.send(piece);
    }
    whole
}

fn write(
    output: Output,
    pieces: &Receiver<(Vec<u8>, Role)>,
    written: &SyncSender<Vec<u8>>,
) -> Written {
    let mut writer = Writer {
        written: Written {
            output,
            last: None,
            error: None,
        },
        chunk: Sha256::new(),
        length: 0,
    };
    for (piece, role) in pieces {
        if let Err(error) = writer.take(&piece, role) {
            writer.written.error = Some(error);
            break;
        }
        if written.send(piece).is_err() {
            break;
        }
    }
    writer.written
}

struct Writer {
    written: Written,
    /// Hash and bytes of the chunk at work.
    chunk: Sha256,
    length: u64,
}

impl Writer {
    fn take(&mut self, piece: &[u8], role: Role) -> io::Result<()> {
        let output = &mut self.written.output;
        if role != Role::Frame
            && self.length == 0
            && let Some((chunk, data)) = output.sizes
        {
            let length = chunk.min(data - output.journal.data());
            allocate(&output.file, output.position, length)?;
        }
        output.file.write_all(piece)?;
        output.position += piece.len() as u64;
        if role == Role::Frame {
            return Ok(());
        }
        self.chunk.update(piece);
        self.length += piece.len() as u64;
        if role == Role::Inside {
            return Ok(());
        }
        let chunk = Chunk {
            bytes: std::mem::take(&mut self.length),
            sha256: hexadecimal(&self.chunk.finalize_reset()),
        };
        if role == Role::Last {
            self.written.last = Some(chunk);
            return Ok(());
        }
        output.file.sync_data()?;
        if !output.path.exists() {
            let gone = "its partial file was removed while it was written";
            return Err(io::Error::new(io::ErrorKind::NotFound, gone));
        }
        output.journal.add(chunk)
    }
}
