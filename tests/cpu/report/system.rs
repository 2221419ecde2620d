//! Links, devices, full disks, pipes: where the operating system has a say.

use super::failure::refusal;
use super::*;
use std::io::{ErrorKind, Read};
use std::os::unix::fs::{FileTypeExt, symlink};
use std::process::{Command, Stdio};

/// Set for the children: tests that this file runs in another process.
const CHILD: &str = "CORPUT_TEST_CHILD";

/// A command that runs one test of this file under limits set by `shell`.
fn child(test: &str, shell: &str, folder: &Path) -> Command {
    let mut command = Command::new("sh");
    command
        .args(["-c", &format!("{shell}; exec \"$@\""), "sh"])
        .arg(std::env::current_exe().unwrap());
    command
        .args(["--exact", test, "--ignored", "--nocapture"])
        .env(CHILD, folder);
    command
}

fn io_kind(result: Result<Summary, Error>) -> ErrorKind {
    let error = result.unwrap_err();
    assert_eq!(error.exit_code(), 4);
    let Error::Io { source, .. } = error else {
        panic!("{error}")
    };
    source.kind()
}

#[test]
fn a_link_is_followed_and_a_dead_one_refused() {
    let folder = tempfile::tempdir().unwrap();
    let (real, link, dead) = (
        folder.path().join("real"),
        folder.path().join("l.npy"),
        folder.path().join("dead"),
    );
    fs::write(&real, "old").unwrap();
    symlink("real", &link).unwrap();
    symlink("nowhere", &dead).unwrap();
    save(&link, Format::Npy, layout(1, 1, Element::U32), &[&[9]]).unwrap();
    assert!(link.is_symlink());
    assert_eq!(parse_npy(&fs::read(&real).unwrap()).2, [9]);
    assert!(refusal(&dead, Format::Npy).contains("leads nowhere"));
}

#[test]
#[cfg(target_os = "linux")]
fn devices_are_written_in_place() {
    let data = vec![7; 1 << 19];
    let shape = layout(1 << 19, 1, Element::U32);
    save(Path::new("/dev/null"), Format::Raw, shape, &[&data]).unwrap();
    for format in [Format::Npy, Format::Raw, Format::Csv] {
        // Every write to it fails with "no space left on device".
        assert_eq!(
            io_kind(save(Path::new("/dev/full"), format, shape, &[&data])),
            ErrorKind::StorageFull
        );
        // Less than the buffer holds: found out at the end.
        assert_eq!(
            io_kind(save(
                Path::new("/dev/full"),
                format,
                layout(1, 1, Element::U32),
                &[&[1]]
            )),
            ErrorKind::StorageFull
        );
    }
    for device in ["/dev/null", "/dev/full"] {
        assert!(fs::metadata(device).unwrap().file_type().is_char_device());
    }
    assert!(!Path::new("/dev/null.json").exists());
}

#[test]
fn a_file_that_cannot_grow_leaves_what_was_there() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.raw"), "old").unwrap();
    let out = child(
        "system::child_outgrows_the_limit",
        "trap '' XFSZ; ulimit -f 64",
        folder.path(),
    )
    .output()
    .unwrap();
    let text = String::from_utf8_lossy(&out.stdout);
    assert!(
        out.status.success() && text.contains("1 passed"),
        "{text}{}",
        String::from_utf8_lossy(&out.stderr)
    );
    assert_eq!(names(&folder), ["p.raw"]);
    assert_eq!(fs::read(folder.path().join("p.raw")).unwrap(), b"old");
}

#[test]
#[ignore = "a_file_that_cannot_grow_leaves_what_was_there runs it, with a limit on file sizes"]
fn child_outgrows_the_limit() {
    let Some(folder) = std::env::var_os(CHILD) else {
        return;
    };
    let path = Path::new(&folder).join("p.raw");
    // 256 KiB against a limit of 64 blocks of 512 or 1024 bytes, in one write and gathered.
    let data = vec![7; 1 << 16];
    let shape = layout(1 << 16, 1, Element::U32);
    assert_eq!(
        io_kind(save(&path, Format::Raw, shape, &[&data])),
        ErrorKind::FileTooLarge
    );
    let rows: Vec<&[u32]> = data.chunks(100).collect();
    assert_eq!(
        io_kind(save(&path, Format::Raw, shape, &rows)),
        ErrorKind::FileTooLarge
    );
    let long = vec![7; 1 << 20];
    assert_eq!(
        io_kind(save(
            &path,
            Format::Npy,
            layout(1 << 20, 1, Element::U32),
            &[&long]
        )),
        ErrorKind::FileTooLarge
    );
}

#[test]
fn standard_output_gets_the_bytes_of_the_file() {
    let out = child(
        "system::child_writes_to_standard_output",
        ":",
        Path::new(""),
    )
    .output()
    .unwrap();
    assert!(out.status.success());
    let start = out
        .stdout
        .windows(6)
        .position(|w| w == b"\x93NUMPY")
        .unwrap();
    let data: Vec<u32> = (0..1 << 20).collect();
    let end = start + NPY_DATA_OFFSET + 4 * data.len();
    assert_eq!(
        parse_npy(&out.stdout[start..end]),
        ("<u4".to_owned(), vec![1 << 20, 1], data)
    );
}

#[test]
fn a_closed_pipe_is_an_error() {
    let mut running = child(
        "system::child_writes_to_standard_output",
        ":",
        Path::new("closed"),
    )
    .stdout(Stdio::piped())
    .stderr(Stdio::piped())
    .spawn()
    .unwrap();
    let mut pipe = running.stdout.take().unwrap();
    pipe.read_exact(&mut [0; 4096]).unwrap();
    drop(pipe);
    let out = running.wait_with_output().unwrap();
    let text = String::from_utf8_lossy(&out.stderr);
    assert!(text.contains("the pipe is closed: BrokenPipe"), "{text}");
}

#[test]
#[ignore = "other tests run it, with their own standard output"]
fn child_writes_to_standard_output() {
    let Some(mode) = std::env::var_os(CHILD) else {
        return;
    };
    let data: Vec<u32> = (0..1 << 20).collect();
    let result = save(
        Path::new("-"),
        Format::Npy,
        layout(1 << 20, 1, Element::U32),
        &[&data],
    );
    if mode == "closed" {
        // Not standard output, which is gone, and where the harness would panic.
        eprintln!("the pipe is closed: {:?}", io_kind(result));
        std::process::exit(0);
    }
    assert_eq!(
        result.unwrap().bytes,
        (NPY_DATA_OFFSET + 4 * data.len()) as u64
    );
}
