//! Tables of a scene file, whose keys are asked for one by one: what was not asked for is
//! unknown, and refused with its place.

use super::{Cause, refused};
use crate::error::nearest;
use crate::{Error, Result};
use std::ops::RangeInclusive;
use std::path::Path;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The text of a file, for places in it.
pub(super) struct Source<'t> {
    pub(super) text: &'t str,
    pub(super) path: &'t Path,
}

impl Source<'_> {
    /// A refusal of what begins at a byte.
    pub(super) fn refuse(&self, at: usize, problem: &str) -> Error {
        let (line, column) = place(self.text, at);
        let problem = format!("line {line}, column {column}: {problem}");
        refused(self.path, problem, "mend it and run again")
    }

    /// The line of a byte.
    pub(super) fn cause(&self, at: usize) -> Cause {
        let (line, _) = place(self.text, at);
        let text = self.text.lines().nth(line - 1).unwrap_or("").trim();
        Cause {
            line: Some(line),
            text: text.to_owned(),
        }
    }
}

/// Line and column of a byte, both counted from 1.
fn place(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let column = before.get(start..).map_or(0, |rest| rest.chars().count());
    (line, column + 1)
}

/// A table, and the keys that it was asked for.
pub(super) struct Table<'s> {
    pub(super) source: &'s Source<'s>,
    /// Where it begins.
    pub(super) at: usize,
    entries: &'s DeTable<'s>,
    known: Vec<&'static str>,
}

impl<'s> Table<'s> {
    pub(super) fn new(source: &'s Source<'s>, at: usize, entries: &'s DeTable<'s>) -> Self {
        Self {
            source,
            at,
            entries,
            known: Vec::new(),
        }
    }

    /// The value of a key.
    pub(super) fn take(&mut self, key: &'static str) -> Option<Value<'s>> {
        self.known.push(key);
        let (name, value) = self
            .entries
            .iter()
            .find(|(name, _)| name.get_ref() == key)?;
        Some(Value {
            source: self.source,
            key: name.span().start,
            name: key,
            value,
        })
    }

    /// The value of a key that must be there.
    pub(super) fn demand(&mut self, key: &'static str) -> Result<Value<'s>> {
        self.take(key)
            .ok_or_else(|| self.source.refuse(self.at, &format!("`{key}` is missing")))
    }

    /// Refuses the first key that was not asked for.
    pub(super) fn finish(&self) -> Result<()> {
        let unknown = self.entries.iter().map(|(name, _)| name);
        let unknown = unknown.filter(|name| !self.known.contains(&name.get_ref().as_ref()));
        let Some(first) = unknown.min_by_key(|name| name.span().start) else {
            return Ok(());
        };
        let name = first.get_ref();
        let guess = nearest(name, self.known.iter().copied());
        let guess = guess.map_or_else(String::new, |one| format!(", did you mean `{one}`?"));
        let known = self.known.join(", ");
        let problem = format!("unknown key `{name}`{guess}; known: {known}");
        Err(self.source.refuse(first.span().start, &problem))
    }
}

/// The value of a key.
#[derive(Clone, Copy)]
pub(super) struct Value<'s> {
    source: &'s Source<'s>,
    /// Where the key begins.
    pub(super) key: usize,
    name: &'static str,
    value: &'s Spanned<DeValue<'s>>,
}

impl<'s> Value<'s> {
    /// Where the value begins.
    pub(super) fn at(&self) -> usize {
        self.value.span().start
    }

    pub(super) fn cause(&self) -> Cause {
        self.source.cause(self.key)
    }

    pub(super) fn refuse(&self, problem: &str) -> Error {
        self.source.refuse(self.at(), problem)
    }

    fn wrong<T>(&self, wanted: &str) -> Result<T> {
        Err(self.refuse(&format!("`{}` must be {wanted}", self.name)))
    }

    pub(super) fn text(&self) -> Result<&'s str> {
        match self.value.get_ref() {
            DeValue::String(text) => Ok(text),
            _ => self.wrong("a text in quotation marks"),
        }
    }

    /// A whole number of a range.
    pub(super) fn whole(&self, range: RangeInclusive<u64>) -> Result<u64> {
        let number = match self.value.get_ref() {
            DeValue::Integer(n) => u64::from_str_radix(n.as_str(), n.radix()).ok(),
            _ => None,
        };
        match number {
            Some(number) if range.contains(&number) => Ok(number),
            _ => self.wrong(&format!(
                "a whole number from {} to {}",
                range.start(),
                range.end()
            )),
        }
    }

    pub(super) fn number(&self) -> Result<f64> {
        number(self.value.get_ref()).map_or_else(|| self.wrong("a finite number"), Ok)
    }

    /// One number, or several in brackets.
    pub(super) fn numbers(&self) -> Result<Vec<f64>> {
        let DeValue::Array(list) = self.value.get_ref() else {
            return Ok(vec![self.number()?]);
        };
        let all: Option<Vec<f64>> = list.iter().map(|one| number(one.get_ref())).collect();
        all.map_or_else(|| self.wrong("finite numbers"), Ok)
    }

    pub(super) fn table(&self) -> Result<Table<'s>> {
        match self.value.get_ref() {
            DeValue::Table(entries) => Ok(Table::new(self.source, self.key, entries)),
            _ => self.wrong("a table"),
        }
    }

    /// The tables of an array of tables.
    pub(super) fn tables(&self) -> Result<Vec<Table<'s>>> {
        let DeValue::Array(list) = self.value.get_ref() else {
            return self.wrong(&format!("a list of tables, as in [[{}]]", self.name));
        };
        let tables = list.iter().map(|one| match one.get_ref() {
            DeValue::Table(entries) => Ok(Table::new(self.source, one.span().start, entries)),
            _ => self.wrong(&format!("a list of tables, as in [[{}]]", self.name)),
        });
        tables.collect()
    }
}

fn number(value: &DeValue) -> Option<f64> {
    let number: f64 = match value {
        DeValue::Integer(n) => i64::from_str_radix(n.as_str(), n.radix()).ok()? as f64,
        DeValue::Float(x) => x.as_str().parse().ok()?,
        _ => return None,
    };
    number.is_finite().then_some(number)
}
