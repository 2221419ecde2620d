//! Values of options, from their text.

use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Columns and rows, as 16x9.
fn sides(text: &str) -> Option<[u32; 2]> {
    let (columns, rows) = text.split_once('x')?;
    Some([columns.parse().ok()?, rows.parse().ok()?])
}

/// The pixels of a picture.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    sides(text).ok_or_else(|| format!("{text} is no size; write columns and rows as 64x48"))
}

/// The cells of a plot's grid.
pub fn cells(text: &str) -> Result<[u32; 2], String> {
    let limit = "it must be columns x rows, each 1 to 1024, as 16x9";
    match sides(text) {
        Some(cells) if cells.iter().all(|n| (1..=1024).contains(n)) => Ok(cells),
        _ => Err(format!("`{text}` is no grid; {limit}")),
    }
}

/// Cells along each axis.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Grid(pub Vec<u64>);

pub fn grid(text: &str) -> Result<Grid, String> {
    let cells: Option<Vec<u64>> = text.split('x').map(|axis| axis.parse().ok()).collect();
    let limit = "it must be the cells along each axis, each 1 or more, as 32x16";
    match cells {
        Some(cells) if !cells.contains(&0) => Ok(Grid(cells)),
        _ => Err(format!("`{text}` is no grid; {limit}")),
    }
}

/// Rows from one up to another, as 0..1000.
pub fn range(text: &str) -> Result<Range<u64>, String> {
    let ends = text.split_once("..");
    let ends = ends.and_then(|(a, b)| Some(a.parse().ok()?..b.parse().ok()?));
    ends.ok_or_else(|| format!("`{text}` is no range; it must be two whole numbers, as 0..1000"))
}

/// A parameter of a map.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Param {
    /// Its name.
    pub name: String,
    /// Its numbers.
    pub numbers: Vec<f64>,
}

pub fn param(text: &str) -> Result<Param, String> {
    let (name, list) = text
        .split_once('=')
        .ok_or_else(|| format!("`{text}` has no value; write NAME=X or NAME=X,Y,Z"))?;
    if name.is_empty() {
        return Err(format!("`{text}` has no name; write NAME=X or NAME=X,Y,Z"));
    }
    let number = |part: &str| {
        let value = part.parse().ok().filter(|value: &f64| value.is_finite());
        value.ok_or_else(|| {
            format!("`{part}` is no finite number; write {name}=0.5 or {name}=1,0,0")
        })
    };
    Ok(Param {
        name: name.to_owned(),
        numbers: list.split(',').map(number).collect::<Result<_, _>>()?,
    })
}

/// A whole number from 0 to 2^64 - 1, with a message that says so.
pub fn whole(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| {
        let limit = "it must be a whole number from 0 to 18446744073709551615";
        match text.parse::<f64>() {
            Ok(value) if value < 0.0 => format!("{text} is negative; {limit}"),
            _ if !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit()) => {
                format!("{text} is too large; {limit}")
            }
            _ => format!("`{text}` is no whole number; {limit}"),
        }
    })
}
