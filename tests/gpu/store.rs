//! Shards, and `corput merge`, as their user meets them.

#[path = "store/estimates.rs"]
mod estimates;
#[path = "store/shares.rs"]
mod shares;

use std::path::PathBuf;
use std::process::{Command, Output};
use tempfile::TempDir;

/// An empty folder to run commands in.
struct Desk(TempDir);

/// What a command left.
struct Run {
    line: String,
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

impl Desk {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// `corput` in this folder with the words of `line`.
    fn command(&self, line: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_corput"));
        command.current_dir(self.0.path());
        command.args(line.split_whitespace());
        command
    }

    /// Runs a command to its end.
    fn run(&self, line: &str) -> Run {
        let output = self.command(line).output().expect("corput runs");
        Run::of(line, output)
    }

    /// Runs a command that must succeed, and returns its standard output.
    fn say(&self, line: &str) -> String {
        let run = self.run(line);
        run.expect(0, &[]);
        run.stdout
    }
}

impl Run {
    fn of(line: &str, output: Output) -> Self {
        Self {
            line: line.to_owned(),
            code: output.status.code(),
            stdout: String::from_utf8(output.stdout).expect("UTF-8"),
            stderr: String::from_utf8(output.stderr).expect("UTF-8"),
        }
    }

    /// Checks the exit code, and that the words are in what was said.
    fn expect(&self, code: i32, words: &[&str]) {
        let said = format!("{}{}", self.stdout, self.stderr);
        assert_eq!(self.code, Some(code), "`{}` said: {said}", self.line);
        for word in words {
            assert!(
                said.contains(word),
                "`{}` does not say {word}: {said}",
                self.line
            );
        }
        assert!(!said.contains("panicked"), "`{}`: {said}", self.line);
    }
}

/// Whether what needs a device is to be skipped, which is said aloud.
fn skips() -> bool {
    let skip = std::env::var_os("CORPUT_SKIP_GPU").is_some_and(|value| value == "1");
    if skip {
        eprintln!("SKIPPED: CORPUT_SKIP_GPU=1");
    }
    skip
}
