//! `corput generate` into Zarr stores, by shards, and `corput merge`, as their user meets them.

#[path = "store/damage.rs"]
mod damage;
#[path = "store/estimates.rs"]
mod estimates;
#[path = "store/refused.rs"]
mod refused;
#[path = "store/shards.rs"]
mod shards;
#[path = "store/shares.rs"]
mod shares;
#[cfg(unix)]
#[path = "store/slurm.rs"]
mod slurm;
#[path = "store/spec.rs"]
mod spec;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
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

    /// The hash that a merge of a complete store ends with.
    fn merged(&self, store: &str) -> String {
        let said = self.say(&format!("merge {store}"));
        let hash = said.lines().find_map(|line| line.strip_prefix("sha256 "));
        hash.unwrap_or_else(|| panic!("no hash: {said}")).to_owned()
    }

    /// Every file below a folder, with its bytes.
    fn tree(&self, name: &str) -> BTreeMap<PathBuf, Vec<u8>> {
        let mut found = BTreeMap::new();
        let mut folders = vec![self.path(name)];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(&folder).expect("a folder") {
                let path = entry.expect("an entry").path();
                if path.is_dir() {
                    folders.push(path);
                } else {
                    let name = path.strip_prefix(self.path(name)).expect("below it");
                    found.insert(name.to_owned(), fs::read(&path).expect("a file"));
                }
            }
        }
        found
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

/// The repository's file.
fn repository(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Whether what needs a device is to be skipped, which is said aloud.
fn skips() -> bool {
    let skip = std::env::var_os("CORPUT_SKIP_GPU").is_some_and(|value| value == "1");
    if skip {
        eprintln!("SKIPPED: CORPUT_SKIP_GPU=1");
    }
    skip
}

/// The SHA-256 of a raw file of the same points, which its sidecar has.
fn raw_hash(desk: &Desk, arguments: &str) -> String {
    desk.say(&format!("generate {arguments} --out points.raw"));
    let text = fs::read_to_string(desk.path("points.raw.json")).expect("a sidecar");
    let sidecar: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    sidecar["sha256"].as_str().expect("a hash").to_owned()
}
