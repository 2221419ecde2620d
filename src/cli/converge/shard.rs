//! `corput converge --shard`: some cells of a study, kept for `corput merge`.

use super::{engine, outdated, paused, watched};
use crate::cli::args::ConvergeArgs;
use crate::cli::{host, print};
use corput::Result;
use corput::catalog::Shard;
use corput::converge::{self, Done, Gathered, Lacking, Study};
use serde_json::{Value, json};
use std::path::Path;

pub fn run(args: &ConvergeArgs, study: &Study, shard: Shard, folder: &Path) -> anyhow::Result<()> {
    converge::check_folder(folder)?;
    let (engine, device, instance) = engine(args)?;
    let command = host::command();
    let mut kept = converge::open_shard(folder, study, shard, [&command, &device], args.fresh)?;
    let all = converge::item_count(study)?;
    let own = (0..all).filter(|item| shard.is_dealt(*item)).count();
    let done = watched(own as u64, |watch| {
        converge::run_shard(&engine, study, shard, &device, &mut kept, watch)
    });
    if let Some(line) = outdated(&kept) {
        eprintln!("corput: {line}");
    }
    let done = done.map_err(|error| paused(error, kept.path().to_owned(), args.fresh))?;
    if let Some(instance) = instance {
        host::validated(&instance)?;
    }
    if done.is_empty() {
        eprintln!(
            "corput: shard {shard} is empty: the study has {}, which other shards measure",
            cells(all as usize)
        );
    }
    let missing = missing(folder);
    if let Err(error) = &missing {
        // What this shard kept is whole all the same.
        eprintln!("corput: warning: the shards do not fit together yet: {error}");
    }
    let missing = missing.ok();
    if args.json {
        let document = document(shard, &done, missing.as_deref());
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        print(&text(shard, &done, missing.as_deref(), folder));
    }
    Ok(())
}

/// What no shard has measured yet.
fn missing(folder: &Path) -> Result<Vec<Lacking>> {
    Gathered::open(folder)?.lacking(None)
}

fn text(shard: Shard, done: &[Done], missing: Option<&[Lacking]>, folder: &Path) -> String {
    let mut lines = vec![format!("shard {shard} has {}:", cells(done.len()))];
    lines.extend(done.iter().map(|one| {
        let how = if one.anew { "measured" } else { "kept" };
        format!("  {}: {how}", one.cell)
    }));
    match missing {
        None => {}
        Some([]) => lines.push(format!(
            "the study is complete: corput merge {} writes its report",
            folder.display()
        )),
        Some(missing) => {
            lines.push(format!("the study lacks {}:", cells(missing.len())));
            lines.extend(missing.iter().map(lacking));
        }
    }
    lines.join("\n")
}

fn cells(many: usize) -> String {
    match many {
        1 => "1 cell".to_owned(),
        many => format!("{many} cells"),
    }
}

/// A cell that is missing, and who measures it.
pub fn lacking(one: &Lacking) -> String {
    format!("  {}: --shard {} measures it", one.cell, one.shard)
}

/// The same for machines.
pub fn lacking_document(one: &Lacking) -> Value {
    json!({ "cell": one.cell, "shard": one.shard.to_string() })
}

fn document(shard: Shard, done: &[Done], missing: Option<&[Lacking]>) -> Value {
    let cell = |one: &Done| json!({ "cell": one.cell, "measured": one.anew });
    let missing = missing.map(|all| all.iter().map(lacking_document).collect::<Vec<_>>());
    json!({
        "shard": shard.to_string(),
        "cells": done.iter().map(cell).collect::<Vec<_>>(),
        "missing": missing,
    })
}
