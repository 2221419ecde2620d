//! Runs that are cut off at any moment.

use super::{Desk, SMALL, skips};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

const KILLS: u32 = 50;

/// The most tries: of a run that had ended when the kill came there is another.
const TRIES: u32 = 4 * KILLS;

/// A random number in [0, 1): splitmix64.
pub(super) fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (z >> 11) as f64 / (1u64 << 53) as f64
}

/// Runs a command and kills it after so long. Whether it was still running.
fn kill(desk: &Desk, line: &str, after: Duration) -> bool {
    kill_command(desk.command(line), after)
}

/// The same of a command that was made ready.
pub(super) fn kill_command(mut command: Command, after: Duration) -> bool {
    command.stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = command.spawn().unwrap();
    sleep(after);
    // An error is that of a process which has ended.
    let _ = child.kill();
    child.wait().unwrap().code().is_none()
}

#[test]
fn a_killed_run_goes_on_to_the_same_bytes() {
    let desk = Desk::new();
    let line = format!("{SMALL} --device cpu --out p.npy");
    let start = Instant::now();
    desk.run(&line).expect(0, &[]);
    // About what a run takes; what else this machine does changes that.
    let mut whole = start.elapsed();
    let expected = desk.bytes("p.npy");
    let sidecar = desk.bytes("p.npy.json");

    let resume = format!("{line} --resume");
    let device = format!("{SMALL} --out p.npy --resume");
    let mut state = 8;
    let (mut kills, mut chunks) = (0, 0);
    for _ in 0..TRIES {
        std::fs::remove_file(desk.path("p.npy")).unwrap();
        std::fs::remove_file(desk.path("p.npy.json")).unwrap();
        if kill(&desk, &line, whole.mul_f64(random(&mut state))) {
            kills += 1;
            whole = whole.mul_f64(1.1);
        } else {
            whole = whole.mul_f64(0.7);
        }
        while random(&mut state) < 0.4 {
            kill(&desk, &resume, whole.mul_f64(random(&mut state) / 2.0));
        }
        chunks += u32::from(desk.chunks() > 0);
        // Every tenth is finished by the device, whose bytes are the same.
        let on_device = kills % 10 == 9 && !skips();
        desk.run(if on_device { &device } else { &resume })
            .expect(0, &[]);
        assert!(desk.bytes("p.npy") == expected, "kill {kills}");
        assert_eq!(desk.names(), ["p.npy", "p.npy.json"], "kill {kills}");
        if !on_device {
            assert!(desk.bytes("p.npy.json") == sidecar, "kill {kills}");
        }
        if kills == KILLS {
            break;
        }
    }
    assert_eq!(kills, KILLS, "killed while they ran, in {TRIES} tries");
    assert!(
        chunks >= KILLS / 4,
        "only {chunks} had a chunk to go on from"
    );
}

#[test]
fn an_interrupted_run_keeps_its_chunks() {
    // So slow, and of so many chunks, that the signal comes before the end.
    let slow = "generate sobol --count 2000000 --dims 4 --scramble owen --chunk-rows 20000";
    for signal in ["INT", "TERM"] {
        let desk = Desk::new();
        let line = format!("{slow} --device cpu --out p.npy");
        let running = desk.start(&line, 3);
        running.signal(signal);
        let said = running.end(&line);
        let words = [
            "interrupted after ",
            " of 2000000 rows stay in .p.npy.partial",
            "--resume",
        ];
        said.expect(4, &words);
        assert!(!said.stderr.contains("run again"), "{}", said.stderr);
        assert_eq!(desk.names(), [".p.npy.partial", ".p.npy.partial.json"]);
        let kept = desk.chunks() as u64;
        assert!((3..100).contains(&kept));
        // The space of what is not kept is given back.
        let length = std::fs::metadata(desk.path(".p.npy.partial"))
            .unwrap()
            .len();
        assert_eq!(length, 4096 + kept * 20_000 * 16);
        desk.run(&format!("{line} --resume")).expect(0, &[]);
        let bytes = desk.bytes("p.npy");
        desk.run(&line).expect(0, &[]);
        assert!(bytes == desk.bytes("p.npy"));
    }
}

/// All of its points are made at once, and each waits for the disk.
#[test]
fn a_run_of_tiny_chunks_hears_the_signal() {
    let desk = Desk::new();
    let line = "generate vdc --count 60000 --chunk-rows 1 --device cpu --out p.npy";
    let running = desk.start(line, 3);
    running.signal("INT");
    let said = running.end(line);
    said.expect(
        4,
        &["interrupted after ", " of 60000 rows stay in", "--resume"],
    );
    let kept = desk.chunks();
    assert!((3..60_000).contains(&kept), "{kept}");
}

/// On a terminal, of which a pipe is none.
#[test]
#[cfg(target_os = "linux")]
fn the_check_of_what_is_there_is_shown() {
    let desk = Desk::new();
    let line =
        "generate sobol --count 4000000 --dims 8 --chunk-rows 500000 --device cpu --out p.npy";
    drop(desk.start(line, 4));
    let mut command = std::process::Command::new("script");
    command
        .current_dir(desk.path(""))
        .args(["-qec", &format!("\"$CORPUT\" {line} --resume"), "/dev/null"])
        .env("CORPUT", env!("CARGO_BIN_EXE_corput"))
        .env("TERM", "xterm")
        .stdin(Stdio::null());
    let Ok(output) = command.output() else {
        eprintln!("SKIPPED: there is no `script` that makes a terminal");
        return;
    };
    let run = super::Run::left(line, output);
    run.tells(0, &["checking what is there: ", "MiB"]);
}

#[test]
fn text_goes_on_too() {
    let desk = Desk::new();
    let line = "generate halton --count 300000 --dims 3 --chunk-rows 10000 --device cpu --format csv --out p.npy";
    drop(desk.start(line, 3));
    desk.run(&format!("{line} --resume")).expect(0, &[]);
    let resumed = desk.bytes("p.npy");
    desk.run(line).expect(0, &[]);
    assert!(resumed == desk.bytes("p.npy"));
}
