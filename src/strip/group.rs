//! Conditions, and the lines that change macros.

use super::condition::evaluate;
use super::lex::{Kind, Symbol, Token};
use super::macros::Definition;
use super::preprocess::{Directive, Preprocessor};
use crate::Result;

/// The place of tokens that are not of the text.
const NOWHERE: usize = usize::MAX / 2;

/// One `#if` that is open.
#[derive(Clone, Copy, Debug)]
struct Group {
    /// Where it begins.
    at: Token,
    /// Whether the text around it counts.
    around: bool,
    /// Whether one of its branches was taken.
    taken: bool,
    /// Whether the present branch counts.
    now: bool,
    /// Whether `#else` has been.
    last: bool,
}

/// The conditions of a file that are open.
#[derive(Debug, Default)]
pub(super) struct Groups {
    open: Vec<Group>,
    /// Of `#ifndef NAME` as a file's first directive: the name.
    guard: Option<Symbol>,
    started: bool,
}

impl Groups {
    /// Whether what stands here counts.
    pub(super) fn active(&self) -> bool {
        self.open.last().is_none_or(|group| group.now)
    }

    /// Where the innermost of those that are open begins.
    pub(super) fn open(&self) -> Option<Token> {
        self.open.last().map(|group| group.at)
    }
}

impl Preprocessor<'_, '_> {
    /// Handles a line if it is one of a condition.
    pub(super) fn condition(&mut self, name: &str, line: &[Token]) -> Result<bool> {
        let first = !std::mem::replace(&mut self.groups.started, true);
        let around = self.groups.active();
        let token = line[0];
        match name {
            "if" | "ifdef" | "ifndef" => {
                let now = around && self.holds(name, line)?;
                if name == "ifndef" && first {
                    self.groups.guard = line.get(2).map(|token| token.symbol);
                }
                self.groups.open.push(Group {
                    at: token,
                    around,
                    taken: now,
                    now,
                    last: false,
                });
            }
            "elif" | "else" => {
                let Some(group) = self.groups.open.last().copied().filter(|group| !group.last)
                else {
                    let problem = format!("`#{name}` has no `#if`");
                    return Err(self.refused(&token, problem, "remove it, or open a condition"));
                };
                let free = group.around && !group.taken;
                let now = free && (name == "else" || self.holds("if", line)?);
                if let Some(open) = self.groups.open.last_mut() {
                    open.now = now;
                    open.taken |= now;
                    open.last = name == "else";
                }
            }
            "endif" => {
                if self.groups.open.pop().is_none() {
                    return Err(self.refused(&token, "`#endif` has no `#if`", "remove it"));
                }
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// The value of an `#if`, `#ifdef` or `#ifndef` line.
    fn holds(&mut self, name: &str, line: &[Token]) -> Result<bool> {
        if name != "if" {
            let [_, _, macro_name] = line else {
                return Err(self.refused(&line[0], "a condition needs one name", "write one"));
            };
            return Ok(self.defined(macro_name)? == (name == "ifdef"));
        }
        let mut operands = Vec::new();
        let mut at = 2;
        while let Some(token) = line.get(at) {
            at += 1;
            if !self.is(token, "defined") {
                operands.push(*token);
                continue;
            }
            let open = line.get(at).is_some_and(|token| self.is(token, "("));
            at += usize::from(open);
            let Some(asked) = line.get(at).filter(|token| token.kind == Kind::Name) else {
                return Err(self.refused(token, "`defined` without a name", "write one"));
            };
            at += 1;
            if open {
                if !line.get(at).is_some_and(|token| self.is(token, ")")) {
                    return Err(self.refused(token, "a parenthesis does not close", "close it"));
                }
                at += 1;
            }
            let digit = if self.defined(asked)? { "1" } else { "0" };
            operands.push(Token {
                kind: Kind::Number,
                symbol: self.text.names.symbol(digit),
                ..*token
            });
        }
        for token in &operands {
            // What only the compiler knows has no value here.
            if token.kind == Kind::Name {
                self.defined(token)?;
            }
        }
        let refused = |this: &Self, problem: String| {
            let remedy = "write a condition of integers and of macros that are defined before it";
            this.refused(&line[0], problem, remedy)
        };
        // Uses of macros by a condition are no uses by the text.
        let uses = self.text.macros.uses.len();
        let live = (self.text.macros).expand_run(&operands, NOWHERE, &mut self.text.names);
        self.text.macros.uses.truncate(uses);
        let live = live.map_err(|fault| refused(self, fault.problem))?;
        let value = evaluate(&live, &self.text.names);
        value
            .map(|value| value != 0)
            .map_err(|problem| refused(self, problem))
    }

    /// Whether a macro is defined; an error for those that only a compiler knows.
    fn defined(&self, token: &Token) -> Result<bool> {
        if self.text.macros.defined.contains_key(&token.symbol) {
            return Ok(true);
        }
        let name = self.word(token);
        let compilers = name.starts_with("GL_") || name.starts_with("__") || name == "VULKAN";
        if compilers && name != "GL_ES" {
            let problem = format!("`{name}` is a macro of compilers, with no value here");
            return Err(self.refused(token, problem, "define a macro of your own in its place"));
        }
        Ok(false)
    }

    pub(super) fn define(&mut self, line: &[Token]) -> Result<()> {
        let Some(name) = line.get(2).filter(|token| token.kind == Kind::Name) else {
            return Err(self.refused(&line[0], "a macro without a name", "write one"));
        };
        let mut at = 3;
        let mut parameters = None;
        let call = line.get(3).filter(|token| token.start == name.end);
        if call.is_some_and(|token| self.is(token, "(")) {
            let mut names = Vec::new();
            at = 4;
            while let Some(token) = line.get(at) {
                at += 1;
                if self.is(token, ")") {
                    parameters = Some(names);
                    break;
                }
                if token.kind == Kind::Name {
                    names.push(token.symbol);
                } else if !self.is(token, ",") {
                    return Err(self.refused(token, "a parameter is no name", "write names"));
                }
            }
            if parameters.is_none() {
                return Err(self.refused(name, "a parenthesis does not close", "close it"));
            }
        }
        let body = line.get(at..).unwrap_or_default();
        let strange = |token: &&Token| matches!(token.kind, Kind::Text | Kind::Other);
        if let Some(token) = body.iter().find(strange) {
            return Err(self.refused(token, "the body of a macro is no GLSL", "write tokens"));
        }
        let guard = self.groups.guard.take() == Some(name.symbol) && body.is_empty();
        let definition = Definition {
            name: name.symbol,
            parameters,
            body: body.to_vec(),
            written: line.to_vec(),
            guard,
        };
        let macros = &self.text.macros;
        if let Some(index) = macros.defined.get(&name.symbol) {
            if macros
                .definitions
                .get(*index)
                .is_some_and(|known| known.same(&definition))
            {
                return Ok(());
            }
            let problem = format!("`{}` is defined anew", self.word(name));
            return Err(self.refused(name, problem, "end the first definition by `#undef`"));
        }
        let index = macros.definitions.len();
        self.keep(Directive::Define(index))?;
        self.text.macros.definitions.push(definition);
        self.text.macros.defined.insert(name.symbol, index);
        Ok(())
    }

    pub(super) fn undefine(&mut self, line: &[Token]) -> Result<()> {
        let [_, _, name] = line else {
            return Err(self.refused(&line[0], "`#undef` needs one name", "write one"));
        };
        if let Some(index) = self.text.macros.defined.get(&name.symbol).copied() {
            self.keep(Directive::Undefine(index, line.to_vec()))?;
            self.text.macros.defined.remove(&name.symbol);
        }
        Ok(())
    }
}
