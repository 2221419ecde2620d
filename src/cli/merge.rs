//! `corput merge`: a store that several machines have filled, a study in shards, or estimates of
//! several ranges.

mod estimates;
mod study;

use super::args::MergeArgs;
use super::{print, progress};
use corput::catalog::Shard;
use corput::converge::Gathered;
use corput::report::zarr::{Fault, Store, Survey};
use corput::{Error, Result};
use serde_json::{Value, json};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Faults that are named without `--json`.
const NAMED: usize = 20;

pub fn run(args: &MergeArgs) -> anyhow::Result<()> {
    match args.paths.as_slice() {
        [path] if Gathered::is_in(path) => study::run(path, args),
        [path] if path.is_dir() => store(path, args),
        paths => {
            refuse(paths.iter().find(|path| path.is_dir()), args.shards)?;
            estimates::run(paths, args.json)
        }
    }
}

/// Refuses a store among documents, and what only stores have.
fn refuse(store: Option<&PathBuf>, shards: Option<u64>) -> Result<()> {
    let refused = |asked: String, limit: &str, remedy: &str| {
        Err(Error::Arguments {
            asked,
            limit: limit.to_owned(),
            remedy: remedy.to_owned(),
        })
    };
    match (store, shards) {
        (Some(path), _) => refused(
            format!("merge the folder {} with others", path.display()),
            "a store, or a study in shards, is one folder, into which all machines write",
            "give it alone",
        ),
        (None, Some(_)) => refused(
            "--shards with estimates".to_owned(),
            "only stores and studies lack shards",
            "drop it",
        ),
        (None, None) => Ok(()),
    }
}

fn store(path: &Path, args: &MergeArgs) -> anyhow::Result<()> {
    let store = Store::open(path)?;
    // Of a store that does not say how it was cut, each chunk is a shard.
    let cut = store.shards().unwrap_or(store.chunks().max(1));
    let shards = args.shards.unwrap_or(cut);
    Shard::new(0, shards)?;
    let bar = progress::chunks(store.chunks());
    let survey = store.survey(&mut |done| {
        bar.set_position(done);
        Ok(())
    })?;
    bar.finish_and_clear();
    let lacks: Vec<Lack> = survey
        .faults
        .iter()
        .map(|(chunks, fault)| Lack::new(&store, chunks, fault, shards))
        .collect::<Result<_>>()?;
    if args.json {
        let document = document(&store, path, &survey, shards, &lacks);
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        print(&text(&store, path, &survey, &lacks));
    }
    match survey.lacking() {
        0 => Ok(()),
        lacking => Err(Error::Incomplete {
            path: path.to_owned(),
            lacking,
            total: store.chunks(),
        }
        .into()),
    }
}

/// Chunks that are not as they should be, and the shards that make them.
struct Lack<'a> {
    chunks: &'a Range<u64>,
    fault: &'a Fault,
    first: Shard,
    last: Shard,
}

impl<'a> Lack<'a> {
    fn new(store: &Store, chunks: &'a Range<u64>, fault: &'a Fault, shards: u64) -> Result<Self> {
        Ok(Self {
            chunks,
            fault,
            first: Shard::holding(chunks.start, store.chunks(), shards)?,
            last: Shard::holding(chunks.end - 1, store.chunks(), shards)?,
        })
    }

    fn text(&self) -> String {
        let Self { fault, first, .. } = self;
        let last = self.chunks.end - 1;
        let chunks = match self.chunks.start {
            one if one == last => format!("chunk {one} is {fault}"),
            from => format!("chunks {from} to {last} are {fault}"),
        };
        match self.last {
            same if same == *first => format!("{chunks}: --shard {first} makes it again"),
            last => format!("{chunks}: --shard {first} to {last} make them again"),
        }
    }

    fn document(&self) -> Value {
        json!({
            "first_chunk": self.chunks.start,
            "last_chunk": self.chunks.end - 1,
            "fault": self.fault.name(),
            "first_shard": self.first.to_string(),
            "last_shard": self.last.to_string(),
        })
    }
}

fn text(store: &Store, path: &Path, survey: &Survey, lacks: &[Lack]) -> String {
    let layout = store.layout();
    let mut lines = vec![format!(
        "{}: {} of {} chunks whole, {} rows of {} {}",
        path.display(),
        store.chunks() - survey.lacking(),
        store.chunks(),
        layout.rows,
        layout.columns,
        layout.element.descr()
    )];
    lines.extend(lacks.iter().take(NAMED).map(Lack::text));
    if lacks.len() > NAMED {
        let more = lacks.len() - NAMED;
        lines.push(format!("and {more} more, which --json names"));
    }
    if lacks.is_empty() {
        lines.push(format!("sha256 {}", survey.sha256));
    }
    lines.join("\n")
}

fn document(store: &Store, path: &Path, survey: &Survey, shards: u64, lacks: &[Lack]) -> Value {
    let layout = store.layout();
    let complete = lacks.is_empty();
    json!({
        "store": path,
        "made_by": store.origin(),
        "shape": [layout.rows, layout.columns],
        "type": layout.element.descr(),
        "chunks": store.chunks(),
        "shards": shards,
        "complete": complete,
        "sha256": complete.then_some(&survey.sha256),
        "faults": lacks.iter().map(Lack::document).collect::<Vec<_>>(),
    })
}
