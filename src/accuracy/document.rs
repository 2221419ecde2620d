//! The figures as JSON and as CSV.

use super::{Accuracy, Comparison, Errors};
use serde_json::{Value, json};
use std::fmt::Write;

/// The version of the JSON document; it changes when a reader of the old one would fail.
pub const SCHEMA: &str = "corput-accuracy/1";

/// Columns of the CSV, in order.
pub const COLUMNS: [&str; 13] = [
    "name",
    "profile",
    "kernel",
    "results_judged",
    "floor",
    "worst_ulp",
    "mean_ulp",
    "worst_relative_ulp",
    "worst_pdf_ulp",
    "mean_pdf_ulp",
    "results_per_s",
    "spread",
    "exact_takes",
];

/// Where figures come from.
#[derive(Clone, Debug)]
pub struct About {
    /// Name and kind of the device.
    pub device: String,
    /// Name and version of its driver, and the Vulkan version.
    pub driver: String,
    /// Identifies the device, in 32 hexadecimal digits.
    pub device_uuid: String,
    /// The command line.
    pub command: String,
}

/// One document: where the figures come from, and both profiles of each function. An error
/// that is not finite, and a speed that was not measured, are `null`.
#[must_use]
pub fn json(about: &About, comparisons: &[Comparison]) -> Value {
    let functions: Vec<Value> = comparisons.iter().map(function).collect();
    json!({
        "schema": SCHEMA,
        "version": env!("CARGO_PKG_VERSION"),
        "command": about.command,
        "device": about.device,
        "driver": about.driver,
        "device_uuid": about.device_uuid,
        "error_unit": "ULP of the larger of the true result and the floor",
        "repeats": crate::interface::REPEATS,
        "functions": functions,
    })
}

fn function(comparison: &Comparison) -> Value {
    let bare = comparison.bare.map(|bare| bare.results_per_s());
    json!({
        "name": comparison.name,
        "domain": comparison.domain,
        "parameters": comparison.parameters,
        "compared": comparison.compared,
        "mismatches": comparison.mismatches,
        "exact_takes": comparison.price(),
        "loop_results_per_s": bare,
        "loop_share_of_native": comparison.loop_share(),
        "exact": profile(&comparison.exact),
        "native": profile(&comparison.native),
    })
}

fn profile(accuracy: &Accuracy) -> Value {
    let pdf = accuracy.judged.pdf;
    let speed = accuracy.speed;
    json!({
        "kernel": accuracy.kernel,
        "results_judged": accuracy.judged.results,
        "floor": accuracy.judged.floor,
        "worst_ulp": accuracy.judged.errors.worst_ulp,
        "mean_ulp": accuracy.judged.errors.mean_ulp,
        "worst_relative_ulp": accuracy.judged.worst_relative_ulp,
        "worst_pdf_ulp": pdf.map(|pdf| pdf.worst_ulp),
        "mean_pdf_ulp": pdf.map(|pdf| pdf.mean_ulp),
        "results_per_s": speed.map(|speed| speed.results_per_s()),
        "spread": speed.map(|speed| speed.spread()),
        "median_s": speed.map(|speed| speed.median_s),
        "results_per_dispatch": speed.map(|speed| speed.results),
        "device_clock": speed.map(|speed| speed.device_clock),
    })
}

/// A row for each function in each profile, below the names of [`COLUMNS`]. What was not
/// measured is empty, and an error that is not finite is `inf`.
#[must_use]
pub fn csv(comparisons: &[Comparison]) -> String {
    let mut text = COLUMNS.join(",") + "\n";
    for comparison in comparisons {
        for one in [&comparison.exact, &comparison.native] {
            let number =
                |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
            let errors = |errors: Option<Errors>| {
                let worst = number(errors.map(|errors| errors.worst_ulp));
                let mean = number(errors.map(|errors| errors.mean_ulp));
                format!("{worst},{mean}")
            };
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{},{},{},{},{}",
                one.name,
                one.profile.name(),
                one.kernel,
                one.judged.results,
                one.judged.floor,
                errors(Some(one.judged.errors)),
                one.judged.worst_relative_ulp,
                errors(one.judged.pdf),
                number(one.speed.map(|speed| speed.results_per_s())),
                number(one.speed.map(|speed| speed.spread())),
                number(comparison.price()),
            );
        }
    }
    text
}

/// An error as tables show it: three digits, by the exponent where there are many.
#[must_use]
pub fn figure(value: f64) -> String {
    match value {
        v if !v.is_finite() => "not finite".to_owned(),
        0.0 => "0".to_owned(),
        v if (1e-2..100.0).contains(&v) => format!("{v:.2}"),
        v if (100.0..1e5).contains(&v) => format!("{v:.0}"),
        v => format!("{v:.1e}"),
    }
}

/// A floor as tables show it: a dash where all errors are relative.
#[must_use]
pub fn floor(value: f64) -> String {
    match value {
        0.0 => "-".to_owned(),
        v if v >= 1.0 / 1024.0 => v.to_string(),
        v => format!("2^{}", v.log2()),
    }
}

/// Millions a second, in three digits.
#[must_use]
pub fn millions(value: f64) -> String {
    match value / 1e6 {
        m if m < 10.0 => format!("{m:.2}"),
        m if m < 100.0 => format!("{m:.1}"),
        m => format!("{m:.0}"),
    }
}
