//! What a chunk is to be, and what may be wrong with it.

use std::fmt;

use serde_json::{Value, json};

/// What may be wrong with a chunk.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// It is not there.
    Missing,
    /// It has no record, or none that can be read: whoever wrote it was stopped.
    Unrecorded,
    /// It was written as part of an array with other arguments.
    Foreign,
    /// It has another length.
    Length {
        /// Bytes that it has.
        found: u64,
    },
    /// Its SHA-256 is not the one that was recorded.
    Damaged,
}

impl Fault {
    /// A word for it, as documents have it.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Missing => "missing",
            Self::Unrecorded => "unrecorded",
            Self::Foreign => "foreign",
            Self::Length { .. } => "length",
            Self::Damaged => "damaged",
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing => f.write_str("missing"),
            Self::Unrecorded => f.write_str("without a record of its hash"),
            Self::Foreign => f.write_str("of an array with other arguments"),
            Self::Length { found } => write!(f, "of the wrong length ({found} bytes)"),
            Self::Damaged => f.write_str("damaged (its hash is not the one recorded)"),
        }
    }
}

/// What was written of a chunk: `corput/INDEX.json`.
pub(super) struct Record {
    /// SHA-256 of the array's `zarr.json` without attributes of others.
    pub array: String,
    /// SHA-256 of the chunk, padding included.
    pub sha256: String,
}

impl Record {
    pub(super) fn document(&self) -> Value {
        json!({ "array": self.array, "sha256": self.sha256 })
    }

    pub(super) fn parse(document: &Value) -> Option<Self> {
        let text = |name: &str| document[name].as_str().map(str::to_owned);
        Some(Self {
            array: text("array")?,
            sha256: text("sha256")?,
        })
    }
}
