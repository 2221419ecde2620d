//! The binary as its user meets it: what it writes, says, refuses and returns.

#[path = "cli/accuracy.rs"]
mod accuracy;
#[path = "cli/auto.rs"]
mod auto;
#[path = "cli/bench.rs"]
mod bench;
#[path = "cli/blue_noise.rs"]
mod blue_noise;
#[path = "cli/check.rs"]
mod check;
#[path = "cli/commands.rs"]
mod commands;
#[path = "cli/converge.rs"]
mod converge;
mod desk;
#[path = "cli/devices.rs"]
mod devices;
#[path = "cli/environment.rs"]
mod environment;
#[path = "cli/estimate.rs"]
mod estimate;
#[path = "cli/guide.rs"]
mod guide;
#[path = "cli/limits.rs"]
mod limits;
#[path = "cli/maps.rs"]
mod maps;
#[path = "cli/measure.rs"]
mod measure;
#[path = "cli/parse.rs"]
mod parse;
#[path = "cli/plot.rs"]
mod plot;
#[path = "cli/published.rs"]
mod published;
#[path = "cli/refused.rs"]
mod refused;
#[path = "cli/report.rs"]
mod report;
#[cfg(unix)]
#[path = "cli/running.rs"]
mod running;
#[path = "cli/same.rs"]
mod same;
#[path = "cli/sequences.rs"]
mod sequences;
mod support;
#[path = "cli/vectors.rs"]
mod vectors;
#[path = "cli/widths.rs"]
mod widths;

use desk::{Desk, Run, repository};
use support::{on_one_device, skips};
