//! A store against its rows made again.

use super::{Fault, Store};
use crate::error::{Error, Result};
use crate::report::differing::{Differing, check_end, check_range};
use crate::report::hexadecimal;
use crate::report::place::failed;
use sha2::{Digest, Sha256};
use std::io::Read;
use std::ops::Range;

/// Compares a store with words that somebody makes, byte for byte; where all rows are compared
/// also each chunk with its record. It holds one chunk in memory.
pub struct Comparison<'a> {
    store: &'a Store,
    /// The rows asked for, and the word to come.
    rows: Range<u64>,
    at: u64,
    /// SHA-256 of the rows so far; none where only a range is compared.
    whole: Option<Sha256>,
    chunk: Option<Chunk>,
    wanted: Vec<u8>,
    /// Chunks and rows that differ, and what is to be said of the first.
    chunks: u64,
    differing: u64,
    problem: Option<String>,
}

/// The chunk at work.
struct Chunk {
    number: u64,
    /// Bytes of its rows; none where it cannot be read as such.
    bytes: Vec<u8>,
    fault: Option<Fault>,
    differing: Differing,
}

impl<'a> Comparison<'a> {
    /// A comparison of these rows.
    ///
    /// # Errors
    /// [`Error::Arguments`] for rows that it has not.
    pub fn new(store: &'a Store, rows: Range<u64>) -> Result<Self> {
        let layout = store.layout();
        check_range(store.path(), &layout, &rows)?;
        let whole = rows == (0..layout.rows);
        Ok(Self {
            store,
            at: rows.start * u64::from(layout.columns),
            rows,
            whole: whole.then(Sha256::new),
            chunk: None,
            wanted: Vec::new(),
            chunks: 0,
            differing: 0,
            problem: None,
        })
    }

    /// Compares the next words, row-major; floats as their bits.
    ///
    /// # Errors
    /// [`Error::Io`] where a chunk is there and cannot be read, [`Error::Arguments`] for more words
    /// than the rows have.
    pub fn take(&mut self, mut words: &[u32]) -> Result<()> {
        let layout = self.store.layout();
        let columns = u64::from(layout.columns);
        let end = self.rows.end * columns;
        if words.len() as u64 > end - self.at {
            return check_end(self.at.saturating_add(words.len() as u64), end);
        }
        while !words.is_empty() {
            let number = self.at / columns / self.store.chunk_rows;
            let own = self.store.rows(number);
            self.enter(number)?;
            let left = own.end * columns - self.at;
            let (now, later) = words.split_at(left.min(words.len() as u64) as usize);
            self.wanted.clear();
            layout.element.append(now, &mut self.wanted);
            if let Some(chunk) = &mut self.chunk
                && !chunk.bytes.is_empty()
            {
                let first = (self.at - own.start * columns) * layout.element.bytes();
                let found = chunk.bytes.get(first as usize..).unwrap_or_default();
                let found = &found[..found.len().min(self.wanted.len())];
                chunk.differing.compare(self.at, found, &self.wanted);
            }
            self.at += now.len() as u64;
            words = later;
        }
        Ok(())
    }

    /// Ends with the last chunk. Returns the SHA-256 of the array's bytes where all rows were
    /// compared.
    ///
    /// # Errors
    /// [`Error::Differs`] where anything was not equal: the first chunk is named, and of it the
    /// first row. [`Error::Arguments`] where words are missing.
    pub fn finish(mut self) -> Result<Option<String>> {
        check_end(
            self.at,
            self.rows.end * u64::from(self.store.layout().columns),
        )?;
        self.leave();
        let Some(problem) = self.problem else {
            return Ok(self.whole.map(|whole| hexadecimal(&whole.finalize())));
        };
        let of = |row: u64| row / self.store.chunk_rows;
        let total = of(self.rows.end - 1) + 1 - of(self.rows.start);
        let rows = match self.differing {
            0 => String::new(),
            rows => format!("{rows} of {} rows and ", self.rows.end - self.rows.start),
        };
        Err(Error::Differs {
            path: self.store.path().to_owned(),
            problem: format!("{problem}; {rows}{} of {total} chunks differ", self.chunks),
        })
    }

    /// Goes to a chunk.
    fn enter(&mut self, number: u64) -> Result<()> {
        if self.chunk.as_ref().is_some_and(|at| at.number == number) {
            return Ok(());
        }
        self.leave();
        let mut chunk = Chunk {
            number,
            bytes: Vec::new(),
            fault: None,
            differing: Differing::new(&self.store.layout()),
        };
        match self.store.file(number)? {
            Err(fault) => chunk.fault = Some(fault),
            Ok(file) => {
                let read = file
                    .take(self.store.chunk_bytes())
                    .read_to_end(&mut chunk.bytes);
                read.map_err(|source| failed("read", &self.store.chunk(number), source))?;
            }
        }
        if let Some(whole) = &mut self.whole {
            if chunk.fault.is_none() {
                let sha256 = hexadecimal(&Sha256::digest(&chunk.bytes));
                chunk.fault = match self.store.recorded(number) {
                    Err(fault) => Some(fault),
                    Ok(recorded) => (recorded != sha256).then_some(Fault::Damaged),
                };
            }
            let rows = self.store.rows(number);
            // What is behind the rows of the last chunk counts by its hash alone.
            chunk
                .bytes
                .truncate(((rows.end - rows.start) * self.store.row_bytes()) as usize);
            whole.update(&chunk.bytes);
        }
        self.chunk = Some(chunk);
        Ok(())
    }

    /// Judges the chunk at work.
    fn leave(&mut self) {
        let Some(chunk) = self.chunk.take() else {
            return;
        };
        let number = chunk.number;
        let said = match (&chunk.fault, chunk.differing.first()) {
            (None, None) => return,
            (Some(fault), None) => format!("chunk {number} is {fault}"),
            (Some(fault), Some(first)) => format!("chunk {number} is {fault}: {first}"),
            (None, Some(first)) if self.whole.is_none() => format!("chunk {number}: {first}"),
            // `generate` would keep it.
            (None, Some(first)) => format!(
                "chunk {number} has its recorded hash, so remove {} before it is made again: {first}",
                self.store.chunk(number).display()
            ),
        };
        self.chunks += 1;
        self.differing += chunk.differing.rows();
        self.problem.get_or_insert(said);
    }
}
