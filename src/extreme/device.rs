//! The cases on a device: words that must be the reference's, and errors of both profiles.

use super::words::{estimate_words, float_sum_words};
use super::{Case, Subject};
use crate::catalog::{FUNCTIONS, Function, Mapping, Problem, Profile, Request, Tier};
use crate::check::{ELEMENTARY, Further, function_words, no_time};
use crate::interface::task;
use crate::kernels::{
    Elementary, Estimator, Evaluator, Mapper, Reducer, Split, largest_group, probe,
};
use crate::vulkan::Device;
use crate::{Error, Result};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// What a device gave for a case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Given {
    /// The words of the exact profile; none of a case of the host.
    pub exact: Option<Vec<u32>>,
    /// Those of the native profile, where it has that function or map.
    pub native: Option<Vec<u32>>,
    /// Why the device was not asked, if so.
    pub refused: Option<String>,
}

/// A case with its verdict.
#[derive(Clone, Debug)]
pub struct Row {
    /// The case.
    pub case: Case,
    /// The error of the device in the exact profile; `None` of a case of the host.
    pub device: Option<f64>,
    /// The same in the native profile: what the device's own functions come to. It has no bound
    /// here, and no part in the verdict.
    pub native: Option<f64>,
    /// Why the case failed; `None` if it passed.
    pub failure: Option<String>,
    /// Why this device was not asked, where the case does not apply to it.
    pub refused: Option<String>,
}

impl Row {
    /// Judges a case: both errors must be within the bound, and the device's words those of the
    /// reference.
    #[must_use]
    pub fn judged(case: Case, given: &Given) -> Self {
        let error = |words: &Vec<u32>| case.error(words);
        let device = given.exact.as_ref().map(error);
        // Native functions have fewer words than kernels of several functions.
        let read = case.reading.first + case.truth.values.len();
        let native = given.native.as_ref().filter(|words| words.len() >= read);
        let native = native.map(error);
        let failure = match given.refused {
            Some(_) => of_cpu(&case),
            None => failure(&case, given.exact.as_deref()),
        };
        Self {
            case,
            device,
            native,
            failure,
            refused: given.refused.clone(),
        }
    }

    /// `passed`, `failed`, or `refused` where the device was not asked.
    #[must_use]
    pub fn verdict(&self) -> &'static str {
        match (&self.failure, &self.refused) {
            (Some(_), _) => "failed",
            (None, Some(_)) => "refused",
            (None, None) => "passed",
        }
    }

    /// The row as a case of JUnit's.
    #[must_use]
    pub fn further(&self) -> Further {
        Further {
            class: "extreme inputs",
            name: format!("{} {}", self.case.number, self.case.input),
            failure: self.failure.clone(),
            skipped: self.refused.clone().filter(|_| self.failure.is_none()),
        }
    }
}

/// Why the CPU fails a case, if it does; a NaN is within no bound.
fn of_cpu(case: &Case) -> Option<String> {
    let (ours, bound) = (case.ours, case.bound);
    let within = ours <= bound;
    (!within).then(|| format!("the CPU errs by {ours:e}, not {bound:e}"))
}

/// Why a case fails on a device, if it does.
fn failure(case: &Case, words: Option<&[u32]>) -> Option<String> {
    let bound = case.bound;
    if let Some(why) = of_cpu(case) {
        return Some(why);
    }
    let expected = case.subject.reference()?;
    let Some(words) = words else {
        return Some("the device gave nothing".into());
    };
    if words.is_empty() || expected.get(..words.len()) != Some(words) {
        return Some(format!(
            "the device gave {words:08x?}, the CPU {expected:08x?}"
        ));
    }
    let error = case.error(words);
    let within = error <= bound;
    (!within).then(|| format!("the device errs by {error:e}, not {bound:e}"))
}

/// All cases on the CPU alone, where the only verdict is that of its errors.
///
/// # Errors
/// Those of [`cases`](super::cases).
pub fn run_on_cpu() -> Result<Vec<Row>> {
    let row = |case: Case| Row {
        device: None,
        native: None,
        failure: of_cpu(&case),
        refused: None,
        case,
    };
    Ok(super::cases()?.into_iter().map(row).collect())
}

/// All cases on a device. The device keeps the pipelines until it is dropped.
///
/// # Errors
/// Those of the device.
pub fn run(device: &Arc<Device>) -> Result<Vec<Row>> {
    Ok(run_within(device, None)?.0)
}

/// The same, but begins no kernel after so long: the rows, and the cases that were left out.
///
/// # Errors
/// Those of the device, and [`Error::Arguments`] where there was no time for any.
pub fn run_within(device: &Arc<Device>, time: Option<Duration>) -> Result<(Vec<Row>, Vec<String>)> {
    device.keep_pipelines();
    let exact_floats = probe(device)?.tier_f();
    let cases = super::cases()?;
    let begun = Instant::now();
    // The cases of a function, a map or an integrand share a kernel.
    let mut groups = BTreeMap::<&str, Vec<usize>>::new();
    for (index, case) in cases.iter().enumerate() {
        groups.entry(case.subject.name()).or_default().push(index);
    }
    let mut given = vec![None; cases.len()];
    for indices in groups.values() {
        if time.is_some_and(|time| begun.elapsed() >= time) {
            break;
        }
        let some: Vec<&Case> = indices.iter().filter_map(|&i| cases.get(i)).collect();
        let made = match refusal(&some, exact_floats) {
            Some(why) => vec![why; some.len()],
            None => of_group(device, &some)?,
        };
        for (&index, made) in indices.iter().zip(made) {
            if let Some(place) = given.get_mut(index) {
                *place = Some(made);
            }
        }
    }
    let (mut rows, mut left_out) = (Vec::new(), Vec::new());
    for (case, given) in cases.into_iter().zip(given) {
        match given {
            Some(given) => rows.push(Row::judged(case, &given)),
            None => left_out.push(format!("{} {}", case.number, case.input)),
        }
    }
    if rows.is_empty() {
        return Err(no_time(time));
    }
    Ok((rows, left_out))
}

/// What is said of cases of one subject, if the device's floats are not such that it can be asked.
fn refusal(cases: &[&Case], exact_floats: bool) -> Option<Given> {
    let Subject::Function { name, .. } = &cases.first()?.subject else {
        return None;
    };
    let of_floats = |function: &&Function| function.name == *name && function.tier == Tier::Float;
    let inexact = !exact_floats && FUNCTIONS.iter().any(|function| of_floats(&function));
    inexact.then(|| Given {
        refused: Some("the probe does not find rounding to nearest even".into()),
        ..Given::default()
    })
}

/// What a device gives for cases of one subject.
fn of_group(device: &Arc<Device>, cases: &[&Case]) -> Result<Vec<Given>> {
    let mut calls = Vec::new();
    let mut samples = Vec::new();
    let mut sums: Vec<Given> = Vec::new();
    let mut last: Option<(&Arc<Request>, Given)> = None;
    for case in cases {
        match &case.subject {
            Subject::Host => {}
            Subject::Function { call, .. } => calls.push(*call),
            Subject::Map { mapping, u } => samples.push((mapping.as_ref(), *u)),
            Subject::Estimate { problem, request } => {
                // One estimate is read in several ways.
                let same = last.take().filter(|(one, _)| Arc::ptr_eq(one, request));
                let given = match same {
                    Some((_, given)) => given,
                    None => estimated(device, problem, request)?,
                };
                sums.push(given.clone());
                last = Some((request, given));
            }
            Subject::Sum { terms, group } => sums.push(summed(device, terms, *group)?),
        }
    }
    match cases.first().map(|case| &case.subject) {
        Some(Subject::Function { name, .. }) => {
            let exact = evaluated(device, name, &calls)?.into_iter().map(Some);
            let native = native(device, name, &calls)?.into_iter();
            let pairs = exact.zip(native.map(Some).chain(std::iter::repeat(None)));
            Ok(pairs
                .map(|(exact, native)| Given {
                    exact,
                    native,
                    refused: None,
                })
                .collect())
        }
        Some(Subject::Map { .. }) => {
            let exact = sampled(device, &samples, Profile::Exact)?.into_iter();
            let native = sampled(device, &samples, Profile::Native)?.into_iter();
            let both = |(exact, native)| Given {
                exact: Some(exact),
                native: Some(native),
                refused: None,
            };
            Ok(exact.zip(native).map(both).collect())
        }
        Some(Subject::Estimate { .. } | Subject::Sum { .. }) => Ok(sums),
        _ => Ok(vec![Given::default(); cases.len()]),
    }
}

fn estimated(device: &Arc<Device>, problem: &Problem, request: &Request) -> Result<Given> {
    let mut estimator = Estimator::new(device, problem, request)?;
    let (sum, _) = estimator.run(0, request.count, &mut |_| Ok(()))?;
    Ok(Given {
        exact: Some(estimate_words(&sum)),
        ..Given::default()
    })
}

/// In groups of that size, and split into dispatches that end in the middle of a run.
fn summed(device: &Arc<Device>, terms: &[f32], group: u32) -> Result<Given> {
    let largest = largest_group(device);
    if group > largest {
        return Ok(Given {
            refused: Some(format!("this device runs groups of {largest} at most")),
            ..Given::default()
        });
    }
    let reducer = Reducer::with_group(device, group)?;
    let split = Split {
        dispatch: terms.len() / 3 + 1,
        run: 100,
    };
    Ok(Given {
        exact: Some(float_sum_words(&reducer.reduce_in(terms, split)?)),
        ..Given::default()
    })
}

fn evaluated(device: &Arc<Device>, name: &str, calls: &[[u32; 4]]) -> Result<Vec<Vec<u32>>> {
    let known: Vec<&str> = FUNCTIONS.iter().map(|function| function.name).collect();
    let function = FUNCTIONS.iter().find(|function| function.name == name);
    let function = function.ok_or_else(|| Error::unknown_name("function", name, &known))?;
    let results = Evaluator::new(device, function.kernel, function.id)?.run(calls)?;
    Ok(results.into_iter().map(|row| row.to_vec()).collect())
}

/// Results of the native profile, if it has this function of these very arguments: both
/// profiles' reference must say the same.
fn native(device: &Arc<Device>, name: &str, calls: &[[u32; 4]]) -> Result<Vec<Vec<u32>>> {
    let Some(function) = ELEMENTARY.iter().find(|one| one.name == name) else {
        return Ok(Vec::new());
    };
    let same = |&[x, y, z, w]: &[u32; 4]| {
        let exact = function_words(name, [x, y, z, w]);
        function.reference([x, y, z]).get(..function.width) == exact.get(..function.width)
    };
    if !calls.iter().all(same) {
        return Ok(Vec::new());
    }
    let kernel = Elementary::new(device, function.id, Profile::Native, task::SAMPLE)?;
    let rows = kernel.run(calls)?.into_iter();
    Ok(rows
        .map(|row| row.into_iter().take(function.width).collect())
        .collect())
}

fn sampled(
    device: &Arc<Device>,
    samples: &[(&Mapping, [u32; 2])],
    profile: Profile,
) -> Result<Vec<Vec<u32>>> {
    let Some((first, _)) = samples.first() else {
        return Ok(Vec::new());
    };
    let mut mapper = Mapper::new(device, first, true, profile, task::SAMPLE)?;
    let mut made = Vec::with_capacity(samples.len());
    for (mapping, u) in samples {
        mapper.set(mapping)?;
        made.push(mapper.run(u)?.0);
    }
    Ok(made)
}
