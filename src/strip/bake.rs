//! Specialization constants as plain ones.

use super::item::{Class, Item, split};
use super::lex::Kind;
use super::preprocess::{Preprocessor, Text};
use super::{Fault, MAIN};
use crate::Result;

/// A flattened shader whose specialization constants are plain constants: of the values given by
/// `constant_id`, as words, or else of their defaults. Values of constants that the shader
/// lacks, such as those that flattening left out, do nothing.
///
/// Compilers fold what depends on them, and languages without specialization constants can have
/// the shader.
///
/// # Errors
/// What [`flatten`](super::flatten) refuses, includes too; a value for a constant of another
/// type than `uint`, `int` and `bool`.
pub fn bake(text: &str, constants: &[(u32, u32)]) -> Result<String> {
    let mut lookup = |_: &str| None;
    let mut preprocessor = Preprocessor::new(&mut lookup);
    let file = preprocessor.add(MAIN, text.to_owned())?;
    preprocessor.read(file)?;
    preprocessor.expand()?;
    let read = preprocessor.text;
    let mut baked = String::with_capacity(text.len());
    let mut from = 0;
    for item in split(&read)? {
        if item.class == Class::Specialization {
            for (start, end, by) in edits(&read, &item, constants).map_err(|f| read.error(f))? {
                baked += text.get(from..start).unwrap_or("");
                baked += &by;
                from = end;
            }
        }
    }
    baked += text.get(from..).unwrap_or("");
    Ok(baked)
}

/// What a declaration changes: bytes of the text, and what is there instead.
fn edits(
    text: &Text,
    item: &Item,
    constants: &[(u32, u32)],
) -> std::result::Result<Vec<(usize, usize, String)>, Fault> {
    let tokens = text.raw.get(item.raw.clone()).unwrap_or_default();
    let word = |at: usize| tokens.get(at).map_or("", |t| text.names.text(t.symbol));
    let other = || {
        Fault::at(
            item.raw.start,
            "a specialization constant that is not understood",
            "write `layout(constant_id = N) const TYPE NAME = VALUE;`",
        )
    };
    // layout ( constant_id = N ) const TYPE NAME = VALUE... ;
    let expected = [
        (0, "layout"),
        (1, "("),
        (2, "constant_id"),
        (3, "="),
        (5, ")"),
        (6, "const"),
        (9, "="),
    ];
    let known = expected.iter().all(|(at, text)| word(*at) == *text);
    let (Some(first), Some(declared), Some(value), Some(last)) =
        (tokens.first(), tokens.get(6), tokens.get(10), tokens.last())
    else {
        return Err(other());
    };
    let number = tokens.get(4).filter(|token| token.kind == Kind::Number);
    let id = number.and_then(|number| text.names.text(number.symbol).parse::<u32>().ok());
    let Some(id) = id.filter(|_| known && item.names.len() == 1) else {
        return Err(other());
    };
    let mut edits = vec![(first.start, declared.start, String::new())];
    if let Some((_, bits)) = constants.iter().find(|(number, _)| *number == id) {
        let by = match word(7) {
            "uint" => format!("{bits}u"),
            // -2^31 is no literal.
            "int" if *bits == 1 << 31 => "-2147483647 - 1".to_owned(),
            "int" => (*bits as i32).to_string(),
            "bool" => (*bits != 0).to_string(),
            kind => {
                return Err(Fault::at(
                    item.raw.start,
                    format!("a value for a constant of type `{kind}`"),
                    "give values for `uint`, `int` and `bool`",
                ));
            }
        };
        edits.push((value.start, last.start, by));
    }
    Ok(edits)
}
