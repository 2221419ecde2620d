//! The committed truth, made in multi-precision.

use crate::{Error, Result};

const SOLID: &str = include_str!("../../assets/truth/solid_truth.csv");
const SCATTERING: &str = include_str!("../../assets/truth/scattering_truth.csv");

/// A number of the distributions over directions.
pub(super) struct Solid {
    pub number: u32,
    pub parameters: Vec<f64>,
    pub u: [u32; 2],
    pub quantity: &'static str,
    pub value: f64,
}

/// Results of a scattering function.
pub(super) struct Scattering {
    pub number: u32,
    pub what: &'static str,
    pub inputs: Vec<f64>,
    pub truth: Vec<f64>,
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split_whitespace()
        .map(|word| word.parse().ok())
        .collect()
}

fn parsed<T>(line: &str, row: Option<T>) -> Result<T> {
    row.ok_or_else(|| Error::Arguments {
        asked: format!("the truth `{line}`"),
        limit: "it is no row of its table".into(),
        remedy: "build from an unharmed copy of assets/truth".into(),
    })
}

/// Those of one map, in the order of the table.
pub(super) fn solid(map: &str) -> Result<Vec<Solid>> {
    let lines = SOLID
        .lines()
        .filter(|line| line.split(',').nth(1) == Some(map));
    lines.map(|line| parsed(line, solid_row(line))).collect()
}

fn solid_row(line: &'static str) -> Option<Solid> {
    let mut fields = line.split(',');
    let number = fields.next()?.parse().ok()?;
    let parameters = numbers(fields.nth(1)?)?;
    let &[x, y] = numbers(fields.next()?)?.as_slice() else {
        return None;
    };
    Some(Solid {
        number,
        parameters,
        u: [x as u32, y as u32],
        quantity: fields.next()?,
        value: fields.next()?.parse().ok()?,
    })
}

/// All of them.
pub(super) fn scattering() -> Result<Vec<Scattering>> {
    let lines = SCATTERING.lines();
    lines
        .map(|line| parsed(line, scattering_row(line)))
        .collect()
}

fn scattering_row(line: &'static str) -> Option<Scattering> {
    let mut fields = line.split(',');
    Some(Scattering {
        number: fields.next()?.parse().ok()?,
        what: fields.next()?,
        inputs: numbers(fields.next()?)?,
        truth: numbers(fields.next()?)?,
    })
}
