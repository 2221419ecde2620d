//! Arrays as source text, for C and C++ and for GLSL. Each row is a line.

use super::text::{fields, number};
use super::{Element, Format, Layout, hexadecimal};
use crate::error::{Error, Result};
use sha2::{Digest, Sha256};
use std::fmt::Write;

/// The most values: compilers take source text of megabytes, and not of more.
pub const MAX_SOURCE_VALUES: u64 = 1 << 20;

/// The array's name: `points_` and that of the file without its ending, so that it is no keyword.
/// What is no letter or digit becomes `_`, and eight digits of the SHA-256 follow: `a-b` and `a_b`
/// have two names. GLSL reserves `__`.
pub(super) fn name(format: Format, layout: &Layout, file: &str) -> Result<String> {
    let refused = |asked: String, limit: &str, remedy: &str| {
        Err(Error::Arguments {
            asked,
            limit: limit.to_owned(),
            remedy: remedy.to_owned(),
        })
    };
    let values = layout.words()?;
    if values > MAX_SOURCE_VALUES {
        let limit = format!("source text holds at most 2^20 = {MAX_SOURCE_VALUES}");
        let remedy = "ask for fewer, or write .npy or .raw and read that";
        return refused(format!("{values} values as {format}"), &limit, remedy);
    }
    if format == Format::Glsl && matches!(layout.element, Element::U16 | Element::F64) {
        return refused(
            format!("{} in a GLSL array", layout.element.name()),
            "GLSL without extensions has f32 and u32",
            "use --type f32 or u32",
        );
    }
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let parts = stem.split(|c: char| !c.is_ascii_alphanumeric());
    let mut parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    let hash = hexadecimal(&Sha256::digest(stem)[..4]);
    if parts.join("_") != stem {
        parts.push(&hash);
    }
    Ok(format!("points_{}", parts.join("_")))
}

pub(super) const C_FOOTER: &[u8] = b"};\n\n#endif\n";

pub(super) fn c_header(layout: &Layout, name: &str) -> Vec<u8> {
    let Layout { rows, columns, .. } = layout;
    let (include, kind) = match layout.element {
        Element::F32 => ("math.h", "float"),
        Element::F64 => ("math.h", "double"),
        Element::U32 => ("stdint.h", "uint32_t"),
        Element::U16 => ("stdint.h", "uint16_t"),
    };
    // No array has a name like it, and in capitals those of p.h and P.h would be one.
    let guard = format!("CORPUT_H_{name}");
    format!(
        "/* {name}[i][j]: column j of row i. */\n\
         #ifndef {guard}\n#define {guard}\n\n#include <{include}>\n\n\
         static const {kind} {name}[{rows}][{columns}] = {{\n"
    )
    .into_bytes()
}

/// Rows in braces, with numbers that read back as the same bits.
pub(super) fn c(layout: &Layout, at: u64, words: &[u32], out: &mut Vec<u8>) {
    let columns = u64::from(layout.columns);
    let mut opens = at.is_multiple_of(columns);
    for (row_at, row) in rows(layout, at, words) {
        if opens {
            out.push(b'{');
        }
        opens = true;
        fields(layout, row_at, row, out, |field, word, end| {
            c_number(layout.element, word, field);
            field.push_str(if end { "},\n" } else { ", " });
        });
    }
}

/// Words in parts that are of one row each, with the index of their first.
fn rows<'w>(
    layout: &Layout,
    mut at: u64,
    mut words: &'w [u32],
) -> impl Iterator<Item = (u64, &'w [u32])> {
    let columns = u64::from(layout.columns);
    std::iter::from_fn(move || {
        let left = (columns - at % columns).min(words.len() as u64);
        let (row, later) = words.split_at(left as usize);
        let start = at;
        at += left;
        words = later;
        (!row.is_empty()).then_some((start, row))
    })
}

fn c_number(element: Element, word: u32, out: &mut String) {
    let value = f32::from_bits(word);
    match element {
        Element::F32 if value.is_nan() => out.push_str("NAN"),
        Element::F32 if value.is_infinite() => {
            out.push_str(if value > 0.0 { "INFINITY" } else { "-INFINITY" });
        }
        Element::F32 | Element::F64 => {
            let start = out.len();
            number(element, word, out);
            if !out[start..].contains(['.', 'e']) {
                out.push_str(".0");
            }
            if element == Element::F32 {
                out.push('f');
            }
        }
        Element::U32 | Element::U16 => {
            number(element, word, out);
            out.push('u');
        }
    }
}

pub(super) const GLSL_FOOTER: &[u8] = b");\n\n#endif\n";

pub(super) fn glsl_header(layout: &Layout, name: &str) -> Vec<u8> {
    let Layout { rows, columns, .. } = layout;
    let (values, guard) = (rows * u64::from(*columns), format!("CORPUT_GLSL_{name}"));
    let element = format!("{name}[{columns}u * i + j]");
    let read = match layout.element {
        // Compilers may read decimal digits as they like.
        Element::F32 => format!("uintBitsToFloat({element})"),
        _ => element,
    };
    format!(
        "// {read} is column j of row i.\n\
         #ifndef {guard}\n#define {guard}\n\n\
         const uint {name}[{values}] = uint[](\n"
    )
    .into_bytes()
}

/// Rows of bits, and of integers.
pub(super) fn glsl(layout: &Layout, at: u64, words: &[u32], out: &mut Vec<u8>) {
    let total = layout.rows * u64::from(layout.columns);
    let last = total.checked_sub(at + words.len() as u64) == Some(0);
    fields(layout, at, words, out, |field, word, end| {
        // Writing to a string cannot fail.
        let _ = match layout.element {
            Element::F32 => write!(field, "{word:#010x}u"),
            _ => write!(field, "{word}u"),
        };
        field.push_str(if end { ",\n" } else { ", " });
    });
    if last {
        // A list of arguments ends without a comma.
        out.truncate(out.len() - 2);
        out.push(b'\n');
    }
}
