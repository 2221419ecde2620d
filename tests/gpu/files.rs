//! Files of `corput generate` when something goes wrong, and `corput verify`.

#[path = "files/busy.rs"]
mod busy;
mod desk;
#[path = "files/formats.rs"]
mod formats;
#[path = "files/full.rs"]
mod full;
#[path = "../cpu/json_schema.rs"]
mod json_schema;
#[path = "files/killed.rs"]
mod killed;
#[path = "files/masks.rs"]
mod masks;
#[path = "files/memory.rs"]
mod memory;
#[path = "files/pictures.rs"]
mod pictures;
#[path = "files/recorded.rs"]
mod recorded;
mod support;
#[path = "files/verify.rs"]
mod verify;
#[cfg(target_os = "linux")]
#[path = "files/windows.rs"]
mod windows;

use desk::{Desk, Run};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::fs;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use support::skips;

/// A file of 25 chunks, which takes a few tenths of a second.
const SMALL: &str =
    "generate sobol --count 500000 --dims 4 --scramble owen-hash --seed 1 --chunk-rows 20000";

impl Desk {
    /// Starts a command, and waits until the journal of p.npy has so many complete chunks.
    fn start(&self, line: &str, chunks: usize) -> Running {
        let mut command = self.command(line);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        self.follow(command, line, chunks)
    }

    /// The same of a command that was made ready.
    fn follow(&self, mut command: Command, line: &str, chunks: usize) -> Running {
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
            stdout: Vec::new(),
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

fn sha256(bytes: &[u8]) -> String {
    corput::report::hexadecimal(&Sha256::digest(bytes))
}

/// The FILE.json of a file.
fn sidecar(desk: &Desk, name: &str) -> Value {
    serde_json::from_slice(&desk.bytes(&format!("{name}.json"))).unwrap()
}

/// The CPU, and the device where there is one.
fn devices() -> &'static [&'static str] {
    match skips() {
        true => &["--device cpu"],
        false => &["--device cpu", ""],
    }
}
