//! Which chunks of a partial file are on the disk: JSON lines.
//!
//! The first line says what the file will be, each other names a chunk that was synced before
//! the line was written. A line that was cut off, and all after it, count for nothing. The lock
//! on this file is what keeps two runs apart; it ends with the process that holds it.

use super::super::difference::{Difference, differences};
use super::super::lock::try_lock;
use super::super::place::{cannot_create, refused, sync_folder};
use super::Chunk;
use super::sidecar::MAX_BYTES;
use crate::error::Result;
use serde_json::{Value, json};
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Openings that may meet a file which its owner is just removing.
const TRIES: usize = 64;

pub(super) struct Journal {
    file: File,
    path: PathBuf,
    /// Complete chunks, and where the line of each ends.
    chunks: Vec<(Chunk, u64)>,
    /// Bytes of data in complete chunks.
    data: u64,
    /// Bytes of the first line.
    head: u64,
}

impl Journal {
    /// Opens and locks the file, whatever it holds. `asked` is the output that messages name.
    pub(super) fn open(path: PathBuf, asked: &Path) -> Result<Self> {
        let busy = || {
            refused(
                asked,
                "another run is writing this file",
                "wait for that run, or give another name",
            )
        };
        for _ in 0..TRIES {
            let file = OpenOptions::new()
                .read(true)
                .write(true)
                .create(true)
                .truncate(false)
                .open(&path)
                .map_err(|source| cannot_create(asked, &path, &source))?;
            match try_lock(&file) {
                Ok(true) => {}
                Ok(false) => return Err(busy()),
                Err(source) => return Err(cannot_create(asked, &path, &source)),
            }
            if is_named(&file, &path) {
                return Ok(Self {
                    file,
                    path,
                    chunks: Vec::new(),
                    data: 0,
                    head: 0,
                });
            }
        }
        Err(busy())
    }

    /// Begins anew: no chunk is complete.
    pub(super) fn begin(&mut self, description: &Value) -> io::Result<()> {
        let line = format!("{description}\n");
        self.file.set_len(0)?;
        self.file.seek(SeekFrom::Start(0))?;
        self.file.write_all(line.as_bytes())?;
        self.head = line.len() as u64;
        self.chunks.clear();
        self.data = 0;
        Ok(())
    }

    /// Reads the chunks of an earlier run. False where there was none.
    ///
    /// # Errors
    /// [`crate::Error::Output`] where it was a run of another description.
    pub(super) fn load(&mut self, description: &Value, asked: &Path) -> Result<bool> {
        let unreadable = |source| cannot_create(asked, &self.path, &source);
        let mut bytes = Vec::new();
        // Of more a run can have left none.
        let mut file = (&self.file).take(MAX_BYTES);
        file.read_to_end(&mut bytes).map_err(unreadable)?;
        let text = String::from_utf8_lossy(&bytes);
        let mut lines = text.split_inclusive('\n');
        let whole = |line: &&str| line.ends_with('\n');
        let Some(first) = lines.next().filter(whole) else {
            return Ok(false);
        };
        let Ok(found) = serde_json::from_str::<Value>(first) else {
            return Ok(false);
        };
        let (by, own) = (&found["version"], &description["version"]);
        if by != own {
            // What it would add may have other bits.
            return Err(refused(
                asked,
                format!(
                    "the partial file beside it is of version {by} of corput, and this is {own}"
                ),
                "go on with that version, or drop --resume to discard what it left and begin anew",
            ));
        }
        let differ = differences(&found, description);
        let say = |one: &Difference| {
            let Difference { path, there, here } = one;
            format!("{path} is {there} there and {here} here")
        };
        if !differ.is_empty() {
            let differ: Vec<String> = differ.iter().map(say).collect();
            let differ = differ.join(", ");
            return Err(refused(
                asked,
                format!("the partial file beside it is of another run: {differ}"),
                "give the arguments of that run, or drop --resume to discard what it left",
            ));
        }
        self.head = first.len() as u64;
        let mut end = self.head;
        for line in lines.take_while(whole) {
            let Some(chunk) = read(line, self.chunks.len()) else {
                break;
            };
            end += line.len() as u64;
            self.data += chunk.bytes;
            self.chunks.push((chunk, end));
        }
        Ok(true)
    }

    /// Forgets all chunks but the first so many, on the disk too.
    pub(super) fn keep(&mut self, chunks: usize) -> io::Result<()> {
        self.chunks.truncate(chunks);
        self.data = self.chunks().map(|chunk| chunk.bytes).sum();
        let end = self.end();
        self.file.set_len(end)?;
        self.file.seek(SeekFrom::Start(end))?;
        Ok(())
    }

    /// Adds a chunk whose data is synced.
    pub(super) fn add(&mut self, chunk: Chunk) -> io::Result<()> {
        let number = self.chunks.len();
        let line = format!(
            "{}\n",
            json!({ "chunk": number, "bytes": chunk.bytes, "sha256": chunk.sha256 })
        );
        self.file.write_all(line.as_bytes())?;
        self.file.sync_data()?;
        if number == 0 {
            // The names of both files are entries of the folder.
            sync_folder(&self.path)?;
        }
        let end = self.end() + line.len() as u64;
        self.data += chunk.bytes;
        self.chunks.push((chunk, end));
        Ok(())
    }

    /// Complete chunks.
    pub(super) fn chunks(&self) -> impl ExactSizeIterator<Item = &Chunk> {
        self.chunks.iter().map(|(chunk, _)| chunk)
    }

    /// Bytes of data in complete chunks.
    pub(super) fn data(&self) -> u64 {
        self.data
    }

    /// Removes the file; the lock goes with it.
    pub(super) fn remove(self) {
        // One that will not go is no harm: it describes data that is not there.
        let _ = std::fs::remove_file(&self.path);
    }

    fn end(&self) -> u64 {
        self.chunks.last().map_or(self.head, |(_, end)| *end)
    }
}

fn read(line: &str, number: usize) -> Option<Chunk> {
    let value: Value = serde_json::from_str(line).ok()?;
    let same = value.get("chunk")?.as_u64()? == number as u64;
    same.then(|| Chunk::read(&value)).flatten()
}

/// Whether the path still leads to the open file, and not to another or to none.
#[cfg(unix)]
fn is_named(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let names =
        |a: &std::fs::Metadata, b: &std::fs::Metadata| (a.dev(), a.ino()) == (b.dev(), b.ino());
    match (file.metadata(), std::fs::metadata(path)) {
        (Ok(open), Ok(found)) => names(&open, &found),
        _ => false,
    }
}

/// Elsewhere an open file cannot be removed.
#[cfg(not(unix))]
fn is_named(_: &File, _: &Path) -> bool {
    true
}
