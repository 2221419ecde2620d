//! The binary as its user meets it: what it writes, says, refuses and returns.

#[path = "cli/accuracy.rs"]
mod accuracy;
#[path = "cli/auto.rs"]
mod auto;
#[path = "cli/bench.rs"]
mod bench;
#[path = "cli/blue_noise.rs"]
mod blue_noise;
#[path = "cli/check.rs"]
mod check;
#[path = "cli/commands.rs"]
mod commands;
#[path = "cli/converge.rs"]
mod converge;
#[path = "cli/devices.rs"]
mod devices;
#[path = "cli/environment.rs"]
mod environment;
#[path = "cli/estimate.rs"]
mod estimate;
#[path = "cli/guide.rs"]
mod guide;
#[path = "cli/limits.rs"]
mod limits;
#[path = "cli/maps.rs"]
mod maps;
#[path = "cli/measure.rs"]
mod measure;
#[path = "cli/parse.rs"]
mod parse;
#[path = "cli/plot.rs"]
mod plot;
#[path = "cli/published.rs"]
mod published;
#[path = "cli/refused.rs"]
mod refused;
#[path = "cli/report.rs"]
mod report;
#[cfg(unix)]
#[path = "cli/running.rs"]
mod running;
#[path = "cli/same.rs"]
mod same;
#[path = "cli/sequences.rs"]
mod sequences;
#[path = "cli/vectors.rs"]
mod vectors;
#[path = "cli/widths.rs"]
mod widths;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// An empty folder to run commands in.
struct Desk(TempDir);

/// What a command left.
struct Run {
    line: String,
    code: Option<i32>,
    stdout: Vec<u8>,
    stderr: String,
}

impl Desk {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Every name in the folder, sorted.
    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<_> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// `corput` in this folder with the words of `line`, validation on.
    fn command(&self, line: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_corput"));
        command
            .current_dir(self.0.path())
            .args(line.split_whitespace());
        if !is_set("CORPUT_SKIP_VALIDATION") {
            command.env("CORPUT_VALIDATION", "1");
        }
        command
    }

    /// Runs a command to its end.
    fn run(&self, line: &str) -> Run {
        Run::of(line, self.command(line))
    }

    /// Runs a command that must succeed, and returns its standard output.
    fn say(&self, line: &str) -> String {
        let run = self.run(line);
        run.expect(0, &[]);
        assert_eq!(run.stderr, "", "`{line}` wrote this to standard error");
        String::from_utf8(run.stdout).unwrap()
    }

    /// Runs a command that must succeed without a word.
    fn quietly(&self, line: &str) {
        assert_eq!(self.say(line), "", "`{line}` wrote to standard output");
    }

    /// Runs a `generate` into a file in silence, and returns the file's bytes.
    fn make(&self, line: &str, name: &str) -> Vec<u8> {
        self.quietly(&format!("generate {line} --out {name}"));
        self.bytes(name)
    }
}

impl Run {
    fn of(line: &str, mut command: Command) -> Self {
        let output = command.output().unwrap();
        Self {
            line: line.to_owned(),
            code: output.status.code(),
            stdout: output.stdout,
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Checks the exit code, and that the words are in the message.
    fn expect(&self, code: i32, words: &[&str]) {
        let Self { line, stderr, .. } = self;
        assert_eq!(self.code, Some(code), "`{line}` said: {stderr}");
        for word in words {
            assert!(
                stderr.contains(word),
                "`{line}` does not say {word}: {stderr}"
            );
        }
        assert!(!stderr.contains("panicked"), "`{line}`: {stderr}");
    }
}

/// The repository's file.
fn repository(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Whether what needs a device is to be skipped, which is said aloud.
fn skips() -> bool {
    let skip = is_set("CORPUT_SKIP_GPU");
    if skip {
        eprintln!("SKIPPED: CORPUT_SKIP_GPU=1");
    }
    skip
}

fn is_set(variable: &str) -> bool {
    std::env::var_os(variable).is_some_and(|value| value == "1")
}
