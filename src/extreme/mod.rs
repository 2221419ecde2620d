//! The catalogue of extreme inputs: what common formulas make of them in float, what this crate
//! does on the CPU, and what a device does.
//!
//! Numbers are those of `docs/extremes.md`. A case either says which call of a function or which
//! sample of a map it is, so that a device can be asked too, or is one of the host.

mod case;
mod covered;
mod device;
mod document;
mod elementary;
mod figures;
mod formulas;
mod heuristics;
mod page;
mod pictures;
mod plane;
mod scattering;
mod solid;
mod tables;
mod truth;

pub use case::{Case, Measure, Reading, Source, Subject, Truth};
pub use covered::{By, COVERED, Covered};
pub use device::{Given, Row, run, run_on_cpu};
pub use document::{Counts, SCHEMA, json, rows_json};
pub use page::page;

use crate::Result;

/// Every case, in the order of their numbers. It takes some 100 ms: tables of 2^20 weights
/// are made.
///
/// # Errors
/// None, if the tables of truth are unharmed.
pub fn cases() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for topic in [
        elementary::integers(),
        elementary::logarithms(),
        elementary::angles(),
        elementary::powers(),
        elementary::geometric_means(),
        heuristics::heuristics(),
        heuristics::deltas(),
        plane::disks()?,
        plane::weights(),
        tables::tables()?,
        solid::spheres()?,
        solid::cones()?,
        solid::cosine_powers()?,
        solid::lights()?,
        figures::triangles()?,
        figures::rectangles()?,
        pictures::pictures()?,
        scattering::lobes()?,
        scattering::frames(),
    ] {
        cases.extend(topic);
    }
    cases.sort_by_cached_key(|case| (case.number, case.input.clone()));
    Ok(cases)
}
