//! Cells of a study's shards as its report.

use crate::cli::args::MergeArgs;
use crate::cli::converge::{conclude, lacking, lacking_document};
use crate::cli::{host, print};
use corput::converge::{Gathered, Lacking};
use serde_json::json;
use std::path::Path;

pub fn run(folder: &Path, args: &MergeArgs) -> anyhow::Result<()> {
    let gathered = Gathered::open(folder)?;
    let missing = gathered.lacking(args.shards)?;
    if !missing.is_empty() {
        print(&incomplete(&gathered, &missing, args.json)?);
    }
    let results = gathered.results(&host::command())?;
    conclude(&results, Some(folder), None, args.json)
}

/// What is missing.
fn incomplete(gathered: &Gathered, missing: &[Lacking], json: bool) -> anyhow::Result<String> {
    if json {
        return Ok(serde_json::to_string_pretty(&json!({
            "cells": gathered.total(),
            "complete": false,
            "missing": missing.iter().map(lacking_document).collect::<Vec<_>>(),
        }))?);
    }
    let (lacks, total) = (missing.len(), gathered.total());
    let mut lines = vec![format!("{lacks} of {total} cells are missing:")];
    lines.extend(missing.iter().map(lacking));
    Ok(lines.join("\n"))
}
