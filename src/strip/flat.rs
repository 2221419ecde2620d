//! What a flattened text has kept and left out.

use super::item::{Class, Item};
use super::lex::Kind;
use super::preprocess::{Directive, Text};
use super::print::Kept;
use super::words::{is_qualifier, words_of};

/// A flattened shader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flat {
    /// The shader: complete GLSL without includes and conditions.
    pub text: String,
    /// The files that it was made of, in the order in which they were met.
    pub parts: Vec<Part>,
}

/// One file of a flattened shader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Its include name; `main` for the shader itself, `defines` for macros from outside.
    pub name: String,
    /// What the shader has of it.
    pub kept: Contents,
    /// What it lacks. Branches of conditions that were not taken are on neither list.
    pub left_out: Contents,
}

/// Declarations of a file, in its order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contents {
    /// Functions, each overload by itself.
    pub functions: Vec<String>,
    /// Constants.
    pub constants: Vec<Constant>,
    /// Macros, less those that guard a file.
    pub macros: Vec<String>,
    /// Types.
    pub structs: Vec<String>,
    /// Buffers, uniform blocks and push constants, by the names of the blocks.
    pub blocks: Vec<String>,
    /// Specialization constants.
    pub specialization: Vec<String>,
    /// Variables of the file.
    pub variables: Vec<String>,
}

/// A constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Constant {
    /// Its name.
    pub name: String,
    /// Bytes of its value, of all elements if it is a table; none where its type is a struct or
    /// its size no literal.
    pub bytes: Option<u64>,
    /// Whether it is an array.
    pub table: bool,
}

impl Contents {
    /// Bytes of the tables.
    #[must_use]
    pub fn table_bytes(&self) -> u64 {
        let tables = self.constants.iter().filter(|constant| constant.table);
        tables.filter_map(|table| table.bytes).sum()
    }

    fn add(&mut self, text: &Text, item: &Item) {
        let names = item
            .names
            .iter()
            .map(|name| text.names.text(*name).to_owned());
        match item.class {
            Class::Function => self.functions.extend(names),
            Class::Struct => self.structs.extend(names.take(1)),
            Class::Block => self.blocks.extend(names.take(1)),
            Class::Specialization => self.specialization.extend(names),
            Class::Variable => self.variables.extend(names),
            Class::Constant => {
                let (bytes, table) = size(text, item);
                self.constants
                    .extend(names.map(|name| Constant { name, bytes, table }));
            }
            Class::Prototype | Class::Setting => {}
        }
    }
}

/// The lists of each file.
pub(super) fn parts(text: &Text, items: &[Item], kept: &Kept) -> Vec<Part> {
    let mut parts: Vec<Part> = text
        .sources
        .iter()
        .map(|source| Part {
            name: source.name.clone(),
            kept: Contents::default(),
            left_out: Contents::default(),
        })
        .collect();
    for (item, keep) in items.iter().zip(&kept.items) {
        let file = text.raw.get(item.raw.start).map(|token| token.file);
        if let Some(part) = file.and_then(|file| parts.get_mut(file)) {
            let list = if *keep {
                &mut part.kept
            } else {
                &mut part.left_out
            };
            list.add(text, item);
        }
    }
    for (_, directive) in &text.directives {
        let Directive::Define(index) = directive else {
            continue;
        };
        let Some(definition) = text.macros.definitions.get(*index).filter(|d| !d.guard) else {
            continue;
        };
        let file = definition.written.first().map(|token| token.file);
        if let Some(part) = file.and_then(|file| parts.get_mut(file)) {
            let keep = kept.directive(directive);
            let list = if keep {
                &mut part.kept
            } else {
                &mut part.left_out
            };
            list.macros
                .push(text.names.text(definition.name).to_owned());
        }
    }
    parts
}

/// Bytes of a constant, where its type and dimensions are plain, and whether it is an array.
fn size(text: &Text, item: &Item) -> (Option<u64>, bool) {
    let tokens = text.live.get(item.live.clone()).unwrap_or_default();
    let word = |at: usize| {
        tokens
            .get(at)
            .map_or("", |token| text.names.text(token.symbol))
    };
    let mut at = 0;
    while is_qualifier(word(at)) {
        at += 1;
    }
    let kind = word(at);
    let head = (at..tokens.len()).take_while(|at| word(*at) != "=");
    let (mut bytes, mut table) = (words_of(kind).map(|words| 4 * words), false);
    for at in head {
        if word(at) != "[" {
            continue;
        }
        table = true;
        let length = match (tokens.get(at + 1), word(at + 2)) {
            (Some(number), "]") if number.kind == Kind::Number => text
                .names
                .text(number.symbol)
                .trim_end_matches(['u', 'U'])
                .parse()
                .ok(),
            _ => None,
        };
        bytes = bytes
            .zip(length)
            .and_then(|(bytes, length): (u64, u64)| bytes.checked_mul(length));
    }
    (bytes.filter(|_| item.names.len() == 1), table)
}
