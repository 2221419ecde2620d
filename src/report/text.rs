//! Rows as text: a line each.

use super::element::{double, leading};
use super::{Element, Layout};
use std::fmt::Write;

/// The first line of a CSV file: `x0,x1,...`.
pub(super) fn csv_header(columns: u32) -> Vec<u8> {
    let names: Vec<String> = (0..columns).map(|column| format!("x{column}")).collect();
    format!("{}\n", names.join(",")).into_bytes()
}

/// Appends words as CSV fields.
pub(super) fn csv(layout: &Layout, at: u64, words: &[u32], out: &mut Vec<u8>) {
    fields(layout, at, words, out, |field, word, end| {
        number(layout.element, word, field);
        field.push(if end { '\n' } else { ',' });
    });
}

/// Appends words as text, the first of which is the array's word `at`, so that words may begin
/// and end within a row. `write` appends one, and hears whether it ends a row.
pub(super) fn fields(
    layout: &Layout,
    at: u64,
    words: &[u32],
    out: &mut Vec<u8>,
    write: impl Fn(&mut String, u32, bool),
) {
    let columns = u64::from(layout.columns);
    let mut field = String::new();
    for (at, &word) in (at..).zip(words) {
        field.clear();
        write(&mut field, word, (at + 1).is_multiple_of(columns));
        out.extend_from_slice(field.as_bytes());
    }
}

/// Appends the number that a word stands for.
pub(super) fn number(element: Element, word: u32, out: &mut String) {
    // Writing to a string cannot fail.
    let _ = match element {
        Element::U32 => write!(out, "{word}"),
        Element::F32 => float(f32::from_bits(word), out),
        Element::U16 => write!(out, "{}", leading(word)),
        Element::F64 => write!(out, "{}", double(word)),
    };
}

/// Appends the fewest decimal digits that read back as the same float.
///
/// Outside [1e-4, 1e16) with an exponent: plain notation would print 2^-149
/// with 45 zeros. A NaN is `NaN`: its payload has no decimal form.
fn float(value: f32, out: &mut String) -> std::fmt::Result {
    let magnitude = value.abs();
    let plain = value == 0.0 || (1e-4..1e16).contains(&magnitude) || !value.is_finite();
    if plain {
        write!(out, "{value}")
    } else {
        write!(out, "{value:e}")
    }
}

/// A row of a file as a message shows it: the beginning, without what ends the line. What a terminal
/// would obey or hide is shown as its escape.
pub(super) fn show(line: &[u8]) -> String {
    const SHOWN: usize = 80;
    let text = String::from_utf8_lossy(line);
    let text: String = text.trim().chars().flat_map(char::escape_debug).collect();
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("`{}...`", &text[..end]),
        None => format!("`{text}`"),
    }
}
