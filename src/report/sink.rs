//! The writer: rows in, a finished file out.

use std::io::{self, BufWriter, Write};
use std::path::PathBuf;

use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::encode::{csv_header, npy_header, write_csv, write_words};
use super::place::{Aside, Place, Target, failed};
use super::{Format, Layout};
use crate::error::{Error, Result};

/// Small writes are gathered up to this many bytes; larger ones pass through.
const BLOCK: usize = 1 << 20;

/// What was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// Bytes of the file, header included, sidecar not.
    pub bytes: u64,
    /// SHA-256 of the file in lower-case hexadecimal, for [`Format::Raw`],
    /// whose sidecar holds it. The other formats are not hashed: it would take
    /// longer than writing them.
    pub sha256: Option<String>,
}

/// Takes the data of one array, chunk by chunk, and makes the file of it.
///
/// Dropped without [`Sink::finish`], it removes what it wrote.
pub struct Sink {
    out: BufWriter<Counted>,
    sidecar: Option<Aside>,
    /// The target as messages name it.
    path: PathBuf,
    format: Format,
    layout: Layout,
    arguments: Value,
    /// Words in the whole array, and those taken so far.
    total: u64,
    taken: u64,
    /// Column of the next word, in CSV.
    column: u32,
    broken: bool,
}

impl Sink {
    /// Opens the target for an array of this layout. `arguments` goes into the
    /// sidecar of a raw file and is otherwise unused.
    ///
    /// # Errors
    ///
    /// [`Error::Output`] if the folder does not exist or is not writable, or if
    /// the target is a folder or, for binary data, a terminal;
    /// [`Error::Arguments`] if the layout is impossible; [`Error::Io`] if the
    /// header cannot be written.
    pub fn open(target: &Target, format: Format, layout: Layout, arguments: Value) -> Result<Self> {
        let total = layout.words()?;
        let (place, path) = Place::open(target, format)?;
        let sidecar = match &place {
            Place::Aside(data) if format == Format::Raw => Some(data.sidecar()?),
            _ => None,
        };
        let counted = Counted {
            place,
            bytes: 0,
            hash: (format == Format::Raw).then(Sha256::new),
        };
        let mut out = BufWriter::with_capacity(BLOCK, counted);
        let header = match format {
            Format::Npy => npy_header(&layout),
            Format::Raw => Vec::new(),
            Format::Csv => csv_header(layout.columns),
        };
        out.write_all(&header)
            .map_err(|e| failed("write", &path, e))?;
        Ok(Self {
            out,
            sidecar,
            path,
            format,
            layout,
            arguments,
            total,
            taken: 0,
            column: 0,
            broken: false,
        })
    }

    /// Appends words, row-major; floats as their bits. A chunk may begin and
    /// end anywhere, also within a row.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if they cannot be written: the disk is full, the pipe is
    /// closed; [`Error::Arguments`] if they are more than the layout has. The
    /// sink is of no more use then.
    pub fn write(&mut self, words: &[u32]) -> Result<()> {
        self.still_whole()?;
        // Until the words are written, so that an error cannot be passed over.
        self.broken = true;
        let taken = self.taken.saturating_add(words.len() as u64);
        if taken > self.total {
            return Err(self.miscounted(taken));
        }
        let Self {
            out,
            layout,
            column,
            ..
        } = self;
        match self.format {
            Format::Npy | Format::Raw => write_words(out, words),
            Format::Csv => write_csv(out, words, layout.element, layout.columns, column),
        }
        .map_err(|e| failed("write", &self.path, e))?;
        self.taken = taken;
        self.broken = false;
        Ok(())
    }

    /// Completes the file: all bytes to the disk, then the final name. A raw
    /// file's sidecar takes its name first and the data last. A crash between
    /// the two leaves a sidecar whose SHA-256 matches no data, which shows;
    /// the other order would leave data under its final name that nothing
    /// describes, or that an older sidecar describes wrongly.
    ///
    /// # Errors
    ///
    /// [`Error::Arguments`] if fewer words came than the layout has;
    /// [`Error::Io`] if the file cannot be completed. The data that stood
    /// under the final name is then as it was.
    pub fn finish(mut self) -> Result<Summary> {
        self.still_whole()?;
        if self.taken != self.total {
            return Err(self.miscounted(self.taken));
        }
        self.out
            .flush()
            .map_err(|e| failed("write", &self.path, e))?;
        let Self {
            out,
            sidecar,
            path,
            layout,
            arguments,
            ..
        } = self;
        let Counted { place, bytes, hash } = out
            .into_inner()
            .map_err(|e| failed("write", &path, e.into_error()))?;
        let summary = Summary {
            bytes,
            sha256: hash.map(|h| hexadecimal(&h.finalize())),
        };
        let Place::Aside(data) = place else {
            return Ok(summary);
        };
        data.sync()?;
        if let Some(mut sidecar) = sidecar {
            sidecar.fill(&describe(&layout, arguments, &summary))?;
            sidecar.sync()?;
            let name = sidecar.real().to_owned();
            sidecar.commit()?;
            return data.commit().map(|()| summary).inspect_err(|_| {
                // It describes data that is not there.
                let _ = std::fs::remove_file(name);
            });
        }
        data.commit().map(|()| summary)
    }

    fn still_whole(&self) -> Result<()> {
        if self.broken {
            return Err(failed(
                "complete",
                &self.path,
                io::Error::other("an earlier write to it failed"),
            ));
        }
        Ok(())
    }

    fn miscounted(&self, taken: u64) -> Error {
        let Layout { rows, columns, .. } = self.layout;
        Error::Arguments {
            asked: format!("{taken} words for {}", self.path.display()),
            limit: format!("{rows} rows of {columns} are {}", self.total),
            remedy: "write exactly as many as the layout has".to_owned(),
        }
    }
}

/// Counts, and for raw data hashes, what reaches the destination.
struct Counted {
    place: Place,
    bytes: u64,
    hash: Option<Sha256>,
}

impl Write for Counted {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // A block at a time, so that the hash finds it still in the cache.
        let written = self.place.write(&bytes[..bytes.len().min(BLOCK)])?;
        self.bytes += written as u64;
        if let Some(hash) = &mut self.hash {
            hash.update(&bytes[..written]);
        }
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.place.flush()
    }
}

/// The sidecar: all that one needs to load the data and to make it again.
fn describe(layout: &Layout, arguments: Value, summary: &Summary) -> Vec<u8> {
    let sidecar = json!({
        "arguments": arguments,
        "version": env!("CARGO_PKG_VERSION"),
        "shape": [layout.rows, layout.columns],
        "type": layout.element.descr(),
        "sha256": summary.sha256,
    });
    format!("{sidecar:#}\n").into_bytes()
}

/// Bytes as lower-case digits, as `sha256sum` prints a hash.
#[must_use]
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
