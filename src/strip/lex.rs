//! GLSL as tokens. GLSL has no strings; the one of `#include` is a token of its own.

use std::collections::HashMap;
use std::rc::Rc;

/// A token's text, as a number: equal texts have equal numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Symbol(u32);

/// The texts of symbols.
#[derive(Debug, Default)]
pub(super) struct Names {
    known: HashMap<String, Symbol>,
    texts: Vec<String>,
}

impl Names {
    /// The symbol of a text.
    pub(super) fn symbol(&mut self, text: &str) -> Symbol {
        if let Some(symbol) = self.known.get(text) {
            return *symbol;
        }
        let symbol = Symbol(self.texts.len() as u32);
        self.texts.push(text.to_owned());
        self.known.insert(text.to_owned(), symbol);
        symbol
    }

    /// The text of a symbol.
    pub(super) fn text(&self, symbol: Symbol) -> &str {
        self.texts.get(symbol.0 as usize).map_or("", String::as_str)
    }
}

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// An identifier or a keyword.
    Name,
    /// A literal.
    Number,
    /// Punctuation.
    Mark,
    /// `"..."`, which only `#include` may have.
    Text,
    /// Any other character, which only `#error` may have.
    Other,
}

/// One token of a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) symbol: Symbol,
    /// Its file among those that are read.
    pub(super) file: usize,
    /// Where it begins in the file's text, in bytes.
    pub(super) start: usize,
    /// Where it ends.
    pub(super) end: usize,
    /// Its line, where lines that a backslash joins are one.
    pub(super) line: usize,
    /// Whether it is the first of that line.
    pub(super) first: bool,
}

/// A comment, from its first character to its last.
#[derive(Clone, Copy, Debug)]
pub(super) struct Comment {
    pub(super) start: usize,
    pub(super) end: usize,
}

/// A file's text and tokens.
#[derive(Debug)]
pub(super) struct Source {
    pub(super) name: String,
    pub(super) text: String,
    pub(super) tokens: Rc<Vec<Token>>,
    pub(super) comments: Vec<Comment>,
    /// Where each line of the text begins.
    pub(super) lines: Vec<usize>,
}

impl Source {
    /// The number of the line with this byte, from 0.
    pub(super) fn line_of(&self, byte: usize) -> usize {
        self.lines.partition_point(|start| *start <= byte).max(1) - 1
    }
}

/// Punctuation of more than one character, the longest first.
const MARKS: [&str; 22] = [
    "<<=", ">>=", "##", "&&", "||", "^^", "==", "!=", "<=", ">=", "<<", ">>", "++", "--", "+=",
    "-=", "*=", "/=", "%=", "&=", "|=", "^=",
];

/// Where the lexer stands.
struct Lexer<'a> {
    text: &'a str,
    at: usize,
    line: usize,
    first: bool,
}

/// Reads a file. The error is a line of the text, from 0, and what is wrong there.
pub(super) fn lex(
    name: &str,
    text: String,
    file: usize,
    names: &mut Names,
) -> Result<Source, (usize, &'static str)> {
    let mut source = Source {
        name: name.to_owned(),
        tokens: Rc::default(),
        comments: Vec::new(),
        lines: std::iter::once(0)
            .chain(text.match_indices('\n').map(|(at, _)| at + 1))
            .collect(),
        text: String::new(),
    };
    let mut lexer = Lexer {
        text: &text,
        at: 0,
        line: 0,
        first: true,
    };
    let mut tokens = Vec::with_capacity(text.len() / 4);
    let fault = lexer
        .run(&mut tokens, &mut source.comments, file, names)
        .err();
    source.tokens = Rc::new(tokens);
    source.text = text;
    match fault {
        None => Ok(source),
        Some((at, problem)) => Err((source.line_of(at), problem)),
    }
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or("")
    }

    fn run(
        &mut self,
        tokens: &mut Vec<Token>,
        comments: &mut Vec<Comment>,
        file: usize,
        names: &mut Names,
    ) -> Result<(), (usize, &'static str)> {
        loop {
            self.blank()?;
            let rest = self.rest();
            let Some(c) = rest.chars().next() else {
                return Ok(());
            };
            let start = self.at;
            if rest.starts_with("//") || rest.starts_with("/*") {
                self.at += comment(rest)
                    .ok_or((start, "a comment that does not end; close it with `*/`"))?;
                comments.push(Comment {
                    start,
                    end: self.at,
                });
                continue;
            }
            let (kind, length) = token(rest, c);
            self.at += length;
            tokens.push(Token {
                kind,
                symbol: names.symbol(&rest[..length]),
                file,
                start,
                end: start + length,
                line: self.line,
                first: std::mem::replace(&mut self.first, false),
            });
        }
    }

    /// Skips white space, and counts lines.
    fn blank(&mut self) -> Result<(), (usize, &'static str)> {
        loop {
            let rest = self.rest().as_bytes();
            match rest {
                [b'\n', ..] => {
                    self.line += 1;
                    self.first = true;
                    self.at += 1;
                }
                [b' ' | b'\t' | b'\r' | 0x0b | 0x0c, ..] => self.at += 1,
                [b'\\', b'\n', ..] | [b'\\', b'\r', b'\n', ..] => {
                    let length = if rest[1] == b'\n' { 2 } else { 3 };
                    let word = |c: Option<&u8>| {
                        c.is_some_and(|c| c.is_ascii_alphanumeric() || *c == b'_' || *c == b'.')
                    };
                    let before = self.at.checked_sub(1);
                    let before = before.and_then(|at| self.text.as_bytes().get(at));
                    if word(before) && word(rest.get(length)) {
                        return Err((
                            self.at,
                            "a word that goes on after a backslash; write it on one line",
                        ));
                    }
                    self.at += length;
                }
                _ => return Ok(()),
            }
        }
    }
}

/// The length of the comment that begins a text, if it ends. A backslash takes a line comment to
/// the next line.
fn comment(text: &str) -> Option<usize> {
    if let Some(rest) = text.strip_prefix("/*") {
        return rest.find("*/").map(|at| at + 4);
    }
    let ends = |at: usize| {
        let line = &text[..at];
        let line = line.strip_suffix('\r').unwrap_or(line);
        !line.ends_with('\\')
    };
    let end = text
        .match_indices('\n')
        .map(|(at, _)| at)
        .find(|at| ends(*at));
    Some(end.unwrap_or(text.len()))
}

/// Kind and length of the token that begins a text.
fn token(text: &str, c: char) -> (Kind, usize) {
    let bytes = text.as_bytes();
    let word = |c: &u8| c.is_ascii_alphanumeric() || *c == b'_';
    let digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    if c.is_ascii_alphabetic() || c == '_' {
        let end = bytes.iter().position(|c| !word(c));
        return (Kind::Name, end.unwrap_or(bytes.len()));
    }
    if digit(0) || (c == '.' && digit(1)) {
        return (Kind::Number, number(bytes));
    }
    if c == '"' {
        let line = text.lines().next().unwrap_or("");
        return match line.get(1..).and_then(|rest| rest.find('"')) {
            Some(end) => (Kind::Text, end + 2),
            None => (Kind::Other, 1),
        };
    }
    if let Some(mark) = MARKS.iter().find(|mark| text.starts_with(**mark)) {
        return (Kind::Mark, mark.len());
    }
    if "()[]{}.,;:?+-*/%&|^!~<>=#".contains(c) {
        return (Kind::Mark, 1);
    }
    (Kind::Other, c.len_utf8())
}

/// The length of a literal: digits, letters and points, and a sign after an exponent's `e`.
fn number(bytes: &[u8]) -> usize {
    let hexadecimal = matches!(bytes, [b'0', b'x' | b'X', ..]);
    let mut end = 1;
    while let Some(c) = bytes.get(end) {
        let after_e = matches!(bytes[end - 1], b'e' | b'E') && !hexadecimal;
        let signed = after_e && matches!(c, b'+' | b'-');
        if !(c.is_ascii_alphanumeric() || matches!(c, b'_' | b'.') || signed) {
            break;
        }
        end += 1;
    }
    end
}
