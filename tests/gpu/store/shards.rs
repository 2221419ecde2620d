//! The same store by one process or by several, in any order, on any device, and after a kill.

use super::{Desk, Run, raw_hash};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Three chunks of 2^21 points, the last not full.
const LINE: &str = "sobol --count 5000000 --dims 2 --scramble shift --seed 4 --device cpu";

/// The files of a store without the number of shards that its zarr.json notes, and that number.
fn parts(desk: &Desk, store: &str) -> (BTreeMap<PathBuf, Vec<u8>>, Option<u64>) {
    let mut files = desk.tree(store);
    let text = files.get_mut(Path::new("zarr.json")).expect("metadata");
    let mut document: Value = serde_json::from_slice(text).expect("JSON");
    let attributes = document["attributes"].as_object_mut().expect("attributes");
    let noted = attributes.remove("corput_shards");
    *text = document.to_string().into_bytes();
    (
        files,
        noted.map(|shards| shards.as_u64().expect("a number")),
    )
}

#[test]
fn shards_in_any_order_are_the_whole() {
    let desk = Desk::new();
    desk.say(&format!("generate {LINE} --out whole.zarr"));
    let hash = desk.merged("whole.zarr");
    assert_eq!(hash, raw_hash(&desk, LINE));
    let (whole, noted) = parts(&desk, "whole.zarr");
    // zarr.json; three chunks, three records, and that of the array.
    assert_eq!(whole.len(), 1 + 3 + 3 + 1, "{:?}", whole.keys());
    assert_eq!(noted, None);
    for order in [&[0, 1][..], &[1, 0], &[2, 0, 1], &[4, 1, 3, 0, 2]] {
        let store = format!("{}.zarr", order.len() * 10 + order[0]);
        let count = order.len();
        for index in order {
            let run = desk.run(&format!(
                "generate {LINE} --out {store} --shard {index}/{count}"
            ));
            // Of five shards, two have none of three chunks.
            let empty = count == 5 && [0, 2].contains(index);
            run.expect(
                0,
                if empty {
                    &["is empty", "3 chunks"]
                } else {
                    &[]
                },
            );
            assert_eq!(run.stderr.is_empty(), !empty, "{}", run.stderr);
        }
        assert_eq!(desk.merged(&store), hash);
        let (files, noted) = parts(&desk, &store);
        assert!(files == whole, "{order:?}");
        assert_eq!(noted, Some(count as u64));
        std::fs::remove_dir_all(desk.path(&store)).expect("removed");
    }
}

#[test]
fn a_device_makes_the_same_store() {
    if super::skips() {
        return;
    }
    let desk = Desk::new();
    let line = "generate sobol --count 2100000 --dims 2 --scramble owen-hash --seed 4";
    desk.say(&format!("{line} --device cpu --out cpu.zarr"));
    // One shard each of the device and the CPU.
    desk.say(&format!(
        "{line} --device llvmpipe --out both.zarr --shard 0/2"
    ));
    desk.say(&format!("{line} --device cpu --out both.zarr --shard 1/2"));
    assert_eq!(desk.merged("cpu.zarr"), desk.merged("both.zarr"));
    assert!(parts(&desk, "cpu.zarr").0 == parts(&desk, "both.zarr").0);
}

/// A worker of a shard, ended at the latest with the test.
pub struct Worker(Option<Child>);

impl Worker {
    pub fn start(desk: &Desk, line: &str) -> Self {
        let mut command = desk.command(line);
        let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
        Self(Some(command.spawn().expect("corput starts")))
    }

    /// Waits until there is a file.
    fn wait_for(&self, path: &Path) {
        self.wait_until(|| path.exists());
    }

    /// Waits until it has come so far.
    pub fn wait_until(&self, done: impl Fn() -> bool) {
        let begun = Instant::now();
        while !done() {
            assert!(begun.elapsed() < Duration::from_secs(60), "it makes none");
            sleep(Duration::from_millis(1));
        }
    }

    #[cfg(unix)]
    fn signal(&self, name: &str) {
        let id = self.0.as_ref().expect("it runs").id().to_string();
        let sent = Command::new("kill").args(["-s", name, &id]).status();
        assert!(sent.expect("kill runs").success());
    }

    /// The same of one that does not take as long as this.
    pub fn end_within(mut self, time: Duration, line: &str) -> Run {
        let begun = Instant::now();
        let child = self.0.as_mut().expect("it runs");
        while child.try_wait().expect("it is known").is_none() {
            assert!(begun.elapsed() < time, "`{line}` takes more than {time:?}");
            sleep(Duration::from_millis(5));
        }
        self.end(line)
    }

    pub fn end(mut self, line: &str) -> Run {
        let child = self.0.take().expect("it runs");
        Run::left(line, child.wait_with_output().expect("it ends"))
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        if let Some(child) = &mut self.0 {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

#[test]
fn a_killed_worker_is_started_again() {
    let desk = Desk::new();
    // Six chunks of Owen's nested scrambling, which takes long.
    let line = "sobol --count 12582912 --dims 2 --scramble owen --seed 9 --device cpu";
    let shard = |index: u32| format!("generate {line} --out s.zarr --shard {index}/2");
    let killed = Worker::start(&desk, &shard(0));
    let other = Worker::start(&desk, &shard(1));
    killed.wait_for(&desk.path("s.zarr/c/0/0"));
    // With SIGKILL.
    drop(killed);
    assert!(
        !desk.path("s.zarr/c/2/0").exists(),
        "it was killed too late to show anything"
    );
    other.end(&shard(1)).expect(0, &[]);
    let lacking = desk.run("merge s.zarr --shards 2");
    lacking.tells(1, &["--shard 0/2 makes", "chunk"]);
    assert!(!lacking.text().contains("1/2"), "{}", lacking.text());
    // It may say that it found a chunk, if it came to be recorded.
    desk.ask(&shard(0));
    let hash = desk.merged("s.zarr");
    assert_eq!(hash, raw_hash(&desk, line));
    // What the killed worker had begun is gone with the merge.
    let names = desk.tree("s.zarr").into_keys();
    let partial = names.filter(|path| path.to_string_lossy().ends_with(".partial"));
    assert_eq!(partial.count(), 0);
}

#[test]
#[cfg(unix)]
fn an_interrupted_shard_says_that_it_goes_on() {
    let desk = Desk::new();
    let line = "generate sobol --count 16777216 --dims 2 --scramble owen --device cpu --out s.zarr";
    let worker = Worker::start(&desk, line);
    worker.wait_for(&desk.path("s.zarr/c/0/0"));
    worker.signal("INT");
    let run = worker.end(line);
    run.expect(4, &["interrupted after", "of 8", "s.zarr keeps", "goes on"]);
    let left = desk.tree("s.zarr").into_keys();
    let partial = |path: &std::path::PathBuf| path.to_string_lossy().ends_with(".partial");
    assert_eq!(left.filter(partial).count(), 0);
}

#[test]
fn shards_at_once_race_for_the_same_files() {
    let desk = Desk::new();
    let line = "generate vdc --count 9000000 --device cpu --out s.zarr";
    // All make all of the three chunks, and two would have zarr.json say so.
    let lines = ["", " --shard 0/1", "", " --shard 0/1"].map(|shard| format!("{line}{shard}"));
    let workers: Vec<_> = lines
        .iter()
        .map(|line| Worker::start(&desk, line))
        .collect();
    for (worker, line) in workers.into_iter().zip(&lines) {
        worker.end(line).expect(0, &[]);
    }
    assert!([None, Some(1)].contains(&parts(&desk, "s.zarr").1));
    let hash = desk.merged("s.zarr");
    assert_eq!(hash, raw_hash(&desk, "vdc --count 9000000 --device cpu"));
}
