//! The scripts of job arrays as Slurm runs them, without Slurm.

use super::{Desk, Run, raw_hash, repository};
use std::process::Command;

const LINE: &str = "sobol --count 5000000 --dims 2 --device cpu";

/// Four cells.
const STUDY: &str = "--integrand x-squared --integrand genz-gaussian:d=3 --sampler random,halton \
                     --max-count 256 --replicates 4 --device cpu";

fn task(desk: &Desk, script: &str, line: &str, id: Option<&str>, shards: &str) -> Run {
    let mut command = Command::new("bash");
    command
        .arg(repository("examples").join(script))
        .args(line.split_whitespace())
        .current_dir(desk.path(""))
        .env("CORPUT", env!("CARGO_BIN_EXE_corput"))
        .env("CORPUT_SHARDS", shards)
        .env_remove("SLURM_ARRAY_TASK_ID");
    if let Some(id) = id {
        command.env("SLURM_ARRAY_TASK_ID", id);
    }
    Run::of(script, command)
}

#[test]
fn tasks_of_the_array_fill_the_store() {
    let desk = Desk::new();
    let line = format!("{LINE} --out s.zarr");
    let task = |id, shards| task(&desk, "slurm_generate.sh", &line, id, shards);
    task(None, "3").tells(1, &["SLURM_ARRAY_TASK_ID", "--array=0-7"]);
    task(Some("3"), "3").expect(2, &["the last of 3 is 2/3"]);
    assert!(!desk.path("s.zarr").exists());
    for id in ["2", "0"] {
        task(Some(id), "3").expect(0, &[]);
    }
    let lacking = desk.run("merge s.zarr --shards 3");
    lacking.tells(1, &["chunk 1 is missing: --shard 1/3 makes it again"]);
    // A part of the array that is run later, and a task that is run twice.
    task(Some("1"), "3").expect(0, &[]);
    task(Some("2"), "3").expect(0, &["1 of 1 chunks were there already"]);
    assert_eq!(desk.merged("s.zarr"), raw_hash(&desk, LINE));
}

#[test]
fn tasks_of_the_array_measure_the_study() {
    let desk = Desk::new();
    let line = format!("{STUDY} --report study");
    let task = |id, shards| task(&desk, "slurm_converge.sh", &line, id, shards);
    task(None, "3").tells(1, &["SLURM_ARRAY_TASK_ID", "--array=0-7"]);
    task(Some("3"), "3").expect(2, &["the last of 3 is 2/3"]);
    assert!(!desk.path("study").exists());
    task(Some("2"), "3").tells(0, &["shard 2/3 has 1 cell:", "the study lacks 3 cells:"]);
    task(Some("0"), "3").tells(0, &["the study lacks 1 cell:"]);
    desk.run("merge study --shards 3").tells(
        1,
        &[
            "1 of 4 cells are missing:",
            "x-squared, halton: --shard 1/3 measures it",
        ],
    );
    // A part of the array that is run later, and a task that is run twice.
    task(Some("1"), "3").tells(0, &["corput merge study writes its report"]);
    task(Some("2"), "3").tells(0, &["genz-gaussian:d=3, random: kept"]);
    desk.run("merge study")
        .expect(0, &["open study/report.html"]);
}
