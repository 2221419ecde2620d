//! A scene's own kernel against the stock ones that draw the same: what is left out, and what
//! that saves. Verified first, then timed.

mod makers;
mod report;

pub use report::{document, page, rows};

use super::{Fills, ROUNDS, deviation, median};
use crate::bulk::SceneReference;
use crate::catalog::Profile;
use crate::interface::FAMILIES;
use crate::kernels::spirv;
use crate::scene::Needs;
use crate::strip::program::{Options, Parameters, Program, Sampler, program};
use crate::strip::{Measure, measure};
use crate::variant::{Plan, Work, general};
use crate::vulkan::{Device, DeviceKind, Timing};
use crate::{Error, Result};
use makers::{Baked, Full, Maker, Stripped, alone, compiled, warm};
use std::sync::Arc;

/// Modules, and the buffers that they read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Size {
    /// The modules' names.
    pub kernels: Vec<String>,
    /// All of their parts together.
    pub modules: Measure,
    /// Buffers and other resources that are bound.
    pub resources: usize,
    /// Bytes of the tables in buffers.
    pub buffer_bytes: u64,
}

/// Times of one way to make samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speed {
    /// Host seconds in which the driver made its pipelines. Some put compiling off.
    pub pipelines_s: f64,
    /// Host seconds until the first 64 samples are there: pipelines are made, and drivers that
    /// compile when they must have done so.
    pub start_s: f64,
    /// Samples of each round.
    pub samples: u32,
    /// Median device seconds of a round.
    pub median_s: f64,
    /// Median absolute deviation of that time.
    pub deviation_s: f64,
    /// Bytes that the device stores in a round.
    pub bytes: u64,
    /// Median seconds of a fill of as many on all cores of the host.
    pub fill_s: f64,
}

/// Times of a scene's samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Speeds {
    /// By the stock kernels, chosen at run time: of each domain its points, by the general kernel
    /// of the sampler's family, and then its map. Numbers with ends and choices are not drawn.
    pub full: Speed,
    /// By the scene's own.
    pub stripped: Speed,
    /// By the kernel of tiles whose constants `corput generate` bakes, which makes bare points
    /// and some maps of points alone.
    pub baked: Option<Speed>,
    /// Median host seconds from the scene's text to its checked module, in a process that has
    /// compiled before: [`COMPILED_S`] at most are the project's goal.
    pub compile_s: f64,
    /// Median host seconds until the scene's own pipeline has its first 64 samples, made once more
    /// in a process that made it before.
    pub warm_s: f64,
}

/// What [`Speeds::compile_s`] is to be at most.
pub const COMPILED_S: f64 = 0.010;

/// A scene's kernel, and what it is compared with.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The scene's name.
    pub name: String,
    /// The stock kernels.
    pub full: Size,
    /// Bytes of the stock modules where the sampler too is chosen at run time: the general
    /// kernels of all families, and the same maps.
    pub any_bytes: usize,
    /// The scene's own.
    pub stripped: Size,
    /// Times, where there is a device.
    pub speeds: Option<Speeds>,
}

/// Sizes of a scene's kernel, in its module, and of the stock ones.
///
/// # Errors
/// [`Error::Shader`] for words that are no module.
pub fn sizes(needs: &Needs, program: &Program, words: &[u32]) -> Result<Comparison> {
    let full = full_size(needs)?;
    let own = spirv(stock_points(needs).kernel.name)?;
    let mut any_bytes = full.modules.bytes - 4 * own.len();
    for family in FAMILIES {
        any_bytes += 4 * spirv(&format!("generate{}", family.suffix()))?.len();
    }
    Ok(Comparison {
        name: program.name.clone(),
        full,
        any_bytes,
        stripped: stripped_size(program, words)?,
        speeds: None,
    })
}

/// The same with times on a device, after [`verify`].
///
/// # Errors
/// Those of [`verify`] and of the device.
pub fn compare(
    device: &Arc<Device>,
    needs: &Needs,
    program: &Program,
    words: &[u32],
) -> Result<Comparison> {
    verify(device, needs, program, words)?;
    let mut stripped = Stripped::new(device, program, words)?;
    let mut full = Full::new(device, needs)?;
    let mut baked = match alone(needs) {
        Some(request) => Some(Baked::new(device, &request)?),
        None => None,
    };
    let again = Again {
        compile_s: compiled(program)?,
        warm_s: warm(device, program, words)?,
    };
    Ok(Comparison {
        speeds: Some(speeds(&mut full, &mut stripped, baked.as_mut(), again)?),
        ..sizes(needs, program, words)?
    })
}

/// A scene's program and module in the form that a device likes: on CPUs long runs, and wide
/// stores where it has integers of 64 bits.
///
/// # Errors
/// Those of [`program`].
pub fn suited(device: &Device, name: &str, needs: &Needs) -> Result<(Program, Vec<u32>)> {
    let options = Options {
        parameters: Parameters::Push,
        cpu: device.info().kind == DeviceKind::Cpu,
        int64: device.has_int64(),
    };
    let program = program(name, needs, options)?;
    let words = program.spirv(&program.flat(false)?.text)?;
    Ok((program, words))
}

fn module(size: &mut Size, name: &str, words: &[u32]) -> Result<()> {
    let one = measure(words).map_err(|error| Error::Shader {
        shader: name.to_owned(),
        problem: error.to_string(),
    })?;
    let all = &mut size.modules;
    all.bytes += one.bytes;
    all.instructions += one.instructions;
    all.functions += one.functions;
    all.constants += one.constants;
    all.specialization += one.specialization;
    all.table_bytes += one.table_bytes;
    size.resources += one.resources.len();
    size.kernels.push(name.to_owned());
    Ok(())
}

fn stripped_size(program: &Program, words: &[u32]) -> Result<Size> {
    let mut size = Size::default();
    module(&mut size, &program.name, words)?;
    let tables = program.tables.iter();
    size.buffer_bytes = tables.map(|table| 4 * table.words.len() as u64).sum();
    Ok(size)
}

/// The general kernel of the points, and the kernel of every group of maps.
fn full_size(needs: &Needs) -> Result<Size> {
    let mut size = Size::default();
    let plan = stock_points(needs);
    module(&mut size, plan.kernel.name, &spirv(plan.kernel.name)?)?;
    size.buffer_bytes = plan.table.map_or(0, |table| 4 * table.len() as u64);
    for mapping in needs.domains.iter().filter_map(|one| one.draw.mapping()) {
        let name = mapping.map().group.kernel(needs.request.profile);
        if !size.kernels.iter().any(|known| known == name) {
            module(&mut size, name, &spirv(name)?)?;
        }
        let tables = mapping.tables().iter();
        size.buffer_bytes += tables.map(|words| 4 * words.len() as u64).sum::<u64>();
    }
    Ok(size)
}

/// The general kernel of the points that a scene draws by: it chooses bases, nets and scrambles
/// of their family at run time.
#[must_use]
pub fn stock_points(needs: &Needs) -> Plan {
    general(&Work {
        columns: &needs.request.columns,
        first: needs.request.first,
        points: needs.request.count,
        fractions: true,
        map: None,
        native: false,
        cpu: false,
        int64: false,
    })
}

/// Rounds last about so long each, if so many samples fit.
const ROUND_S: f64 = 0.05;

/// Samples of the first trial.
const TRIAL: u32 = 1 << 12;

fn seconds(timing: Timing) -> f64 {
    1e-9 * timing.device_ns.unwrap_or(timing.host_ns)
}

/// Samples of a dispatch at most.
const MOST: u64 = 1 << 24;

/// What it takes to have the scene's kernel once more.
struct Again {
    compile_s: f64,
    warm_s: f64,
}

fn speeds(
    full: &mut Full,
    stripped: &mut Stripped,
    baked: Option<&mut Baked>,
    again: Again,
) -> Result<Speeds> {
    let whole = round(&mut [full])?;
    let mut own: Vec<&mut dyn Maker> = vec![stripped];
    own.extend(baked.map(|one| one as &mut dyn Maker));
    let each = round(&mut own)?;
    let mut makers: Vec<(&mut dyn Maker, u32)> = vec![(full, whole)];
    makers.extend(own.into_iter().map(|maker| (maker, each)));
    let mut times = vec![(Vec::new(), Vec::new()); makers.len()];
    for (maker, samples) in &mut makers {
        maker.make(*samples)?;
    }
    let mut memory = Fills::new();
    for _ in 0..ROUNDS {
        for ((maker, samples), (times, fills)) in makers.iter_mut().zip(&mut times) {
            fills.push(memory.seconds(u64::from(*samples) * maker.bytes()));
            times.push(seconds(maker.make(*samples)?));
        }
    }
    let mut all = makers
        .iter()
        .zip(&mut times)
        .map(|((maker, samples), (times, fills))| {
            let start = maker.start();
            Speed {
                pipelines_s: start.pipelines_s,
                start_s: start.all_s,
                samples: *samples,
                median_s: median(times),
                deviation_s: deviation(times),
                bytes: u64::from(*samples) * maker.bytes(),
                fill_s: median(fills),
            }
        });
    let (Some(full), Some(stripped)) = (all.next(), all.next()) else {
        return Err(Error::CheckFailed {
            failures: 1,
            total: 1,
        });
    };
    Ok(Speeds {
        full,
        stripped,
        baked: all.next(),
        compile_s: again.compile_s,
        warm_s: again.warm_s,
    })
}

/// Samples of a round of each of these: as many as the slowest makes in [`ROUND_S`].
fn round(makers: &mut [&mut dyn Maker]) -> Result<u32> {
    let limits = makers.iter().map(|maker| maker.limit());
    let most = limits.min().unwrap_or(0).min(MOST) as u32;
    let mut samples = TRIAL.min(most);
    // A dispatch of few is mostly its start, so that the second trial is of more.
    for _ in 0..2 {
        let mut slowest = 0.0f64;
        for maker in &mut *makers {
            maker.make(samples)?;
            slowest = slowest.max(seconds(maker.make(samples)?));
        }
        let wanted = (f64::from(samples) * ROUND_S / slowest.max(1e-9)) as u64;
        samples = wanted.clamp(TRIAL.min(most).into(), most.into()) as u32;
    }
    Ok(samples)
}

/// Compares samples at the beginning and at the end of the indices with the reference: in the
/// exact profile word for word, in the native one numbers and choices so, and coordinates within
/// the bound of their map.
///
/// # Errors
/// [`Error::CheckFailed`] for samples that are others; those of the device.
pub fn verify(device: &Arc<Device>, needs: &Needs, program: &Program, words: &[u32]) -> Result<()> {
    let profile = needs.request.profile;
    let mut exact = needs.clone();
    exact.request.profile = Profile::Exact;
    let reference = SceneReference::new(&exact)?;
    let bounds = bounds(needs, &reference);
    let sampler = Sampler::new(device, program, words)?;
    let count = needs.request.count.min(1 << 10);
    let last = needs.request.count - count;
    let over = last % u64::from(program.aligned);
    for (first, count) in [(0, count), (last - over, count + over)] {
        let got = sampler.run(first as u32, count as u32)?;
        let mut want = vec![0; got.len()];
        reference.fill(first as u32, &mut want);
        let words = got.iter().zip(&want).zip(bounds.iter().cycle());
        let failures = words
            .filter(|((got, want), bound)| match (profile, bound) {
                (Profile::Exact, _) | (_, None) => got != want,
                (Profile::Native, Some(bound)) => {
                    let [got, want] = [got, want].map(|word| f64::from(f32::from_bits(**word)));
                    // NaN is never near.
                    !bound.is_infinite() && !near(got, want, bound * want.abs().max(1.0))
                }
            })
            .count();
        if failures > 0 {
            return Err(Error::CheckFailed {
                failures,
                total: got.len(),
            });
        }
    }
    Ok(())
}

fn near(got: f64, want: f64, most: f64) -> bool {
    (got - want).abs() <= most
}

/// For each word of a record how far it may be off in the native profile; none may that no map
/// makes. Densities, which `check` judges at the samples that they are of, may be anything.
fn bounds(needs: &Needs, reference: &SceneReference) -> Vec<Option<f64>> {
    let fields = needs.domains.iter().zip(&reference.record().fields);
    let bound = |(domain, field): (&crate::scene::Domain, &crate::scene::Field)| {
        let native = domain.draw.mapping().map(|mapping| mapping.map().native);
        let values = field.values.iter();
        let of =
            values.map(|value| native.map(|n| if *value == "pdf" { f64::INFINITY } else { n }));
        of.collect::<Vec<_>>()
    };
    fields.flat_map(bound).collect()
}
