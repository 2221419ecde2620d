//! A finished cell as a line of JSON.

use super::cell::{Cell, Point};
use serde_json::{Value, json};

/// A cell with what names it.
pub(super) struct Line {
    /// What was measured, as [`key`](super::key) has it.
    pub key: String,
    /// What measured it, as [`Engine::program`](super::Engine::program) has it.
    pub program: String,
    /// The device and its driver, where the key does not name them.
    pub device: Option<String>,
    pub cell: Cell,
}

impl Line {
    /// The line, with its end.
    pub fn text(&self) -> String {
        let mut value =
            json!({ "key": self.key, "program": self.program, "cell": document(&self.cell) });
        if let Some(device) = &self.device {
            value["device"] = json!(device);
        }
        format!("{value}\n")
    }

    /// Reads one; none where it was cut off or is another's.
    pub fn read(line: &str) -> Option<Self> {
        let value: Value = serde_json::from_str(line).ok()?;
        let text = |name: &str| Some(value.get(name)?.as_str()?.to_owned());
        Some(Self {
            key: text("key")?,
            program: text("program")?,
            device: text("device"),
            cell: cell(value.get("cell")?)?,
        })
    }
}

fn document(cell: &Cell) -> Value {
    let bits = |values: &[f64]| -> Vec<u64> { values.iter().map(|one| one.to_bits()).collect() };
    let point = |point: &Point| {
        json!({
            "count": point.count,
            // What is no number has no JSON.
            "means": bits(&point.means),
            "variances": bits(&point.variances),
            "device_ns": point.device_ns,
            "host_ns": point.host_ns,
        })
    };
    json!({
        "setup_ms": cell.setup_ms,
        "first_ms": cell.first_ms,
        "points": cell.points.iter().map(point).collect::<Vec<_>>(),
        "refused": cell.refused,
        "warnings": cell.warnings,
    })
}

fn cell(cell: &Value) -> Option<Cell> {
    let numbers = |value: &Value| -> Option<Vec<f64>> {
        value.as_array()?.iter().map(Value::as_f64).collect()
    };
    let bits = |value: &Value| -> Option<Vec<f64>> {
        let words = value.as_array()?.iter().map(Value::as_u64);
        words.map(|word| word.map(f64::from_bits)).collect()
    };
    let point = |value: &Value| -> Option<Point> {
        Some(Point {
            count: value.get("count")?.as_u64()?,
            means: bits(value.get("means")?)?,
            variances: bits(value.get("variances")?)?,
            device_ns: numbers(value.get("device_ns")?)?,
            host_ns: numbers(value.get("host_ns")?)?,
        })
    };
    let points: Option<Vec<Point>> = cell.get("points")?.as_array()?.iter().map(point).collect();
    let refused = |value: &Value| -> Option<(u64, String)> {
        Some((value.get(0)?.as_u64()?, value.get(1)?.as_str()?.to_owned()))
    };
    let refusals: Option<Vec<_>> = cell
        .get("refused")?
        .as_array()?
        .iter()
        .map(refused)
        .collect();
    let warnings = cell.get("warnings")?.as_array()?.iter();
    let warnings: Option<Vec<String>> = warnings
        .map(|one| one.as_str().map(str::to_owned))
        .collect();
    Some(Cell {
        setup_ms: cell.get("setup_ms")?.as_f64()?,
        first_ms: cell.get("first_ms")?.as_f64()?,
        points: points?,
        refused: refusals?,
        warnings: warnings?,
    })
}
