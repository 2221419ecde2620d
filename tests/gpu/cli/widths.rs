//! lavapipe as other machines run it: vectors of other widths, other numbers of threads.

use super::{Desk, Run, skips};
use serde_json::Value;

/// Points, maps and functions, of which most are SPIR-V that llvmpipe compiles to vectors.
const LINE: &str = "check --only hemisphere --device llvmpipe --json";

#[test]
fn lavapipe_gives_the_same_bits_at_every_width_and_on_any_threads() {
    let desk = Desk::new();
    let devices: Value = serde_json::from_str(&desk.say("devices --json")).unwrap_or_default();
    let devices = devices["devices"].as_array().cloned().unwrap_or_default();
    let there = |one: &Value| {
        one["name"]
            .as_str()
            .is_some_and(|name| name.contains("llvmpipe"))
    };
    if skips() || !devices.iter().any(there) {
        eprintln!("SKIPPED: no lavapipe");
        return;
    }
    let mut names = Vec::new();
    let mut fingerprints = Vec::new();
    for (width, threads) in [("128", "2"), ("256", "0"), ("256", "1"), ("512", "2")] {
        let mut command = desk.command(LINE);
        command
            .env("LP_NATIVE_VECTOR_WIDTH", width)
            .env("LP_NUM_THREADS", threads);
        let run = Run::of(LINE, command);
        run.expect(0, &[]);
        let said: Value = serde_json::from_slice(&run.stdout).unwrap();
        names.push(said["device"]["name"].as_str().unwrap().to_owned());
        fingerprints.push(said["fingerprint"].as_str().unwrap().to_owned());
    }
    // The driver's name has the width: it was heeded, as far as the machine has such vectors.
    assert!(
        names[0].contains("128 bits") && names[1].contains("256 bits"),
        "{names:?}"
    );
    assert!(
        fingerprints.iter().all(|one| *one == fingerprints[0]),
        "{fingerprints:?}"
    );
}
