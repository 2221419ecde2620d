//! Peak memory does not grow with the file.

use super::Desk;

/// The peak of resident memory so far, in KiB; none once the process has ended.
#[cfg(target_os = "linux")]
fn peak(id: u32) -> Option<u64> {
    let text = std::fs::read_to_string(format!("/proc/{id}/status")).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse().ok()
}

#[test]
#[cfg(target_os = "linux")]
fn a_large_file_takes_little_memory() {
    const FILE: u64 = 256 << 20;
    // Four buffers of 16 MiB, and as much again for the program and its points.
    const LIMIT: u64 = 128 << 20;
    let desk = Desk::new();
    let line = "generate lattice --count 1048576 --dims 64 --device cpu --out p.npy";
    let mut child = desk.command(line).spawn().unwrap();
    let mut most = 0;
    while child.try_wait().unwrap().is_none() {
        most = most.max(peak(child.id()).unwrap_or(0));
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    assert!(child.wait().unwrap().success());
    let length = std::fs::metadata(desk.path("p.npy")).unwrap().len();
    assert_eq!(length, FILE + 4096);
    let bytes = most * 1024;
    assert!(
        (1 << 20..LIMIT).contains(&bytes),
        "{bytes} bytes at the peak"
    );
}
