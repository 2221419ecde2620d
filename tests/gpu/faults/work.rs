//! What is asked of a device, and the CPU's answers.

use std::sync::{Arc, OnceLock};

use corput::bulk::{self, Reference};
use corput::catalog::{Engine, Map, Mapping, Options, Problem, Request, Sequence};
use corput::check;
use corput::estimate::Estimate;
use corput::kernels::{Estimator, Generator};
use corput::vulkan::{Access, Buffer, Device, DeviceInfo, Instance, InstanceOptions, Timing};
use corput::{Error, Result};

use super::loader::entry;
use super::plan::{Lie, Session};
use super::support;

/// Several dispatches of points, and several of sums.
const POINTS: u64 = 100_003;

/// Of a map, whose kernel takes its input from another's.
const SAMPLES: u64 = 10_001;

/// What there is to know of a problem and its points.
fn integral() -> (Problem, Request) {
    let problem = Problem::parse("x-squared").expect("a problem");
    let mut options = Options::new(Sequence::Sobol, POINTS);
    options.dimensions = Some(problem.dimensions().into());
    options.fractions = true;
    (problem, Request::new(&options).expect("a request"))
}

/// What there is to know of the points.
pub fn points() -> Request {
    Request::new(&Options::new(Sequence::Halton, POINTS)).expect("a request")
}

/// The same of the samples.
pub fn samples() -> Request {
    let mut options = Options::new(Sequence::Halton, SAMPLES);
    let map = Map::from_name("cone").expect("a map");
    options.map = Some(Mapping::new(map, &[("theta_max", &[0.5])]).expect("a mapping"));
    Request::new(&options).expect("a request")
}

/// All words of a request.
pub fn reference(request: &Request) -> Vec<u32> {
    let mut words = vec![0; (request.count * u64::from(request.words_per_point())) as usize];
    Reference::new(request).fill(0, &mut words).unwrap();
    words
}

/// The words that a generator makes.
pub fn made(generator: &mut Generator, count: u64) -> Result<Vec<u32>> {
    let mut words = Vec::new();
    generator.make(0, count, &mut |part| {
        words.extend_from_slice(part);
        Ok(())
    })?;
    Ok(words)
}

/// A generator of points, and how many.
pub fn generator(device: &Arc<Device>) -> Result<(Generator, u64)> {
    Ok((Generator::new(device, &points())?, POINTS))
}

/// An estimator and how many points it sums.
pub fn estimator(device: &Arc<Device>) -> Result<(Estimator, u64)> {
    let (problem, request) = integral();
    Ok((Estimator::new(device, &problem, &request)?, POINTS))
}

/// Generates points. Equal to the CPU's, or an error.
pub fn generate(device: &Arc<Device>) -> Result<()> {
    static TRUTH: OnceLock<Vec<u32>> = OnceLock::new();
    let (mut generator, count) = generator(device)?;
    let words = made(&mut generator, count)?;
    assert!(
        words == *TRUTH.get_or_init(|| reference(&points())),
        "wrong points"
    );
    Ok(())
}

/// Generates points and maps them.
pub fn map(device: &Arc<Device>) -> Result<()> {
    static TRUTH: OnceLock<Vec<u32>> = OnceLock::new();
    let request = samples();
    let words = made(&mut Generator::new(device, &request)?, SAMPLES)?;
    assert!(
        words == *TRUTH.get_or_init(|| reference(&request)),
        "wrong samples"
    );
    Ok(())
}

/// Whether these sums are the CPU's.
pub fn is_the_sum(sum: &Estimate) -> bool {
    static TRUTH: OnceLock<Estimate> = OnceLock::new();
    let (problem, request) = integral();
    let truth = || bulk::estimate(&problem, &request, 0, POINTS).expect("sums");
    sum == TRUTH.get_or_init(truth)
}

/// Sums an integrand.
pub fn estimate(device: &Arc<Device>) -> Result<()> {
    let (mut estimator, count) = estimator(device)?;
    let (sum, _) = estimator.run(0, count, &mut |_| Ok(()))?;
    assert!(is_the_sum(&sum), "wrong sums");
    Ok(())
}

/// The same sums so many times, some of them in batches.
pub fn summed(device: &Arc<Device>, times: usize) -> Result<Vec<(Estimate, Timing)>> {
    let (problem, request) = integral();
    let mut estimator = Estimator::new(device, &problem, &request)?;
    estimator.run_each(&vec![request; times], &mut |_| Ok(()))
}

/// Sums an integrand several times.
pub fn estimates(device: &Arc<Device>) -> Result<()> {
    let sums = summed(device, 7)?;
    assert!(sums.iter().all(|(sum, _)| is_the_sum(sum)), "wrong sums");
    Ok(())
}

/// Checks some rows.
pub fn check(device: &Arc<Device>) -> Result<()> {
    let options = check::Options {
        only: Some("unit_stratum".into()),
        time: None,
    };
    let outcome = check::run(device, &options, &mut |_| ())?;
    assert!(!outcome.rows.is_empty() && outcome.left_out.is_empty());
    outcome.result()
}

/// A clock that stands still: chunks of work grow as fast as they may, and runs are alike.
pub const STILL: Lie = Lie::Properties(|said| said.limits.timestamp_period = 0.0);

/// A piece of work.
pub type Work = fn(&Arc<Device>) -> Result<()>;

/// All of it, by name.
pub const ALL: [(&str, Work); 5] = [
    ("generate", generate),
    ("map", map),
    ("estimate", estimate),
    ("estimates", estimates),
    ("check", check),
];

/// Everything that the device is for.
pub fn everything(device: &Arc<Device>) -> Result<()> {
    ALL.iter().try_for_each(|(_, work)| work(device))
}

/// An instance by the wrapped loader.
pub fn instance() -> Result<Arc<Instance>> {
    let validation = support::validates();
    // SAFETY: the wrapped loader does what the system's does, or says that it failed.
    unsafe { Instance::with_entry(entry(), &InstanceOptions { validation }) }
}

/// Calls `test` with every device present. What it leaves undestroyed, and what the validation
/// layer says, are failures.
pub fn on_each(test: impl Fn(&Session, &Arc<Instance>, &DeviceInfo)) {
    visit(false, test);
}

/// The same where a wait is given up, after which nothing may be destroyed.
pub fn on_each_that_hangs(test: impl Fn(&Session, &Arc<Instance>, &DeviceInfo)) {
    visit(true, test);
}

fn visit(hangs: bool, test: impl Fn(&Session, &Arc<Instance>, &DeviceInfo)) {
    if support::skips() {
        return;
    }
    let session = Session::begin();
    let instance = instance().unwrap_or_else(|error| panic!("{error}"));
    let devices = instance.devices().expect("a list of devices");
    assert!(!devices.is_empty(), "no device is listed");
    for info in &devices {
        println!("on {}: {}", info.index, info.name);
        session.heal();
        let before = session.live();
        test(&session, &instance, info);
        session.heal();
        if !hangs {
            assert_eq!(session.live(), before, "objects are left of {}", info.name);
        }
        let said = instance.take_validation_messages();
        assert!(said.is_empty(), "validation on {}: {said:#?}", info.name);
        // A fault leaves nothing behind for the next.
        let device = Device::open(&instance, info).expect("a fresh device");
        counts(&device);
    }
    drop(instance);
    assert!(hangs || session.live() == 0, "the instance is left");
}

/// The least work: a shader that writes its numbers.
fn counts(device: &Arc<Device>) {
    static WORDS: OnceLock<Vec<u32>> = OnceLock::new();
    let out = "layout(std430, binding = 0) buffer Out { uint o[]; };";
    let words = WORDS.get_or_init(|| support::shader(out, "o[i] = i;"));
    let pipeline = support::pipeline(device, words, &[0], 0);
    let mut buffer = Buffer::new(device, 4096, Access::Readback).expect("a buffer");
    device
        .run(&pipeline, &[(0, &buffer)], &[], 16)
        .expect("a run");
    let got = buffer.read(0, 4096, support::words).expect("words");
    assert!((0..1024).eq(got), "a fresh device counts wrongly");
}

/// Whether it is the error of this call, with a code and what to do.
pub fn assert_failed(error: &Error, called: &str, code: &str, remedy: &str) {
    match error {
        Error::Vulkan { call, result } => assert_eq!((*call, result.as_str()), (called, code)),
        _ => panic!("{called}: {code} became {error}"),
    }
    assert_eq!(error.exit_code(), 4);
    let text = error.to_string();
    let begin = format!("{called} failed: {code}; ");
    assert!(text.starts_with(&begin) && text.contains(remedy), "{text}");
}
