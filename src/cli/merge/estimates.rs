//! Estimates of several ranges of points as one: exact sums, added.

use crate::cli::estimate::numbers;
use crate::cli::print;
use corput::estimate::Recorded;
use corput::report::read_json;
use corput::{Error, Result};
use serde_json::{Value, json};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Bytes of a document at most.
const MOST: u64 = 64 << 20;

pub fn run(paths: &[PathBuf], json: bool) -> anyhow::Result<()> {
    let parts: Vec<Part> = paths.iter().map(|path| read(path)).collect::<Result<_>>()?;
    let document = merged(&parts)?;
    if json {
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        print(&text(&document, paths.len()));
    }
    Ok(())
}

/// A document, as far as it is merged.
struct Part<'a> {
    path: &'a Path,
    recorded: Recorded,
}

fn read(path: &Path) -> Result<Part<'_>> {
    let document = read_json(path, MOST, Recorded::REMEDY)?;
    let recorded = Recorded::parse(&document, path)?;
    Ok(Part { path, recorded })
}

fn merged(parts: &[Part]) -> Result<Value> {
    let Some((first, others)) = parts.split_first() else {
        return Ok(Value::Null);
    };
    let mut estimate = first.recorded.estimate;
    for part in others {
        for (name, value) in &part.recorded.shared {
            let wanted = &first.recorded.shared[name];
            if value != wanted {
                let of = first.path.display();
                let problem = format!("its {name} is {value}, and {wanted} in {of}");
                return Err(refused(part.path, problem));
            }
        }
        estimate = estimate.merged(part.recorded.estimate)?;
    }
    let ranges = joined(parts)?;
    let independent = first.recorded.shared["independent"]
        .as_bool()
        .unwrap_or(false);
    let truth = first.recorded.shared["truth"].as_f64().unwrap_or(f64::NAN);
    let mut document = first.recorded.shared.clone();
    document.extend(numbers(&estimate, independent, truth));
    let start = ranges.first().map(|range| range.start);
    document.insert("start".to_owned(), json!(start));
    let ranges = ranges
        .into_iter()
        .map(|range| json!({ "first": range.start, "count": range.end - range.start }));
    document.insert("ranges".to_owned(), ranges.collect());
    Ok(Value::Object(document))
}

/// The ranges of all parts in order, those that touch as one.
fn joined(parts: &[Part]) -> Result<Vec<Range<u64>>> {
    let ranges = parts.iter().flat_map(|part| {
        let own = part.recorded.ranges.iter();
        own.map(|range| (range.clone(), part.path))
    });
    let mut ranges: Vec<_> = ranges.collect();
    ranges.sort_by_key(|(range, _)| range.start);
    let mut joined: Vec<(Range<u64>, &Path)> = Vec::new();
    for (range, path) in ranges {
        match joined.last_mut() {
            Some((last, other)) if range.start < last.end => {
                let both = range.start..range.end.min(last.end);
                return Err(refused(
                    path,
                    format!(
                        "its points {} to {} are in {} too",
                        both.start,
                        both.end - 1,
                        other.display()
                    ),
                ));
            }
            Some((last, other)) if range.start == last.end => {
                (last.end, *other) = (range.end, path);
            }
            _ => joined.push((range, path)),
        }
    }
    Ok(joined.into_iter().map(|(range, _)| range).collect())
}

fn refused(path: &Path, problem: String) -> Error {
    Error::Document {
        path: path.to_owned(),
        problem,
        remedy: Recorded::REMEDY,
    }
}

fn text(document: &Value, files: usize) -> String {
    let member = |name: &str| match &document[name] {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    let ranges = document["ranges"].as_array().map_or(0, Vec::len);
    let mut lines = vec![format!(
        "{}, {} points of {} in {ranges} range{}, of {files} file{}",
        member("integrand"),
        member("count"),
        member("sampler"),
        if ranges == 1 { "" } else { "s" },
        if files == 1 { "" } else { "s" },
    )];
    for name in [
        "mean",
        "truth",
        "error",
        "standard_error",
        "variance",
        "sum",
        "sum_of_squares",
        "scale",
    ] {
        if !document[name].is_null() {
            lines.push(format!("{:<15} {}", name.replace('_', " "), member(name)));
        }
    }
    lines.join("\n")
}
