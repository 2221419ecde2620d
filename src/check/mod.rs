//! GPU against CPU: every function and every kernel on one device, judged by a third.
//!
//! A row of the exact profile passes when the device's words equal the reference's and
//! the judge finds the error within its bound; a row of the native profile when the
//! judge finds it within what Vulkan's precision tables allow. Single functions of the driver's
//! own that are not are its defects, and fail nothing.

mod blue_noise;
mod cases;
mod compare;
mod discrete;
mod domain;
mod elementary;
mod estimates;
mod functions;
mod inputs;
mod irradiance;
mod junit;
mod maps;
mod native;
mod native_elementary;
mod native_points;
mod net;
mod pairs;
mod points;
mod random;
mod real;
mod reductions;
mod rows;
mod strata;
mod tasks;
mod transcendental;

pub use blue_noise::compare_mask;
pub use cases::cases;
pub use compare::{Comparison, compare};
pub(crate) use elementary::FRACTIONS;
pub use elementary::{ELEMENTARY, ElementaryFunction};
pub use estimates::{compare_estimates, judged_range};
pub use functions::{compare_function, function_error, function_words};
pub use inputs::{arguments, critical, mix, normal};
pub use junit::{Further, junit};
pub use maps::{compare_map, examples, fractions, judge_native, map_error, truth};
pub use native::{NATIVE, NativeRow, compare_native};
pub use native_elementary::compare_native_elementary;
pub use pairs::{compare_nearest, compare_pair_sums};
pub use points::{Case, compare_points};
pub use reductions::{FloatSums, REDUCTIONS, Reduction, compare_reduction};
pub use rows::{Row, Verdict, figure};

use crate::catalog::{FUNCTIONS, Profile, Tier};
use crate::interface::KERNELS;
use crate::kernels::probe;
use crate::vulkan::{Device, Probe};
use crate::{Error, Result};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tasks::Task;

/// What to check.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Only rows whose name, header or kernel contains this.
    pub only: Option<String>,
    /// Begin no row after so long; what is left out is named.
    pub time: Option<Duration>,
}

/// What came out.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// What the device does with floats.
    pub probe: Probe,
    /// The rows, in the order of the catalogue.
    pub rows: Vec<Row>,
    /// What there was no time for.
    pub left_out: Vec<String>,
}

impl Outcome {
    /// Rows that failed.
    #[must_use]
    pub fn failures(&self) -> usize {
        let failed = |row: &&Row| matches!(row.verdict, Verdict::Failed);
        self.rows.iter().filter(failed).count()
    }

    /// Functions of the driver's own that are beyond what Vulkan allows.
    #[must_use]
    pub fn defects(&self) -> usize {
        let defects = |row: &&Row| matches!(row.verdict, Verdict::Defect);
        self.rows.iter().filter(defects).count()
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

/// Checks a device, on several threads; `progress` sees the rows in the order of the
/// catalogue. The device keeps the pipelines, of which some serve several rows, until it is
/// dropped.
///
/// # Errors
/// Those of the device, and [`Error::Arguments`] where no row is left to check, or time for one.
pub fn run(
    device: &Arc<Device>,
    options: &Options,
    progress: &mut dyn FnMut(&Row),
) -> Result<Outcome> {
    let deadline = options
        .time
        .and_then(|time| Instant::now().checked_add(time));
    let probe = probe(device)?;
    let wanted = |names: &[&str]| match &options.only {
        None => true,
        Some(part) => names.iter().any(|name| name.contains(part.as_str())),
    };
    let mut tasks = of_functions(device, &probe, &wanted);
    tasks.extend(of_points(device, &wanted)?);
    for integrand in crate::catalog::integrands() {
        if wanted(&[integrand.name, "estimate", "integrand", "sum", "genz"]) {
            tasks.push(task(integrand.name, move || {
                estimates::check(device, integrand)
            }));
        }
    }
    if wanted(&["irradiance", "envmap_texel", "envmap"]) {
        tasks.push(task("irradiance", move || irradiance::check(device)));
    }
    if wanted(&["pairs", "discrepancy"]) {
        tasks.push(task("pairs", move || pairs::check_sums(device)));
    }
    if wanted(&["nearest", "distance"]) {
        tasks.push(task("nearest", move || pairs::check_nearest(device)));
    }
    for reduction in REDUCTIONS {
        if wanted(&[reduction.name, "reduction", "reduce", "sum"]) {
            tasks.push(task(&format!("reduction {}", reduction.name), move || {
                reductions::check(device, reduction)
            }));
        }
    }
    if wanted(&["blue_noise_mask", "void_and_cluster"]) {
        tasks.push(task("blue_noise_mask", move || blue_noise::check(device)));
    }
    for row in NATIVE {
        if wanted(&[row.name, "native"]) {
            tasks.push(task(row.name, move || native::check(device, row)));
        }
    }
    for function in native_elementary::functions() {
        let name = native_elementary::name(function);
        if wanted(&[&name, "function_native", "native"]) {
            tasks.push(task(&name, move || {
                native_elementary::check(device, function)
            }));
        }
    }
    for case in native_points::native_cases()? {
        if wanted(&[&case.name, case.kernel]) {
            let name = case.name.clone();
            let check = move || native_points::check_native(device, &case, native::SINE);
            tasks.push(task(&name, check));
        }
    }
    if tasks.is_empty() {
        return Err(Error::Arguments {
            asked: format!("--only {}", options.only.as_deref().unwrap_or("")),
            limit: "no row's name, header or kernel contains that".into(),
            remedy: "run `corput check` to see all rows".into(),
        });
    }
    device.keep_pipelines();
    let (rows, left_out) = tasks::run(&tasks, deadline, progress)?;
    if rows.is_empty() {
        return Err(no_time(options.time));
    }
    Ok(Outcome {
        probe,
        rows,
        left_out,
    })
}

/// What is said where there was no time for any row.
pub(crate) fn no_time(time: Option<Duration>) -> Error {
    Error::Arguments {
        asked: format!("--seconds {}", time.unwrap_or_default().as_secs_f64()),
        limit: "no row began in that time".into(),
        remedy: "give it more".into(),
    }
}

/// A task of one row.
fn task<'a>(name: &str, check: impl Fn() -> Result<Row> + Send + Sync + 'a) -> Task<'a> {
    Task {
        name: name.to_owned(),
        check: Box::new(check),
    }
}

/// The functions of the headers.
fn of_functions<'a>(
    device: &'a Arc<Device>,
    probe: &Probe,
    wanted: &dyn Fn(&[&str]) -> bool,
) -> Vec<Task<'a>> {
    let mut tasks = Vec::new();
    for function in FUNCTIONS {
        if !wanted(&[function.name, function.header]) {
            continue;
        }
        if function.tier == Tier::Float && !probe.tier_f() {
            let why = "the probe does not find rounding to nearest even";
            tasks.push(task(function.name, move || Ok(Row::refused(function, why))));
            continue;
        }
        tasks.push(task(function.name, move || {
            functions::check(device, function, function.kernel)
        }));
        // The same function built with CORPUT_PORTABLE, where there is such a module.
        let portable = format!("{}_portable", function.kernel);
        if KERNELS.iter().any(|kernel| kernel.name == portable) {
            tasks.push(task(function.name, move || {
                functions::check(device, function, &portable)
            }));
        }
    }
    tasks
}

/// The kernels that make points, and the maps.
fn of_points<'a>(
    device: &'a Arc<Device>,
    wanted: &dyn Fn(&[&str]) -> bool,
) -> Result<Vec<Task<'a>>> {
    let mut tasks = Vec::new();
    for case in cases::cases()? {
        if wanted(&[&case.name, case.kernel]) {
            tasks.push(task(&case.name.clone(), move || {
                points::check(device, &case)
            }));
        }
    }
    for map in crate::catalog::maps() {
        if wanted(&[map.name, map.group.kernel(Profile::Exact)]) {
            for (profile, of) in maps::tasks(map)? {
                tasks.push(task(map.name, move || {
                    maps::check(device, map, profile, of)
                }));
            }
        }
    }
    Ok(tasks)
}
