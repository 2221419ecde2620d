//! The example of a Dask cluster, by workers of this machine.

use super::python::{python, within};
use super::{Desk, raw_hash, repository};
use std::fs::{File, read_to_string};
use std::path::Path;
use std::process::Command;
use std::time::Duration;

/// Runs the example, and returns its exit code and all that it said.
fn example(python: &Path, desk: &Desk, arguments: &str) -> (Option<i32>, String) {
    let said = desk.path("said");
    let file = File::create(&said).expect("a file");
    let mut command = Command::new(python);
    command
        .arg(repository("examples/dask_generate.py"))
        .args(["--corput", env!("CARGO_BIN_EXE_corput"), "--out", "s.zarr"])
        .args(arguments.split_whitespace())
        .current_dir(desk.path(""))
        .stdout(file.try_clone().expect("a file"))
        .stderr(file);
    let code = within(
        Duration::from_secs(300),
        command.spawn().expect("python runs"),
    );
    (code, read_to_string(said).expect("UTF-8"))
}

/// A corput whose first call is killed half-way together with the worker that made it, and whose
/// second fails.
#[cfg(unix)]
fn faulty(desk: &Desk) -> String {
    use std::os::unix::fs::PermissionsExt;
    let corput = env!("CARGO_BIN_EXE_corput");
    let [died, failed] = ["died", "failed"].map(|name| desk.path(name).display().to_string());
    let script = format!(
        "#!/bin/sh\n\
         if mkdir '{died}' 2>/dev/null; then '{corput}' \"$@\" & sleep 0.2; kill -9 $! $PPID; fi\n\
         if mkdir '{failed}' 2>/dev/null; then echo 'a fault of the test' >&2; exit 4; fi\n\
         exec '{corput}' \"$@\"\n"
    );
    let path = desk.path("faulty");
    std::fs::write(&path, script).expect("a script");
    std::fs::set_permissions(&path, PermissionsExt::from_mode(0o755)).expect("it may run");
    path.display().to_string()
}

/// One worker dies in the middle of a shard, and one task fails: both are tried again, and the store
/// is what a single run makes.
#[test]
#[cfg(unix)]
fn workers_fill_a_store() {
    let packages = ["zarr==3.*", "dask", "distributed"];
    let check = "import dask, distributed, zarr; assert zarr.__version__ >= '3'";
    let Some(python) = python("dask-python", &packages, check) else {
        eprintln!("SKIPPED: Dask could not be installed; the example was not run");
        return;
    };
    let desk = Desk::new();
    let points = "--count 5000000 --dims 2";
    let more = "--scramble owen-hash --seed 3";
    let corput = faulty(&desk);
    let line = format!("--workers 2 --shards 3 --corput {corput} {points} -- {more}");
    let (code, said) = example(&python, &desk, &line);
    assert_eq!(code, Some(0), "{said}");
    assert!(desk.path("died").is_dir() && desk.path("failed").is_dir());
    for shard in ["0/3", "1/3", "2/3"] {
        assert!(
            said.contains(&format!("shard {shard} by worker ")),
            "{said}"
        );
    }
    let hash = raw_hash(&desk, &format!("sobol {points} {more} --device cpu"));
    for words in [
        "s.zarr: (5000000, 2) float32, chunks of (2097152, 2)",
        &format!("store       {hash}\nsingle run  {hash}\nequal"),
    ] {
        assert!(said.contains(words), "{said}");
    }
    assert_eq!(desk.merged("s.zarr"), hash);
    // A task that cannot succeed ends the example, with what corput said.
    let (code, said) = example(
        &python,
        &desk,
        "--workers 1 --retries 0 --count 5000000 --dims 3",
    );
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("the store is of another array"), "{said}");
}
