//! The catalogue of extreme inputs: what common formulas make of them in float, what this crate
//! does on the CPU, and what a device does.
//!
//! Numbers are those of `docs/extremes.md`. A case either says which call of a function, sample of
//! a map, estimate or sum it is, so that a device can be asked too, or is one of the host.

mod case;
mod device;
mod document;
mod elementary;
mod figures;
mod formulas;
mod heuristics;
mod indices;
mod integrals;
mod integrals_float;
mod integrands;
mod page;
mod pictures;
mod plane;
mod scattering;
mod solid;
mod sums;
mod tables;
mod truth;
mod words;

pub use case::{Case, Measure, Reading, Source, Subject, Truth};
pub use device::{Given, Row, run, run_on_cpu, run_within};
pub use document::{Counts, SCHEMA, json, rows_json};
pub use page::page;

use crate::Result;

/// Every case, in the order of their numbers. It takes most of a second: tables of
/// 2^20 weights are made, and means of up to 2^20 points.
///
/// # Errors
/// None, if the tables of truth are unharmed.
pub fn cases() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for topic in [
        indices::indices(),
        indices::refusals(),
        indices::shifts(),
        indices::conversions(),
        indices::rotations(),
        indices::intervals(),
        indices::strata(),
        indices::high_bases()?,
        integrands::loops()?,
        integrands::rough()?,
        integrands::steps()?,
        integrands::products()?,
        sums::swallowed(),
        sums::grouped(),
        sums::variances()?,
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
