//! GPU against CPU: every function and every kernel on one device, judged by a third.
//!
//! A row of the exact profile passes when the device's words equal the reference's and
//! the judge finds the error within its bound; a row of the native profile when the
//! judge finds it within what Vulkan's precision tables allow.

mod blue_noise;
mod cases;
mod compare;
mod discrete;
mod domain;
mod estimates;
mod functions;
mod inputs;
mod irradiance;
mod junit;
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
pub use compare::{Comparison, compare};
pub use estimates::{compare_estimates, judged_range};
pub use functions::{compare_function, function_words};
pub use inputs::{arguments, mix};
pub use junit::junit;
pub use maps::{compare_map, examples, fractions, judge_native, truth};
pub use native::{NATIVE, NativeRow, compare_native};
pub use pairs::{compare_nearest, compare_pair_sums};
pub use points::{Case, compare_points};
pub use rows::{Row, Verdict};

use crate::catalog::{FUNCTIONS, Function, Profile, Tier};
use crate::interface::KERNELS;
use crate::kernels::probe;
use crate::vulkan::{Device, Probe};
use crate::{Error, Result};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// What to check.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Only rows whose name, header or kernel contains this.
    pub only: Option<String>,
    /// Begin no row after so long; what is left out is counted.
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

/// Rows as they come, until time is up.
struct Rows<'a> {
    options: &'a Options,
    deadline: Option<Instant>,
    progress: &'a mut dyn FnMut(&Row),
    rows: Vec<Row>,
    left_out: Vec<String>,
}

impl Rows<'_> {
    /// Checks one more, which has these names, unless it is not asked for or time is up.
    fn add(&mut self, names: &[&str], check: impl FnOnce() -> Result<Row>) -> Result<()> {
        self.add_all(names, || Ok(vec![check()?]))
    }

    /// The same of what several rows come of.
    fn add_all(&mut self, names: &[&str], check: impl FnOnce() -> Result<Vec<Row>>) -> Result<()> {
        let only = self.options.only.as_deref();
        if only.is_some_and(|part| names.iter().all(|name| !name.contains(part))) {
            return Ok(());
        }
        if self
            .deadline
            .is_some_and(|deadline| Instant::now() >= deadline)
        {
            self.left_out.extend(names.first().map(ToString::to_string));
            return Ok(());
        }
        let begun = Instant::now();
        let mut rows = check()?;
        let share = begun.elapsed().as_secs_f64() / rows.len().max(1) as f64;
        for row in &mut rows {
            row.seconds = share;
            (self.progress)(row);
        }
        self.rows.extend(rows);
        Ok(())
    }
}

/// Checks a device; `progress` sees each row as it ends.
///
/// # Errors
/// Those of the device, and [`Error::Arguments`] where no row is left to check, or time for
/// one.
pub fn run(
    device: &Arc<Device>,
    options: &Options,
    progress: &mut dyn FnMut(&Row),
) -> Result<Outcome> {
    let deadline = options
        .time
        .and_then(|time| Instant::now().checked_add(time));
    let probe = probe(device)?;
    let mut rows = Rows {
        options,
        deadline,
        progress,
        rows: Vec::new(),
        left_out: Vec::new(),
    };
    for function in FUNCTIONS {
        functions(device, function, &probe, &mut rows)?;
    }
    for case in cases::cases()? {
        rows.add(&[&case.name, case.kernel], || points::check(device, &case))?;
    }
    for map in crate::catalog::maps() {
        let names = [map.name, map.group.kernel(Profile::Exact)];
        rows.add_all(&names, || maps::check(device, map))?;
    }
    for integrand in crate::catalog::integrands() {
        let names = [integrand.name, "estimate", "integrand", "sum", "genz"];
        rows.add(&names, || estimates::check(device, integrand))?;
    }
    rows.add(&["irradiance", "envmap_texel", "envmap"], || {
        irradiance::check(device)
    })?;
    rows.add(&["pairs", "discrepancy"], || pairs::check_sums(device))?;
    rows.add(&["nearest", "distance"], || pairs::check_nearest(device))?;
    rows.add(&["blue_noise_mask", "void_and_cluster"], || {
        blue_noise::check(device)
    })?;
    for row in NATIVE {
        rows.add(&[row.name, "native"], || native::check(device, row))?;
    }
    for case in native_points::native_cases()? {
        rows.add(&[&case.name, case.kernel], || {
            native_points::check_native(device, &case, native::SINE)
        })?;
    }
    if rows.rows.is_empty() && !rows.left_out.is_empty() {
        return Err(Error::Arguments {
            asked: format!(
                "--seconds {}",
                options.time.unwrap_or_default().as_secs_f64()
            ),
            limit: "no row began in that time".into(),
            remedy: "give it more".into(),
        });
    }
    if rows.rows.is_empty() {
        return Err(Error::Arguments {
            asked: format!("--only {}", options.only.as_deref().unwrap_or("")),
            limit: "no row's name, header or kernel contains that".into(),
            remedy: "run `corput check` to see all rows".into(),
        });
    }
    Ok(Outcome {
        probe,
        rows: rows.rows,
        left_out: rows.left_out,
    })
}

/// The rows of a function: in its kernel, and built with CORPUT_PORTABLE where there is such
/// a module.
fn functions(
    device: &Arc<Device>,
    function: &Function,
    probe: &Probe,
    rows: &mut Rows,
) -> Result<()> {
    let names = [function.name, function.header];
    if function.tier == Tier::Float && !probe.tier_f() {
        let reason = "the probe does not find rounding to nearest even";
        return rows.add(&names, || Ok(Row::refused(function, reason)));
    }
    let portable = format!("{}_portable", function.kernel);
    let portable = KERNELS
        .iter()
        .any(|kernel| kernel.name == portable)
        .then_some(portable);
    for kernel in [function.kernel].into_iter().chain(portable.as_deref()) {
        rows.add(&names, || functions::check(device, function, kernel))?;
    }
    Ok(())
}
