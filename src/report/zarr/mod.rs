//! Arrays as Zarr v3 stores: folders of chunks, which many processes fill at once.
//!
//! ```text
//! store.zarr/zarr.json        shape, type, chunks; what makes the array
//! store.zarr/c/3/0            chunk 3: its rows, little-endian, padded with zeros
//! store.zarr/corput/3.json    its SHA-256, and that of the array's description
//! store.zarr/corput/array.json  SHA-256 of the array's bytes, once all chunks are there
//! ```
//!
//! Any reader of Zarr v3 takes such a folder; those files under `corput` it does not look at.
//! The chunk's shape follows from the number of columns and their type alone. Every file is written aside and
//! renamed, so that nobody ever reads half of one, and each has the same bytes whoever writes
//! it: work that was done twice, or was killed, does no harm. Into how many shards the work was cut
//! when it was begun `zarr.json` notes too, which no other file depends on.
//!
//! ```
//! use corput::report::zarr::Store;
//! use corput::report::{Element, Layout};
//!
//! let folder = tempfile::tempdir().unwrap();
//! let layout = Layout { rows: 3, columns: 2, element: Element::U32 };
//! let origin = serde_json::json!({ "arguments": "of my own" });
//! let store = Store::create(&folder.path().join("a.zarr"), layout, &origin)?;
//! assert_eq!((store.chunks(), store.rows(0)), (1, 0..3));
//! store.put(0, &[1, 2, 3, 4, 5, 6])?;
//! let survey = store.survey(&mut |_| Ok(()))?;
//! assert!(survey.faults.is_empty());
//! # Ok::<(), corput::Error>(())
//! ```

mod aside;
mod begin;
mod compare;
mod fault;
mod metadata;
mod survey;

pub use compare::Comparison;
pub use fault::Fault;
pub use survey::Survey;

use std::borrow::Cow;
use std::ops::Range;
use std::path::{Path, PathBuf};

use serde_json::Value;
use sha2::{Digest, Sha256};

use super::{Element, Layout, create_folder, hexadecimal};
use crate::error::{Error, Result};
use fault::Record;

/// An array in a folder.
#[derive(Clone, Debug)]
pub struct Store {
    path: PathBuf,
    layout: Layout,
    chunk_rows: u64,
    /// SHA-256 of what describes the array.
    array: String,
    origin: Value,
    shards: Option<u64>,
}

impl Store {
    /// Opens one that is there.
    ///
    /// # Errors
    ///
    /// [`Error::Document`] if there is none, or one that [`Store::create`] did not make;
    /// [`Error::Io`] if it cannot be read.
    pub fn open(path: &Path) -> Result<Self> {
        let name = path.join("zarr.json");
        let refused = |problem: String| Error::Document {
            path: name.clone(),
            problem,
            remedy: "give a folder that `corput generate --out STORE.zarr` made",
        };
        let found =
            metadata::read(&name)?.ok_or_else(|| refused("there is no such file".to_owned()))?;
        let (layout, origin) = metadata::parse(&found).map_err(refused)?;
        Ok(Self {
            shards: metadata::shards(&found),
            ..Self::new(path, layout, origin)
        })
    }

    fn new(path: &Path, layout: Layout, origin: Value) -> Self {
        let description = metadata::document(&layout, &origin).to_string();
        Self {
            path: path.to_owned(),
            layout,
            chunk_rows: metadata::chunk_rows(&layout),
            array: hexadecimal(&Sha256::digest(description)),
            origin,
            shards: None,
        }
    }

    /// Shape and type.
    #[must_use]
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// What makes the array.
    #[must_use]
    pub fn origin(&self) -> &Value {
        &self.origin
    }

    /// Into how many shards the work was cut when the store was begun, at least 1; `None` where that
    /// was not noted.
    #[must_use]
    pub fn shards(&self) -> Option<u64> {
        self.shards
    }

    /// The folder.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Chunks of the array.
    #[must_use]
    pub fn chunks(&self) -> u64 {
        self.layout.rows.div_ceil(self.chunk_rows)
    }

    /// Rows of a chunk; none of one past the end.
    #[must_use]
    pub fn rows(&self, chunk: u64) -> Range<u64> {
        let end = self.layout.rows;
        let first = chunk.saturating_mul(self.chunk_rows).min(end);
        first..first.saturating_add(self.chunk_rows).min(end)
    }

    /// Bytes of every chunk, the last one too.
    #[must_use]
    pub fn chunk_bytes(&self) -> u64 {
        self.row_bytes() * self.chunk_rows
    }

    fn row_bytes(&self) -> u64 {
        self.layout.element.bytes() * u64::from(self.layout.columns)
    }

    /// Writes a chunk of the words of its rows, and then the record of its hash.
    ///
    /// # Errors
    ///
    /// [`Error::Arguments`] for another number of words than its rows have; [`Error::Io`] if it
    /// cannot be written.
    pub fn put(&self, chunk: u64, words: &[u32]) -> Result<()> {
        let rows = self.rows(chunk);
        let wanted = (rows.end - rows.start) * u64::from(self.layout.columns);
        if words.is_empty() || words.len() as u64 != wanted {
            return Err(Error::Arguments {
                asked: format!("{} words for chunk {chunk}", words.len()),
                limit: format!("its rows {}..{} have {wanted}", rows.start, rows.end),
                remedy: "write each chunk of the store whole".into(),
            });
        }
        let mut bytes = self.bytes(words);
        if (bytes.len() as u64) < self.chunk_bytes() {
            bytes.to_mut().resize(self.chunk_bytes() as usize, 0);
        }
        let record = Record {
            array: self.array.clone(),
            sha256: hexadecimal(&Sha256::digest(&bytes)),
        };
        let path = self.chunk(chunk);
        if let Some(folder) = path.parent() {
            create_folder(folder, "--out")?;
            // The folder's own name must last too.
            super::place::sync_folder(folder)
                .map_err(|error| super::place::failed("sync the folder of", folder, error))?;
        }
        aside::save(&self.records(), &path, &bytes)?;
        let record = metadata::text(&record.document());
        aside::save(&self.records(), &self.record(chunk), &record)
    }

    /// Words as a chunk holds them.
    fn bytes<'w>(&self, words: &'w [u32]) -> Cow<'w, [u8]> {
        match self.layout.element {
            // As they lie in memory.
            Element::U32 | Element::F32 if cfg!(target_endian = "little") => {
                Cow::Borrowed(bytemuck::cast_slice(words))
            }
            element => {
                let mut bytes = Vec::with_capacity(self.chunk_bytes() as usize);
                element.append(words, &mut bytes);
                Cow::Owned(bytes)
            }
        }
    }

    /// Where the records lie, and what is not finished.
    fn records(&self) -> PathBuf {
        self.path.join("corput")
    }

    fn record(&self, chunk: u64) -> PathBuf {
        self.records().join(format!("{chunk}.json"))
    }

    fn chunk(&self, chunk: u64) -> PathBuf {
        self.path.join("c").join(chunk.to_string()).join("0")
    }
}
