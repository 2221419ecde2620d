//! Directives: includes, conditions, macros. What remains is the text's tokens in order, and
//! what they expand to.

use std::collections::HashMap;
use std::rc::Rc;

use super::fault::{Fault, refuse};
use super::lex::{Kind, Names, Source, Token, lex};
use super::macros::{Live, Macros};
use super::{Lookup, group::Groups};
use crate::{Error, Result};

/// How deep includes may nest.
const DEPTH: usize = 64;

/// A directive that the result may keep.
#[derive(Clone, Debug)]
pub(super) enum Directive {
    /// A macro, by its definition.
    Define(usize),
    /// The end of a macro, by its definition.
    Undefine(usize, Vec<Token>),
    /// A pragma.
    Pragma(Vec<Token>),
}

/// A text after its directives.
pub(super) struct Text {
    pub(super) names: Names,
    pub(super) sources: Vec<Source>,
    pub(super) macros: Macros,
    /// What follows `#version`.
    pub(super) version: String,
    /// The `#extension` lines, each once.
    pub(super) extensions: Vec<String>,
    /// The tokens that conditions leave.
    pub(super) raw: Vec<Token>,
    /// The same after expansion.
    pub(super) live: Vec<Live>,
    /// Directives, and how many tokens of the text stand before each.
    pub(super) directives: Vec<(usize, Directive)>,
}

/// What reads a text.
pub(super) struct Preprocessor<'a, 'l> {
    pub(super) text: Text,
    pub(super) groups: Groups,
    lookup: &'a mut Lookup<'l>,
    files: HashMap<String, usize>,
    /// The first token of the run that is not expanded yet.
    run: usize,
    depth: usize,
}

impl<'a, 'l> Preprocessor<'a, 'l> {
    pub(super) fn new(lookup: &'a mut Lookup<'l>) -> Self {
        let mut names = Names::default();
        let macros = Macros::new(&mut names);
        Self {
            text: Text {
                names,
                sources: Vec::new(),
                macros,
                version: String::new(),
                extensions: Vec::new(),
                raw: Vec::new(),
                live: Vec::new(),
                directives: Vec::new(),
            },
            groups: Groups::default(),
            lookup,
            files: HashMap::new(),
            run: 0,
            depth: 0,
        }
    }

    /// The number of a file, which is read if it is new.
    pub(super) fn add(&mut self, name: &str, text: String) -> Result<usize> {
        let file = self.text.sources.len();
        let lexed = lex(name, text, file, &mut self.text.names);
        let source = lexed.map_err(|(line, problem)| {
            refuse(name, line, problem, "no token is understood from there on")
        })?;
        self.files.insert(name.to_owned(), file);
        self.text.sources.push(source);
        Ok(file)
    }

    /// Reads the tokens of a file, those of its includes in their places.
    pub(super) fn read(&mut self, file: usize) -> Result<()> {
        let tokens = Rc::clone(&self.text.sources[file].tokens);
        let outer = std::mem::take(&mut self.groups);
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            if token.first && self.is(token, "#") {
                let rest = &tokens[at..];
                let end = rest.iter().position(|other| other.line != token.line);
                let line = &rest[..end.unwrap_or(rest.len())];
                self.directive(line)?;
                at += line.len();
                continue;
            }
            if self.groups.active() {
                if matches!(token.kind, Kind::Text | Kind::Other) {
                    let text = self.word(token).to_owned();
                    return Err(self.refused(
                        token,
                        format!("`{text}` is no GLSL"),
                        "remove it, or put it into a comment",
                    ));
                }
                self.text.raw.push(*token);
            }
            at += 1;
        }
        if let Some(open) = self.groups.open() {
            return Err(self.refused(&open, "a condition does not end", "close it with `#endif`"));
        }
        self.groups = outer;
        Ok(())
    }

    fn directive(&mut self, line: &[Token]) -> Result<()> {
        let Some(keyword) = line.get(1) else {
            return Ok(());
        };
        let name = self.word(keyword).to_owned();
        if self.condition(&name, line)? || !self.groups.active() {
            return Ok(());
        }
        match name.as_str() {
            "include" => self.include(line),
            "define" => self.define(line),
            "undef" => self.undefine(line),
            "version" => self.version(line),
            "extension" => {
                let text = self.written(line);
                // Nothing is included any more.
                let include = [
                    "GL_GOOGLE_include_directive",
                    "GL_ARB_shading_language_include",
                ];
                let needed = !include.iter().any(|name| text.contains(name));
                if needed && !self.text.extensions.contains(&text) {
                    self.text.extensions.push(text);
                }
                Ok(())
            }
            "pragma" if line.get(2).is_some_and(|token| self.is(token, "once")) => Err(self
                .refused(
                    keyword,
                    "`#pragma once` is no GLSL",
                    "guard the file by `#ifndef` and `#define`",
                )),
            "pragma" => self.keep(Directive::Pragma(line.to_vec())),
            "error" => {
                let text = self.written(line);
                Err(self.refused(keyword, format!("it says {text}"), "do what it asks"))
            }
            _ => Err(self.refused(
                keyword,
                format!("`#{name}` is not understood"),
                "remove the directive",
            )),
        }
    }

    fn include(&mut self, line: &[Token]) -> Result<()> {
        let [_, _, what] = line else {
            return Err(self.refused(
                &line[0],
                "an include without a name",
                "write #include \"FILE\"",
            ));
        };
        if what.kind != Kind::Text {
            return Err(self.refused(what, "an include without quotes", "write #include \"FILE\""));
        }
        let name = self.word(what).trim_matches('"').to_owned();
        let file = match self.files.get(&name) {
            Some(file) => *file,
            None => {
                let text = (self.lookup)(&name).ok_or_else(|| {
                    let problem = format!("no include `{name}`");
                    self.refused(what, problem, "give its text, or correct the name")
                })?;
                self.add(&name, text)?
            }
        };
        self.depth += 1;
        if self.depth > DEPTH {
            let problem = format!("includes nest deeper than {DEPTH}");
            return Err(self.refused(what, problem, "guard it by `#ifndef` and `#define`"));
        }
        self.read(file)?;
        self.depth -= 1;
        Ok(())
    }

    fn version(&mut self, line: &[Token]) -> Result<()> {
        if !self.text.version.is_empty() || !self.text.raw.is_empty() || line.len() < 3 {
            return Err(self.refused(
                &line[0],
                "`#version` stands in the wrong place",
                "write it once, in the first line of the shader",
            ));
        }
        let words: Vec<&str> = line[2..].iter().map(|token| self.word(token)).collect();
        let version = words.join(" ");
        self.text.version = version;
        if self.text.version.ends_with(" es") {
            self.text
                .macros
                .define_one("GL_ES", &line[0], &mut self.text.names);
        }
        Ok(())
    }

    /// Keeps a directive in its place.
    pub(super) fn keep(&mut self, directive: Directive) -> Result<()> {
        self.expand()?;
        let at = self.text.raw.len();
        self.text.directives.push((at, directive));
        Ok(())
    }

    /// Expands what was read since the macros last changed.
    pub(super) fn expand(&mut self) -> Result<()> {
        let text = &mut self.text;
        let run = &text.raw[self.run..];
        let call = run
            .first()
            .is_some_and(|token| text.names.text(token.symbol) == "(");
        if let Some(last) = text.live.last().filter(|_| call) {
            let mut definitions = text.macros.definitions.iter();
            if definitions.any(|d| d.name == last.symbol && d.parameters.is_some()) {
                return Err(text.error(Fault::at(
                    last.raw,
                    "a directive stands between a macro and its arguments",
                    "move it before the call",
                )));
            }
        }
        let live = text.macros.expand_run(run, self.run, &mut text.names);
        self.run = text.raw.len();
        let live = live.map_err(|fault| self.text.error(fault))?;
        self.text.live.extend(live);
        Ok(())
    }

    /// A line from `#` to its last token, comments left out.
    pub(super) fn written(&self, line: &[Token]) -> String {
        self.text.written(line)
    }

    pub(super) fn word(&self, token: &Token) -> &str {
        self.text.names.text(token.symbol)
    }

    pub(super) fn is(&self, token: &Token, text: &str) -> bool {
        self.word(token) == text
    }

    pub(super) fn refused(
        &self,
        token: &Token,
        problem: impl Into<String>,
        remedy: &'static str,
    ) -> Error {
        let source = &self.text.sources[token.file];
        refuse(&source.name, source.line_of(token.start), problem, remedy)
    }
}

impl Text {
    /// The error of a fault.
    pub(super) fn error(&self, fault: Fault) -> Error {
        let token = self.raw.get(fault.raw).or(self.raw.last());
        let (name, line) = token.map_or(("main", 0), |token| {
            let source = &self.sources[token.file];
            (source.name.as_str(), source.line_of(token.start))
        });
        refuse(name, line, fault.problem, fault.remedy)
    }
}
