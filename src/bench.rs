//! Speed, as a ratio to a fill of the same bytes in the same run. Verify first, then
//! time: a kernel whose words are not the reference's is not timed.

#[cfg(feature = "scenes")]
pub mod scene;

use crate::bulk::Reference;
use crate::catalog::{Map, Mapping, Options, Profile, Request, Scramble, Sequence};
use crate::kernels::Generator;
use crate::vulkan::Device;
use crate::{Error, Result};
use serde_json::{Value, json};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

/// Words that each job stores: 2^25, 128 MiB, in dispatches that a buffer holds.
const WORDS: u64 = 1 << 25;

/// Rounds; the median of them is reported. Fill and jobs take turns.
const ROUNDS: usize = 9;

/// A measured job.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// What was made.
    pub name: String,
    /// The kernel.
    pub kernel: String,
    /// Points.
    pub points: u64,
    /// Bytes stored.
    pub bytes: u64,
    /// Device time of the first dispatch, which compiles on some drivers, in seconds.
    pub cold_s: f64,
    /// Median device time of all points, in seconds.
    pub median_s: f64,
    /// Median absolute deviation of that time.
    pub deviation_s: f64,
    /// Median time of a fill of the same bytes on all cores of the host.
    pub fill_s: f64,
    /// The goal, where the project has one: a ratio to the fill, at most, or points per
    /// second, at least.
    pub goal: Option<Goal>,
}

/// What a job is to reach.
#[derive(Clone, Copy, Debug)]
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

    /// The measurement as JSON.
    #[must_use]
    pub fn json(&self) -> Value {
        json!({
            "name": self.name,
            "kernel": self.kernel,
            "points": self.points,
            "bytes": self.bytes,
            "cold_s": self.cold_s,
            "median_s": self.median_s,
            "deviation_s": self.deviation_s,
            "fill_s": self.fill_s,
            "times_fill": self.fills(),
            "points_per_s": self.rate(),
            "goal_reached": self.reached(),
        })
    }
}

/// Maps with pdf over Sobol points, in both profiles: labels, name and parameters.
#[rustfmt::skip]
const MAPS: &[(&str, &str, &str, &[f64])] = &[
    ("cone, exact", "cone, native", "cone", &[0.1]),
    ("spherical-triangle, exact", "spherical-triangle, native", "spherical-triangle",
        &[0.0, 0.0, 1.0, 0.5, 0.0, 1.0, 0.0, 0.5, 1.0]),
    ("henyey-greenstein, exact", "henyey-greenstein, native", "henyey-greenstein", &[0.9]),
    ("ggx-vndf, exact", "ggx-vndf, native", "ggx-vndf", &[0.1, 0.0, 0.8, 0.0, 0.6]),
    ("ggx-vndf-bounded, exact", "ggx-vndf-bounded, native", "ggx-vndf-bounded",
        &[0.1, 0.0, 0.8, 0.0, 0.6]),
    ("normal-pair, exact", "normal-pair, native", "normal-pair", &[1.0]),
];

struct Job {
    name: &'static str,
    request: Request,
    goal: Option<Goal>,
}

fn jobs() -> Result<Vec<Job>> {
    let mut jobs = Vec::new();
    let mut add =
        |name, words_per_point: u64, goal, change: &dyn Fn(&mut Options) -> Result<()>| {
            let mut options = Options::new(Sequence::Halton, WORDS / words_per_point);
            change(&mut options)?;
            jobs.push(Job {
                name,
                request: Request::new(&options)?,
                goal,
            });
            Ok::<(), Error>(())
        };
    add("van der Corput", 1, None, &|o| {
        o.sequence = Sequence::VanDerCorput;
        Ok(())
    })?;
    add("Halton d=2", 2, Some(Goal::Fill(6.0)), &|_| Ok(()))?;
    add("Halton d=4", 4, None, &|o| {
        o.dimensions = Some(4);
        Ok(())
    })?;
    add("Halton d=8", 8, None, &|o| {
        o.dimensions = Some(8);
        Ok(())
    })?;
    add("Hammersley d=2", 2, None, &|o| {
        o.sequence = Sequence::Hammersley;
        Ok(())
    })?;
    for (name, scramble, dimensions) in [
        ("Sobol d=2", Scramble::None, 2),
        ("Sobol d=8", Scramble::None, 8),
        ("Sobol d=2, hash-scrambled", Scramble::OwenHash, 2),
        ("Sobol d=2, Owen-scrambled", Scramble::Owen, 2),
    ] {
        add(name, dimensions, None, &|o| {
            o.sequence = Sequence::Sobol;
            o.dimensions = Some(dimensions);
            o.scramble = Some(scramble);
            Ok(())
        })?;
    }
    for (name, sequence, dimensions) in [
        ("random d=4", Sequence::Random, 4),
        ("random-fast d=4", Sequence::RandomFast, 4),
        ("R2 d=2", Sequence::R2, 2),
    ] {
        add(name, dimensions, None, &|o| {
            o.sequence = sequence;
            o.dimensions = Some(dimensions);
            Ok(())
        })?;
    }
    let map = |o: &mut Options, name: &str, profile| {
        o.map = Some(Mapping::new(Map::from_name(name)?, &[])?);
        o.profile = profile;
        Ok(())
    };
    add("cosine polar, exact", 3, Some(Goal::Rate(0.15e9)), &|o| {
        map(o, "cosine-hemisphere-polar", Profile::Exact)
    })?;
    add("cosine concentric, exact", 3, None, &|o| {
        map(o, "cosine-hemisphere", Profile::Exact)
    })?;
    add("cosine polar, native", 3, None, &|o| {
        map(o, "cosine-hemisphere-polar", Profile::Native)
    })?;
    for &(exact, native, name, values) in MAPS {
        for (label, profile) in [(exact, Profile::Exact), (native, Profile::Native)] {
            add(label, 16, None, &|o| {
                o.sequence = Sequence::Sobol;
                o.dimensions = Some(2);
                o.map = Some(Mapping::with_values(Map::from_name(name)?, values)?);
                o.with_pdf = true;
                o.profile = profile;
                Ok(())
            })?;
        }
    }
    Ok(jobs)
}

/// Verifies and measures every job.
///
/// # Errors
/// Those of the device, and [`Error::CheckFailed`] for a kernel that is not exact.
pub fn run(device: &Arc<Device>, progress: &mut dyn FnMut(&str)) -> Result<Vec<Measurement>> {
    let mut results = Vec::new();
    for job in jobs()? {
        progress(job.name);
        results.push(measure(device, &job)?);
    }
    Ok(results)
}

fn measure(device: &Arc<Device>, job: &Job) -> Result<Measurement> {
    let request = &job.request;
    let mut generator = Generator::new(device, request)?;
    let apart = request.map.as_ref().is_some_and(|m| !m.map().group.fused());
    // Maps in kernels of their own are long: their dispatches stay short by fewer points.
    let most = if apart { 1 << 19 } else { u64::MAX };
    let limit = generator.limit().min(request.count).min(most);
    let probe = limit.min(1 << 16);
    let cold = generator.dispatch(0, probe)?;
    verify(&mut generator, request, probe)?;
    let bytes = request.count * 4 * u64::from(request.words_per_point());
    let mut memory = vec![1u8; bytes as usize];
    let (mut times, mut fills) = (Vec::new(), Vec::new());
    for round in 0..ROUNDS {
        fills.push(fill(&mut memory, round as u8));
        let mut seconds = 0.0;
        let mut start = 0;
        while start < request.count {
            let points = limit.min(request.count - start);
            let timing = generator.dispatch(start, points)?;
            seconds += timing.device_ns.unwrap_or(timing.host_ns) * 1e-9;
            start += points;
        }
        times.push(seconds);
    }
    let median_s = median(&mut times);
    let mut away: Vec<f64> = times.iter().map(|t| (t - median_s).abs()).collect();
    Ok(Measurement {
        name: job.name.to_owned(),
        kernel: generator.kernel_name().to_owned(),
        points: request.count,
        bytes,
        cold_s: cold.device_ns.unwrap_or(cold.host_ns) * 1e-9,
        median_s,
        deviation_s: median(&mut away),
        fill_s: median(&mut fills),
        goal: job.goal,
    })
}

/// The largest difference of two native results that Vulkan's sine and cosine explain.
const NATIVE: f32 = 2.0 / 1024.0;

/// The first points and the last ones: word for word, in the native profile within what
/// Vulkan allows.
fn verify(generator: &mut Generator, request: &Request, points: u64) -> Result<()> {
    let reference = Reference::new(request);
    let mut expected = vec![0; (points * u64::from(request.words_per_point())) as usize];
    for start in [0, request.count - points] {
        generator.dispatch(start, points)?;
        reference.fill_singly(start, &mut expected);
        let same = |(got, want): (&u32, &u32)| match request.profile {
            Profile::Exact => got == want,
            Profile::Native => {
                let (got, want) = (f32::from_bits(*got), f32::from_bits(*want));
                (got - want).abs() <= NATIVE * want.abs().max(1.0)
            }
        };
        if !generator.read(points, |words| words.iter().zip(&expected).all(same))? {
            return Err(Error::CheckFailed {
                failures: 1,
                total: 1,
            });
        }
    }
    Ok(())
}

/// Seconds to fill memory whose pages were touched before, with all cores.
fn fill(memory: &mut [u8], value: u8) -> f64 {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let share = memory.len().div_ceil(threads);
    let start = Instant::now();
    std::thread::scope(|scope| {
        for part in memory.chunks_mut(share) {
            scope.spawn(move || black_box(part).fill(value));
        }
    });
    start.elapsed().as_secs_f64()
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
