//! What `main` reaches: names, followed from declaration to declaration.
//!
//! A name before a parenthesis is a function or a constructor, any other a variable, a constant or
//! a type: GLSL has no pointers to functions. Names that a function declares itself are its own
//! from there to the end of their block; where that is in doubt, they count as the file's, so
//! that too much is kept and never too little.

use std::collections::{HashMap, HashSet};

use super::item::{Class, Item};
use super::lex::{Kind, Symbol};
use super::macros::Live;
use super::preprocess::Text;
use super::words::is_keyword;

/// Whether each item is reached. None where there is no `main`.
pub(super) fn reached(text: &Text, items: &[Item]) -> Option<Vec<bool>> {
    let mut functions: HashMap<Symbol, Vec<usize>> = HashMap::new();
    let mut values: HashMap<Symbol, Vec<usize>> = HashMap::new();
    let mut open = Vec::new();
    let mut main = false;
    for (index, item) in items.iter().enumerate() {
        let function = matches!(item.class, Class::Function | Class::Prototype);
        let table = if function {
            &mut functions
        } else {
            &mut values
        };
        for name in &item.names {
            table.entry(*name).or_default().push(index);
        }
        let is_main = item
            .names
            .iter()
            .any(|name| text.names.text(*name) == "main");
        main |= is_main && item.class == Class::Function;
        // The value of a variable may do more than give it one.
        let acts = item.class == Class::Variable && item.value.is_some();
        if item.class == Class::Setting || acts || is_main {
            open.push(index);
        }
    }
    let mut kept = vec![false; items.len()];
    while let Some(index) = open.pop() {
        let (Some(seen), Some(item)) = (kept.get_mut(index), items.get(index)) else {
            continue;
        };
        if std::mem::replace(seen, true) {
            continue;
        }
        for (name, call) in references(text, item) {
            open.extend(values.get(&name).into_iter().flatten());
            if call {
                open.extend(functions.get(&name).into_iter().flatten());
            }
        }
    }
    main.then_some(kept)
}

/// The names that an item takes from the file, and whether it calls them.
fn references(text: &Text, item: &Item) -> HashSet<(Symbol, bool)> {
    let mut reader = Scopes {
        text,
        tokens: text.live.get(item.live.clone()).unwrap_or_default(),
        scopes: vec![HashSet::new()],
        pending: Vec::new(),
    };
    reader.read(item.class == Class::Function)
}

struct Scopes<'a> {
    text: &'a Text,
    tokens: &'a [Live],
    scopes: Vec<HashSet<Symbol>>,
    /// Names whose declaration has not ended.
    pending: Vec<Symbol>,
}

impl Scopes<'_> {
    fn word(&self, at: Option<usize>) -> &str {
        let token = at.and_then(|at| self.tokens.get(at));
        token.map_or("", |token| self.text.names.text(token.symbol))
    }

    fn read(&mut self, function: bool) -> HashSet<(Symbol, bool)> {
        let mut found = HashSet::new();
        let (mut parentheses, mut braces) = (0, 0);
        for (at, token) in self.tokens.iter().enumerate() {
            if token.kind != Kind::Name {
                match self.text.names.text(token.symbol) {
                    "(" => parentheses += 1,
                    ")" => parentheses -= 1,
                    "{" => {
                        braces += 1;
                        self.scopes
                            .push(std::mem::take(&mut self.pending).into_iter().collect());
                    }
                    "}" => {
                        braces -= 1;
                        self.scopes.pop();
                        self.pending.clear();
                    }
                    ";" => {
                        let names = std::mem::take(&mut self.pending);
                        if let Some(scope) = self.scopes.last_mut() {
                            scope.extend(names);
                        }
                    }
                    _ => {}
                }
                continue;
            }
            let before = at.checked_sub(1);
            let call = self.word(Some(at + 1)) == "(";
            if self.declares(at) {
                let parameter = function && braces == 0 && parentheses == 1;
                let local = function && braces > 0 && parentheses == 0 && self.begins(at);
                if !call && (parameter || local) {
                    self.pending.push(token.symbol);
                }
            } else if self.word(before) != "."
                && (call
                    || !self
                        .scopes
                        .iter()
                        .any(|scope| scope.contains(&token.symbol)))
            {
                found.insert((token.symbol, call));
            }
        }
        found
    }

    /// Whether the name at a place stands after a type.
    fn declares(&self, at: usize) -> bool {
        let Some(before) = at.checked_sub(1) else {
            return false;
        };
        match self.tokens.get(before) {
            Some(token) if token.kind == Kind::Name => !is_keyword(self.word(Some(before))),
            _ => self.word(Some(before)) == "]" && self.after_dimensions(before),
        }
    }

    /// Whether the bracket that closes at a place ends the dimensions of a type: a name can
    /// follow them, or those of an attribute such as `[[unroll]]`.
    fn after_dimensions(&self, mut at: usize) -> bool {
        let mut depth = 0;
        loop {
            match self.word(Some(at)) {
                "]" => depth += 1,
                "[" => depth -= 1,
                _ => {}
            }
            let Some(before) = at.checked_sub(1) else {
                return false;
            };
            at = before;
            if depth == 0 && self.word(Some(at)) != "]" {
                return self
                    .tokens
                    .get(at)
                    .is_some_and(|token| token.kind == Kind::Name);
            }
        }
    }

    /// Whether the declaration of the name at a place is a statement of its block.
    fn begins(&self, at: usize) -> bool {
        let mut depth = 0;
        for before in (0..at).rev() {
            match self.word(Some(before)) {
                "]" => depth += 1,
                "[" => depth -= 1,
                "{" | "}" | ";" if depth == 0 => return true,
                _ if depth > 0 => {}
                _ if self
                    .tokens
                    .get(before)
                    .is_some_and(|t| t.kind == Kind::Name) =>
                {
                    if matches!(self.word(Some(before)), "else" | "do" | "case") {
                        return false;
                    }
                }
                _ => return false,
            }
        }
        false
    }
}
