//! Words to bytes: the `.npy` header, little-endian words, text.

use super::text;
use super::{Element, Format, Layout};

/// Where the data of an `.npy` file starts: a page, so that a memory map or
/// an imported host pointer of the data is aligned.
pub const NPY_DATA_OFFSET: usize = 4096;

/// The `.npy` header: [`NPY_DATA_OFFSET`] bytes, format version 1.0.
///
/// Version 1.0 always suffices: its header may have 65,535 bytes, and the
/// dictionary of an array of a few axes has under 200.
#[must_use]
pub fn npy_header(layout: &Layout) -> Vec<u8> {
    let shape = format!("({}, {})", layout.rows, layout.columns);
    header_of(layout.element, &shape)
}

/// A whole `.npy` file of any shape, row-major; an empty shape is that of one number.
#[must_use]
pub fn npy_array(element: Element, shape: &[u32], words: &[u32]) -> Vec<u8> {
    let axes: String = shape.iter().map(|axis| format!("{axis}, ")).collect();
    let mut bytes = header_of(element, &format!("({})", axes.trim_end()));
    bytes.extend(words.iter().flat_map(|word| word.to_le_bytes()));
    bytes
}

fn header_of(element: Element, shape: &str) -> Vec<u8> {
    let prefix_len = 10;
    let mut header = Vec::with_capacity(NPY_DATA_OFFSET);
    header.extend_from_slice(b"\x93NUMPY\x01\x00");
    header.extend_from_slice(&((NPY_DATA_OFFSET - prefix_len) as u16).to_le_bytes());
    header.extend_from_slice(
        format!(
            "{{'descr': '{}', 'fortran_order': False, 'shape': {shape}, }}",
            element.descr()
        )
        .as_bytes(),
    );
    header.resize(NPY_DATA_OFFSET - 1, b' ');
    header.push(b'\n');
    header
}

/// The bytes of one array in one format: a header, and the rows.
#[derive(Clone, Debug)]
pub(super) struct Encoder {
    pub(super) format: Format,
    pub(super) layout: Layout,
}

impl Encoder {
    /// What stands before the first row.
    pub(super) fn header(&self) -> Vec<u8> {
        match self.format {
            Format::Npy => npy_header(&self.layout),
            Format::Raw => Vec::new(),
            Format::Csv => text::csv_header(self.layout.columns),
        }
    }

    /// Bytes of a row, where all have as many.
    pub(super) fn row_bytes(&self) -> Option<u64> {
        match self.format {
            Format::Npy | Format::Raw => {
                Some(u64::from(self.layout.columns) * self.layout.element.bytes())
            }
            Format::Csv => None,
        }
    }

    /// Appends the bytes of words, the first of which is the array's word `at`.
    pub(super) fn append(&self, at: u64, words: &[u32], out: &mut Vec<u8>) {
        match self.format {
            Format::Npy | Format::Raw => append_words(words, out),
            Format::Csv => text::csv(&self.layout, at, words, out),
        }
    }
}

/// Little-endian words; on a little-endian host a copy of memory.
fn append_words(words: &[u32], out: &mut Vec<u8>) {
    if cfg!(target_endian = "little") {
        out.extend_from_slice(bytemuck::cast_slice(words));
    } else {
        out.extend(words.iter().flat_map(|word| word.to_le_bytes()));
    }
}
