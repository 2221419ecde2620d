//! Words to bytes: headers, rows and what stands at the end.

use super::{Element, Format, Layout, source, text};
use crate::error::Result;

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
    element.append(words, &mut bytes);
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

/// The bytes of one array in one format: a header, the rows, and an end.
#[derive(Clone, Debug)]
pub(super) struct Encoder {
    pub(super) format: Format,
    pub(super) layout: Layout,
    /// The array's name in source text; none in data.
    pub(super) name: Option<String>,
}

impl Encoder {
    /// `file` is the name of the file, after which an array in source text is called.
    ///
    /// # Errors
    /// [`crate::Error::Arguments`] for an impossible layout, or one that source text cannot hold.
    pub(super) fn new(format: Format, layout: Layout, file: &str) -> Result<Self> {
        layout.words()?;
        let name = match format.is_source() {
            true => Some(source::name(format, &layout, file)?),
            false => None,
        };
        Ok(Self {
            format,
            layout,
            name,
        })
    }

    fn name(&self) -> &str {
        self.name.as_deref().unwrap_or_default()
    }

    /// What stands before the first row.
    pub(super) fn header(&self) -> Vec<u8> {
        match self.format {
            Format::Npy => npy_header(&self.layout),
            Format::Raw => Vec::new(),
            Format::Csv => text::csv_header(self.layout.columns),
            Format::C => source::c_header(&self.layout, self.name()),
            Format::Glsl => source::glsl_header(&self.layout, self.name()),
        }
    }

    /// What stands after the last row.
    pub(super) fn footer(&self) -> &'static [u8] {
        match self.format {
            Format::Npy | Format::Raw | Format::Csv => b"",
            Format::C => source::C_FOOTER,
            Format::Glsl => source::GLSL_FOOTER,
        }
    }

    /// Bytes of a row in binary formats. In text each row is a line.
    pub(super) fn row_bytes(&self) -> Option<u64> {
        let row = u64::from(self.layout.columns) * self.layout.element.bytes();
        (!self.format.is_text()).then_some(row)
    }

    /// Appends the bytes of words, the first of which is the array's word `at`.
    pub(super) fn append(&self, at: u64, words: &[u32], out: &mut Vec<u8>) {
        let layout = &self.layout;
        match self.format {
            Format::Npy | Format::Raw => layout.element.append(words, out),
            Format::Csv => text::csv(layout, at, words, out),
            Format::C => source::c(layout, at, words, out),
            Format::Glsl => source::glsl(layout, at, words, out),
        }
    }
}
