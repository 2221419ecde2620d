//! Peak memory does not grow with the file, nor with what is wrong with it.

use super::Desk;
#[cfg(target_os = "linux")]
use super::windows;
#[cfg(target_os = "linux")]
use std::process::Command;

/// The peak of resident memory so far, in KiB; none once the process has ended.
#[cfg(target_os = "linux")]
fn peak(id: u32) -> Option<u64> {
    let text = std::fs::read_to_string(format!("/proc/{id}/status")).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse().ok()
}

/// Runs a command that ends with this code, and returns its peak in bytes.
#[cfg(target_os = "linux")]
fn most(desk: &Desk, line: &str, code: i32) -> u64 {
    most_of(desk.command(line), line, code)
}

/// The same of a command that was made ready.
#[cfg(target_os = "linux")]
fn most_of(mut command: Command, line: &str, code: i32) -> u64 {
    let mut child = command.spawn().unwrap();
    let mut most = 0;
    while child.try_wait().unwrap().is_none() {
        most = most.max(peak(child.id()).unwrap_or(0));
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    assert_eq!(child.wait().unwrap().code(), Some(code), "{line}");
    most * 1024
}

#[test]
#[cfg(target_os = "linux")]
fn a_large_file_takes_little_memory() {
    // Four buffers of 16 MiB, and as much again for the program and its points.
    const LIMIT: u64 = 128 << 20;
    // Less than a buffer and a half: what differs by the moment at which two threads meet.
    const MORE: u64 = 24 << 20;
    let desk = Desk::new();
    for out in ["p.npy", "s.zarr"] {
        let [small, large] = [1u64 << 18, 1 << 20].map(|count| {
            let line = format!(
                "generate lattice --count {count} --dims 64 --device cpu --out {count}-{out}"
            );
            let bytes = most(&desk, &line, 0);
            println!("{line}: {} MiB at the peak", bytes >> 20);
            assert!(
                (1 << 20..LIMIT).contains(&bytes),
                "{bytes} bytes at the peak"
            );
            bytes
        });
        assert!(large < small + MORE, "{out}: {small} and {large} bytes");
    }
    let length = std::fs::metadata(desk.path("1048576-p.npy")).unwrap().len();
    assert_eq!(length, (256 << 20) + 4096);
}

/// Mapped windows are resident, and so is what the driver has.
#[test]
#[cfg(target_os = "linux")]
fn a_large_file_of_a_device_takes_little_memory() {
    const FILE: u64 = 768 << 20;
    const LIMIT: u64 = 512 << 20;
    let desk = Desk::new();
    for device in windows::devices() {
        for wish in device.wishes() {
            let line = format!(
                "generate sobol --count 3145728 --dims 64 --out p.npy --device {}",
                device.index
            );
            let mut command = desk.command(&line);
            command.env(windows::VARIABLE, wish);
            let bytes = most_of(command, &line, 0);
            println!("{}, {wish}: {} MiB at the peak", device.name, bytes >> 20);
            let length = std::fs::metadata(desk.path("p.npy")).unwrap().len();
            assert_eq!(length, FILE + 4096);
            assert!((1 << 20..LIMIT).contains(&bytes), "{bytes} bytes");
        }
    }
}

/// A text file that has become one line of zeros, within its rows or behind them.
#[test]
#[cfg(target_os = "linux")]
fn a_damaged_file_takes_little_memory() {
    const FILE: u64 = 512 << 20;
    const LIMIT: u64 = 128 << 20;
    let desk = Desk::new();
    let line = "generate halton --count 1000 --device cpu --out p.csv";
    desk.run(line).expect(0, &[]);
    let whole = desk.bytes("p.csv");
    let sidecar = String::from_utf8(desk.bytes("p.csv.json")).unwrap();
    let said = format!("\"bytes\": {},\n  \"chunk", whole.len());
    let longer = sidecar.replace(&said, &format!("\"bytes\": {FILE},\n  \"chunk"));
    assert_ne!(longer, sidecar);
    std::fs::write(desk.path("p.csv.json"), longer).unwrap();
    for kept in [whole.len() - 9, whole.len()] {
        std::fs::write(desk.path("p.csv"), &whole[..kept]).unwrap();
        let file = std::fs::OpenOptions::new()
            .write(true)
            .open(desk.path("p.csv"));
        // A hole, which takes no space.
        file.unwrap().set_len(FILE).unwrap();
        for (range, code) in [
            ("", 1),
            ("--range 999..1000", i32::from(kept < whole.len())),
        ] {
            let line = format!("verify p.csv --device cpu {range}");
            let bytes = most(&desk, &line, code);
            assert!(bytes < LIMIT, "`{line}`: {bytes} bytes at the peak");
        }
    }
}
