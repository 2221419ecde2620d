//! Two checks against each other, as their documents have them.

use crate::report::read_json;
use crate::{Error, Result};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// What two documents of `corput check --json` differ in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// Rows of the exact profile with the same hash.
    pub equal: usize,
    /// Those with different ones.
    pub differ: Vec<String>,
    /// Exact rows that only one of the two has, or has a hash of.
    pub only: Vec<String>,
    /// Rows of the native profile with different hashes, which they may have.
    pub native: usize,
}

impl Comparison {
    /// `Ok` where every exact row that both have is equal, and both have the same.
    ///
    /// # Errors
    /// [`Error::CardsDiffer`].
    pub fn result(&self) -> Result<()> {
        match (self.differ.len(), self.only.len()) {
            (0, 0) => Ok(()),
            (differ, missing) => Err(Error::CardsDiffer { differ, missing }),
        }
    }
}

/// Bytes of a document at most: a whole card has some hundred thousand.
const MOST: u64 = 64 << 20;

const REMEDY: &str = "write one with `corput check --report DIR` or --json";

/// Name and kernel of a row.
type Key = (String, String);

/// The hashes of a document's rows, exact and native.
type Hashes = [BTreeMap<Key, Option<String>>; 2];

/// Compares two files that `corput check --json` or `--report` wrote.
///
/// # Errors
/// [`Error::Document`] for a file that cannot be read, is none of these, or has no exact row.
pub fn compare(one: &Path, other: &Path) -> Result<Comparison> {
    let [exact, native] = hashes(one)?;
    let [other_exact, other_native] = hashes(other)?;
    let mut found = Comparison {
        equal: 0,
        differ: Vec::new(),
        only: Vec::new(),
        native: 0,
    };
    let name = |(name, kernel): &Key| format!("{name} ({kernel})");
    for (key, hash) in &exact {
        match (hash, other_exact.get(key)) {
            (Some(one), Some(Some(other))) if one == other => found.equal += 1,
            (Some(_), Some(Some(_))) => found.differ.push(name(key)),
            // Both devices refused it.
            (None, Some(None)) => {}
            _ => found.only.push(name(key)),
        }
    }
    let missing = other_exact.keys().filter(|key| !exact.contains_key(*key));
    found.only.extend(missing.map(name));
    found.native = native
        .iter()
        .filter(|(key, hash)| other_native.get(*key).is_some_and(|other| other != *hash))
        .count();
    Ok(found)
}

fn hashes(path: &Path) -> Result<Hashes> {
    let refused = |problem: String| Error::Document {
        path: path.to_owned(),
        problem,
        remedy: REMEDY,
    };
    let document = read_json(path, MOST, REMEDY)?;
    let rows = document.get("rows").and_then(Value::as_array);
    let rows = rows.ok_or_else(|| refused("it has no rows".into()))?;
    let mut hashes = Hashes::default();
    for (index, row) in rows.iter().enumerate() {
        let text = |key: &str| row.get(key).and_then(Value::as_str).map(str::to_owned);
        let (Some(name), Some(kernel), Some(profile)) =
            (text("name"), text("kernel"), text("profile"))
        else {
            return Err(refused(format!(
                "row {index} lacks name, kernel or profile"
            )));
        };
        let [exact, native] = &mut hashes;
        let of = if profile == "exact" { exact } else { native };
        if of.insert((name, kernel), text("sha256")).is_some() {
            return Err(refused(format!("row {index} is there twice")));
        }
    }
    let [exact, _] = &hashes;
    if exact.is_empty() {
        return Err(Error::Document {
            path: path.to_owned(),
            problem: "it has no row of the exact profile".into(),
            remedy: "compare documents of other rows: the native profile's may differ",
        });
    }
    Ok(hashes)
}
