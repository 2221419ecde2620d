//! A folder to run `corput` in, and what its commands leave: as the user meets them.

#![allow(dead_code, reason = "each test uses a part of it")]

use super::support::validates;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// An empty folder to run commands in.
pub struct Desk(TempDir);

/// What a command left.
pub struct Run {
    pub line: String,
    pub code: Option<i32>,
    pub stdout: Vec<u8>,
    pub stderr: String,
}

impl Desk {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Every name in the folder, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).expect("a folder");
        let name = |entry: fs::DirEntry| entry.file_name().into_string().expect("UTF-8");
        let mut names: Vec<_> = entries
            .map(|entry| name(entry.expect("an entry")))
            .collect();
        names.sort();
        names
    }

    /// `corput` in this folder with the words of `line`, validation on.
    pub fn command(&self, line: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_corput"));
        command
            .current_dir(self.0.path())
            .args(line.split_whitespace());
        if validates() {
            command.env("CORPUT_VALIDATION", "1");
        }
        command
    }

    /// Runs a command to its end.
    pub fn run(&self, line: &str) -> Run {
        Run::of(line, self.command(line))
    }

    /// Runs a command that must succeed, whatever it warns of, and returns its standard output.
    pub fn ask(&self, line: &str) -> String {
        let run = self.run(line);
        run.expect(0, &[]);
        String::from_utf8(run.stdout).expect("UTF-8")
    }

    /// The same without a warning.
    pub fn say(&self, line: &str) -> String {
        let run = self.run(line);
        run.expect(0, &[]);
        assert_eq!(run.stderr, "", "`{line}` wrote this to standard error");
        String::from_utf8(run.stdout).expect("UTF-8")
    }

    /// Runs a command that must succeed without a word.
    pub fn quietly(&self, line: &str) {
        assert_eq!(self.say(line), "", "`{line}` wrote to standard output");
    }

    /// Runs a `generate` into a file in silence, and returns the file's bytes.
    pub fn make(&self, line: &str, name: &str) -> Vec<u8> {
        self.quietly(&format!("generate {line} --out {name}"));
        self.bytes(name)
    }
}

impl Run {
    /// Runs a command to its end.
    pub fn of(line: &str, mut command: Command) -> Self {
        Self::left(line, command.output().expect("it runs"))
    }

    /// What a command that has ended left.
    pub fn left(line: &str, output: Output) -> Self {
        Self {
            line: line.to_owned(),
            code: output.status.code(),
            stdout: output.stdout,
            stderr: String::from_utf8(output.stderr).expect("UTF-8"),
        }
    }

    /// Standard output, where it is text.
    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.stdout).into_owned()
    }

    /// Checks the exit code, and that the words are in the message on standard error.
    pub fn expect(&self, code: i32, words: &[&str]) {
        self.check(code, words, &self.stderr);
    }

    /// The same of words on standard output or standard error: of a command that answers, and
    /// fails by its answer.
    pub fn tells(&self, code: i32, words: &[&str]) {
        self.check(code, words, &format!("{}{}", self.text(), self.stderr));
    }

    fn check(&self, code: i32, words: &[&str], said: &str) {
        let line = &self.line;
        assert_eq!(self.code, Some(code), "`{line}` said: {said}");
        for word in words {
            assert!(said.contains(word), "`{line}` does not say {word}: {said}");
        }
        assert!(!self.stderr.contains("panicked"), "`{line}`: {said}");
    }
}

/// The repository's file.
pub fn repository(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}
