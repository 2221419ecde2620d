//! A Python with packages of its own, for tests that need them.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A Python in the folder `name` that has these packages, which `check` imports: one made before,
/// or made now with three minutes for each step.
pub fn python(name: &str, packages: &[&str], check: &str) -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let python = folder.join("bin/python");
    let quietly = |command: &mut Command| {
        let command = command.stdin(Stdio::null()).stdout(Stdio::null());
        let child = command.stderr(Stdio::null()).spawn().ok();
        child.is_some_and(|child| within(Duration::from_secs(180), child) == Some(0))
    };
    let has = || quietly(Command::new(&python).args(["-c", check]));
    if python.exists() && has() {
        return Some(python);
    }
    let made = quietly(Command::new("python3").args(["-m", "venv"]).arg(&folder))
        && quietly(
            Command::new(&python)
                .args(["-m", "pip", "install", "--quiet", "--retries", "0"])
                .arg("--disable-pip-version-check")
                .args(packages),
        )
        && has();
    made.then_some(python)
}

/// The exit code of a process; it is ended where it takes too long.
pub fn within(limit: Duration, mut child: Child) -> Option<i32> {
    let begun = Instant::now();
    while begun.elapsed() < limit {
        match child.try_wait() {
            Ok(Some(status)) => return status.code(),
            Ok(None) => sleep(Duration::from_millis(50)),
            Err(_) => break,
        }
    }
    let _ = child.kill();
    let _ = child.wait();
    None
}
