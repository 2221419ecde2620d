//! Files of `corput generate` when something goes wrong, and `corput verify`.

#[path = "files/busy.rs"]
mod busy;
#[path = "files/formats.rs"]
mod formats;
#[path = "files/full.rs"]
mod full;
#[path = "files/killed.rs"]
mod killed;
#[path = "files/memory.rs"]
mod memory;
#[path = "files/recorded.rs"]
mod recorded;
mod support;
#[path = "files/verify.rs"]
mod verify;

use std::fs;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use support::skips;
use tempfile::TempDir;

/// A file of 25 chunks, which takes a few tenths of a second.
const SMALL: &str =
    "generate sobol --count 500000 --dims 4 --scramble owen-hash --seed 1 --chunk-rows 20000";

/// A folder to run commands in.
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
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<_> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    fn command(&self, line: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_corput"));
        command
            .current_dir(self.0.path())
            .args(line.split_whitespace());
        command
    }

    fn run(&self, line: &str) -> Run {
        Run::of(line, self.command(line))
    }

    /// Starts a command, and waits until the journal of p.npy has so many complete chunks.
    fn start(&self, line: &str, chunks: usize) -> Running {
        let mut command = self.command(line);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut running = Running(command.spawn().unwrap());
        let start = Instant::now();
        while self.chunks() < chunks {
            assert_eq!(
                running.0.try_wait().unwrap(),
                None,
                "`{line}` ended by itself"
            );
            assert!(start.elapsed() < Duration::from_secs(60), "no chunk");
            sleep(Duration::from_millis(1));
        }
        running
    }

    /// Complete chunks in the journal of p.npy.
    fn chunks(&self) -> usize {
        let text = fs::read_to_string(self.path(".p.npy.partial.json")).unwrap_or_default();
        text.matches('\n').count().saturating_sub(1)
    }
}

impl Run {
    fn of(line: &str, mut command: Command) -> Self {
        let output = command.output().unwrap();
        Self {
            line: line.to_owned(),
            code: output.status.code(),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
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

/// A started command, ended at the latest with the test.
struct Running(Child);

impl Running {
    fn signal(&self, name: &str) {
        let id = self.0.id().to_string();
        let sent = Command::new("kill").args(["-s", name, &id]).status();
        assert!(sent.unwrap().success());
    }

    fn end(mut self, line: &str) -> Run {
        let start = Instant::now();
        while self.0.try_wait().unwrap().is_none() {
            assert!(
                start.elapsed() < Duration::from_secs(60),
                "`{line}` does not end"
            );
            sleep(Duration::from_millis(5));
        }
        let mut stderr = String::new();
        let mut pipe = self.0.stderr.take().unwrap();
        std::io::Read::read_to_string(&mut pipe, &mut stderr).unwrap();
        Run {
            line: line.to_owned(),
            code: self.0.wait().unwrap().code(),
            stdout: String::new(),
            stderr,
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It has ended where the test passes.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// The CPU, and the device where there is one.
fn devices() -> &'static [&'static str] {
    match skips() {
        true => &["--device cpu"],
        false => &["--device cpu", ""],
    }
}
