//! What a declaration declares, by its first words and by what follows its names.

use super::fault::Fault;
use super::item::{Class, Item, Reader};
use super::words::is_qualifier;

impl Reader<'_> {
    /// The place after the bracket that closes the one at a place.
    fn closed(&self, mut at: usize, end: usize) -> usize {
        let mut depth = 0;
        while at < end {
            match self.word(at) {
                "(" | "[" | "{" => depth += 1,
                ")" | "]" | "}" => depth -= 1,
                _ => {}
            }
            at += 1;
            if depth == 0 {
                break;
            }
        }
        at
    }

    /// The place after brackets of arrays.
    fn dimensions(&self, mut at: usize, end: usize) -> usize {
        while self.word(at) == "[" {
            at = self.closed(at, end);
        }
        at
    }

    pub(super) fn classify(
        &self,
        item: &mut Item,
        body: Option<usize>,
    ) -> std::result::Result<(), Fault> {
        let end = item.live.end;
        let mut at = self.at;
        let (mut constant, mut specialization, mut qualified) = (false, false, false);
        while is_qualifier(self.word(at)) {
            qualified = true;
            constant |= self.word(at) == "const";
            let layout = self.word(at) == "layout";
            at += 1;
            if layout {
                let close = self.closed(at, end);
                specialization |= (at..close).any(|at| self.word(at) == "constant_id");
                at = close;
            }
        }
        if qualified && self.word(at) == ";" {
            return Ok(());
        }
        let of_struct = self.word(at) == "struct";
        let Some(name) = self.name(at + usize::from(of_struct)) else {
            return Err(self.fault(at, "a declaration of a kind that is not understood"));
        };
        let after = at + 1 + usize::from(of_struct);
        if self.word(after) == "{" {
            item.class = if of_struct {
                Class::Struct
            } else {
                Class::Block
            };
            item.names.push(name);
            let close = self.closed(after, end);
            if !of_struct && !qualified {
                return Err(self.fault(at, "a block that is neither buffer nor uniform"));
            }
            if !of_struct && self.word(close) == ";" {
                // The members of a block without a name of its own are the file's.
                self.members(after + 1, close - 1, item);
            }
            return self.declarators(item, close, end);
        }
        let declared = self.dimensions(after, end);
        if qualified && matches!(self.word(declared), ";" | ",") {
            // Names of the shader are qualified anew.
            return Ok(());
        }
        if let (Some(function), "(") = (self.name(declared), self.word(declared + 1)) {
            item.class = if body.is_some() {
                Class::Function
            } else {
                Class::Prototype
            };
            item.names.push(function);
            let close = self.closed(declared + 1, end);
            return match self.word(close) {
                "{" if body == Some(close) => Ok(()),
                ";" if body.is_none() => Ok(()),
                _ => Err(self.fault(close, "a function whose head is not understood")),
            };
        }
        item.class = match (constant, specialization) {
            (true, true) => Class::Specialization,
            (true, false) => Class::Constant,
            _ => Class::Variable,
        };
        self.declarators(item, declared, end)
    }

    /// Names of the members between two places: each the last name before its dimensions.
    fn members(&self, mut at: usize, end: usize, item: &mut Item) {
        let mut last = None;
        while at < end {
            match self.word(at) {
                ";" | "," => item.names.extend(last.take()),
                "[" | "(" => {
                    at = self.closed(at, end);
                    continue;
                }
                _ => last = self.name(at).or(last),
            }
            at += 1;
        }
    }

    /// Names, dimensions and values up to the semicolon.
    fn declarators(
        &self,
        item: &mut Item,
        mut at: usize,
        end: usize,
    ) -> std::result::Result<(), Fault> {
        if self.word(at) == ";" && !item.names.is_empty() {
            return Ok(());
        }
        loop {
            let Some(name) = self.name(at) else {
                return Err(self.fault(at, "a declaration of a kind that is not understood"));
            };
            item.names.push(name);
            at = self.dimensions(at + 1, end);
            if self.word(at) == "=" {
                item.value.get_or_insert(at + 1);
                while !matches!(self.word(at), "," | ";") {
                    at = if matches!(self.word(at), "(" | "[" | "{") {
                        self.closed(at, end)
                    } else {
                        at + 1
                    };
                }
            }
            match self.word(at) {
                ";" => return Ok(()),
                "," => at += 1,
                _ => return Err(self.fault(at, "a declaration of a kind that is not understood")),
            }
        }
    }
}
