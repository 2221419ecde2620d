//! The job array script as Slurm runs it, without Slurm.

use super::{Desk, Run, raw_hash, repository};
use std::process::Command;

const LINE: &str = "sobol --count 5000000 --dims 2 --device cpu";

fn task(desk: &Desk, id: Option<&str>, shards: &str) -> Run {
    let mut command = Command::new("bash");
    command
        .arg(repository("examples/slurm_generate.sh"))
        .args(LINE.split_whitespace())
        .args(["--out", "s.zarr"])
        .current_dir(desk.path(""))
        .env("CORPUT", env!("CARGO_BIN_EXE_corput"))
        .env("CORPUT_SHARDS", shards)
        .env_remove("SLURM_ARRAY_TASK_ID");
    if let Some(id) = id {
        command.env("SLURM_ARRAY_TASK_ID", id);
    }
    Run::of("slurm_generate.sh", command)
}

#[test]
fn tasks_of_the_array_fill_the_store() {
    let desk = Desk::new();
    task(&desk, None, "3").tells(1, &["SLURM_ARRAY_TASK_ID", "--array=0-7"]);
    task(&desk, Some("3"), "3").expect(2, &["the last of 3 is 2/3"]);
    assert!(!desk.path("s.zarr").exists());
    for id in ["2", "0"] {
        task(&desk, Some(id), "3").expect(0, &[]);
    }
    let lacking = desk.run("merge s.zarr --shards 3");
    lacking.tells(1, &["chunk 1 is missing: --shard 1/3 makes it again"]);
    // A part of the array that is run later, and a task that is run twice.
    task(&desk, Some("1"), "3").expect(0, &[]);
    task(&desk, Some("2"), "3").expect(0, &["1 of 1 chunks were there already"]);
    assert_eq!(desk.merged("s.zarr"), raw_hash(&desk, LINE));
}
