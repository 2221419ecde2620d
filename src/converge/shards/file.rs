//! The file of a shard.

use super::description::{describe, difference, restore};
use crate::catalog::Shard;
use crate::converge::kept::{Kept, text, unread, unusable};
use crate::converge::study::Study;
use crate::report::{create_folder, try_lock};
use crate::{Error, Result};
use serde_json::{Value, json};
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Read, Seek, Write};
use std::path::{Path, PathBuf};

/// Name and version of the form of the first line.
const SCHEMA: &str = "corput-cells/1";

/// Bytes of a first line at most that another shard's file is asked for: those of integrands by
/// the ten thousand.
const HEAD: u64 = 64 << 20;

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
/// [`Error::Output`] where it cannot be read or written, is being written by another run, has
/// cells of another study, or is no such file; [`Error::Document`] where another shard's file in
/// the folder is of another study or is none, since the two would never merge;
/// [`Error::Arguments`] for a study that no document can describe.
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
    check_others(folder, &path, &described)?;
    // Two runs that no lock keeps apart, on file systems without, append line after line. Windows
    // lets such a file not be cut.
    let opened = OpenOptions::new()
        .read(true)
        .write(true)
        .append(cfg!(unix))
        .create(true)
        .truncate(false)
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
    let mut found = text(&mut file).map_err(|problem| unread(&path, problem))?;
    match Head::of(&found) {
        None => {
            let head = json!({
                "schema": SCHEMA,
                "shard": shard.to_string(),
                "command": command,
                "study": described,
            });
            let head = format!("{head}\n");
            // One that a killed run has left half is no line; anything else is not ours to cut.
            if !head.starts_with(&found) {
                return Err(refused(
                    "its first line has no end, and was not begun by this command".into(),
                    "move it, or give another folder, or --fresh to discard it",
                ));
            }
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

/// Refuses a folder where another shard has begun another study. Of two that begin at once
/// neither may see the other: what they keep is compared again when it is merged.
fn check_others(folder: &Path, own: &Path, study: &Value) -> Result<()> {
    let found = files(folder).map_err(|error| unusable(folder, &error))?;
    for (_, path) in found.into_iter().filter(|(_, path)| path != own) {
        // One that only its writer may read now is read when all are merged.
        let Ok(line) = File::open(&path).and_then(first_line) else {
            continue;
        };
        let problem = match Head::of(&line) {
            None => continue,
            Some(Err(problem)) => problem,
            Some(Ok(head)) => match difference(&head.study, study) {
                None => continue,
                Some(difference) => format!("it has cells of another study: {difference}"),
            },
        };
        return Err(Error::Document {
            path,
            problem,
            remedy: "give the arguments of that study or another folder, or move that file elsewhere",
        });
    }
    Ok(())
}

/// With its end, where it has one.
fn first_line(file: File) -> std::io::Result<String> {
    let mut line = Vec::new();
    BufReader::new(file.take(HEAD)).read_until(b'\n', &mut line)?;
    Ok(String::from_utf8_lossy(&line).into_owned())
}

/// Writes the first line.
fn begin(file: &mut File, head: &str) -> std::io::Result<()> {
    file.set_len(0)?;
    file.rewind()?;
    file.write_all(head.as_bytes())?;
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
