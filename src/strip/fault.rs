//! What is wrong with a text, and where.

use crate::Error;

/// What a stage refuses, at a token of the text that is read.
#[derive(Debug)]
pub(super) struct Fault {
    /// The token, among all those of the text without what conditions leave out.
    pub(super) raw: usize,
    pub(super) problem: String,
    pub(super) remedy: &'static str,
}

impl Fault {
    pub(super) fn at(raw: usize, problem: impl Into<String>, remedy: &'static str) -> Self {
        Self {
            raw,
            problem: problem.into(),
            remedy,
        }
    }

    /// A macro called with another number of arguments than it takes.
    pub(super) fn arguments(raw: usize, takes: usize) -> Self {
        Self::at(
            raw,
            format!("a macro takes {takes} arguments, and is given others"),
            "give as many as its definition has",
        )
    }
}

/// The error of a line of a file; lines count from 0 here and from 1 in messages.
pub(super) fn refuse(
    file: &str,
    line: usize,
    problem: impl Into<String>,
    remedy: impl Into<String>,
) -> Error {
    Error::Glsl {
        file: file.to_owned(),
        line: line + 1,
        problem: problem.into(),
        remedy: remedy.into(),
    }
}
