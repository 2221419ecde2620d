//! Beside whoever makes the data: one thread writes it, and one hashes the whole.
//!
//! Buffers go round, from the producer to the writer, to the hasher and back, so that memory
//! does not grow and each waits for the slowest. What is in the file already is read from there.

use super::allocate::allocate;
use super::journal::Journal;
use super::{Chunk, written};
use crate::report::hexadecimal;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::{Builder, JoinHandle};

/// Bytes of a buffer.
pub(super) const PIECE: usize = 16 << 20;

/// Buffers in all.
const BUFFERS: usize = 4;

/// The next bytes of the file.
pub(super) enum Piece {
    /// To write.
    Buffer(Vec<u8>),
    /// So many that are there.
    There(u64),
}

/// Where the bytes of a piece belong.
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
    pub(super) file: Arc<File>,
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
    pieces: SyncSender<(Piece, Role)>,
    free: Receiver<Vec<u8>>,
    made: usize,
    writer: JoinHandle<Written>,
    hasher: JoinHandle<io::Result<Sha256>>,
}

impl Pipeline {
    pub(super) fn start(output: Output) -> io::Result<Self> {
        let (pieces, to_write) = sync_channel(BUFFERS);
        let (written, to_hash) = sync_channel(BUFFERS);
        let (emptied, free) = channel();
        let (whole, file, at) = (
            output.whole.clone(),
            Arc::clone(&output.file),
            output.position,
        );
        let hasher = Builder::new()
            .name("hash".into())
            .spawn(move || hash(whole, &file, at, &to_hash, &emptied))?;
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
        self.pieces.send((Piece::Buffer(piece), role)).ok()?;
        if self.made < BUFFERS {
            self.made += 1;
            return Some(Vec::new());
        }
        self.free.recv().ok()
    }

    /// Passes on that the next so many bytes are in the file; none where the writer has failed.
    pub(super) fn send_there(&mut self, bytes: u64, role: Role) -> Option<()> {
        self.pieces.send((Piece::There(bytes), role)).ok()
    }

    /// Waits for all that was sent.
    pub(super) fn finish(self) -> io::Result<Written> {
        drop(self.pieces);
        let died = |_| io::Error::other("a thread that writes it has died");
        let mut written = self.writer.join().map_err(died)?;
        match self.hasher.join().map_err(died)? {
            Ok(whole) => written.output.whole = whole,
            // The writer met it too, or stopped because of it.
            Err(error) => written.error = written.error.or(Some(error)),
        }
        Ok(written)
    }
}

fn hash(
    mut whole: Sha256,
    file: &File,
    mut at: u64,
    pieces: &Receiver<Piece>,
    free: &Sender<Vec<u8>>,
) -> io::Result<Sha256> {
    for piece in pieces {
        match piece {
            Piece::Buffer(mut bytes) => {
                whole.update(&bytes);
                at += bytes.len() as u64;
                bytes.clear();
                // The producer is gone at the end.
                let _ = free.send(bytes);
            }
            Piece::There(bytes) => {
                written::read(file, at, bytes, |block| whole.update(block))?;
                at += bytes;
            }
        }
    }
    Ok(whole)
}

fn write(output: Output, pieces: &Receiver<(Piece, Role)>, written: &SyncSender<Piece>) -> Written {
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
    fn take(&mut self, piece: &Piece, role: Role) -> io::Result<()> {
        let length = match piece {
            Piece::Buffer(bytes) => self.write(bytes, role)?,
            Piece::There(bytes) => self.pass(*bytes)?,
        };
        let output = &mut self.written.output;
        output.position += length;
        if role == Role::Frame {
            return Ok(());
        }
        self.length += length;
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

    /// Writes bytes, and says how many they are.
    fn write(&mut self, piece: &[u8], role: Role) -> io::Result<u64> {
        let output = &mut self.written.output;
        if role == Role::Frame {
            output.file.write_all(piece)?;
            return Ok(piece.len() as u64);
        }
        if self.length == 0
            && let Some((chunk, data)) = output.sizes
        {
            let length = chunk.min(data - output.journal.data());
            allocate(&output.file, output.position, length)?;
        }
        output.file.write_all(piece)?;
        self.chunk.update(piece);
        Ok(piece.len() as u64)
    }

    /// Goes past bytes that are there.
    fn pass(&mut self, bytes: u64) -> io::Result<u64> {
        let output = &mut self.written.output;
        let (at, chunk) = (output.position, &mut self.chunk);
        written::read(&output.file, at, bytes, |block| chunk.update(block))?;
        output.file.seek(SeekFrom::Start(at + bytes))?;
        Ok(bytes)
    }
}
