//! Measurements as JSON.

use super::{Change, Goal, Measurement};
use serde_json::{Value, json};

/// Names the form of the document.
pub const SCHEMA: &str = "corput-bench/1";

/// Where and how it was measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Machine {
    /// One line that names the device.
    pub device: String,
    /// Threads of the fills, and of the CPU path.
    pub threads: usize,
    /// The command.
    pub command: String,
}

/// Everything, and what changed since a baseline, where there is one.
#[must_use]
pub fn json(machine: &Machine, measured: &[Measurement], changes: Option<&[Change]>) -> Value {
    let mut document = json!({
        "schema": SCHEMA,
        "version": env!("CARGO_PKG_VERSION"),
        "device": machine.device,
        "host_threads": machine.threads,
        "command": machine.command,
        "jobs": measured.iter().map(job).collect::<Vec<_>>(),
    });
    if let Some(changes) = changes {
        document["changes"] = changes.iter().map(change).collect();
    }
    document
}

fn job(m: &Measurement) -> Value {
    let goal = m.goal.map(|goal| match goal {
        Goal::Fill(most) => json!({ "times_fill_at_most": most }),
        Goal::Rate(least) => json!({ "points_per_s_at_least": least }),
    });
    json!({
        "name": m.name,
        "kernel": m.kernel,
        "points": m.points,
        "bytes": m.bytes,
        "cold_s": m.cold_s,
        "median_s": m.median_s,
        "deviation_s": m.deviation_s,
        "fill_s": m.fill_s,
        "times_fill": m.fills(),
        "points_per_s": m.rate(),
        "goal": goal,
        "goal_reached": m.reached(),
    })
}

fn change(change: &Change) -> Value {
    json!({
        "name": change.name,
        "time_ratio": change.seconds,
        "times_fill_ratio": change.fills,
        "verdict": change.verdict.name(),
    })
}
