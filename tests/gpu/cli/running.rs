//! What fails under way: full disks, closed pipes, Ctrl-C.

use super::{Desk, Run, repository, skips};
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_an_error() {
    let desk = Desk::new();
    for format in ["npy", "raw", "csv"] {
        for count in [1, 1_000_000] {
            let line = format!(
                "generate halton --count {count} --device cpu --format {format} --out /dev/full"
            );
            desk.run(&line)
                .expect(4, &["/dev/full", "No space left", "free space"]);
        }
    }
    assert!(desk.names().is_empty());
}

#[test]
fn a_file_that_cannot_grow_is_removed() {
    let desk = Desk::new();
    std::fs::write(desk.path("p.raw"), "old").unwrap();
    let line = "generate halton --count 1000000 --device cpu --out p.raw";
    let mut command = Command::new("sh");
    command
        .current_dir(desk.path(""))
        .args(["-c", "trap '' XFSZ; ulimit -f 64; exec \"$0\" \"$@\""])
        .arg(env!("CARGO_BIN_EXE_corput"))
        .args(line.split_whitespace());
    Run::of(line, command).expect(4, &["cannot write p.raw", "free space"]);
    assert_eq!(desk.names(), ["p.raw"]);
    assert_eq!(desk.bytes("p.raw"), b"old");
}

/// A started command, ended at the latest with the test.
struct Running(Child);

impl Running {
    fn start(desk: &Desk, line: &str) -> Self {
        let mut command = desk.command(line);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        Self(command.spawn().unwrap())
    }

    /// Waits until the process handles interrupts itself, which a loaded machine may delay.
    #[cfg(target_os = "linux")]
    fn wait_for_handler(&mut self) {
        let status = format!("/proc/{}/status", self.0.id());
        let start = Instant::now();
        loop {
            let text = std::fs::read_to_string(&status).unwrap_or_default();
            let caught = text.lines().find_map(|line| line.strip_prefix("SigCgt:"));
            let mask = caught.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
            // SIGINT is number 2.
            if mask.is_some_and(|mask| mask >> 1 & 1 == 1) {
                return;
            }
            assert_eq!(self.0.try_wait().unwrap(), None, "it ended by itself");
            assert!(start.elapsed() < Duration::from_secs(60), "no handler");
            sleep(Duration::from_millis(5));
        }
    }

    /// Elsewhere there is no telling, so a second must do.
    #[cfg(not(target_os = "linux"))]
    fn wait_for_handler(&mut self) {
        sleep(Duration::from_secs(1));
    }

    /// Waits until a partial file in the folder has this many bytes.
    fn wait_for_partial(&mut self, folder: &Path, bytes: u64) {
        let start = Instant::now();
        loop {
            let names = std::fs::read_dir(folder).into_iter().flatten().flatten();
            let grown = names
                .filter(|entry| entry.file_name().to_string_lossy().ends_with(".partial"))
                .any(|entry| entry.metadata().is_ok_and(|found| found.len() >= bytes));
            if grown {
                return;
            }
            assert_eq!(self.0.try_wait().unwrap(), None, "it ended by itself");
            assert!(start.elapsed() < Duration::from_secs(60), "no partial file");
            sleep(Duration::from_millis(20));
        }
    }

    fn signal(&self, name: &str) {
        let id = self.0.id().to_string();
        let sent = Command::new("kill").args(["-s", name, &id]).status();
        assert!(sent.unwrap().success());
    }

    /// The exit code and standard error, within a minute.
    fn end(mut self) -> (Option<i32>, String) {
        let start = Instant::now();
        let code = loop {
            if let Some(status) = self.0.try_wait().unwrap() {
                break status.code();
            }
            assert!(start.elapsed() < Duration::from_secs(60), "it does not end");
            sleep(Duration::from_millis(20));
        };
        let mut text = String::new();
        let mut pipe = self.0.stderr.take().unwrap();
        pipe.read_to_string(&mut text).unwrap();
        (code, text)
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It has ended where the test passes.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn a_run_interrupted_in_its_first_chunk_leaves_no_file() {
    let mut cases = vec![(" --device cpu", "INT"), (" --device cpu", "TERM")];
    if !skips() {
        cases.push(("", "INT"));
    }
    for (device, signal) in cases {
        for file in ["big.npy", "big.raw"] {
            let desk = Desk::new();
            let line = format!(
                "generate vdc --count 4294967296{device} --chunk-rows 268435456 --out {file}"
            );
            let mut running = Running::start(&desk, &line);
            running.wait_for_partial(&desk.path(""), 1 << 20);
            running.signal(signal);
            let (code, text) = running.end();
            assert_eq!(code, Some(4), "`{line}`: {text}");
            assert!(text.contains("interrupted after "), "{text}");
            assert!(text.contains(" of 4294967296; nothing was left"), "{text}");
            assert!(desk.names().is_empty(), "{:?}", desk.names());
        }
    }
}

#[test]
fn an_interrupted_demonstration_leaves_no_file() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let map = repository("tests/data/sunrise.exr");
    let line = format!("demo --env {} --out .", map.display());
    let mut running = Running::start(&desk, &line);
    running.wait_for_partial(&desk.path(""), 1 << 20);
    running.signal("INT");
    let (code, text) = running.end();
    assert_eq!(code, Some(4), "{text}");
    assert!(text.contains("interrupted after "), "{text}");
    assert!(desk.names().is_empty(), "{:?}", desk.names());
}

#[test]
fn an_interrupted_picture_leaves_no_file() {
    for device in if skips() {
        &["cpu"][..]
    } else {
        &["cpu", "llvmpipe"]
    } {
        let desk = Desk::new();
        let line = format!(
            "estimate --integrand pixel-edge --sampler sobol --pixels 512x512 --count 4096 \
             --device {device} --out p.npy"
        );
        let mut running = Running::start(&desk, &line);
        running.wait_for_partial(&desk.path(""), 0);
        running.signal("INT");
        let (code, text) = running.end();
        assert_eq!(code, Some(4), "{text}");
        assert!(text.contains(" of 1073741824; nothing was left"), "{text}");
        assert!(desk.names().is_empty(), "{:?}", desk.names());
    }
}

#[test]
fn an_interrupted_plot_leaves_no_file() {
    let desk = Desk::new();
    desk.make("halton --count 65536 --device cpu", "p.npy");
    let mut running = Running::start(&desk, "plot p.npy --out p.png");
    running.wait_for_partial(&desk.path(""), 0);
    running.signal("INT");
    let (code, text) = running.end();
    assert_eq!(code, Some(4), "{text}");
    assert!(text.contains(" of 65536; nothing was left"), "{text}");
    assert_eq!(desk.names(), ["p.npy", "p.npy.json"]);
}

#[test]
fn an_interrupted_check_ends_at_once() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for delay in [0, 300, 700, 1100] {
        let mut running = Running::start(&desk, "check");
        running.wait_for_handler();
        sleep(Duration::from_millis(delay));
        running.signal("INT");
        let (code, text) = running.end();
        assert_eq!(code, Some(4), "{text}");
        assert!(text.contains("interrupted"), "{text}");
    }
}

#[test]
fn a_closed_pipe_is_an_error_without_a_panic() {
    let desk = Desk::new();
    let mut devices = vec![" --device cpu"];
    if !skips() {
        devices.push("");
    }
    for device in devices {
        for format in ["npy", "csv"] {
            let line = format!("generate halton --count 1000000{device} --format {format} --out -");
            let mut running = Running::start(&desk, &line);
            let mut pipe = running.0.stdout.take().unwrap();
            pipe.read_exact(&mut [0; 10]).unwrap();
            drop(pipe);
            let (code, text) = running.end();
            assert_eq!(code, Some(4), "{text}");
            assert!(text.contains("its reader has gone"), "{text}");
            assert!(
                !text.contains("panicked") && text.lines().count() == 1,
                "{text}"
            );
        }
    }
    let mut running = Running::start(&desk, "headers --out h");
    drop(running.0.stdout.take());
    assert_eq!(running.end(), (Some(4), String::new()));
}

/// The rows of a study's table without its times, which are the last four columns.
fn errors_of(desk: &Desk, folder: &str) -> Vec<String> {
    let text = String::from_utf8(desk.bytes(&format!("{folder}/results.csv"))).unwrap();
    let line = |line: &str| line.rsplitn(5, ',').last().unwrap_or("").to_owned();
    text.lines().map(line).collect()
}

/// A study of six cells on the CPU.
fn study(options: &str) -> String {
    format!(
        "converge --integrand x-squared --integrand genz-gaussian:d=8 --max-count 32768 \
         --sampler random,halton,sobol:owen-hash --replicates 8 --device cpu {options}"
    )
}

/// What a study says that is interrupted once it has kept a cell in a file.
fn interrupted(desk: &Desk, line: &str, cells: &Path) -> String {
    let running = Running::start(desk, line);
    let start = Instant::now();
    while kept(cells) == 0 {
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "no finished cell"
        );
        sleep(Duration::from_millis(5));
    }
    running.signal("INT");
    let (code, text) = running.end();
    assert_eq!(code, Some(4), "{text}");
    text
}

fn kept(cells: &Path) -> usize {
    std::fs::read_to_string(cells).map_or(0, |text| text.lines().count())
}

#[test]
fn an_interrupted_study_goes_on() {
    let desk = Desk::new();
    let cells = desk.path("out/unfinished.jsonl");
    let text = interrupted(&desk, &study("--report out"), &cells);
    let words = "the same command goes on from there";
    assert!(text.contains(words), "{text}");
    assert_eq!(desk.names(), ["out"]);
    let first = kept(&cells);
    assert!((1..6).contains(&first), "{first} cells of 6");

    desk.run(&study("--report out")).expect(0, &["report.html"]);
    assert!(!cells.exists());
    desk.run(&study("--report whole"))
        .expect(0, &["report.html"]);
    assert_eq!(errors_of(&desk, "out"), errors_of(&desk, "whole"));
}

#[test]
fn an_interrupted_study_says_how_to_go_on() {
    let desk = Desk::new();
    let cells = desk.path("out/unfinished.jsonl");
    let text = interrupted(&desk, &study("--report out --fresh"), &cells);
    assert!(text.contains("the same command without --fresh"), "{text}");

    // Before it begins to measure, there is nothing to keep: then it says so, and it is
    // interrupted later.
    for wait in [0, 200, 1000, 5000] {
        let mut running = Running::start(&desk, &study(""));
        running.wait_for_handler();
        sleep(Duration::from_millis(wait));
        running.signal("INT");
        let (code, text) = running.end();
        assert_eq!(code, Some(4), "{text}");
        if text.contains("give --report DIR") {
            return;
        }
        assert!(text.contains("interrupted; run again"), "{text}");
    }
    panic!("it does not say what would be kept");
}

/// A mean that is no number, as an integrand or a device may give one.
#[test]
fn means_that_are_not_finite_are_told_and_marked() {
    let desk = Desk::new();
    let cells = desk.path("out/unfinished.jsonl");
    interrupted(&desk, &study("--report out"), &cells);
    let text = std::fs::read_to_string(&cells).unwrap();
    let (line, others) = text.split_once('\n').unwrap();
    let mut cell: serde_json::Value = serde_json::from_str(line).unwrap();
    // Of the first count, 16.
    cell["cell"]["points"][0]["means"][3] = f64::NAN.to_bits().into();
    std::fs::write(&cells, format!("{cell}\n{others}")).unwrap();
    let said = desk.run(&study("--report out"));
    let number = 8 * 12 + 12 + 8 * 12;
    said.expect(
        1,
        &[
            &format!("1 of {} means are not finite", 2 * number),
            "random on x-squared at 16 points",
        ],
    );
    let table = String::from_utf8_lossy(&said.stdout);
    assert!(table.contains("; 1 not finite"), "{table}");
    let page = String::from_utf8(desk.bytes("out/report.html")).unwrap();
    assert!(page.contains("1 mean is not finite"));
}
