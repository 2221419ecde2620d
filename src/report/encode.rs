//! Words to bytes: the `.npy` header, little-endian words, CSV text.

use std::io::{self, Write};

use super::{Element, Layout};

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

/// Writes words little-endian; on a little-endian host without a copy.
pub(super) fn write_words(out: &mut impl Write, words: &[u32]) -> io::Result<()> {
    if cfg!(target_endian = "little") {
        return out.write_all(bytemuck::cast_slice(words));
    }
    for word in words {
        out.write_all(&word.to_le_bytes())?;
    }
    Ok(())
}

/// The first line of a CSV file: `x0,x1,...`.
pub(super) fn csv_header(columns: u32) -> Vec<u8> {
    let mut header = Vec::new();
    for column in 0..columns {
        let end = if column + 1 == columns { '\n' } else { ',' };
        header.extend_from_slice(format!("x{column}{end}").as_bytes());
    }
    header
}

/// Writes words as CSV fields. `column` is the column of the next word and is
/// carried from call to call, so a chunk may end within a row.
pub(super) fn write_csv(
    out: &mut impl Write,
    words: &[u32],
    element: Element,
    columns: u32,
    column: &mut u32,
) -> io::Result<()> {
    for &word in words {
        match element {
            Element::U32 => write!(out, "{word}")?,
            Element::F32 => write_f32(out, f32::from_bits(word))?,
        }
        *column += 1;
        if *column == columns {
            *column = 0;
            out.write_all(b"\n")?;
        } else {
            out.write_all(b",")?;
        }
    }
    Ok(())
}

/// Writes the fewest decimal digits that read back as the same float.
///
/// Outside [1e-4, 1e16) with an exponent: plain notation would print 2^-149
/// with 45 zeros. A NaN is `NaN`: its payload has no decimal form.
fn write_f32(out: &mut impl Write, value: f32) -> io::Result<()> {
    let magnitude = value.abs();
    let plain = value == 0.0 || (1e-4..1e16).contains(&magnitude) || !value.is_finite();
    if plain {
        write!(out, "{value}")
    } else {
        write!(out, "{value:e}")
    }
}
