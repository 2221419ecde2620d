//! Published vectors: arguments and results of every exact function, points of every
//! sequence, blue noise, samples of every map and sums of every integrand, as words with their SHA-256,
//! so that an engine or a port can test itself without this crate.
//!
//! The words are the reference's, which no device may differ from. A function's file has a row
//! for each call, four words of arguments and four of results; what they mean the source of its
//! kernel says, line by line, and the sources are beside the vectors.

mod blue_noise;
mod functions;
mod integrands;
mod maps;
mod sequences;
mod write;

pub use write::write;

use crate::Result;
use crate::catalog::{self, FUNCTIONS};
use crate::check;
use crate::report::{Element, Layout, hexadecimal, npy_array, npy_header};
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};

/// Version of the manifest's form.
pub const SCHEMA: &str = "corput-vectors/1";

/// A table of words.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The file, in the folder of the vectors.
    pub file: String,
    /// Words of a row.
    pub columns: u32,
    /// All rows, one after another.
    pub words: Vec<u32>,
    /// The axes of an array that is no list of rows, such as a picture's.
    pub axes: Option<Vec<u32>>,
}

impl Table {
    /// The file's bytes: NumPy's, `<u4`, of shape (rows, columns) or of its axes, as
    /// `corput generate` writes.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        if let Some(axes) = &self.axes {
            return npy_array(Element::U32, axes, &self.words);
        }
        let mut bytes = npy_header(&Layout {
            rows: self.rows(),
            columns: self.columns,
            element: Element::U32,
        });
        bytes.extend(self.words.iter().flat_map(|word| word.to_le_bytes()));
        bytes
    }

    fn rows(&self) -> u64 {
        self.words.len() as u64 / u64::from(self.columns.max(1))
    }

    /// Of the file, as `sha256sum` prints it.
    #[must_use]
    pub fn sha256(&self) -> String {
        hexadecimal(&Sha256::digest(self.bytes()))
    }

    fn json(&self) -> Value {
        json!({
            "file": self.file,
            "shape": match &self.axes {
                Some(axes) => json!(axes),
                None => json!([self.rows(), u64::from(self.columns)]),
            },
            "sha256": self.sha256(),
        })
    }
}

/// An entry of the manifest.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// `function`, `sequence`, `blue noise`, `map` or `integrand`.
    pub kind: &'static str,
    /// What it is called.
    pub name: String,
    /// What it was made with.
    pub about: Map<String, Value>,
    /// Its words; none of an integrand, whose sums are in `about`.
    pub table: Option<Table>,
    /// Words that it reads besides, of a map: alias tables and sums of an environment.
    pub tables: Vec<Table>,
}

impl Entry {
    fn json(&self) -> Value {
        let mut entry = Map::new();
        entry.insert("kind".into(), self.kind.into());
        entry.insert("name".into(), self.name.clone().into());
        entry.extend(self.about.clone());
        if let Some(table) = &self.table {
            entry.insert("table".into(), table.json());
        }
        if !self.tables.is_empty() {
            let tables = self.tables.iter().map(Table::json);
            entry.insert("reads".into(), tables.collect());
        }
        Value::Object(entry)
    }
}

/// Makes every entry in turn.
///
/// # Errors
/// Those of `take`.
pub fn each(take: &mut dyn FnMut(&Entry) -> Result<()>) -> Result<()> {
    functions::each(take)?;
    sequences::each(take)?;
    blue_noise::each(take)?;
    maps::each(take)?;
    integrands::each(take)
}

/// How many entries there are.
///
/// # Errors
/// None, if the catalogue is right.
pub fn number() -> Result<u64> {
    let blue_noise = 1 + blue_noise::MASKS.len();
    let mut number = FUNCTIONS.len() + sequences::all().count() + blue_noise;
    for map in catalog::maps() {
        number += check::examples(map)?.len();
    }
    for integrand in integrands::published() {
        number += catalog::examples(integrand)?.len();
    }
    Ok(number as u64)
}

/// The manifest, without writing a file: 40 MB of words are made and hashed, seconds.
///
/// # Errors
/// None, if the catalogue is right.
pub fn manifest() -> Result<Value> {
    let mut entries = Vec::new();
    each(&mut |entry| {
        entries.push(entry.json());
        Ok(())
    })?;
    Ok(document(entries))
}

fn document(entries: Vec<Value>) -> Value {
    json!({ "schema": SCHEMA, "entries": entries })
}

/// About so many rows of a table.
const ROWS: usize = 1 << 12;

/// Rows evenly from all of a list, the first among them: at most [`ROWS`].
fn thinned<T>(list: Vec<T>) -> impl Iterator<Item = T> {
    let every = list.len().div_ceil(ROWS).max(1);
    list.into_iter().step_by(every)
}

fn about<const N: usize>(pairs: [(&str, Value); N]) -> Map<String, Value> {
    pairs
        .into_iter()
        .map(|(key, value)| (key.to_owned(), value))
        .collect()
}
