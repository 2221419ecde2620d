//! GPU against CPU: every function and every kernel on one device, judged by a third.
//!
//! A row of the exact profile passes when the device's words equal the reference's and
//! the judge finds the error within its bound; a row of the native profile when the
//! judge finds it within what Vulkan's precision tables allow.

mod blue_noise;
mod cases;
mod discrete;
mod domain;
mod estimates;
mod functions;
mod inputs;
mod irradiance;
mod maps;
mod native;
mod native_points;
mod net;
mod pairs;
mod points;
mod random;
mod real;
mod rows;
mod strata;
mod transcendental;

pub use blue_noise::compare_mask;
pub use estimates::{compare_estimates, judged_range};
pub use functions::{compare_function, function_words};
pub use inputs::{arguments, mix};
pub use maps::{compare_map, examples, fractions, judge_native, truth};
pub use native::{NATIVE, NativeRow, compare_native};
pub use pairs::{compare_nearest, compare_pair_sums};
pub use points::{Case, compare_points};
pub use rows::{Row, Verdict};

use crate::catalog::{FUNCTIONS, Profile, Tier};
use crate::interface::KERNELS;
use crate::kernels::probe;
use crate::vulkan::{Device, Probe};
use crate::{Error, Result};
use std::sync::Arc;

/// What to check.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Only rows whose name, header or kernel contains this.
    pub only: Option<String>,
}

/// What came out.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// What the device does with floats.
    pub probe: Probe,
    /// The rows, in the order of the catalogue.
    pub rows: Vec<Row>,
}

impl Outcome {
    /// Rows that failed.
    #[must_use]
    pub fn failures(&self) -> usize {
        let failed = |row: &&Row| matches!(row.verdict, Verdict::Failed);
        self.rows.iter().filter(failed).count()
    }

    /// `Ok`, or how many rows failed.
    ///
    /// # Errors
    /// [`Error::CheckFailed`].
    pub fn result(&self) -> Result<()> {
        match self.failures() {
            0 => Ok(()),
            failures => Err(Error::CheckFailed {
                failures,
                total: self.rows.len(),
            }),
        }
    }
}

/// Checks a device; `progress` sees each row as it ends.
///
/// # Errors
/// Those of the device, and [`Error::Arguments`] where no row is left to check.
pub fn run(
    device: &Arc<Device>,
    options: &Options,
    progress: &mut dyn FnMut(&Row),
) -> Result<Outcome> {
    let probe = probe(device)?;
    let wanted = |names: &[&str]| match &options.only {
        None => true,
        Some(part) => names.iter().any(|name| name.contains(part.as_str())),
    };
    let mut rows = Vec::new();
    let mut add = |row: Row| {
        progress(&row);
        rows.push(row);
    };
    for function in FUNCTIONS {
        if !wanted(&[function.name, function.header]) {
            continue;
        }
        if function.tier == Tier::Float && !probe.tier_f() {
            add(Row::refused(
                function,
                "the probe does not find rounding to nearest even",
            ));
            continue;
        }
        add(functions::check(device, function, function.kernel)?);
        // The same function built with CORPUT_PORTABLE, where there is such a module.
        let portable = format!("{}_portable", function.kernel);
        if KERNELS.iter().any(|kernel| kernel.name == portable) {
            add(functions::check(device, function, &portable)?);
        }
    }
    for case in cases::cases()? {
        if !wanted(&[&case.name, case.kernel]) {
            continue;
        }
        add(points::check(device, &case)?);
    }
    for map in crate::catalog::maps() {
        if wanted(&[map.name, map.group.kernel(Profile::Exact)]) {
            maps::check(device, map)?.into_iter().for_each(&mut add);
        }
    }
    for integrand in crate::catalog::integrands() {
        if wanted(&[integrand.name, "estimate", "integrand", "sum", "genz"]) {
            add(estimates::check(device, integrand)?);
        }
    }
    if wanted(&["irradiance", "envmap_texel", "envmap"]) {
        add(irradiance::check(device)?);
    }
    if wanted(&["pairs", "discrepancy"]) {
        add(pairs::check_sums(device)?);
    }
    if wanted(&["nearest", "distance"]) {
        add(pairs::check_nearest(device)?);
    }
    if wanted(&["blue_noise_mask", "void_and_cluster"]) {
        add(blue_noise::check(device)?);
    }
    for row in NATIVE {
        if wanted(&[row.name, "native"]) {
            add(native::check(device, row)?);
        }
    }
    for case in native_points::native_cases()? {
        if wanted(&[&case.name, case.kernel]) {
            add(native_points::check_native(device, &case, native::SINE)?);
        }
    }
    if rows.is_empty() {
        return Err(Error::Arguments {
            asked: format!("--only {}", options.only.as_deref().unwrap_or("")),
            limit: "no row's name, header or kernel contains that".into(),
            remedy: "run `corput check` to see all rows".into(),
        });
    }
    Ok(Outcome { probe, rows })
}
