//! The rows as one document.

use super::Row;
use serde_json::{Value, json};

/// The version of the document and of the manifest; it changes when a reader of the old one
/// would fail.
pub const SCHEMA: &str = "corput-exhaustive/1";

/// Where rows come from.
#[derive(Clone, Debug)]
pub struct About {
    /// The device and its driver, in one line.
    pub device: String,
    /// The command line.
    pub command: String,
}

/// Where the rows come from, the rows, and the names of those for which there was no time.
#[must_use]
pub fn json(about: &About, rows: &[Row], left_out: &[String]) -> Value {
    json!({
        "schema": SCHEMA,
        "version": env!("CARGO_PKG_VERSION"),
        "command": about.command,
        "device": about.device,
        "rows": rows.iter().map(Row::json).collect::<Vec<_>>(),
        "left_out": left_out,
    })
}
