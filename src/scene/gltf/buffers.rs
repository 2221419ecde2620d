//! Bytes of buffers, and what accessors make of them.

use super::container::{BROKEN, too_large};
use super::{MOST_BYTES, names::short};
use crate::scene::refused;
use crate::{Error, Result};
use glam::DVec3;
use gltf::json::accessor::{ComponentType, Type};
use gltf::json::validation::Checked;
use gltf::json::{Accessor, Root, accessor::GenericComponentType};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::Read;
use std::path::{Component, Path, PathBuf};

/// The buffers of a file, each read when it is first needed.
pub(super) struct Buffers<'r> {
    root: &'r Root,
    blob: Option<&'r [u8]>,
    path: &'r Path,
    read: BTreeMap<usize, Cow<'r, [u8]>>,
    total: u64,
}

/// Elements of an accessor, all within its buffer.
#[derive(Clone, Copy)]
pub(super) struct Elements {
    buffer: usize,
    start: usize,
    stride: usize,
    size: usize,
    /// How many there are.
    pub(super) count: usize,
}

impl<'r> Buffers<'r> {
    pub(super) fn new(root: &'r Root, blob: Option<&'r [u8]>, path: &'r Path) -> Self {
        Self {
            root,
            blob,
            path,
            read: BTreeMap::new(),
            total: 0,
        }
    }

    pub(super) fn refuse(&self, problem: impl Into<String>) -> Error {
        refused(self.path, problem, BROKEN)
    }

    /// The elements of an accessor, which must have this type and one of these components.
    pub(super) fn elements(
        &mut self,
        index: usize,
        shape: Type,
        components: &[ComponentType],
    ) -> Result<Elements> {
        let wrong = |what: &str| self.refuse(format!("accessor {index}, of a light, {what}"));
        let accessor = self.root.accessors.get(index);
        let accessor = accessor.ok_or_else(|| wrong("is not there"))?;
        if accessor.sparse.is_some() {
            return Err(wrong("is sparse, which is not read"));
        }
        let size = element(accessor, shape, components);
        let size = size.ok_or_else(|| wrong("is not of a type that is read"))?;
        let view = accessor.buffer_view.map(|view| view.value());
        let view = view.and_then(|view| self.root.buffer_views.get(view));
        let view = view.ok_or_else(|| wrong("has no data"))?;
        let stride = view.byte_stride.map_or(size, |stride| stride.0);
        let begin = view.byte_offset.unwrap_or_default().0;
        let offset = accessor.byte_offset.unwrap_or_default().0;
        let count = accessor.count.0;
        // The last byte that it reads, and the last of its view.
        let last = count.checked_sub(1).and_then(|rest| {
            let strides = rest.checked_mul(stride as u64)?;
            strides.checked_add(offset)?.checked_add(size as u64)
        });
        let fits = last.is_some_and(|last| last <= view.byte_length.0) && stride >= size;
        let end = begin.checked_add(view.byte_length.0);
        let (true, Some(end)) = (fits, end) else {
            return Err(wrong("passes the end of its view, or has no element"));
        };
        let buffer = view.buffer.value();
        let length = self.bytes(buffer)?.len() as u64;
        if end > length {
            let problem = format!("accessor {index} passes the end of buffer {buffer}");
            return Err(self.refuse(problem));
        }
        // All below the length of the buffer, hence within usize.
        Ok(Elements {
            buffer,
            start: (begin + offset) as usize,
            stride,
            size,
            count: count as usize,
        })
    }

    fn element(&self, of: Elements, index: usize) -> Option<&[u8]> {
        let start = of.start.checked_add(index.checked_mul(of.stride)?)?;
        let within = index < of.count;
        let bytes = self.read.get(&of.buffer).filter(|_| within)?;
        bytes.get(start..start.checked_add(of.size)?)
    }

    /// A position.
    pub(super) fn position(&self, of: Elements, index: usize) -> Option<DVec3> {
        let bytes: &[u8; 12] = self.element(of, index)?.try_into().ok()?;
        let [x, y, z] = [0, 4, 8].map(|at| {
            let four = [bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]];
            f64::from(f32::from_le_bytes(four))
        });
        Some(DVec3::new(x, y, z))
    }

    /// An index of a vertex.
    pub(super) fn index(&self, of: Elements, index: usize) -> Option<usize> {
        let bytes = self.element(of, index)?;
        let number = bytes.iter().rev().fold(0u32, |n, b| n << 8 | u32::from(*b));
        Some(number as usize)
    }

    /// The bytes of a buffer.
    fn bytes(&mut self, index: usize) -> Result<&[u8]> {
        if !self.read.contains_key(&index) {
            let bytes = self.load(index)?;
            self.total += bytes.len() as u64;
            self.read.insert(index, bytes);
        }
        Ok(self.read.get(&index).map_or(&[], |bytes| bytes))
    }

    fn load(&self, index: usize) -> Result<Cow<'r, [u8]>> {
        let buffer = self.root.buffers.get(index);
        let buffer = buffer.ok_or_else(|| self.refuse(format!("buffer {index} is not there")))?;
        let length = buffer.byte_length.0;
        if self.total.saturating_add(length) > MOST_BYTES {
            let what = format!("buffer {index}, with those before,");
            return Err(too_large(self.path, &what, length, "2^30"));
        }
        let bytes: Cow<[u8]> = match (buffer.uri.as_deref(), self.blob) {
            (None, Some(blob)) if index == 0 => Cow::Borrowed(blob),
            (None, _) => return Err(self.refuse(format!("buffer {index} has no data"))),
            (Some(uri), _) => match uri.strip_prefix("data:") {
                Some(data) => Cow::Owned(self.inline(index, data)?),
                None => Cow::Owned(self.file(index, uri, length)?),
            },
        };
        match bytes.len() as u64 >= length {
            true => Ok(bytes),
            false => Err(self.refuse(format!(
                "buffer {index} says {length} bytes; it has {}",
                bytes.len()
            ))),
        }
    }

    fn inline(&self, index: usize, data: &str) -> Result<Vec<u8>> {
        let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
        encoded
            .and_then(base64)
            .ok_or_else(|| self.refuse(format!("buffer {index} is no base64")))
    }

    /// A file of the scene's folder, links resolved; never one outside, nor the scene's own.
    fn file(&self, index: usize, uri: &str, length: u64) -> Result<Vec<u8>> {
        let said = format!("buffer {index}, {},", short(uri));
        let remedy = "put its buffers beside it, or below";
        let failed = |error: std::io::Error| refused(self.path, format!("{said} {error}"), remedy);
        let outside = || refused(self.path, format!("{said} is outside its folder"), remedy);
        let relative = relative(uri).ok_or_else(outside)?;
        let own = self.path.canonicalize().map_err(failed)?;
        let folder = own.parent().ok_or_else(outside)?;
        let path = folder.join(relative).canonicalize().map_err(failed)?;
        if !path.starts_with(folder) {
            return Err(outside());
        }
        if path == own || !path.is_file() {
            let problem = format!("{said} is the scene's own file, or none that is regular");
            return Err(refused(self.path, problem, remedy));
        }
        let mut bytes = Vec::new();
        let file = std::fs::File::open(&path).map_err(failed)?;
        file.take(length).read_to_end(&mut bytes).map_err(failed)?;
        Ok(bytes)
    }
}

/// Bytes of an element, if it has the type and one of the components.
fn element(accessor: &Accessor, shape: Type, components: &[ComponentType]) -> Option<usize> {
    let (Checked::Valid(found), Checked::Valid(GenericComponentType(component))) =
        (accessor.type_, accessor.component_type)
    else {
        return None;
    };
    let known = found == shape && components.contains(&component);
    known.then(|| component.size() * shape.multiplicity())
}

/// A path below a folder that a relative reference names, or none.
fn relative(uri: &str) -> Option<PathBuf> {
    let mut bytes = Vec::new();
    let mut rest = uri.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'%' => {
                let digits = [rest.next()?, rest.next()?];
                u8::from_str_radix(std::str::from_utf8(&digits).ok()?, 16).ok()?
            }
            byte => byte,
        });
    }
    let text = String::from_utf8(bytes).ok()?;
    // A scheme, a drive or a path of another system.
    if text.contains([':', '\\', '\0']) {
        return None;
    }
    let path = PathBuf::from(text);
    let below = |part| matches!(part, Component::Normal(_) | Component::CurDir);
    path.components().all(below).then_some(path)
}

/// The bytes that base64 (RFC 4648) encodes, with its padding or without.
fn base64(text: &str) -> Option<Vec<u8>> {
    let text = text.trim_end_matches('=').as_bytes();
    let digit = |byte: u8| match byte {
        b'A'..=b'Z' => Some(byte - b'A'),
        b'a'..=b'z' => Some(byte - b'a' + 26),
        b'0'..=b'9' => Some(byte - b'0' + 52),
        b'+' | b'-' => Some(62),
        b'/' | b'_' => Some(63),
        _ => None,
    };
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    for group in text.chunks(4) {
        let mut word = 0u32;
        for &byte in group {
            word = word << 6 | u32::from(digit(byte)?);
        }
        word <<= 6 * (4 - group.len());
        let whole = match group.len() {
            1 => return None,
            length => length - 1,
        };
        bytes.extend(word.to_be_bytes().iter().skip(1).take(whole));
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_rfc() {
        for (text, bytes) in [
            ("", &b""[..]),
            ("Zg==", b"f"),
            ("Zm8=", b"fo"),
            ("Zm9v", b"foo"),
            ("Zm9vYg==", b"foob"),
            ("Zm9vYmE", b"fooba"),
            ("Zm9vYmFy", b"foobar"),
        ] {
            assert_eq!(base64(text).as_deref(), Some(bytes), "{text}");
        }
        assert!(base64("Z").is_none() && base64("Zm9*").is_none());
    }

    #[test]
    fn references_stay_in_the_folder() {
        assert_eq!(relative("a%20b/c.bin"), Some(PathBuf::from("a b/c.bin")));
        for outside in [
            "../a.bin",
            "a/../../b",
            "/etc/passwd",
            "file:///a",
            "%2e%2e/a",
            "c:\\a",
            "a%",
        ] {
            assert!(relative(outside).is_none(), "{outside}");
        }
    }
}
