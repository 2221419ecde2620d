//! The file of a shard.

use super::description::{describe, difference, restore};
use crate::catalog::Shard;
use crate::converge::kept::{Kept, text, unusable};
use crate::converge::study::Study;
use crate::report::{create_folder, try_lock};
use crate::{Error, Result};
use serde_json::{Value, json};
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Name and version of the form of the first line.
const SCHEMA: &str = "corput-cells/1";

/// The first line of a file, read.
pub(super) struct Head {
    pub study: Value,
    pub command: String,
}

impl Head {
    /// Of the text of a file; none of one whose first line is not complete.
    ///
    /// # Errors
    /// A sentence on a line that is none of a shard's.
    pub fn of(text: &str) -> Option<Result<Self, String>> {
        let (line, _) = text.split_once('\n')?;
        let value: Value = serde_json::from_str(line).unwrap_or_default();
        Some(match (&value["schema"], value["command"].as_str()) {
            (schema, Some(command)) if schema == SCHEMA => Ok(Self {
                command: command.to_owned(),
                study: value["study"].clone(),
            }),
            _ => Err(format!("its first line is none of \"{SCHEMA}\"")),
        })
    }
}

/// Opens the file of a shard in a folder, which is made if it is not there, for [`run_shard`]. It
/// is locked until it is dropped. `command` is what a report says made the cells, `device` what
/// measures those that are added; `fresh` discards what an earlier run kept.
///
/// [`run_shard`]: super::run_shard
///
/// # Errors
/// [`Error::Output`] where it cannot be read or written, is being written by another run, or has
/// cells of another study; [`Error::Arguments`] for a study that no document can describe.
pub fn open_shard(
    folder: &Path,
    study: &Study,
    shard: Shard,
    [command, device]: [&str; 2],
    fresh: bool,
) -> Result<Kept> {
    let described = describe(study);
    restore(&described)?;
    create_folder(folder, "--report")?;
    let path = path_of(folder, shard);
    let opened = OpenOptions::new()
        .read(true)
        .append(true)
        .create(true)
        .open(&path);
    let mut file = opened.map_err(|error| unusable(&path, &error))?;
    let refused = |problem: String, remedy: &str| Error::Output {
        path: path.clone(),
        problem,
        remedy: remedy.to_owned(),
    };
    if !try_lock(&file).map_err(|error| unusable(&path, &error))? {
        let remedy = "wait for that run, or give another shard";
        return Err(refused("another run is writing this file".into(), remedy));
    }
    if fresh {
        file.set_len(0).map_err(|error| unusable(&path, &error))?;
    }
    let mut found = text(&path, &mut file)?;
    match Head::of(&found) {
        None => {
            let head = json!({
                "schema": SCHEMA,
                "shard": shard.to_string(),
                "command": command,
                "study": described,
            });
            begin(&mut file, &head).map_err(|error| unusable(&path, &error))?;
            found.clear();
        }
        Some(Err(problem)) => return Err(refused(problem, "move it, or give another folder")),
        Some(Ok(head)) => {
            if let Some(difference) = difference(&head.study, &described) {
                return Err(refused(
                    format!("it has cells of another study: {difference}"),
                    "give the arguments of that study or another folder, or --fresh to discard what it kept",
                ));
            }
        }
    }
    Kept::of(&path, file, &found, Some(device.to_owned()))
}

/// Writes the first line. One that a killed run has left half is no line.
fn begin(file: &mut File, head: &Value) -> std::io::Result<()> {
    file.set_len(0)?;
    file.write_all(format!("{head}\n").as_bytes())?;
    file.sync_all()
}

fn path_of(folder: &Path, shard: Shard) -> PathBuf {
    let (index, count) = shard.parts();
    folder.join(format!("cells-{index}-of-{count}.jsonl"))
}

/// The files of shards in a folder, by how many shards there are, and by their numbers.
pub(super) fn files(folder: &Path) -> std::io::Result<Vec<(Shard, PathBuf)>> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let shard = path.file_name().and_then(|name| shard(name.to_str()?));
        // A name that is written otherwise is none of ours.
        found.extend(
            shard
                .map(|shard| (shard, path_of(folder, shard)))
                .filter(|(_, own)| *own == path),
        );
    }
    found.sort_by_key(|(shard, _)| {
        let (index, count) = shard.parts();
        (count, index)
    });
    Ok(found)
}

fn shard(name: &str) -> Option<Shard> {
    let parts = name.strip_prefix("cells-")?.strip_suffix(".jsonl")?;
    let (index, count) = parts.split_once("-of-")?;
    Shard::new(index.parse().ok()?, count.parse().ok()?).ok()
}
