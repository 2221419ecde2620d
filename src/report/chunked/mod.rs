//! Files of chunks: written beside the producer, and taken up again where a run ended.
//!
//! The data of `big.npy` grows in `.big.npy.partial`; `.big.npy.partial.json` says which chunks
//! of it are on the disk. At the end `big.npy.json` comes first and `big.npy` after it. A crash
//! between the two leaves a sidecar whose SHA-256 matches no data, which shows; the other order
//! would leave data under its final name that nothing describes, or that an older sidecar
//! describes wrongly.

mod allocate;
mod extent;
mod file;
mod journal;
mod pipeline;
mod recover;
mod sidecar;
mod turn;
mod written;

pub use extent::Extent;
pub use sidecar::{Origin, SIDECAR_SCHEMA, Sidecar};

pub(super) use file::Chunked;
pub(super) use sidecar::{check_free, document, recorded, save as describe, whole_description};
pub(super) use turn::Turn;

use super::Layout;
use super::encode::Encoder;
use super::place::{Existing, existing, refused};
use crate::error::{Error, Result};
use journal::Journal;
use serde_json::Value;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// Endings of the partial file and of its journal.
const PARTIAL: &str = ".partial";
const JOURNAL: &str = ".partial.json";

/// Bytes of a chunk, about.
const CHUNK_BYTES: u64 = 64 << 20;

/// Chunks keep whole pages where rows are small: a multiple of this many.
const GRAIN: u64 = 4096;

/// The most chunks of a file: a sidecar has a line for each.
pub const MAX_CHUNKS: u64 = 1 << 16;

/// A part of a file's data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chunk {
    /// Its length.
    pub bytes: u64,
    /// SHA-256 of it, in hexadecimal digits.
    pub sha256: String,
}

impl Chunk {
    pub(super) fn read(value: &Value) -> Option<Self> {
        Some(Self {
            bytes: value.get("bytes")?.as_u64()?,
            sha256: value.get("sha256")?.as_str()?.to_owned(),
        })
    }
}

/// Rows of a chunk, which depend on the layout alone: about 64 MiB, and at most [`MAX_CHUNKS`]
/// chunks.
#[must_use]
pub fn chunk_rows(layout: &Layout) -> u64 {
    let row = u64::from(layout.columns.max(1)) * layout.element.bytes();
    let rows = (CHUNK_BYTES / row).max(1);
    let even = if rows > GRAIN {
        rows / GRAIN * GRAIN
    } else {
        rows
    };
    even.max(layout.rows.div_ceil(MAX_CHUNKS))
}

/// How much of a file outlives a run that fails.
#[derive(Clone, Copy, Debug, Default)]
pub struct Keeping {
    /// Go on from what an earlier run left, rather than discard it.
    pub resume: bool,
    /// Rows of a chunk, at least 1; by default those of [`chunk_rows`].
    pub chunk_rows: Option<u64>,
}

impl Keeping {
    fn rows(&self, layout: &Layout) -> Result<u64> {
        let rows = self.chunk_rows.unwrap_or(chunk_rows(layout));
        if rows == 0 || layout.rows.div_ceil(rows) > MAX_CHUNKS {
            return Err(Error::Arguments {
                asked: format!("chunks of {rows} rows"),
                limit: format!("a file has at most {MAX_CHUNKS} chunks of at least 1 row"),
                remedy: format!(
                    "ask for {} or more",
                    layout.rows.div_ceil(MAX_CHUNKS).max(1)
                ),
            });
        }
        Ok(rows.min(layout.rows.max(1)))
    }
}

/// Whether the file is there with a sidecar of the same origin and form, and no partial file
/// is. Its bytes are not read. A journal that a kill left behind the last rename is removed. One
/// that another version finished is refused: this one may make other bits.
pub(super) fn is_finished(path: &Path, encoder: &Encoder, origin: &Origin) -> Result<bool> {
    let Existing::File(real) = existing(path)? else {
        return Ok(false);
    };
    let Ok(found) = Sidecar::of(&real) else {
        return Ok(false);
    };
    let length = std::fs::metadata(&real).map(|file| file.len()).ok();
    let finished = !beside(&real, PARTIAL).exists()
        && length == Some(found.bytes)
        && found.origin.arguments == origin.arguments
        && (found.format, found.layout) == (encoder.format, encoder.layout);
    let own = env!("CARGO_PKG_VERSION");
    if finished && found.version != own {
        let by = found.version;
        return Err(refused(
            path,
            format!("version {by} of corput finished it, and this is {own}"),
            "check it with `corput verify`, or drop --resume to make it again",
        ));
    }
    let left = beside(&real, JOURNAL);
    if finished && left.exists() {
        Journal::open(left, path)?.remove();
    }
    Ok(finished)
}

/// `.NAME` with an ending, in the folder of the file.
fn beside(file: &Path, ending: &str) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(file.file_name().unwrap_or_default());
    name.push(ending);
    file.with_file_name(name)
}
