//! Estimates as `corput estimate --json` writes them down.

use super::{Estimate, U256};
use crate::{Error, Result};
use serde_json::{Map, Value};
use std::ops::Range;
use std::path::Path;

/// What estimates must have in common to be added.
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

/// An estimate of a document, and of what it is one.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    /// Integrand, sampler and the like, by their names in the document.
    pub shared: Map<String, Value>,
    /// Ranges of indices of the points, none of them empty, in order and apart.
    pub ranges: Vec<Range<u64>>,
    /// The sums, of as many points as the ranges have.
    pub estimate: Estimate,
}

impl Recorded {
    /// Reads a document, which messages call `path`.
    ///
    /// # Errors
    /// [`Error::Document`] for one of another kind, or whose numbers do not fit together.
    pub fn parse(document: &Value, path: &Path) -> Result<Self> {
        let problem = match read(document) {
            Ok(recorded) => return Ok(recorded),
            Err(problem) => problem,
        };
        Err(Error::Document {
            path: path.to_owned(),
            problem,
            remedy: Self::REMEDY,
        })
    }

    /// What to do about documents that cannot be added.
    pub const REMEDY: &'static str = "give documents of `corput estimate --json`, of other points of the same sequence and of the \
         same integrand";
}

fn read(document: &Value) -> Result<Recorded, String> {
    if document.get("pixels").is_some() {
        return Err("it is a picture, an estimate for each pixel".to_owned());
    }
    let mut shared = Map::new();
    for name in SHARED {
        let value = document.get(name);
        let value = value.ok_or_else(|| format!("it has no `{name}`"))?;
        shared.insert(name.to_owned(), value.clone());
    }
    let lacks = |name: &str| format!("its `{name}` is not what it must be");
    let ranges = ranges(document).ok_or_else(|| lacks("ranges"))?;
    let estimate = estimate(document).ok_or_else(|| lacks("sum"))?;
    let points: u64 = ranges.iter().map(|range| range.end - range.start).sum();
    if points != estimate.count() {
        return Err(lacks("count"));
    }
    Ok(Recorded {
        shared,
        ranges,
        estimate,
    })
}

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
