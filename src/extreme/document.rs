//! The rows as JSON.

use super::Row;
use super::formulas::formula;
use serde_json::{Value, json};

/// The version of the JSON document; it changes when a reader of the old one would fail.
pub const SCHEMA: &str = "corput-extreme/2";

/// How many rows there are of each kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    /// Rows.
    pub rows: usize,
    /// Those that failed.
    pub failed: usize,
    /// Those that were run on the device.
    pub device: usize,
    /// Those that do not apply to the device.
    pub refused: usize,
    /// Those that have a result of the native profile too.
    pub native: usize,
    /// Those whose common formula is beyond the bound.
    pub naive_beyond: usize,
    /// Those whose native result is.
    pub native_beyond: usize,
}

impl Counts {
    /// Those of rows.
    #[must_use]
    pub fn of(rows: &[Row]) -> Self {
        let count = |test: &dyn Fn(&Row) -> bool| rows.iter().filter(|row| test(row)).count();
        // A NaN is beyond every bound.
        let beyond = |error: f64, row: &Row| error.is_nan() || error > row.case.bound;
        Self {
            rows: rows.len(),
            failed: count(&|row| row.failure.is_some()),
            device: count(&|row| row.device.is_some()),
            refused: count(&|row| row.refused.is_some()),
            native: count(&|row| row.native.is_some()),
            naive_beyond: count(&|row| beyond(row.case.naive, row)),
            native_beyond: count(&|row| row.native.is_some_and(|error| beyond(error, row))),
        }
    }
}

/// One document: the device in words, counts, rows, and the cases for which there was no time. An error that is not finite is `null`; one that there is none of is not there.
#[must_use]
pub fn json(device: &str, command: &str, rows: &[Row], left_out: &[String]) -> Value {
    let counts = Counts::of(rows);
    json!({
        "schema": SCHEMA,
        "version": env!("CARGO_PKG_VERSION"),
        "command": command,
        "device": device,
        "counts": {
            "rows": counts.rows,
            "failed": counts.failed,
            "on_device": counts.device,
            "on_host_alone": counts.rows - counts.device - counts.refused,
            "refused": counts.refused,
            "native": counts.native,
            "common_formula_beyond_bound": counts.naive_beyond,
            "native_beyond_bound": counts.native_beyond,
        },
        "rows": rows_json(rows),
        "left_out": left_out,
    })
}

/// The rows alone.
#[must_use]
pub fn rows_json(rows: &[Row]) -> Vec<Value> {
    rows.iter().map(row).collect()
}

fn row(row: &Row) -> Value {
    let case = &row.case;
    let mut value = json!({
        "case": case.number,
        "input": case.input,
        "subject": case.subject.name(),
        "truth": case.truth.values,
        "truth_source": case.truth.source.name(),
        "formula": formula(case),
        "common_formula": case.naive,
        "cpu": case.ours,
        "bound": case.bound,
        "verdict": row.verdict(),
    });
    if let Value::Object(fields) = &mut value {
        let errors = [("device", row.device), ("native", row.native)];
        for (name, error) in errors {
            fields.extend(error.map(|error| (name.to_owned(), json!(error))));
        }
        let why = row.failure.as_ref().or(row.refused.as_ref());
        fields.extend(why.map(|why| ("reason".to_owned(), json!(why))));
    }
    value
}
