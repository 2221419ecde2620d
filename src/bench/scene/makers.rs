//! Ways to make the samples of a scene.

use super::{MOST, ROUNDS, median};
use crate::Result;
use crate::catalog::{Engine, Mapping, Output, Profile, Request};
use crate::interface::task;
use crate::kernels::{Generator, Mapper};
use crate::scene::{Domain, Draw, Needs};
use crate::strip::program::{Program, Sampler};
use crate::vulkan::{Access, Buffer, Device, Timing};
use std::sync::Arc;
use std::time::Instant;

/// Something that makes samples, which stay on the device.
pub(super) trait Maker {
    /// Samples that fit.
    fn limit(&self) -> u64;
    /// Bytes that the device stores for one.
    fn bytes(&self) -> u64;
    /// Makes the first ones.
    fn make(&mut self, count: u32) -> Result<Timing>;
    /// What it took until then.
    fn start(&self) -> Start;
}

/// Host seconds until the first samples of a maker are there.
#[derive(Clone, Copy)]
pub(super) struct Start {
    pub(super) all_s: f64,
    /// Those of them in which the driver made pipelines.
    pub(super) pipelines_s: f64,
}

/// Makes something, and what it needs until its first samples are there.
fn started<M>(device: &Device, make: impl FnOnce() -> Result<M>) -> Result<(M, Start)> {
    let (begun, before) = (Instant::now(), device.pipeline_time());
    let made = make()?;
    let start = Start {
        all_s: begun.elapsed().as_secs_f64(),
        pipelines_s: (device.pipeline_time() - before).as_secs_f64(),
    };
    Ok((made, start))
}

/// Bytes of a buffer of results.
const BYTES: u64 = 1 << 26;

/// What takes longer is timed in three rounds.
const LONG_S: f64 = 0.2;

/// The samples that a start makes.
const FIRST: u32 = 64;

pub(super) struct Stripped {
    sampler: Sampler,
    results: Buffer,
    limit: u64,
    bytes: u64,
    start: Start,
}

impl Stripped {
    pub(super) fn new(device: &Arc<Device>, program: &Program, words: &[u32]) -> Result<Self> {
        let bytes = 4 * u64::from(program.record.words);
        let limit = BYTES / bytes / 64 * 64;
        let make = || {
            let results = Buffer::new(device, program.sample_bytes(limit), Access::Readback)?;
            let sampler = Sampler::new(device, program, words)?;
            sampler.dispatch_any(&results, 0, FIRST)?;
            Ok((sampler, results))
        };
        let ((sampler, results), start) = started(device, make)?;
        Ok(Self {
            sampler,
            results,
            limit,
            bytes,
            start,
        })
    }
}

/// Host seconds from a program's text to its module.
pub(super) fn compiled(program: &Program) -> Result<f64> {
    let text = program.flat(false)?.text;
    let mut times = Vec::new();
    for _ in 0..ROUNDS {
        let begun = Instant::now();
        program.spirv(&text)?;
        times.push(begun.elapsed().as_secs_f64());
    }
    Ok(median(&mut times))
}

/// Host seconds until a pipeline of a program's module has made its first samples, where others
/// have before. A driver that keeps what it compiled does not compile again; Mesa does where
/// `MESA_SHADER_CACHE_DISABLE` is set.
pub(super) fn warm(device: &Arc<Device>, program: &Program, words: &[u32]) -> Result<f64> {
    let first = u64::from(FIRST);
    let results = Buffer::new(device, program.sample_bytes(first), Access::Readback)?;
    let mut times = Vec::new();
    for round in 0..ROUNDS {
        if round >= 3 && times[0] > LONG_S {
            break;
        }
        let begun = Instant::now();
        Sampler::new(device, program, words)?.dispatch_any(&results, 0, FIRST)?;
        times.push(begun.elapsed().as_secs_f64());
    }
    Ok(median(&mut times))
}

impl Maker for Stripped {
    fn limit(&self) -> u64 {
        self.limit
    }

    fn bytes(&self) -> u64 {
        self.bytes
    }

    fn make(&mut self, count: u32) -> Result<Timing> {
        self.sampler.dispatch_any(&self.results, 0, count)
    }

    fn start(&self) -> Start {
        self.start
    }
}

/// A domain's kernel of points, and that of its map.
type Part = (Generator, Option<(Mapper, Buffer)>);

/// The stock kernels of every domain.
pub(super) struct Full {
    parts: Vec<Part>,
    start: Start,
}

impl Full {
    pub(super) fn new(device: &Arc<Device>, needs: &Needs) -> Result<Self> {
        let make = || {
            let mut parts = Vec::new();
            for domain in &needs.domains {
                let request = points_of(needs, domain);
                let generator = Generator::general(device, &request)?;
                let mapped = match domain.draw.mapping() {
                    Some(mapping) => Some(mapper(device, mapping, request.profile)?),
                    None => None,
                };
                parts.push((generator, mapped));
            }
            dispatch(&mut parts, FIRST)?;
            Ok(parts)
        };
        let (parts, start) = started(device, make)?;
        Ok(Self { parts, start })
    }
}

/// Samples of all domains.
fn dispatch(parts: &mut [Part], count: u32) -> Result<Timing> {
    let mut total = Timing {
        device_ns: Some(0.0),
        host_ns: 0.0,
    };
    let mut add = |one: Timing| {
        total.host_ns += one.host_ns;
        total.device_ns = total.device_ns.zip(one.device_ns).map(|(a, b)| a + b);
    };
    for (generator, mapped) in parts {
        add(generator.dispatch(0, count.into())?);
        if let Some((mapper, results)) = mapped {
            add(mapper.dispatch(generator.results(), results, count.into())?);
        }
    }
    Ok(total)
}

fn mapper(device: &Arc<Device>, mapping: &Mapping, profile: Profile) -> Result<(Mapper, Buffer)> {
    let mapper = Mapper::new(device, mapping, true, profile, task::SAMPLE)?;
    Ok((mapper, Buffer::new(device, BYTES, Access::DeviceOnly)?))
}

/// The scene's request of at least [`MOST`] points, of which a renderer has those of many pixels:
/// kernels for few are others, and make no more.
fn many(needs: &Needs) -> Request {
    let mut request = needs.request.clone();
    request.count = request.count.max(MOST);
    request
}

/// The fractions of a domain's points; the floats of one that is a plain number.
fn points_of(needs: &Needs, domain: &Domain) -> Request {
    let mut request = many(needs);
    let columns = request.columns.iter().copied();
    let range = domain.range();
    request.columns = columns
        .skip(range.start as usize)
        .take(range.len())
        .collect();
    request.output = match domain.draw {
        Draw::Between(_) => Output::Floats,
        _ => Output::Fractions,
    };
    request
}

impl Maker for Full {
    fn limit(&self) -> u64 {
        // A sample of a map has four words at most.
        let limits = self.parts.iter().map(|(generator, _)| generator.limit());
        limits.min().unwrap_or(0).min(BYTES / 16)
    }

    fn bytes(&self) -> u64 {
        let words = |(generator, mapped): &Part| {
            let mapped = mapped.as_ref().map_or(0, |(mapper, _)| mapper.words());
            u64::from(generator.words_per_point() + mapped)
        };
        4 * self.parts.iter().map(words).sum::<u64>()
    }

    fn make(&mut self, count: u32) -> Result<Timing> {
        dispatch(&mut self.parts, count)
    }

    fn start(&self) -> Start {
        self.start
    }
}

/// The request of `generate` that makes the same words; `None` where there is none.
pub(super) fn alone(needs: &Needs) -> Option<Request> {
    let mut request = many(needs);
    request.output = Output::Floats;
    match &needs.domains[..] {
        [one] => match &one.draw {
            Draw::Map(mapping) if mapping.map().group.fused() => {
                request.map = Some(mapping.clone());
                request.with_pdf = true;
                Some(request)
            }
            Draw::Between([0.0, 1.0]) => Some(request),
            _ => None,
        },
        all => all
            .iter()
            .all(|one| matches!(one.draw, Draw::Between([0.0, 1.0])))
            .then_some(request),
    }
}

pub(super) struct Baked {
    generator: Generator,
    start: Start,
}

impl Baked {
    pub(super) fn new(device: &Arc<Device>, request: &Request) -> Result<Self> {
        let make = || {
            let mut generator = Generator::new(device, request)?;
            generator.dispatch(0, FIRST.into())?;
            Ok(generator)
        };
        let (generator, start) = started(device, make)?;
        Ok(Self { generator, start })
    }
}

impl Maker for Baked {
    fn limit(&self) -> u64 {
        self.generator.limit()
    }

    fn bytes(&self) -> u64 {
        4 * u64::from(self.generator.words_per_point())
    }

    fn make(&mut self, count: u32) -> Result<Timing> {
        self.generator.dispatch(0, count.into())
    }

    fn start(&self) -> Start {
        self.start
    }
}
