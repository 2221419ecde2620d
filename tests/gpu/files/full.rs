//! Disks that are full, folders that cannot be written or go away.

use super::{Desk, Run};
use std::path::{Path, PathBuf};
use std::process::Command;

/// 16 MB in chunks of 1 MiB.
const LINE: &str = "generate sobol --count 1000000 --dims 4 --chunk-rows 65536 --device cpu";

/// A file system of its own in the folder, where this user may mount one.
pub(super) struct Mount(pub(super) PathBuf);

impl Mount {
    pub(super) fn new(folder: PathBuf, options: &str) -> Option<Self> {
        std::fs::create_dir_all(&folder).unwrap();
        let mounted = mount(&["-t", "tmpfs", "-o", options, "tmpfs"], &folder);
        mounted.then_some(Self(folder))
    }
}

impl Drop for Mount {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(&self.0).output();
    }
}

pub(super) fn mount(arguments: &[&str], folder: &Path) -> bool {
    let done = Command::new("mount").args(arguments).arg(folder).output();
    done.is_ok_and(|done| done.status.success())
}

fn finished(desk: &Desk, name: &str) {
    desk.run(&format!("{LINE} --out whole.npy")).expect(0, &[]);
    assert!(desk.bytes(name) == desk.bytes("whole.npy"));
}

#[test]
fn a_full_disk_keeps_what_is_done() {
    let desk = Desk::new();
    let words = [
        "cannot write",
        "free space",
        " of 1000000 rows stay in",
        "--resume",
    ];
    let Some(disk) = Mount::new(desk.path("disk"), "size=8m") else {
        eprintln!("no file system may be mounted here: a limit of the shell on files in its place");
        return a_file_at_its_limit_keeps_what_is_done();
    };
    eprintln!("on a tmpfs of 8 MiB");
    let line = format!("{LINE} --out disk/p.npy");
    let run = desk.run(&line);
    run.expect(4, &words);
    run.expect(4, &["No space left"]);
    let names = || std::fs::read_dir(&disk.0).unwrap().count();
    assert_eq!(names(), 2);
    // The disk is still full, so that going on fails in the same way and loses nothing.
    desk.run(&format!("{line} --resume")).expect(4, &words);
    assert_eq!(names(), 2);
    assert!(mount(&["-o", "remount,size=64m"], &disk.0));
    desk.run(&format!("{line} --resume")).expect(0, &[]);
    assert_eq!(names(), 2);
    finished(&desk, "disk/p.npy");
}

#[test]
fn a_file_at_its_limit_keeps_what_is_done() {
    let desk = Desk::new();
    let line = format!("{LINE} --out p.npy");
    let mut command = Command::new("sh");
    command
        .current_dir(desk.path(""))
        .args(["-c", "trap '' XFSZ; ulimit -f 8192; exec \"$0\" \"$@\""])
        .arg(env!("CARGO_BIN_EXE_corput"))
        .args(line.split_whitespace());
    let words = [
        "cannot write p.npy",
        " of 1000000 rows stay in .p.npy.partial",
    ];
    Run::of(&line, command).expect(4, &words);
    assert!(desk.chunks() >= 3);
    desk.run(&format!("{line} --resume")).expect(0, &[]);
    finished(&desk, "p.npy");
}

#[test]
fn a_folder_that_cannot_be_written_is_refused() {
    let desk = Desk::new();
    let mounted = Mount::new(desk.path("disk"), "ro");
    let folder = match &mounted {
        Some(_) => "disk",
        None => {
            eprintln!("no file system may be mounted here: /proc in its place");
            "/proc"
        }
    };
    let run = desk.run(&format!("{LINE} --out {folder}/p.npy"));
    run.expect(2, &["folder", "is not writable", "another folder"]);
}

#[test]
fn a_folder_that_vanishes_ends_the_run() {
    let desk = Desk::new();
    std::fs::create_dir(desk.path("sub")).unwrap();
    let line = "generate sobol --count 4294967296 --dims 2 --chunk-rows 100000 --device cpu --out sub/p.npy";
    let mut command = desk.command(line);
    command
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped());
    let running = super::Running(command.spawn().unwrap());
    while !desk.path("sub/.p.npy.partial").exists() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    std::fs::remove_dir_all(desk.path("sub")).unwrap();
    let said = running.end(line);
    said.expect(
        4,
        &["cannot write sub/p.npy", "was removed while it was written"],
    );
    assert!(desk.names().is_empty());
}
