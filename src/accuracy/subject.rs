//! What is measured: an elementary function, or a map with parameters.

use crate::bulk::map_sample;
use crate::catalog::{Group, Mapping, Profile, maps};
use crate::check::{ELEMENTARY, ElementaryFunction, FRACTIONS, examples, truth};
use crate::error::nearest;
use crate::interface::{REPEATS, map};
use crate::judge::ulp_above;
use crate::kernels::{Elementary, Mapper};
use crate::vulkan::{Buffer, Device, Timing};
use crate::{Error, Result};
use std::sync::Arc;

/// What is measured.
#[derive(Clone, Debug)]
pub enum Subject {
    /// An elementary function.
    Function(&'static ElementaryFunction),
    /// Samples and pdf of a map, with the parameters of its first example.
    Map(Mapping),
}

/// Every name that can be asked for, in the order of the table.
pub fn names() -> impl Iterator<Item = &'static str> {
    let functions = ELEMENTARY.iter().map(|function| function.name);
    functions.chain(maps().map(|map| map.name))
}

/// The subjects with these names, or all of them where no name is given; each once, in the
/// order of the table.
///
/// # Errors
/// [`Error::UnknownName`], with the nearest name.
pub fn subjects(asked: &[String]) -> Result<Vec<Subject>> {
    if let Some(name) = asked
        .iter()
        .find(|name| !names().any(|known| known == **name))
    {
        return Err(Error::UnknownName {
            kind: "function",
            name: name.clone(),
            nearest: nearest(name, names()).map(str::to_owned),
            known: "those that `corput accuracy --list` names".into(),
        });
    }
    let wanted = |name: &str| asked.is_empty() || asked.iter().any(|one| one == name);
    let functions = ELEMENTARY.iter().filter(|function| wanted(function.name));
    let mut all: Vec<Subject> = functions.map(Subject::Function).collect();
    for map in maps().filter(|map| wanted(map.name)) {
        all.extend(examples(map)?.into_iter().next().map(Subject::Map));
    }
    Ok(all)
}

impl Subject {
    /// Its name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Function(function) => function.name,
            Self::Map(mapping) => mapping.map().name,
        }
    }

    /// The numbers of a map's parameters.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        match self {
            Self::Function(_) => &[],
            Self::Map(mapping) => mapping.values(),
        }
    }

    /// What it is evaluated on.
    #[must_use]
    pub fn domain(&self) -> &'static str {
        match self {
            Self::Function(function) => function.domain,
            Self::Map(_) => FRACTIONS,
        }
    }

    /// The kernel that evaluates it.
    #[must_use]
    pub fn kernel(&self, profile: Profile) -> &'static str {
        match self {
            Self::Function(_) => Elementary::kernel(profile),
            Self::Map(mapping) => mapping.map().group.kernel(profile),
        }
    }

    /// Words of a result, the pdf not among them.
    #[must_use]
    pub fn width(&self) -> usize {
        match self {
            Self::Function(function) => function.width,
            Self::Map(mapping) => mapping.map().coordinates as usize,
        }
    }

    /// Whether a pdf follows.
    #[must_use]
    pub fn has_pdf(&self) -> bool {
        matches!(self, Self::Map(_))
    }

    /// What the exact profile gives, as the CPU computes it.
    #[must_use]
    pub fn reference(&self, u: [u32; 3]) -> [u32; 4] {
        match self {
            Self::Function(function) => function.reference(u),
            Self::Map(mapping) => map_sample(mapping, Profile::Exact, self.taken(u)),
        }
    }

    /// What both profiles approximate, by the judge; `None` where no judge knows.
    #[must_use]
    pub fn truth(&self, u: [u32; 3]) -> Option<[f64; 4]> {
        match self {
            Self::Function(function) => Some(function.truth(u)),
            Self::Map(mapping) => truth(mapping, self.taken(u)),
        }
    }

    /// Results below this have their error counted in ULP of it, given the largest: the
    /// power of two below what the results are measured by. That is 1 for directions and the
    /// disk, the standard deviation or mean length of distributions that do not end, and the
    /// largest coordinate of other figures.
    #[must_use]
    pub fn floor(&self, largest: f64) -> f64 {
        let mapping = match self {
            Self::Function(function) => return function.floor,
            Self::Map(mapping) => mapping,
        };
        let [first, ..] = mapping.parameters().map(f64::from);
        let scale = match mapping.map().group {
            Group::Planar
            | Group::Filter
            | Group::GaussianFilter
            | Group::WindowFilter
            | Group::MitchellFilter => largest,
            Group::Line if mapping.map().id == map::EXPONENTIAL => 1.0 / first,
            Group::Line | Group::Normal => first,
            _ => 1.0,
        };
        f64::powf(2.0, scale.log2().ceil() - 1.0)
    }

    /// The error of a result's word in ULP of the larger of |truth| and the floor.
    #[must_use]
    pub fn error(&self, word: u32, truth: f64, floor: f64) -> f64 {
        if self.name() == "atan2" {
            // A fraction of a turn, of which one and none are the same angle; as a float, so
            // that its unit is that of the others.
            let turns = (f64::from(word) / 4_294_967_296.0) as f32;
            let away = (f64::from(turns) - truth).abs();
            return ulp_above(away.min(1.0 - away) as f32, 0.0, floor.max(truth));
        }
        ulp_above(f32::from_bits(word), truth, floor)
    }

    /// The fractions that it takes; the others are zero.
    fn taken(&self, mut u: [u32; 3]) -> [u32; 3] {
        if let Self::Map(mapping) = self {
            let left = u.iter_mut().skip(mapping.map().dimensions as usize);
            left.for_each(|word| *word = 0);
        }
        u
    }
}

/// A subject's kernel in a profile, for one task.
pub(super) enum Kernel {
    Elementary(Elementary),
    Mapper(Mapper),
}

impl Kernel {
    pub(super) fn new(
        device: &Arc<Device>,
        subject: &Subject,
        profile: Profile,
        task: u32,
        words: &[u32],
    ) -> Result<Self> {
        match subject {
            Subject::Function(function) => {
                Elementary::with_module(device, function.id, profile, task, words)
                    .map(Self::Elementary)
            }
            Subject::Map(mapping) => {
                Mapper::with_module(device, mapping, true, profile, task, words).map(Self::Mapper)
            }
        }
    }

    /// Results for these arguments, by the task of samples: words and a pdf.
    pub(super) fn run(&self, subject: &Subject, arguments: &[[u32; 3]]) -> Result<Vec<Vec<u32>>> {
        let width = subject.width() + usize::from(subject.has_pdf());
        match self {
            Self::Elementary(kernel) => {
                let rows: Vec<[u32; 4]> = arguments.iter().map(|&[x, y, z]| [x, y, z, 0]).collect();
                let cut = |row: [u32; 4]| row.into_iter().take(width).collect();
                Ok(kernel.run(&rows)?.into_iter().map(cut).collect())
            }
            Self::Mapper(kernel) => {
                let taken = match subject {
                    Subject::Map(mapping) => mapping.map().dimensions as usize,
                    Subject::Function(_) => 3,
                };
                let words: Vec<u32> = arguments
                    .iter()
                    .flat_map(|u| u.iter().take(taken).copied())
                    .collect();
                let (words, _) = kernel.run(&words)?;
                Ok(words.chunks_exact(width).map(<[u32]>::to_vec).collect())
            }
        }
    }

    pub(super) fn repeat(&self, results: &Buffer, invocations: u32) -> Result<Timing> {
        match self {
            Self::Elementary(kernel) => kernel.repeat(results, invocations),
            Self::Mapper(kernel) => kernel.repeat(results, invocations),
        }
    }
}

/// The arguments of invocation `i` of the task `REPEAT`, as the kernels make them.
#[must_use]
pub fn repeated(i: u32) -> Vec<[u32; 3]> {
    let mut u = [0xd1b5_4a33u32, 0xabc9_8389, 0x8cb9_2ba7].map(|word| word.wrapping_mul(i));
    (0..REPEATS)
        .map(|_| {
            for (word, step) in u.iter_mut().zip([0x9e37_79b9u32, 0xc13f_a9a9, 0x91e1_0da5]) {
                *word = word.wrapping_add(step);
            }
            u
        })
        .collect()
}
