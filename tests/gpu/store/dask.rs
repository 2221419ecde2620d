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

#[test]
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
    let line = format!("--workers 2 --shards 3 {points} -- {more}");
    let (code, said) = example(&python, &desk, &line);
    assert_eq!(code, Some(0), "{said}");
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
