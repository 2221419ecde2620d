//! The cases on a device: words that must be the reference's, and errors of both profiles.

use super::{Case, Subject};
use crate::catalog::{FUNCTIONS, Mapping, Profile};
use crate::check::{ELEMENTARY, function_words};
use crate::interface::task;
use crate::kernels::{Elementary, Evaluator, Mapper};
use crate::vulkan::Device;
use crate::{Error, Result};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a device gave for a case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Given {
    /// The words of the exact profile; none of a case of the host.
    pub exact: Option<Vec<u32>>,
    /// Those of the native profile, where it has that function or map.
    pub native: Option<Vec<u32>>,
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
        let failure = failure(&case, given.exact.as_deref());
        Self {
            case,
            device,
            native,
            failure,
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
        case,
    };
    Ok(super::cases()?.into_iter().map(row).collect())
}

/// All cases on a device. The device keeps the pipelines until it is dropped.
///
/// # Errors
/// Those of the device.
pub fn run(device: &Arc<Device>) -> Result<Vec<Row>> {
    device.keep_pipelines();
    let cases = super::cases()?;
    // The cases of a function, or of a map, share a kernel.
    let mut groups = BTreeMap::<&str, Vec<usize>>::new();
    for (index, case) in cases.iter().enumerate() {
        groups.entry(case.subject.name()).or_default().push(index);
    }
    let mut given = vec![Given::default(); cases.len()];
    for indices in groups.values() {
        let some: Vec<&Case> = indices.iter().filter_map(|&i| cases.get(i)).collect();
        for (&index, made) in indices.iter().zip(of_group(device, &some)?) {
            if let Some(place) = given.get_mut(index) {
                *place = made;
            }
        }
    }
    let rows = cases.into_iter().zip(&given);
    Ok(rows.map(|(case, given)| Row::judged(case, given)).collect())
}

/// What a device gives for cases of one subject.
fn of_group(device: &Arc<Device>, cases: &[&Case]) -> Result<Vec<Given>> {
    let mut calls = Vec::new();
    let mut samples = Vec::new();
    for case in cases {
        match &case.subject {
            Subject::Host => {}
            Subject::Function { call, .. } => calls.push(*call),
            Subject::Map { mapping, u } => samples.push((mapping.as_ref(), *u)),
        }
    }
    match cases.first().map(|case| &case.subject) {
        Some(Subject::Function { name, .. }) => {
            let exact = evaluated(device, name, &calls)?.into_iter().map(Some);
            let native = native(device, name, &calls)?.into_iter();
            let pairs = exact.zip(native.map(Some).chain(std::iter::repeat(None)));
            Ok(pairs
                .map(|(exact, native)| Given { exact, native })
                .collect())
        }
        Some(Subject::Map { .. }) => {
            let exact = sampled(device, &samples, Profile::Exact)?.into_iter();
            let native = sampled(device, &samples, Profile::Native)?.into_iter();
            let both = |(exact, native)| Given {
                exact: Some(exact),
                native: Some(native),
            };
            Ok(exact.zip(native).map(both).collect())
        }
        _ => Ok(vec![Given::default(); cases.len()]),
    }
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
