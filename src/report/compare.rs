//! A file against its rows made again.

mod hashes;

use super::chunked::Sidecar;
use super::differing::{Differing, check_end, check_range};
use super::encode::Encoder;
use super::place::failed;
use super::text;
use crate::error::{Error, Result};
use hashes::Hashes;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Bytes that are read at a time.
const BLOCK: usize = 1 << 20;

/// Compares a file with words that somebody makes, byte for byte; where all rows are compared
/// also header, end and hashes.
pub struct Comparison {
    path: PathBuf,
    encoder: Encoder,
    file: BufReader<File>,
    /// None where only a range is compared.
    hashes: Option<Hashes>,
    /// The rows asked for; the word to come, and that after the last.
    count: u64,
    at: u64,
    end: u64,
    /// Bytes that the words to come begin with, and those of the file.
    wanted: Vec<u8>,
    found: Vec<u8>,
    differing: Differing,
    /// What is wrong before the first row.
    problem: Option<String>,
}

impl Comparison {
    /// Opens a file, of which these rows are to be compared.
    ///
    /// # Errors
    /// [`Error::Arguments`] for rows that it has not, [`Error::Differs`] where its size is not
    /// that of the sidecar, [`Error::Points`] where it cannot be opened.
    pub fn open(path: &Path, sidecar: &Sidecar, rows: Range<u64>) -> Result<Self> {
        let layout = sidecar.layout;
        check_range(path, &layout, &rows)?;
        let unreadable = |source: io::Error| Error::Points {
            path: path.to_owned(),
            problem: source.to_string(),
            remedy: "name a file that can be read".into(),
        };
        let file = File::open(path).map_err(unreadable)?;
        let bytes = file.metadata().map_err(unreadable)?.len();
        if bytes != sidecar.bytes {
            return Err(Error::Differs {
                path: path.to_owned(),
                problem: format!("it has {bytes} bytes, and {} by its sidecar", sidecar.bytes),
            });
        }
        // A header of text names every column: more than the file has need not be made.
        let least = 2 * u64::from(layout.columns);
        if sidecar.format.is_text() && bytes < least {
            return Err(Error::Differs {
                path: path.to_owned(),
                problem: format!("it has {bytes} bytes, and at least {least} by its shape"),
            });
        }
        let encoder = Encoder {
            format: sidecar.format,
            layout,
            name: sidecar.name.clone(),
        };
        let header = encoder.header().len() as u64;
        if let Some(row) = encoder.row_bytes()
            && header + row * layout.rows != bytes
        {
            let must = header + row * layout.rows;
            return Err(Error::Differs {
                path: path.to_owned(),
                problem: format!("it has {bytes} bytes, and {must} by its shape"),
            });
        }
        let columns = u64::from(layout.columns);
        let whole = rows == (0..layout.rows);
        let mut comparison = Self {
            path: path.to_owned(),
            encoder,
            file: BufReader::with_capacity(BLOCK, file),
            hashes: whole.then(|| Hashes::new(sidecar)),
            count: rows.end - rows.start,
            at: rows.start * columns,
            end: rows.end * columns,
            wanted: Vec::new(),
            found: Vec::new(),
            differing: Differing::new(&layout),
            problem: None,
        };
        comparison
            .begin(rows.start)
            .map_err(|source| failed("read", path, source))?;
        Ok(comparison)
    }

    /// Compares the header, and goes to a row.
    fn begin(&mut self, row: u64) -> io::Result<()> {
        let header = self.encoder.header();
        self.read(header.len())?;
        if self.found != header {
            self.problem = Some("its header is not that of its shape and type".into());
        }
        if let Some(hashes) = &mut self.hashes {
            hashes.frame(&self.found);
        }
        match self.encoder.row_bytes() {
            Some(bytes) => {
                let offset = header.len() as u64 + row * bytes;
                self.file.seek(SeekFrom::Start(offset))?;
            }
            None => {
                for _ in 0..row {
                    if !self.line(0)? {
                        // Its sidecar may say more rows than it has.
                        break;
                    }
                }
            }
        }
        Ok(())
    }

    /// Compares the next words, row-major; floats as their bits.
    ///
    /// # Errors
    /// [`Error::Io`] where the file cannot be read.
    pub fn take(&mut self, words: &[u32]) -> Result<()> {
        self.encoder.append(self.at, words, &mut self.wanted);
        let compared = match self.encoder.row_bytes() {
            Some(_) => self.binary(),
            None => self.text(),
        };
        self.at += words.len() as u64;
        compared.map_err(|source| failed("read", &self.path, source))
    }

    fn binary(&mut self) -> io::Result<()> {
        let wanted = std::mem::take(&mut self.wanted);
        self.read(wanted.len())?;
        self.differing.compare(self.at, &self.found, &wanted);
        self.hash();
        self.wanted = wanted;
        self.wanted.clear();
        Ok(())
    }

    fn text(&mut self) -> io::Result<()> {
        let wanted = std::mem::take(&mut self.wanted);
        let mut row = self.at / u64::from(self.encoder.layout.columns);
        let mut lines = wanted.split_inclusive(|byte| *byte == b'\n').peekable();
        while let Some(line) = lines.next_if(|line| line.ends_with(b"\n")) {
            self.line(line.len())?;
            if self.found != line {
                let (is, must) = (text::show(&self.found), text::show(line));
                self.differing
                    .note(row, || format!("row {row} is {is} and must be {must}"));
            }
            row += 1;
        }
        // A row that goes on with the words to come.
        self.wanted = lines.next().unwrap_or_default().to_vec();
        Ok(())
    }

    /// Compares what follows the last row, and the hashes.
    ///
    /// # Errors
    /// [`Error::Differs`] where anything was not equal, [`Error::Arguments`] where words are
    /// missing, [`Error::Io`] where the file cannot be read.
    pub fn finish(mut self) -> Result<()> {
        check_end(self.at, self.end)?;
        let differing = &self.differing;
        let rows = differing.first().map(|first| {
            let (rows, count) = (differing.rows(), self.count);
            format!("{first}; {rows} of {count} rows differ")
        });
        let mut problem = self.problem.take().or(rows);
        if let Some(mut hashes) = self.hashes.take() {
            let footer = self.encoder.footer();
            let rest = rest(&mut self.file, &mut hashes, footer.len() + 1);
            if rest.map_err(|source| failed("read", &self.path, source))? != footer {
                let end = "what follows its last row is not the end of such a file";
                problem.get_or_insert(end.into());
            }
            if let Some(wrong) = hashes.finish() {
                problem.get_or_insert(wrong);
            }
        }
        match problem {
            Some(problem) => Err(Error::Differs {
                path: self.path,
                problem,
            }),
            None => Ok(()),
        }
    }

    fn read(&mut self, bytes: usize) -> io::Result<()> {
        // What is not there is not equal.
        self.found.clear();
        let mut part = (&mut self.file).take(bytes as u64);
        part.read_to_end(&mut self.found).map(|_| ())
    }

    /// Reads and hashes a line, of which one byte more than so many is kept: a damaged file may be
    /// one line. False at the end of the file.
    fn line(&mut self, most: usize) -> io::Result<bool> {
        self.found.clear();
        let mut any = false;
        loop {
            let block = match self.file.fill_buf() {
                Ok(block) => block,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                Err(error) => return Err(error),
            };
            let end = block.iter().position(|byte| *byte == b'\n');
            let part = &block[..end.map_or(block.len(), |end| end + 1)];
            if let Some(hashes) = &mut self.hashes {
                hashes.data(part);
            }
            let room = (most + 1).saturating_sub(self.found.len());
            self.found.extend_from_slice(&part[..part.len().min(room)]);
            let read = part.len();
            self.file.consume(read);
            any |= read > 0;
            if end.is_some() || read == 0 {
                return Ok(any);
            }
        }
    }

    fn hash(&mut self) {
        if let Some(hashes) = &mut self.hashes {
            hashes.data(&self.found);
        }
    }
}

/// Hashes what is left of a file, and returns the first bytes of it.
fn rest(file: &mut impl Read, hashes: &mut Hashes, most: usize) -> io::Result<Vec<u8>> {
    let (mut kept, mut block) = (Vec::new(), vec![0; BLOCK]);
    loop {
        let read = match file.read(&mut block) {
            Ok(0) => return Ok(kept),
            Ok(read) => &block[..read],
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(error),
        };
        hashes.frame(read);
        kept.extend_from_slice(&read[..read.len().min(most - kept.len())]);
    }
}
