//! `corput generate` into Zarr stores, by shards, and `corput merge`, as their user meets them.

#[path = "store/damage.rs"]
mod damage;
#[cfg(unix)]
#[path = "store/dask.rs"]
mod dask;
mod desk;
#[path = "store/estimates.rs"]
mod estimates;
#[path = "store/python.rs"]
mod python;
#[path = "store/refused.rs"]
mod refused;
#[path = "store/shards.rs"]
mod shards;
#[path = "store/shares.rs"]
mod shares;
#[cfg(unix)]
#[path = "store/slurm.rs"]
mod slurm;
#[path = "store/spec.rs"]
mod spec;
#[path = "store/study.rs"]
mod study;
mod support;
#[path = "store/verify.rs"]
mod verify;

use desk::{Desk, Run, repository};
use shards::Worker;
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use support::skips;

impl Desk {
    /// The hash that a merge of a complete store ends with.
    fn merged(&self, store: &str) -> String {
        let said = self.say(&format!("merge {store}"));
        let hash = said.lines().find_map(|line| line.strip_prefix("sha256 "));
        hash.unwrap_or_else(|| panic!("no hash: {said}")).to_owned()
    }

    /// Every file below a folder, with its bytes.
    fn tree(&self, name: &str) -> BTreeMap<PathBuf, Vec<u8>> {
        let mut found = BTreeMap::new();
        let mut folders = vec![self.path(name)];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(&folder).expect("a folder") {
                let path = entry.expect("an entry").path();
                if path.is_dir() {
                    folders.push(path);
                } else {
                    let name = path.strip_prefix(self.path(name)).expect("below it");
                    found.insert(name.to_owned(), fs::read(&path).expect("a file"));
                }
            }
        }
        found
    }
}

/// The SHA-256 of a raw file of the same points, which its sidecar has.
fn raw_hash(desk: &Desk, arguments: &str) -> String {
    desk.say(&format!("generate {arguments} --out points.raw"));
    let text = fs::read_to_string(desk.path("points.raw.json")).expect("a sidecar");
    let sidecar: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    sidecar["sha256"].as_str().expect("a hash").to_owned()
}
