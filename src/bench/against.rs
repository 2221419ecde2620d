//! Measurements against earlier ones.

use super::{Measurement, SCHEMA};
use crate::error::{Error, Result};
use crate::report::read_json;
use serde_json::Value;
use std::path::Path;

/// What an earlier `corput bench --json` measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Baseline {
    /// The device's line.
    pub device: String,
    jobs: Vec<Before>,
}

#[derive(Clone, Debug, PartialEq)]
struct Before {
    name: String,
    median_s: f64,
    deviation_s: f64,
    fill_s: f64,
}

/// Whether a job takes another time than before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Less.
    Faster,
    /// The same within noise.
    Same,
    /// More.
    Slower,
    /// It was not measured before.
    New,
}

impl Verdict {
    /// The verdict as one word.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Faster => "faster",
            Self::Same => "same",
            Self::Slower => "slower",
            Self::New => "new",
        }
    }
}

/// A job now and before.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The job.
    pub name: String,
    /// Its time as a multiple of that before.
    pub seconds: Option<f64>,
    /// The same of times as multiples of their runs' fills.
    pub fills: Option<f64>,
    /// What follows.
    pub verdict: Verdict,
}

/// Changes of less than a tenth are noise wherever it was measured.
const LEAST: f64 = 0.1;

/// So many median absolute deviations are too.
const DEVIATIONS: f64 = 3.0;

/// Bytes of a document at most.
const MOST: u64 = 16 << 20;

const REMEDY: &str = "give a file that `corput bench --json` wrote";

impl Baseline {
    /// Reads a document of `corput bench --json`.
    ///
    /// # Errors
    /// [`Error::Document`] for what cannot be read, is no such document, or has times that
    /// are no positive numbers.
    pub fn read(path: &Path) -> Result<Self> {
        let refused = |problem: String| Error::Document {
            path: path.to_owned(),
            problem,
            remedy: REMEDY,
        };
        let document: Value = read_json(path, MOST, REMEDY)?;
        if document["schema"] != SCHEMA {
            return Err(refused(format!("its schema is not {SCHEMA}")));
        }
        let jobs = document["jobs"].as_array().into_iter().flatten();
        let jobs = jobs.map(|job| {
            let positive = |name: &str| job[name].as_f64().filter(|s| *s > 0.0 && s.is_finite());
            Some(Before {
                name: job["name"].as_str()?.to_owned(),
                median_s: positive("median_s")?,
                deviation_s: job["deviation_s"].as_f64().filter(|s| *s >= 0.0)?,
                fill_s: positive("fill_s")?,
            })
        });
        let jobs: Option<Vec<_>> = jobs.collect();
        let jobs = jobs.filter(|jobs| !jobs.is_empty());
        Ok(Self {
            device: document["device"].as_str().unwrap_or_default().to_owned(),
            jobs: jobs.ok_or_else(|| refused("a job lacks its name or times".into()))?,
        })
    }
}

impl Baseline {
    /// Whether it has a job of this name.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.jobs.iter().any(|job| job.name == name)
    }
}

/// Each measurement against the baseline's of the same name.
///
/// A machine may be slower as a whole, and its memory alone may be faster: a job counts as
/// slower or faster only where its seconds and its multiple of the fill both moved that way,
/// by more than a tenth and more than three deviations of both runs.
#[must_use]
pub fn changes(measured: &[Measurement], baseline: &Baseline) -> Vec<Change> {
    let change = |now: &Measurement| {
        let before = baseline.jobs.iter().find(|job| job.name == now.name);
        let Some(before) = before else {
            return Change {
                name: now.name.clone(),
                seconds: None,
                fills: None,
                verdict: Verdict::New,
            };
        };
        let seconds = now.median_s / before.median_s;
        let fills = now.fills() / (before.median_s / before.fill_s);
        let spread = now.deviation_s / now.median_s + before.deviation_s / before.median_s;
        let margin = 1.0 + LEAST.max(DEVIATIONS * spread);
        let verdict = if seconds.min(fills) > margin {
            Verdict::Slower
        } else if seconds.max(fills) < 1.0 / margin {
            Verdict::Faster
        } else {
            Verdict::Same
        };
        Change {
            name: now.name.clone(),
            seconds: Some(seconds),
            fills: Some(fills),
            verdict,
        }
    };
    measured.iter().map(change).collect()
}

/// An error where something is slower than before.
///
/// # Errors
/// [`Error::Slower`].
pub fn slower(changes: &[Change]) -> Result<()> {
    let slow = changes.iter().filter(|c| c.verdict == Verdict::Slower);
    match slow.count() {
        0 => Ok(()),
        jobs => Err(Error::Slower {
            jobs,
            total: changes.len(),
        }),
    }
}
