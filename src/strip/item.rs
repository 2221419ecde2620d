//! The declarations at file level: where each begins and ends, and what it declares.

use std::ops::Range;

use super::fault::Fault;
use super::lex::{Kind, Symbol};
use super::macros::Live;
use super::preprocess::Text;
use crate::Result;

/// What a declaration declares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// A function with its body.
    Function,
    /// A function without.
    Prototype,
    /// A type, and maybe variables of it.
    Struct,
    /// A constant.
    Constant,
    /// A specialization constant.
    Specialization,
    /// A variable.
    Variable,
    /// A buffer, a uniform block or push constants.
    Block,
    /// What holds for the whole shader: the size of a group, precisions.
    Setting,
}

/// One declaration.
#[derive(Clone, Debug)]
pub(super) struct Item {
    pub(super) class: Class,
    /// The names that it brings into the file's scope.
    pub(super) names: Vec<Symbol>,
    /// Its tokens in the text.
    pub(super) raw: Range<usize>,
    /// Its tokens after expansion.
    pub(super) live: Range<usize>,
    /// Where its value begins, if it has one.
    pub(super) value: Option<usize>,
}

/// Splits a text into its declarations.
pub(super) fn split(text: &Text) -> Result<Vec<Item>> {
    let mut items: Vec<Item> = Vec::new();
    let directives = &text.directives;
    let mut at = 0;
    let mut free = 0;
    while at < text.live.len() {
        let reader = Reader { text, at };
        let mut item = reader.item().map_err(|fault| text.error(fault))?;
        at = item.live.end;
        let many = "one macro makes several declarations";
        if item.raw.start < free {
            let fault = Fault::at(item.raw.start, many, "write a macro for each");
            return Err(text.error(fault));
        }
        // What expands to nothing belongs to what follows it.
        let before = directives.partition_point(|(place, _)| *place <= item.raw.start);
        let last = before.checked_sub(1).and_then(|last| directives.get(last));
        item.raw.start = last.map_or(free, |(place, _)| free.max(*place));
        free = item.raw.end;
        // A semicolon by itself declares nothing.
        if item.live.len() > 1 {
            items.push(item);
        }
    }
    let mut next = 0;
    for (place, _) in directives {
        while items.get(next).is_some_and(|item| item.raw.end <= *place) {
            next += 1;
        }
        if items.get(next).is_some_and(|item| item.raw.start < *place) {
            let problem = "a directive that is no condition stands within a declaration";
            let fault = Fault::at(
                place.saturating_sub(1),
                problem,
                "move it out of the declaration",
            );
            return Err(text.error(fault));
        }
    }
    Ok(items)
}

pub(super) struct Reader<'a> {
    text: &'a Text,
    pub(super) at: usize,
}

impl<'a> Reader<'a> {
    pub(super) fn word(&self, at: usize) -> &'a str {
        let token = self.text.live.get(at);
        token.map_or("", |token| self.text.names.text(token.symbol))
    }

    fn token(&self, at: usize) -> Option<&'a Live> {
        self.text.live.get(at)
    }

    pub(super) fn name(&self, at: usize) -> Option<Symbol> {
        let token = self.token(at).filter(|token| token.kind == Kind::Name);
        token.map(|token| token.symbol)
    }

    pub(super) fn fault(&self, at: usize, problem: &str) -> Fault {
        let raw = self.token(at).or(self.text.live.last());
        let raw = raw.map_or(0, |token| token.raw);
        Fault::at(
            raw,
            problem,
            "write it as GLSL 4.50 has it, or keep it out of this text",
        )
    }

    fn item(&self) -> std::result::Result<Item, Fault> {
        let (end, body) = self.end()?;
        let live = self.at..end;
        let tokens = self.text.live.get(live.clone()).unwrap_or_default();
        let first = tokens.iter().map(|token| token.raw).min().unwrap_or(0);
        let ends = &self.text.macros.ends;
        let last = tokens
            .iter()
            .map(|t| ends.get(&t.raw).copied().unwrap_or(t.raw).max(t.raw));
        let mut item = Item {
            class: Class::Setting,
            names: Vec::new(),
            raw: first..last.max().unwrap_or(0) + 1,
            live,
            value: None,
        };
        if self.word(self.at) != "precision" && item.live.len() > 1 {
            self.classify(&mut item, body)?;
        }
        Ok(item)
    }

    /// Where the declaration ends, and where the body begins if it is a function.
    fn end(&self) -> std::result::Result<(usize, Option<usize>), Fault> {
        let mut open: Vec<(&str, usize)> = Vec::new();
        let mut assigned = false;
        let mut body = None;
        let mut at = self.at;
        while at < self.text.live.len() {
            let word = self.word(at);
            match word {
                "(" | "[" => open.push((word, at)),
                "{" => {
                    if open.is_empty() && !assigned && at > self.at && self.word(at - 1) == ")" {
                        body = Some(at);
                    }
                    open.push((word, at));
                }
                ")" | "]" | "}" => {
                    let pair = matches!(
                        (open.pop().map(|(word, _)| word), word),
                        (Some("("), ")") | (Some("["), "]") | (Some("{"), "}")
                    );
                    if !pair {
                        return Err(self.fault(at, &format!("`{word}` closes nothing")));
                    }
                    if open.is_empty() && word == "}" && body.is_some() {
                        return Ok((at + 1, body));
                    }
                }
                "=" if open.is_empty() => assigned = true,
                ";" if open.is_empty() => return Ok((at + 1, None)),
                _ => {}
            }
            at += 1;
        }
        Err(self.fault(self.at, "a declaration does not end"))
    }
}
