//! Speed, as a ratio to a fill of the same bytes in the same run. Verify first, then
//! time: what is not the reference's words is not timed.

mod against;
mod document;
mod fill;
mod jobs;
mod measure;
mod scaling;
#[cfg(feature = "scenes")]
pub mod scene;

pub use against::{Baseline, Change, Verdict, changes, slower};
pub use document::{Machine, SCHEMA, json};
pub use jobs::{Job, chosen, jobs};
pub use measure::{on_cpu, on_device};
pub use scaling::{MOST, SIZES, Scale, scaling, scaling_json, spread};

#[cfg(feature = "scenes")]
use fill::Fills;
#[cfg(feature = "scenes")]
use measure::{ROUNDS, deviation, median};

/// A measured job.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// What was made.
    pub name: String,
    /// The kernel; empty on the CPU.
    pub kernel: String,
    /// Points.
    pub points: u64,
    /// Bytes stored.
    pub bytes: u64,
    /// Seconds until the first 2^16 points at most are there, by the host's clock: with what is
    /// compiled, allocated and prepared for them.
    pub cold_s: f64,
    /// Median time of all points, in seconds: device time, or the host's on the CPU.
    pub median_s: f64,
    /// Median absolute deviation of that time.
    pub deviation_s: f64,
    /// Median time of a fill of the same bytes on all cores of the host.
    pub fill_s: f64,
    /// The goal, where the project has one.
    pub goal: Option<Goal>,
}

/// What a job is to reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// At most so many times the fill.
    Fill(f64),
    /// At least so many points a second.
    Rate(f64),
}

impl Measurement {
    /// Times the fill.
    #[must_use]
    pub fn fills(&self) -> f64 {
        self.median_s / self.fill_s
    }

    /// Points per second.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.points as f64 / self.median_s
    }

    /// Whether the goal is reached; `None` without one.
    #[must_use]
    pub fn reached(&self) -> Option<bool> {
        self.goal.map(|goal| match goal {
            Goal::Fill(most) => self.fills() <= most,
            Goal::Rate(least) => self.rate() >= least,
        })
    }
}
