//! Choices: a few items by comparisons, many by a search in a table.

use super::literal::{float, word};
use crate::scene::Choice;
use std::fmt::Write;

/// A function of that name: a fraction to the index of an item, and the bits of its
/// probability. `table` is the name of the buffer with [`Choice::words`].
pub(super) fn function(name: &str, choice: &Choice, table: &str) -> String {
    let mut text = format!("uvec2 {name}(uint u) {{\n");
    // Writing to a String cannot fail.
    if choice.words().is_empty() {
        for share in choice.shares.iter().skip(1).rev() {
            let _ = writeln!(
                text,
                "    if (u >= {}) {{\n        return uvec2({}, floatBitsToUint({}));\n    }}",
                word(share.begin),
                word(share.index),
                float(share.probability)
            );
        }
        let (index, probability) = match choice.shares.first() {
            Some(first) => (first.index, first.probability),
            None => (0, 1.0),
        };
        let _ = writeln!(
            text,
            "    return uvec2({}, floatBitsToUint({}));\n}}",
            word(index),
            float(probability)
        );
        return text;
    }
    let last = choice.shares.len() - 1;
    let _ = write!(
        text,
        "    // The last of them that begins at u or before.\n\
         \x20   uint low = 0u;\n    uint high = {last}u;\n    while (low < high) {{\n\
         \x20       uint middle = (low + high + 1u) >> 1;\n\
         \x20       if (u < {table}[3u * middle]) {{\n            high = middle - 1u;\n\
         \x20       }} else {{\n            low = middle;\n        }}\n    }}\n\
         \x20   return uvec2({table}[3u * low + 1u], {table}[3u * low + 2u]);\n}}\n"
    );
    text
}
