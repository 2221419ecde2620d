//! Verifies a job, and times it in turn with a fill.

use super::fill::fill;
use super::{Goal, Job, Measurement};
use crate::bulk::Reference;
use crate::catalog::{Engine, Profile, Request};
use crate::kernels::Generator;
use crate::vulkan::Device;
use crate::{Error, Result};
use std::sync::Arc;
use std::time::Instant;

/// Rounds; the median of them is reported. Fill and job take turns.
pub(super) const ROUNDS: usize = 9;

/// Points of the first piece, and of each that is verified.
const PROBE: u64 = 1 << 16;

/// The largest difference of two native results that Vulkan's sine and cosine explain.
const NATIVE: f32 = 2.0 / 1024.0;

/// Measures a job on a device: its device time, into a buffer that is used again.
///
/// # Errors
/// Those of the device, and [`Error::CheckFailed`] where its words are not the reference's.
pub fn on_device(device: &Arc<Device>, job: &Job) -> Result<Measurement> {
    let request = &job.request;
    let begun = Instant::now();
    let mut generator = Generator::new(device, request)?;
    let apart = request.map.as_ref().is_some_and(|m| !m.map().group.fused());
    // Maps in kernels of their own are long: their dispatches stay short by fewer points.
    let most = if apart { 1 << 19 } else { u64::MAX };
    let limit = generator.limit().min(request.count).min(most);
    let probe = limit.min(PROBE);
    generator.dispatch(0, probe)?;
    let cold_s = begun.elapsed().as_secs_f64();
    verify(request, probe, &mut |start, expected, same| {
        generator.dispatch(start, probe)?;
        generator.read(probe, |words| words.iter().zip(expected).all(same))
    })?;
    let kernel = generator.kernel_name();
    let round = &mut |_: &mut [u32]| dispatched(&mut generator, request.count, most);
    timed(job, job.goal, kernel, cold_s, round)
}

/// Device seconds of so many points from the first, up to `most` in a dispatch.
pub(super) fn dispatched(generator: &mut Generator, count: u64, most: u64) -> Result<f64> {
    let limit = generator.limit().min(most);
    let (mut seconds, mut start) = (0.0, 0);
    while start < count {
        let points = limit.min(count - start);
        let timing = generator.dispatch(start, points)?;
        seconds += timing.device_ns.unwrap_or(timing.host_ns) * 1e-9;
        start += points;
    }
    Ok(seconds)
}

/// Measures a job on the CPU, into memory that is used again.
///
/// # Errors
/// [`Error::CheckFailed`] where its words are not those of the definition, row by row.
pub fn on_cpu(job: &Job) -> Result<Measurement> {
    let request = &job.request;
    let width = u64::from(request.words_per_point());
    let probe = request.count.min(PROBE);
    let mut words = vec![0; (probe * width) as usize];
    let begun = Instant::now();
    let mut reference = Reference::new(request);
    reference.fill(0, &mut words)?;
    let cold_s = begun.elapsed().as_secs_f64();
    verify(request, probe, &mut |start, expected, same| {
        reference.fill(start, &mut words)?;
        Ok(words.iter().zip(expected).all(same))
    })?;
    timed(job, job.cpu_goal, "", cold_s, &mut |memory| {
        let begun = Instant::now();
        reference.fill(0, memory)?;
        Ok(begun.elapsed().as_secs_f64())
    })
}

/// Times rounds of a job, in turn with fills of memory that its pages were touched in.
fn timed(
    job: &Job,
    goal: Option<Goal>,
    kernel: &str,
    cold_s: f64,
    round: &mut dyn FnMut(&mut [u32]) -> Result<f64>,
) -> Result<Measurement> {
    let request = &job.request;
    let words = request.count * u64::from(request.words_per_point());
    let mut memory = vec![1u32; words as usize];
    let (mut times, mut fills) = (Vec::new(), Vec::new());
    for number in 0..ROUNDS {
        fills.push(fill(&mut memory, number as u8));
        times.push(round(&mut memory)?);
    }
    let median_s = median(&mut times);
    Ok(Measurement {
        name: job.name.clone(),
        kernel: kernel.to_owned(),
        points: request.count,
        bytes: 4 * words,
        cold_s,
        median_s,
        deviation_s: deviation(&mut times),
        fill_s: median(&mut fills),
        goal,
    })
}

/// Whether a word may stand for another.
type Same<'a> = &'a dyn Fn((&u32, &u32)) -> bool;

/// Whether the words from a point on are these.
type Equal<'a> = &'a mut dyn FnMut(u64, &[u32], Same) -> Result<bool>;

/// Asks `equal` of the first points and the last ones: word for word, in the native profile
/// within what Vulkan allows.
fn verify(request: &Request, points: u64, equal: Equal) -> Result<()> {
    let reference = Reference::new(request);
    let mut expected = vec![0; (points * u64::from(request.words_per_point())) as usize];
    for start in [0, request.count - points] {
        reference.fill_singly(start, &mut expected);
        let same = |(got, want): (&u32, &u32)| match request.profile {
            Profile::Exact => got == want,
            Profile::Native => {
                let (got, want) = (f32::from_bits(*got), f32::from_bits(*want));
                (got - want).abs() <= NATIVE * want.abs().max(1.0)
            }
        };
        if !equal(start, &expected, &same)? {
            return Err(Error::CheckFailed {
                failures: 1,
                total: 1,
            });
        }
    }
    Ok(())
}

/// The median absolute deviation from the median.
pub(super) fn deviation(values: &mut [f64]) -> f64 {
    let middle = median(values);
    let mut away: Vec<f64> = values.iter().map(|value| (value - middle).abs()).collect();
    median(&mut away)
}

pub(super) fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
