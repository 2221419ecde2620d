//! Files that others may have written, read within bounds.

use std::io::Read;
#[cfg(any(feature = "gpu", feature = "scenes"))]
use std::{fs::File, path::Path};

/// All bytes of a file that has at most so many, or what is wrong with it. No more than tells
/// that it is too long is read: a pipe or a device may have no end.
pub(crate) fn bytes(file: impl Read, most: u64) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let read = file.take(most.saturating_add(1)).read_to_end(&mut bytes);
    read.map_err(|error| error.to_string())?;
    match bytes.len() as u64 > most {
        true => Err(format!("it has more than {most} bytes, the limit")),
        false => Ok(bytes),
    }
}

/// The same of the text at a path.
#[cfg(any(feature = "gpu", feature = "scenes"))]
pub(crate) fn text(path: &Path, most: u64) -> Result<String, String> {
    let file = File::open(path).map_err(|error| error.to_string())?;
    String::from_utf8(bytes(file, most)?).map_err(|error| format!("it is no text ({error})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_than_the_limit_is_read() {
        assert_eq!(bytes(&b"abc"[..], 3), Ok(b"abc".to_vec()));
        let long = bytes(&b"abc"[..], 2).expect_err("three bytes");
        assert!(long.contains("more than 2 bytes"), "{long}");
        let endless = bytes(std::io::repeat(b' '), 1 << 16).expect_err("no end");
        assert!(endless.contains("the limit"), "{endless}");
    }

    #[cfg(any(feature = "gpu", feature = "scenes"))]
    #[test]
    fn text_is_utf_8() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("t");
        std::fs::write(&path, "ab").expect("written");
        assert_eq!(text(&path, 2), Ok("ab".to_owned()));
        assert!(text(&path, 1).is_err_and(|problem| problem.contains("the limit")));
        std::fs::write(&path, [0xff]).expect("written");
        assert!(text(&path, 9).is_err_and(|problem| problem.contains("no text")));
        assert!(text(&folder.path().join("none"), 9).is_err());
    }
}
