//! The examples of a Dask cluster, by workers of this machine.

use super::python::{python, within};
use super::support::validates;
use super::{Desk, raw_hash, repository, skips};
use serde_json::{Value, json};
use std::fs::{self, File, read_to_string};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use std::time::Duration;

/// A Python with what the examples need, made once for all tests. Where there is none, that is said aloud.
fn dask() -> Option<&'static Path> {
    static PYTHON: OnceLock<Option<PathBuf>> = OnceLock::new();
    let made = PYTHON.get_or_init(|| {
        let packages = ["zarr==3.*", "dask", "distributed"];
        let check = "import dask, distributed, zarr; assert zarr.__version__ >= '3'";
        python("dask-python", &packages, check)
    });
    if made.is_none() {
        eprintln!("SKIPPED: Dask could not be installed; the examples were not run");
    }
    made.as_deref()
}

/// Runs Python in the folder, and returns its exit code and all that it said.
fn run(python: &Path, desk: &Desk, arguments: &[&str]) -> (Option<i32>, String) {
    let said = desk.path("said");
    let file = File::create(&said).expect("a file");
    let mut command = Command::new(python);
    command
        .args(arguments)
        .current_dir(desk.path(""))
        .env_remove("CORPUT_DEVICE")
        // The repository stays as it is.
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .env("CORPUT_VALIDATION", if validates() { "1" } else { "0" })
        .stdout(file.try_clone().expect("a file"))
        .stderr(file);
    let child = command.spawn().expect("python runs");
    let code = within(Duration::from_secs(300), child);
    (code, read_to_string(said).expect("UTF-8"))
}

/// Runs an example with a corput in the folder.
fn example(python: &Path, desk: &Desk, name: &str, arguments: &str) -> (Option<i32>, String) {
    let script = repository("examples").join(name);
    let mut all = vec![script.to_str().expect("UTF-8"), "--corput", "corput"];
    all.extend(arguments.split_whitespace());
    run(python, desk, &all)
}

/// Puts a corput into the folder that writes its arguments to `calls`. The first call of shard 2 is
/// killed in the middle, together with the worker that made it, by `kill`, for which its process is
/// `$!`; the second fails. The shards before it are of one worker each.
fn faulty(desk: &Desk, kill: &str) {
    let corput = env!("CARGO_BIN_EXE_corput");
    script(
        desk,
        &format!(
            "echo \"$*\" >> calls\n\
             case \"$*\" in *' --shard 2/'*)\n\
               if mkdir died 2>/dev/null; then '{corput}' \"$@\" & {kill}; exit; fi\n\
               if mkdir failed 2>/dev/null; then echo 'a fault of the test' >&2; exit 4; fi ;;\n\
             esac\n\
             exec '{corput}' \"$@\"\n"
        ),
    );
}

/// Puts a shell script into the folder as its corput.
fn script(desk: &Desk, text: &str) {
    use std::os::unix::fs::PermissionsExt;
    let path = desk.path("corput");
    fs::write(&path, format!("#!/bin/sh\n{text}")).expect("a script");
    fs::set_permissions(&path, PermissionsExt::from_mode(0o755)).expect("it may run");
}

/// The device of the tests; the CPU where devices are not tested.
fn device() -> &'static str {
    if skips() { "cpu" } else { "llvmpipe" }
}

/// Checks that both faults happened, that all shards were made, and that shards ran on a Vulkan device
/// and on the CPU.
fn check_calls(desk: &Desk, said: &str, shards: usize) {
    assert!(desk.path("died").is_dir() && desk.path("failed").is_dir());
    let calls = read_to_string(desk.path("calls")).expect("UTF-8");
    for shard in 0..shards {
        let told = format!("shard {shard}/{shards} by worker ");
        assert!(said.contains(&told), "{said}");
        let made = calls
            .matches(&format!(" --shard {shard}/{shards} "))
            .count();
        assert!(made >= if shard == 2 { 3 } else { 1 }, "{calls}");
    }
    for device in [device(), "cpu"] {
        let on = format!("/{shards} --device {device}");
        assert!(calls.lines().any(|call| call.ends_with(&on)), "{calls}");
    }
}

/// One worker has a Vulkan device and one the CPU. One dies in the middle of a shard, and one
/// task fails: both are tried again, and the store is what a single run makes.
#[test]
fn workers_fill_a_store() {
    let Some(python) = dask() else { return };
    let desk = Desk::new();
    // Once a chunk lies beside its place, half-written.
    faulty(
        &desk,
        "until ls -A s.zarr/corput | grep -q partial || ! kill -0 $!; do :; done; kill -9 $! $PPID",
    );
    let points = "--count 5000000 --dims 2";
    let more = "--scramble owen-hash --seed 3";
    let devices = format!("--device {} --device cpu", device());
    let line = format!("--workers 2 --shards 3 {devices} {points} --out s.zarr -- {more}");
    let (code, said) = example(python, &desk, "dask_generate.py", &line);
    assert_eq!(code, Some(0), "{said}");
    check_calls(&desk, &said, 3);
    let hash = raw_hash(&desk, &format!("sobol {points} {more} --device cpu"));
    for words in [
        "s.zarr: (5000000, 2) float32, chunks of (2097152, 2)",
        &format!("store       {hash}\nsingle run  {hash}\nequal"),
    ] {
        assert!(said.contains(words), "{said}");
    }
    assert_eq!(desk.merged("s.zarr"), hash);
    // What corput refuses is not tried again, and ends the example with what corput said.
    let line = "--workers 1 --shards 1 --count 5000000 --dims 3 --out s.zarr";
    let (code, said) = example(python, &desk, "dask_generate.py", line);
    assert_eq!(code, Some(1), "{said}");
    assert!(
        said.contains("shard 0/1 by worker 0 on device ")
            && said.contains("the store is of another array")
            && !said.contains("Traceback"),
        "{said}"
    );
    let calls = read_to_string(desk.path("calls")).expect("UTF-8");
    assert_eq!(calls.matches("--dims 3").count(), 1, "{calls}");
}

/// The same of a study, where the process of the worker that dies lives on, and holds its cells for
/// a while.
#[test]
fn workers_measure_a_study() {
    let Some(python) = dask() else { return };
    let desk = Desk::new();
    faulty(
        &desk,
        "until [ -s study/cells-2-of-4.jsonl ] || [ ! -e corput ]; do sleep 0.01; done; \
         kill -STOP $!; kill -9 $PPID; sleep 2; kill -CONT $!; wait",
    );
    let devices = format!("--device {} --device cpu", device());
    let study = "--integrand x-squared --integrand genz-gaussian:d=3 --sampler random,halton \
                 --max-count 1024 --replicates 4";
    let line = format!("--workers 2 --shards 4 {devices} --out study -- {study}");
    let (code, said) = example(python, &desk, "dask_converge.py", &line);
    assert_eq!(code, Some(0), "{said}");
    check_calls(&desk, &said, 4);
    let line = |name: &str| {
        let found = said.lines().find_map(|line| line.strip_prefix(name));
        found.unwrap_or_else(|| panic!("no {name}: {said}"))
    };
    assert_eq!(line("study       "), line("single run  "));
    assert!(said.contains("\nequal\n"), "{said}");
    let results: Value =
        serde_json::from_slice(&desk.bytes("study/results.json")).expect("a document");
    let series = results["series"].as_array().expect("series");
    assert_eq!((series.len(), &results["shards"]), (4, &json!(4)));
    for device in [device(), "cpu (the reference"] {
        let has = |one: &Value| one["device"].as_str().expect("a name").contains(device);
        assert!(series.iter().any(has), "{results}");
    }
    assert!(desk.path("study/report.html").exists());
}

/// A device as `corput devices --json` lists it, as far as it matters here.
fn listed(index: u32, name: &str, kind: &str, probe: &Value) -> Value {
    json!({ "index": index, "name": name, "kind": kind, "probe": probe })
}

/// GPUs before drivers of the CPU, discrete ones first, and nothing that is not exact; for times
/// those of one name.
#[test]
fn workers_hold_what_there_is() {
    let Some(python) = dask() else { return };
    let desk = Desk::new();
    let code = "import sys; sys.path.insert(0, sys.argv[1]); import cluster; \
                print(*[cluster.devices(sys.argv[2], alike) for alike in (False, True)])";
    let examples = repository("examples");
    let held = |corput: &str| {
        let arguments = ["-c", code, examples.to_str().expect("UTF-8"), corput];
        let (code, said) = run(python, &desk, &arguments);
        assert_eq!(code, Some(0), "{said}");
        said
    };
    // Sums and products in floats, which tier F promises besides, are in no kernel of points.
    let exact = json!({ "tier_i": true, "tier_f": false });
    let refused = json!({ "tier_i": false, "tier_f": false });
    let broken = json!({ "error": "it hangs" });
    let drivers = [
        listed(0, "llvmpipe", "cpu", &exact),
        listed(1, "SwiftShader", "cpu", &exact),
    ];
    let mut all = drivers.to_vec();
    all.extend([
        listed(2, "small", "integrated", &exact),
        listed(3, "large", "discrete", &exact),
        listed(4, "large", "discrete", &exact),
        listed(5, "old", "discrete", &refused),
        listed(6, "older", "discrete", &broken),
    ]);
    for (devices, wanted) in [
        (&all[..], "['3', '4', '2'] ['3', '4']\n"),
        (&drivers[..], "['0', 'cpu'] ['0']\n"),
        (&all[5..], "['cpu'] ['cpu']\n"),
    ] {
        let document = json!({ "devices": devices }).to_string();
        fs::write(desk.path("listed"), document).expect("a list");
        script(&desk, "exec cat listed");
        assert_eq!(held("./corput"), wanted);
    }
    script(&desk, "exit 3");
    assert_eq!(held("./corput"), "['cpu'] ['cpu']\n");
    if !skips() {
        let found = held(env!("CARGO_BIN_EXE_corput"));
        assert!(!found.starts_with("['cpu'"), "{found}");
    }
}
