//! Parts of a file that somebody else writes in place.

use super::pipeline::PIECE;
use crate::report::encode::Encoder;
use crate::report::{Element, Format, NPY_DATA_OFFSET};
use std::fs::File;
use std::ops::Range;
use std::sync::Arc;

/// Pages begin at multiples of it, on most machines.
const PAGE: u64 = NPY_DATA_OFFSET as u64;

/// Bytes of an extent at most: few mapped pages, and bytes that are hashed soon.
const LONGEST: u64 = PIECE as u64;

/// Bytes of a chunk that has extents: what a mapping costs is little against those of more.
const LEAST: u64 = 1 << 20;

/// Space on the disk for rows of a file: whole pages of it but for the last, in which every word
/// of the rows has its 4 bytes.
///
/// While there is one the file is not made shorter: a sink that is abandoned before it is dropped
/// keeps its partial file whole, and locked for as long as the process lives. Drop it first.
#[derive(Debug)]
pub struct Extent {
    pub(super) file: Arc<File>,
    pub(super) offset: u64,
    pub(super) bytes: u64,
    pub(super) rows: Range<u64>,
}

impl Extent {
    /// The file, which is open to read and write.
    #[must_use]
    pub fn file(&self) -> &Arc<File> {
        &self.file
    }

    /// Its first byte in the file.
    #[must_use]
    pub fn offset(&self) -> u64 {
        self.offset
    }

    /// Its length.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// The rows that belong there.
    #[must_use]
    pub fn rows(&self) -> Range<u64> {
        self.rows.clone()
    }
}

/// First byte, length and rows of the extent that begins with a row, in chunks of so many rows;
/// none of files whose bytes are others than the words, or whose chunks are no whole pages.
pub(super) fn extent_from(
    encoder: &Encoder,
    chunk_rows: u64,
    row: u64,
) -> Option<(u64, u64, Range<u64>)> {
    let layout = &encoder.layout;
    let words = matches!(encoder.format, Format::Npy | Format::Raw)
        && matches!(layout.element, Element::F32 | Element::U32)
        && cfg!(target_endian = "little");
    if !words || row >= layout.rows {
        return None;
    }
    let row_bytes = encoder.row_bytes()?;
    let chunk = chunk_rows.min(layout.rows) * row_bytes;
    let offset = encoder.header().len() as u64 + row * row_bytes;
    if chunk < LEAST || !offset.is_multiple_of(PAGE) {
        return None;
    }
    if chunk_rows < layout.rows && !chunk.is_multiple_of(PAGE) {
        return None;
    }
    let end = layout.rows.min((row / chunk_rows + 1) * chunk_rows);
    let rows = match (end - row) * row_bytes {
        0..=LONGEST => end - row,
        // So many that the next begins on a page.
        _ => {
            let step = PAGE / greatest_common_divisor(PAGE, row_bytes);
            LONGEST / row_bytes / step * step
        }
    };
    (rows > 0).then(|| (offset, rows * row_bytes, row..row + rows))
}

fn greatest_common_divisor(mut a: u64, mut b: u64) -> u64 {
    while b > 0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Layout;

    fn encoder(format: Format, rows: u64, columns: u32, element: Element) -> Encoder {
        let layout = Layout {
            rows,
            columns,
            element,
        };
        Encoder::new(format, layout, "p").unwrap()
    }

    /// All extents of a file, each of which begins where the one before ends.
    fn all(encoder: &Encoder, chunk_rows: u64) -> Vec<(u64, u64, Range<u64>)> {
        let mut found: Vec<(u64, u64, Range<u64>)> = Vec::new();
        let mut row = 0;
        while let Some(next) = extent_from(encoder, chunk_rows, row) {
            if let Some((offset, bytes, rows)) = found.last() {
                assert_eq!((next.0, next.2.start), (offset + bytes, rows.end));
            }
            assert!(next.0.is_multiple_of(PAGE) && next.1 <= LONGEST);
            assert_eq!(next.2.start / chunk_rows, (next.2.end - 1) / chunk_rows);
            row = next.2.end;
            found.push(next);
        }
        found
    }

    #[test]
    fn chunks_are_extents() {
        let float = encoder(Format::Npy, 1_000_001, 4, Element::F32);
        let found = all(&float, 65536);
        assert_eq!(found.len(), 16);
        assert_eq!(found[0], (4096, 1 << 20, 0..65536));
        assert_eq!(found[15].2, 983_040..1_000_001);
        let raw = encoder(Format::Raw, 1_000_001, 4, Element::U32);
        assert_eq!(all(&raw, 65536)[1], (1 << 20, 1 << 20, 65536..131_072));
        // One chunk, which need not end with a page.
        assert_eq!(all(&float, 1_000_001).len(), 1);
    }

    #[test]
    fn long_chunks_are_cut_at_rows_and_pages() {
        for columns in [1, 3, 7, 1000, 5000] {
            let rows = 300_000_000 / u64::from(columns);
            let long = encoder(Format::Npy, rows, columns, Element::F32);
            let found = all(&long, rows);
            assert_eq!(found.last().unwrap().2.end, rows, "{columns} columns");
            assert!(found.len() > 10);
        }
    }

    #[test]
    fn other_files_have_none() {
        for (format, rows, columns, element, chunk_rows) in [
            (Format::Csv, 1 << 20, 4, Element::F32, 1 << 20),
            (Format::Npy, 1 << 20, 4, Element::U16, 1 << 20),
            (Format::Raw, 1 << 20, 4, Element::F64, 1 << 20),
            // Chunks that are small, or end within a page.
            (Format::Npy, 1 << 20, 4, Element::F32, 65535),
            (Format::Npy, 65535, 4, Element::F32, 65535),
            (Format::Npy, 1 << 20, 4, Element::F32, 65537),
            // Rows of which no whole pages are short enough.
            (Format::Raw, 1 << 20, (1 << 22) + 1, Element::F32, 1 << 20),
        ] {
            let none = encoder(format, rows, columns, element);
            assert_eq!(extent_from(&none, chunk_rows, 0), None, "{none:?}");
        }
        // From within a page on, and past the end.
        let float = encoder(Format::Npy, 1 << 20, 4, Element::F32);
        assert_eq!(extent_from(&float, 1 << 16, 1), None);
        assert_eq!(extent_from(&float, 1 << 16, 1 << 20), None);
        assert!(extent_from(&float, 1 << 16, 256).is_some());
    }
}
