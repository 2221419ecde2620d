//! Results to bytes: `.npy`, raw and text, into a file or standard output, and Zarr stores
//! ([`zarr`]); and `.npy` files back to points.
//!
//! A [`Sink`] takes rows of 32-bit words in pieces of any size. A file is
//! written beside its final name and renamed at the end, so a run that dies
//! leaves nothing under that name, and what stood there before stays whole. Beside it
//! stands a [`Sidecar`], by which a [`Comparison`] checks it. What a run left that was cut off
//! is taken up again by [`Sink::keeping`]. Memory use does not grow with the number of rows.
//!
//! ```
//! use corput::report::{Element, Format, Layout, Sink, Target};
//!
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("points.npy");
//! let layout = Layout { rows: 2, columns: 2, element: Element::F32 };
//! let mut sink = Sink::open(&Target::File(path.clone()), Format::Npy, layout, serde_json::Value::Null)?;
//! sink.write(&[0.0f32, 0.0, 0.5, 1.0 / 3.0].map(f32::to_bits))?;
//! let summary = sink.finish()?;
//! assert_eq!(summary.bytes, 4096 + 16);
//! assert_eq!(std::fs::metadata(&path).unwrap().len(), summary.bytes);
//! # Ok::<(), corput::Error>(())
//! ```

mod aside;
mod bounded;
mod chunked;
mod compare;
mod difference;
mod differing;
mod element;
mod encode;
mod escape;
mod format;
mod json;
mod lock;
#[cfg(feature = "gpu")]
mod owner;
mod page;
mod place;
mod read;
mod sink;
mod source;
mod stream;
mod text;
mod whole;
pub mod zarr;

#[cfg(any(feature = "gpu", feature = "scenes"))]
pub(crate) use bounded::{bytes as bounded_bytes, text as bounded_text};
pub use chunked::{
    Chunk, Extent, Keeping, MAX_CHUNKS, Origin, SIDECAR_SCHEMA, Sidecar, chunk_rows,
};
pub use compare::Comparison;
#[cfg(feature = "gpu")]
pub(crate) use difference::{Difference, differences};
pub use element::Element;
pub use encode::{NPY_DATA_OFFSET, npy_array, npy_header};
pub use escape::escape;
pub use format::Format;
pub use json::read_json;
#[cfg(feature = "gpu")]
pub(crate) use lock::try_lock;
#[cfg(all(feature = "gpu", feature = "images"))]
pub(crate) use owner::CARD;
#[cfg(feature = "gpu")]
pub(crate) use owner::STUDY;
pub use page::page;
pub use place::Target;
pub use read::{MAX_VALUES, read_points};
pub use sink::{Sink, Summary, hexadecimal};
pub use source::MAX_SOURCE_VALUES;
pub use whole::{Form, Whole};

use crate::error::{Error, Result};
use place::{Place, failed};
use std::collections::HashSet;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;

/// Writes a small file whole: aside, then under its name, as a [`Sink`] does.
///
/// # Errors
///
/// [`Error::Output`] if it cannot be created, [`Error::Io`] if it cannot be written.
pub fn save(path: &Path, bytes: &[u8]) -> Result<()> {
    Document::open(&Target::File(path.to_owned()))?.finish(bytes)
}

/// Makes a folder and those above it, as far as they are not there; `option` is the one that
/// names it.
///
/// # Errors
///
/// [`Error::Output`] if it cannot be made.
pub fn create_folder(path: &Path, option: &str) -> Result<()> {
    std::fs::create_dir_all(path).map_err(|source| Error::Output {
        path: path.to_owned(),
        problem: source.to_string(),
        remedy: format!("choose a folder that can be made and written with {option}"),
    })
}

/// As [`save`], for bytes that take time to make: a path that cannot be written is
/// refused before.
///
/// # Errors
///
/// As [`save`], and those of `make`, after which nothing is left.
pub fn save_with<B: AsRef<[u8]>>(path: &Path, make: impl FnOnce() -> Result<B>) -> Result<()> {
    let document = Document::open(&Target::File(path.to_owned()))?;
    document.finish(make()?.as_ref())
}

/// Writes several small files whole: all aside, and then each under its name. On an error
/// before all are written, none has its name.
///
/// # Errors
///
/// As [`save`].
pub fn save_all<'b>(files: impl IntoIterator<Item = (PathBuf, &'b [u8])>) -> Result<()> {
    let mut written: Vec<aside::Aside> = Vec::new();
    for (path, bytes) in files {
        let document = Document::open(&Target::File(path))?;
        match document.place {
            Place::Aside(mut aside) => {
                aside.fill(bytes)?;
                written.push(aside);
            }
            place => Document { place, ..document }.finish(bytes)?,
        }
    }
    written.iter_mut().try_for_each(aside::Aside::rename)?;
    // A folder is synced once, after its last name.
    let mut folders = HashSet::new();
    let mut last = written.iter().rev();
    last.try_for_each(|one| match folders.insert(one.real().parent()) {
        true => one.last(),
        false => Ok(()),
    })
}

/// A place for a small binary file, opened before the work whose result it takes.
///
/// Dropped without [`Document::finish`], it removes what it made.
pub struct Document {
    place: Place,
    /// The target as messages name it.
    path: PathBuf,
    /// Of a file with a FILE.json, what keeps others from it.
    turn: Option<chunked::Turn>,
}

impl Document {
    /// Opens the target.
    ///
    /// # Errors
    ///
    /// [`Error::Output`] if it cannot be created, or is a terminal.
    pub fn open(target: &Target) -> Result<Self> {
        // Small files are taken for binary ones.
        let (place, path) = Place::open(target, Format::Npy)?;
        Ok(Self {
            place,
            path,
            turn: None,
        })
    }

    /// Writes all bytes, and gives the file its name.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if they cannot be written.
    pub fn finish(self, bytes: &[u8]) -> Result<()> {
        match self.place {
            Place::Aside(mut aside) => {
                aside.fill(bytes)?;
                aside.commit()
            }
            mut place => place
                .write_all(bytes)
                .and_then(|()| place.flush())
                .map_err(|source| failed("write", &self.path, source)),
        }
    }
}

/// Shape and type of the data: `rows` x `columns`, row-major.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Number of rows: points, directions. May be 0.
    pub rows: u64,
    /// Words in a row: at least 1.
    pub columns: u32,
    /// What the array holds for each word.
    pub element: Element,
}

impl Layout {
    /// Number of words, if it and its bytes can be counted in 64 bits.
    ///
    /// # Errors
    ///
    /// [`Error::Arguments`] for no columns, or for more than 2^61 words or 2^63 bytes.
    pub fn words(&self) -> Result<u64> {
        let refused = |limit: &str, remedy: &str| Error::Arguments {
            asked: format!(
                "an array of {} rows and {} columns",
                self.rows, self.columns
            ),
            limit: limit.to_owned(),
            remedy: remedy.to_owned(),
        };
        if self.columns == 0 {
            return Err(refused(
                "a row has at least one column",
                "ask for one dimension or more",
            ));
        }
        self.rows
            .checked_mul(u64::from(self.columns))
            .filter(|words| *words <= (1 << 63) / self.element.bytes().max(4))
            .ok_or_else(|| {
                refused(
                    "an array has at most 2^63 bytes and 2^61 words",
                    "ask for fewer rows",
                )
            })
    }
}
