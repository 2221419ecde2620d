//! JSON documents that others may have written, read within bounds.

use super::bounded;
use crate::error::{Error, Result};
use serde_json::Value;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Reads a document of at most so many bytes; `remedy` is what to do about one that is none.
///
/// # Errors
/// [`Error::Document`] for what cannot be read, is longer, or is no JSON.
pub fn read_json(path: &Path, most: u64, remedy: &'static str) -> Result<Value> {
    let opened = File::open(path).map_err(|error| error.to_string());
    opened
        .and_then(|file| bounded(file, most))
        .map_err(|problem| Error::Document {
            path: path.to_owned(),
            problem,
            remedy,
        })
}

/// The document that a file holds, or what is wrong with it.
pub(super) fn bounded(file: impl Read, most: u64) -> Result<Value, String> {
    let text = bounded::bytes(file, most)?;
    serde_json::from_slice(&text).map_err(|error| format!("it is no JSON document ({error})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn documents_are_json_within_the_limit() {
        assert_eq!(bounded(&b"[1]"[..], 3), Ok(serde_json::json!([1])));
        let long = bounded(&b"[1]"[..], 2).expect_err("three bytes");
        assert!(long.contains("more than 2 bytes"), "{long}");
        let text = bounded(&b"text"[..], 9).expect_err("no JSON");
        assert!(text.contains("no JSON document"), "{text}");
    }
}
