//! JSON documents that others may have written, read within bounds.

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

/// The document that a file holds, or what is wrong with it. No more than tells that it is too
/// long is read: a pipe or a device may have no end.
pub(super) fn bounded(file: impl Read, most: u64) -> Result<Value, String> {
    let mut text = Vec::new();
    let read = file.take(most.saturating_add(1)).read_to_end(&mut text);
    read.map_err(|error| error.to_string())?;
    if text.len() as u64 > most {
        return Err(format!("it has more than {most} bytes, the limit"));
    }
    serde_json::from_slice(&text).map_err(|error| format!("it is no JSON document ({error})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_than_the_limit_is_read() {
        assert_eq!(bounded(&b"[1]"[..], 3), Ok(serde_json::json!([1])));
        let long = bounded(&b"[1]"[..], 2).expect_err("three bytes");
        assert!(long.contains("more than 2 bytes"), "{long}");
        // Without an end.
        let endless = bounded(std::io::repeat(b' '), 1 << 16).expect_err("no end");
        assert!(endless.contains("the limit"), "{endless}");
        let text = bounded(&b"text"[..], 9).expect_err("no JSON");
        assert!(text.contains("no JSON document"), "{text}");
    }
}
