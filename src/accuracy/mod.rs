//! What exactness costs: errors and speed of single functions, in both profiles.
//!
//! Every elementary function and every map that has an exact and a native form. The exact
//! one is compared with the CPU's bits first, then judged and timed; the native one is judged
//! and timed beside it.
//!
//! Errors are in units of the last place (ULP) of the correctly rounded float, against the
//! judge's `f64`. A function that passes through 0 has no relative error there that hardware
//! would bound, so a result below a [floor](Judged::floor) counts in ULP of that: for
//! directions 1/2, whose ULP is that of all floats from there to 1, the radius. The worst
//! [relative](Judged::worst_relative_ulp) error stands beside. Both are over critical
//! arguments and 2^16 others, a mean is over those others.
//!
//! Speeds are those of a loop that evaluates the function 64 times an invocation, on
//! arguments that it makes itself, and stores 16 bytes for all: 0.25 bytes a result, so that
//! memory does not hide what the function costs. The [bare](Comparison::bare) loop, in
//! the same run, says what the loop takes of it.

#[cfg(feature = "images")]
mod chart;
mod document;
mod errors;
mod page;
mod speed;
mod subject;

#[cfg(feature = "images")]
pub use chart::chart;
pub use document::{About, COLUMNS, SCHEMA, csv, figure, floor, json, millions};
pub use errors::{Errors, Judged, judge};
pub use page::page;
pub use speed::Speed;
pub use subject::{Subject, names, repeated, subjects};

use crate::Result;
use crate::catalog::Profile;
use crate::check::fractions;
use crate::interface::task;
use crate::vulkan::{Access, Buffer, Device};
use std::sync::Arc;
use subject::Kernel;

/// Invocations of the loop whose results are judged one by one, and whose folded results are
/// compared with the CPU's.
const JUDGED: u32 = 1 << 10;

/// A function in one profile.
#[derive(Clone, Debug, PartialEq)]
pub struct Accuracy {
    /// The function, or the map.
    pub name: &'static str,
    /// Whose.
    pub profile: Profile,
    /// The module that ran.
    pub kernel: &'static str,
    /// How far its results are from the truth.
    pub judged: Judged,
    /// How fast they come; `None` where they are not the CPU's, though they must be.
    pub speed: Option<Speed>,
}

/// A function in both profiles.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The function, or the map.
    pub name: &'static str,
    /// What it was evaluated on.
    pub domain: &'static str,
    /// The numbers of the map's parameters.
    pub parameters: Vec<f64>,
    /// Exact results and folds compared with the CPU's.
    pub compared: u64,
    /// How many of them differ.
    pub mismatches: u64,
    /// The exact profile.
    pub exact: Accuracy,
    /// The native one.
    pub native: Accuracy,
    /// The loop without the function.
    pub bare: Option<Speed>,
}

impl Comparison {
    /// How many times as long the exact profile takes as the native one.
    #[must_use]
    pub fn price(&self) -> Option<f64> {
        let [exact, native] = [&self.exact, &self.native].map(|one| one.speed);
        Some(native?.results_per_s() / exact?.results_per_s())
    }

    /// The share of the native profile's time that the bare loop takes.
    #[must_use]
    pub fn loop_share(&self) -> Option<f64> {
        Some(self.native.speed?.results_per_s() / self.bare?.results_per_s())
    }
}

/// Verifies, judges and times subjects; `progress` sees how many are done, and the name of
/// the next.
///
/// # Errors
/// Those of the device, and what `progress` returns, which ends the work.
pub fn run(
    device: &Arc<Device>,
    subjects: &[Subject],
    progress: &mut dyn FnMut(usize, &str) -> Result<()>,
) -> Result<Vec<Comparison>> {
    let mut all = Vec::new();
    for subject in subjects {
        progress(all.len(), subject.name())?;
        all.push(compare(device, subject, &crate::kernels::spirv)?);
    }
    Ok(all)
}

/// Verifies, judges and times one subject, by the modules that `module` gives for the names
/// of its kernels: how tests measure broken ones.
///
/// # Errors
/// Those of the device, and of `module`.
pub fn compare(
    device: &Arc<Device>,
    subject: &Subject,
    module: &dyn Fn(&str) -> Result<Vec<u32>>,
) -> Result<Comparison> {
    let kernel = |profile, task| {
        let words = module(subject.kernel(profile))?;
        Kernel::new(device, subject, profile, task, &words)
    };
    let mut arguments = fractions();
    let typical = arguments.len();
    arguments.extend((0..JUDGED).flat_map(repeated));
    let expected: Vec<[u32; 4]> = arguments.iter().map(|&u| subject.reference(u)).collect();

    let judged = |profile| {
        let results = kernel(profile, task::SAMPLE)?.run(subject, &arguments)?;
        Ok::<_, crate::Error>((judge(subject, &arguments, &results, typical), results))
    };
    let (exact, results) = judged(Profile::Exact)?;
    let (native, _) = judged(Profile::Native)?;
    let same = |(got, want): &(&Vec<u32>, &[u32; 4])| got.iter().zip(*want).all(|(a, b)| a == b);
    let differ = results.iter().zip(&expected).filter(|pair| !same(pair));
    let mut mismatches = differ.count() as u64;

    let loops = [
        kernel(Profile::Exact, task::REPEAT)?,
        kernel(Profile::Native, task::REPEAT)?,
        kernel(Profile::Native, task::BARE)?,
    ];
    let [timed, native_loop, bare] = &loops;
    mismatches += folds(device, timed, expected.split_at(typical).1)?;
    let speeds = match mismatches {
        0 => Some(speed::speeds(device, [timed, native_loop, bare])?),
        _ => None,
    };
    let accuracy = |profile, judged, at: usize| Accuracy {
        name: subject.name(),
        profile,
        kernel: subject.kernel(profile),
        judged,
        speed: speeds.and_then(|list| list.get(at).copied()),
    };
    Ok(Comparison {
        name: subject.name(),
        domain: subject.domain(),
        parameters: subject.parameters().to_vec(),
        compared: arguments.len() as u64 + u64::from(JUDGED),
        mismatches,
        exact: accuracy(Profile::Exact, exact, 0),
        native: accuracy(Profile::Native, native, 1),
        bare: speeds.map(|[_, _, bare]| bare),
    })
}

/// How many invocations of a loop fold other words than the CPU's results give.
fn folds(device: &Arc<Device>, timed: &Kernel, expected: &[[u32; 4]]) -> Result<u64> {
    let each = crate::interface::REPEATS as usize;
    let bytes = 16 * u64::from(JUDGED);
    let mut results = Buffer::new(device, bytes, Access::Readback)?;
    timed.repeat(&results, JUDGED)?;
    let got: Vec<[u32; 4]> = results.read(0, bytes, bytemuck::pod_collect_to_vec)?;
    let differs = |(got, words): &(&[u32; 4], &[[u32; 4]])| {
        let folded = words.iter().fold([0; 4], |all: [u32; 4], word| {
            [0, 1, 2, 3].map(|k| all[k] ^ word[k])
        });
        **got != folded
    };
    let pairs = got.iter().zip(expected.chunks_exact(each));
    Ok(pairs.filter(differs).count() as u64)
}
