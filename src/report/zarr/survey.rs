//! Whether a store is whole, and what its array hashes to.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::ops::Range;

use serde_json::json;
use sha2::{Digest, Sha256};

use super::fault::{Fault, Record};
use super::{Store, aside, metadata};
use crate::error::{Error, Result};
use crate::report::hexadecimal;
use crate::report::place::failed;

/// Bytes that are read and hashed at a time.
const BLOCK: usize = 1 << 20;

/// What was found in a store.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Survey {
    /// Chunks with the same fault, in order; none of a store that is whole.
    pub faults: Vec<(Range<u64>, Fault)>,
    /// SHA-256 of the array's bytes, row after row without padding, which a raw file of the
    /// same points has too. Of a store with faults it means nothing.
    pub sha256: String,
}

impl Survey {
    /// Chunks with a fault.
    #[must_use]
    pub fn lacking(&self) -> u64 {
        let lengths = self.faults.iter().map(|(run, _)| run.end - run.start);
        lengths.sum()
    }
}

fn is_read_only(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem
    )
}

impl Store {
    /// Reads every chunk that is there and compares it with its record; `step` is told how many are done. A
    /// store without faults then has the record of the whole, and nothing that is unfinished.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if something cannot be read or written, but for the record of a store that
    /// may only be read; and those of `step`.
    pub fn survey(&self, step: &mut dyn FnMut(u64) -> Result<()>) -> Result<Survey> {
        let mut whole = Sha256::new();
        let mut faults: Vec<(Range<u64>, Fault)> = Vec::new();
        let mut add = |run: Range<u64>, fault: Fault| match faults.last_mut() {
            Some((last, same)) if last.end == run.start && *same == fault => last.end = run.end,
            _ => faults.push((run, fault)),
        };
        let mut next = 0;
        for chunk in self.present()? {
            if next < chunk {
                add(next..chunk, Fault::Missing);
            }
            if let Some(fault) = self.compare(chunk, &mut |bytes| whole.update(bytes))? {
                add(chunk..chunk + 1, fault);
            }
            next = chunk + 1;
            step(next)?;
        }
        if next < self.chunks() {
            add(next..self.chunks(), Fault::Missing);
            step(self.chunks())?;
        }
        let sha256 = hexadecimal(&whole.finalize());
        let path = self.records().join("array.json");
        if faults.is_empty() {
            let record = json!({ "array": self.array, "sha256": sha256 });
            match aside::save(&self.records(), &path, &metadata::text(&record)) {
                // Whoever may only read learns whether it is whole all the same.
                Err(Error::Io { source, .. }) if is_read_only(&source) => {}
                done => {
                    done?;
                    aside::sweep(&self.records())?;
                }
            }
        } else {
            // It said that all were there.
            let _ = std::fs::remove_file(path);
        }
        Ok(Survey { faults, sha256 })
    }

    /// The chunks of which there is a folder, rising. However many a description speaks of, no
    /// more are looked at.
    fn present(&self) -> Result<BTreeSet<u64>> {
        let folder = self.path.join("c");
        let failed = |error| failed("read", &folder, error);
        let entries = match std::fs::read_dir(&folder) {
            Ok(entries) => entries,
            Err(error)
                if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) =>
            {
                return Ok(BTreeSet::new());
            }
            Err(error) => return Err(failed(error)),
        };
        let mut found = BTreeSet::new();
        for entry in entries {
            let name = entry.map_err(failed)?.file_name();
            let number = name.to_str().and_then(|name| name.parse::<u64>().ok());
            found.extend(number.filter(|chunk| *chunk < self.chunks()));
        }
        Ok(found)
    }

    /// What is wrong with a chunk, if anything is.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if it is there and cannot be read.
    pub fn fault(&self, chunk: u64) -> Result<Option<Fault>> {
        self.compare(chunk, &mut |_| {})
    }

    /// The same, with the bytes of the chunk's rows handed on.
    fn compare(&self, chunk: u64, take: &mut dyn FnMut(&[u8])) -> Result<Option<Fault>> {
        let mut file = match self.file(chunk)? {
            Ok(file) => file,
            Err(fault) => return Ok(Some(fault)),
        };
        let recorded = match self.recorded(chunk) {
            Ok(sha256) => sha256,
            Err(fault) => return Ok(Some(fault)),
        };
        let rows = self.rows(chunk);
        let mut left = (rows.end - rows.start) * self.row_bytes();
        let mut hash = Sha256::new();
        let mut block = vec![0; BLOCK];
        loop {
            let read = match file.read(&mut block) {
                Ok(0) => break,
                Ok(read) => read,
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                Err(error) => return Err(failed("read", &self.chunk(chunk), error)),
            };
            hash.update(&block[..read]);
            let shown = left.min(read as u64);
            take(&block[..shown as usize]);
            left -= shown;
        }
        let damaged = hexadecimal(&hash.finalize()) != recorded;
        Ok(damaged.then_some(Fault::Damaged))
    }

    /// The file of a chunk, if it is there and as long as it must be.
    pub(super) fn file(&self, chunk: u64) -> Result<Result<File, Fault>> {
        let path = self.chunk(chunk);
        let file = match File::open(&path) {
            Ok(file) => file,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Err(Fault::Missing)),
            Err(error) => return Err(failed("open", &path, error)),
        };
        let found = file.metadata().map(|found| found.len());
        let found = found.map_err(|error| failed("read", &path, error))?;
        if found != self.chunk_bytes() {
            return Ok(Err(Fault::Length { found }));
        }
        Ok(Ok(file))
    }

    /// The SHA-256 that is recorded of a chunk, as part of this array.
    pub(super) fn recorded(&self, chunk: u64) -> Result<String, Fault> {
        let record = metadata::read(&self.record(chunk)).ok().flatten();
        let record = record.as_ref().and_then(Record::parse);
        let record = record.ok_or(Fault::Unrecorded)?;
        if record.array != self.array {
            return Err(Fault::Foreign);
        }
        Ok(record.sha256)
    }
}
