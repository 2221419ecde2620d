//! `--device auto`: the faster one, and the same bytes.

use super::{Desk, Run, skips};
use serde_json::Value;
use std::fs;

/// A run in which the loader finds what the file of a driver says.
fn with_driver(desk: &Desk, driver: &str, line: &str) -> Run {
    let mut command = desk.command(line);
    command
        .env("VK_DRIVER_FILES", driver)
        .env("VK_ICD_FILENAMES", driver)
        .env_remove("CORPUT_DEVICE")
        .env_remove("CORPUT_VALIDATION");
    Run::of(line, command)
}

/// The rate in a message that names `whose` before it, in millions of points per second.
fn rate(message: &str, whose: &str) -> f64 {
    let (_, rest) = message.split_once(whose).unwrap();
    let (rate, _) = rest.trim_start().split_once(" M points/s").unwrap();
    rate.parse().unwrap()
}

/// Whether what was said is what was done: the larger rate is taken, and the sidecar names it.
/// None for a message of another form.
fn agrees(message: &str, device: &str) -> Option<bool> {
    let taken = message.strip_prefix("corput: --device auto takes ")?;
    let (taken, rates) = taken.split_once(": cpu ")?;
    let (_, name_and_rate) = rates.split_once(" M points/s, ")?;
    let name = name_and_rate.rsplitn(4, ' ').last()?;
    let (cpu, there) = (
        rate(message, ": cpu "),
        rate(message, &format!(", {name} ")),
    );
    let faster = if cpu >= there { "cpu" } else { name };
    Some(taken == faster && device.starts_with(taken))
}

#[test]
fn the_faster_one_is_taken_and_the_bytes_are_the_same() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for points in [
        "halton --count 300001 --dims 2",
        "halton --count 10 --dims 2",
        "sobol --count 100000 --dims 2 --scramble owen --seed 1",
        "halton --count 50000 --dims 2 --map cosine-hemisphere --with-pdf",
    ] {
        let run = desk.run(&format!("generate {points} --device auto --out a.raw"));
        run.expect(0, &["--device auto takes"]);
        let said: Value = serde_json::from_slice(&desk.bytes("a.raw.json")).unwrap();
        let device = said["device"].as_str().unwrap();
        let message = run.stderr.trim_end();
        assert_eq!(agrees(message, device), Some(true), "{message}; {device}");
        let wanted = desk.make(&format!("{points} --device cpu"), "cpu.raw");
        assert!(desk.bytes("a.raw") == wanted, "{points}: {}", run.stderr);
    }
}

#[test]
fn a_message_that_does_not_fit_is_noticed() {
    let said = |taken: &str| {
        format!("corput: --device auto takes {taken}: cpu 3.5 M points/s, a (b) 2.5 M points/s")
    };
    assert_eq!(agrees(&said("cpu"), "cpu"), Some(true));
    assert_eq!(agrees(&said("a (b)"), "a (b), 1.3"), Some(false));
    assert_eq!(agrees(&said("cpu"), "a (b), 1.3"), Some(false));
    assert_eq!(agrees("corput: it takes cpu", "cpu"), None);
}

#[test]
fn without_a_driver_that_opens_it_is_the_cpu() {
    let desk = Desk::new();
    let line = "generate halton --count 1000 --device auto --out a.npy";
    let wanted = desk.make("halton --count 1000 --device cpu", "cpu.npy");
    let broken = desk.path("broken.json");
    let text = r#"{"file_format_version": "1.0.0",
        "ICD": {"library_path": "/nonexistent.so", "api_version": "1.3.0"}}"#;
    fs::write(&broken, text).unwrap();
    for driver in ["/nonexistent.json", broken.to_str().unwrap()] {
        let run = with_driver(&desk, driver, line);
        run.expect(0, &["--device auto takes cpu: no Vulkan device"]);
        assert!(desk.bytes("a.npy") == wanted);
    }
}

#[test]
fn what_cannot_be_the_same_or_is_no_choice_is_refused() {
    let desk = Desk::new();
    let map = "generate halton --count 9 --map cosine-hemisphere --profile native --out n.npy";
    let native = desk.run(&format!("{map} --device auto"));
    native.expect(2, &["--profile native", "other bytes", "name the device"]);
    let mut command = desk.command("check");
    command.env("CORPUT_DEVICE", "auto");
    Run::of("check", command).expect(2, &["only `generate`", "corput devices"]);
    assert!(desk.names().is_empty());
}
