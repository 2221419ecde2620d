//! Kernels of scenes: their samples are those of the reference, word for word, on every
//! driver.

#[path = "program/corpus.rs"]
mod corpus;
mod support;

use corpus::{Case, every_map, files, samplers};
use corput::bulk::SceneReference;
use corput::catalog::Profile;
use corput::strip::program::{Options, Parameters, Program, Sampler, program};
use corput::vulkan::Device;
use std::sync::Arc;
use support::{at_once, on_each_device, skips};

/// Samples at either end of the indices; no whole number of runs.
const COUNT: u32 = 777;

fn made(case: &Case, options: Options) -> (Program, Vec<u32>) {
    let program = program(&case.name, &case.needs, options)
        .unwrap_or_else(|error| panic!("{}: {error}", case.name));
    let flat = program
        .flat(false)
        .unwrap_or_else(|error| panic!("{}: {error}\n{}", case.name, program.source));
    let words = program
        .spirv(&flat.text)
        .unwrap_or_else(|error| panic!("{}: {error}\n{}", case.name, flat.text));
    (program, words)
}

/// The first sample that differs: its index, word, and both values.
fn difference(device: &Arc<Device>, case: &Case, options: Options) -> Option<String> {
    let (program, words) = made(case, options);
    let sampler = Sampler::new(device, &program, &words).unwrap();
    let reference = SceneReference::new(&case.needs).unwrap();
    let samples = case.needs.request.count;
    let count = COUNT.min(u32::try_from(samples).unwrap_or(COUNT));
    let last = (samples - u64::from(count)) as u32;
    for first in [0, last] {
        let got = sampler.run(first, count).unwrap();
        let mut want = vec![0; got.len()];
        reference.fill(first, &mut want);
        let stride = program.record.words as usize;
        let differ = got.iter().zip(&want).position(|(got, want)| got != want);
        if let Some(at) = differ {
            let (n, word) = (first as usize + at / stride, at % stride);
            return Some(format!(
                "{}: word {word} of sample {n} is {:#x}, not {:#x}",
                case.name, got[at], want[at]
            ));
        }
    }
    None
}

fn all_equal(cases: &[Case], options: &[Options]) {
    on_each_device(|device| {
        at_once(cases, |case| {
            for options in options {
                let found = difference(device, case, *options);
                assert_eq!(found, None, "{options:?}");
            }
        });
    });
}

const LONG: Options = Options {
    parameters: Parameters::Push,
    cpu: true,
};
const UNIFORM: Options = Options {
    parameters: Parameters::Uniform,
    cpu: false,
};

#[test]
fn every_sampler_is_that_of_the_reference() {
    if skips() {
        return;
    }
    let cases = samplers();
    assert!(cases.len() > 60, "{}", cases.len());
    all_equal(&cases, &[LONG, UNIFORM]);
}

#[test]
fn every_map_is_that_of_the_reference() {
    if skips() {
        return;
    }
    all_equal(&every_map(Profile::Exact), &[LONG]);
}

#[test]
fn the_scenes_are_those_of_the_reference() {
    if skips() {
        return;
    }
    let exact: Vec<Case> = files()
        .into_iter()
        .filter(|case| case.needs.request.profile == Profile::Exact)
        .collect();
    assert!(exact.len() >= 8);
    all_equal(&exact, &[LONG]);
}
