//! Estimates of several ranges of points as one: exact sums, added.

use crate::cli::estimate::numbers;
use crate::cli::print;
use corput::estimate::{Estimate, U256};
use corput::{Error, Result};
use serde_json::{Map, Value, json};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// What all of them must have in common.
const SHARED: [&str; 13] = [
    "version",
    "integrand",
    "estimator",
    "dimensions",
    "parameters",
    "sampler",
    "scramble",
    "seed",
    "total",
    "independent",
    "truth",
    "term_error",
    "scale",
];

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
    shared: Map<String, Value>,
    ranges: Vec<Range<u64>>,
    estimate: Estimate,
}

fn read(path: &Path) -> Result<Part<'_>> {
    let text = std::fs::read(path).map_err(|error| refused(path, error.to_string()))?;
    let document: Value =
        serde_json::from_slice(&text).map_err(|error| refused(path, error.to_string()))?;
    if document.get("pixels").is_some() {
        let problem = "it is a picture, an estimate for each pixel";
        return Err(refused(path, problem.to_owned()));
    }
    let mut shared = Map::new();
    for name in SHARED {
        let value = document.get(name);
        let value = value.ok_or_else(|| refused(path, format!("it has no `{name}`")))?;
        shared.insert(name.to_owned(), value.clone());
    }
    let lacks = |name: &str| refused(path, format!("its `{name}` is not what it must be"));
    let ranges = ranges(&document).ok_or_else(|| lacks("ranges"))?;
    let estimate = estimate(&document).ok_or_else(|| lacks("sum"))?;
    let points: u64 = ranges.iter().map(|range| range.end - range.start).sum();
    if points != estimate.count() {
        return Err(lacks("count"));
    }
    Ok(Part {
        path,
        shared,
        ranges,
        estimate,
    })
}

/// Ranges of indices, none of them empty, in order and apart.
fn ranges(document: &Value) -> Option<Vec<Range<u64>>> {
    let mut ranges: Vec<Range<u64>> = Vec::new();
    for range in document["ranges"].as_array()? {
        let first = range["first"].as_u64()?;
        let end = first.checked_add(range["count"].as_u64()?)?;
        let after = ranges.last().is_none_or(|last| last.end <= first);
        if end == first || end > 1 << 32 || !after {
            return None;
        }
        ranges.push(first..end);
    }
    Some(ranges)
}

fn estimate(document: &Value) -> Option<Estimate> {
    let scale = i32::try_from(document["scale"].as_i64()?).ok()?;
    let sum = document["sum"].as_str()?.parse().ok()?;
    let squares = U256::from_decimal(document["sum_of_squares"].as_str()?)?;
    Estimate::from_sums(document["count"].as_u64()?, scale, sum, squares)
}

fn merged(parts: &[Part]) -> Result<Value> {
    let Some((first, others)) = parts.split_first() else {
        return Ok(Value::Null);
    };
    let mut estimate = first.estimate;
    for part in others {
        for (name, value) in &part.shared {
            let wanted = &first.shared[name];
            if value != wanted {
                let of = first.path.display();
                let problem = format!("its {name} is {value}, and {wanted} in {of}");
                return Err(refused(part.path, problem));
            }
        }
        estimate = estimate.merged(part.estimate)?;
    }
    let ranges = joined(parts)?;
    let independent = first.shared["independent"].as_bool().unwrap_or(false);
    let truth = first.shared["truth"].as_f64().unwrap_or(f64::NAN);
    let mut document = first.shared.clone();
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
        let own = part.ranges.iter();
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
        remedy: "give documents of `corput estimate --json`, of other points of the same sequence and of the \
                 same integrand",
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
