//! `zarr.json`: what an array is, in the words of Zarr v3.

use std::fs::File;
use std::io::ErrorKind;
use std::path::Path;

use serde_json::{Value, json};

use crate::error::{Error, Result};
use crate::report::difference::{Difference, differences};
use crate::report::json::bounded;
use crate::report::place::failed;
use crate::report::{Element, Layout};

/// Bytes of a chunk at most, unless one row has more.
const CHUNK_BYTES: u64 = 1 << 24;

/// Bytes of a document at most: a store's own have a few thousand.
const DOCUMENT_BYTES: u64 = 1 << 20;

/// The attribute beside `corput` that notes into how many shards the work was cut. It is none of
/// those that say what the array is, so that neither stores nor chunks are compared by it.
const SHARDS: &str = "corput_shards";

/// Every type, by its name in Zarr.
const TYPES: [(Element, &str); 4] = [
    (Element::F32, "float32"),
    (Element::U32, "uint32"),
    (Element::U16, "uint16"),
    (Element::F64, "float64"),
];

/// Rows of a chunk: the largest power of two within 16 MiB, at least one. Only columns and type
/// count, so that arrays of other lengths share their first chunks.
pub(super) fn chunk_rows(layout: &Layout) -> u64 {
    let row = layout.element.bytes() * u64::from(layout.columns.max(1));
    1 << (CHUNK_BYTES / row).max(1).ilog2()
}

/// The document of an array; `origin` says what makes it.
pub(super) fn document(layout: &Layout, origin: &Value) -> Value {
    let data_type = TYPES.iter().find(|(element, _)| *element == layout.element);
    let fill = match layout.element {
        Element::U32 | Element::U16 => json!(0),
        Element::F32 | Element::F64 => json!(0.0),
    };
    json!({
        "zarr_format": 3,
        "node_type": "array",
        "shape": [layout.rows, layout.columns],
        "data_type": data_type.map(|(_, name)| name),
        "chunk_grid": {
            "name": "regular",
            "configuration": { "chunk_shape": [chunk_rows(layout), layout.columns] },
        },
        "chunk_key_encoding": { "name": "default", "configuration": { "separator": "/" } },
        "fill_value": fill,
        "codecs": [{ "name": "bytes", "configuration": { "endian": "little" } }],
        "attributes": { "corput": origin },
    })
}

/// A document with a number of shards noted, if there is one.
pub(super) fn noted(mut document: Value, shards: Option<u64>) -> Value {
    if let Some(shards) = shards {
        document["attributes"][SHARDS] = json!(shards);
    }
    document
}

/// The number of shards that a document notes. What somebody else has put there, and what can be
/// no number of shards, is none: it says nothing of the array.
pub(super) fn shards(document: &Value) -> Option<u64> {
    let noted = document["attributes"][SHARDS].as_u64();
    noted.filter(|shards| *shards > 0)
}

/// Layout and origin of a document, if this module writes that for them.
pub(super) fn parse(document: &Value) -> Result<(Layout, Value), String> {
    let number = |axis: usize| document["shape"][axis].as_u64();
    let columns = number(1).and_then(|columns| u32::try_from(columns).ok());
    let (Some(rows), Some(columns)) = (number(0), columns) else {
        return Err("its shape is not that of rows and columns".to_owned());
    };
    let element = TYPES
        .iter()
        .find(|(_, name)| document["data_type"] == *name);
    let Some(&(element, _)) = element else {
        return Err("its data_type is none of float32, uint32, uint16 and float64".to_owned());
    };
    let layout = Layout {
        rows,
        columns,
        element,
    };
    layout.words().map_err(|error| error.to_string())?;
    let origin = document["attributes"]["corput"].clone();
    if !origin.is_object() {
        return Err("it has no attribute `corput`, so something else wrote it".to_owned());
    }
    match difference(&self::document(&layout, &origin), document) {
        None => Ok((layout, origin)),
        Some(found) => Err(found),
    }
}

/// The first member in which a document on the disk is not the one that is wanted. Attributes
/// that others have added do not count, nor do members that say nothing, which zarr-python
/// writes with those.
pub(super) fn difference(wanted: &Value, found: &Value) -> Option<String> {
    let mut found = found.clone();
    if let Some(members) = found.as_object_mut() {
        members.retain(|name, value| name != "storage_transformers" || *value != json!([]));
    }
    if let Some(attributes) = found.get_mut("attributes").and_then(Value::as_object_mut) {
        attributes.retain(|name, _| name == "corput");
    }
    let first = differences(&found, wanted).into_iter().next()?;
    let Difference { path, there, here } = first;
    Some(format!("{path} is {there} there, and {here} is wanted"))
}

/// A JSON document of a store; `None` where there is no such file.
pub(super) fn read(path: &Path) -> Result<Option<Value>> {
    let file = match File::open(path) {
        Ok(file) => file,
        Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {
            return Ok(None);
        }
        Err(error) => return Err(failed("open", path, error)),
    };
    let parsed = bounded(file, DOCUMENT_BYTES);
    parsed.map(Some).map_err(|problem| Error::Document {
        path: path.to_owned(),
        problem,
        remedy: "remove it, and run again what made the store",
    })
}

/// A document as it is written.
pub(super) fn text(document: &Value) -> Vec<u8> {
    format!("{document:#}\n").into_bytes()
}
