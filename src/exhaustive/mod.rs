//! Functions over all their inputs: those of one word over every word, radical inverses over
//! every index, all others over every pair of critical values and 2^24 random inputs; maps too,
//! with the parameter sets of `corput check`; and the sum of 2^28 equal terms.
//!
//! A row compares each result with the CPU twin, and the floats with a truth that shares no
//! arithmetic with it: `f64` from the definitions, with a bound of its own error, so that
//! each result is known to be correctly rounded, known not to be, or counted as undecided. Of maps,
//! whose judges are slower and are taken to be within 2^-32, those of critical inputs that have a
//! judge, of a share of the random ones, and of one word in 4,096.
//! The SHA-256 of all results in order must be the published one, where one is. Memory stays
//! below 1 GiB: results come in chunks of at most 64 MiB, of which one is made while another
//! is compared and hashed.

mod compare;
mod document;
mod edges;
mod fractions;
mod inputs;
mod judge;
mod manifest;
mod maps;
mod row;
mod terms;
mod truth;

use compare::compare;
pub use compare::{Source, Watch};
pub use document::{About, SCHEMA, json};
pub use fractions::{Fractions, Input};
pub use inputs::{Domain, RANDOM, arguments};
pub use manifest::{publish, published};
pub use maps::{compare_map, mapper};
pub use row::{Figures, Hash, Row};
pub use terms::compare_terms;
pub use truth::{Rounding, Truth};

use crate::catalog::{
    Engine, FUNCTIONS, Function, Kind, Map, Options as Points, Request, Sequence,
};
use crate::catalog::{Profile, Tier, maps};
use crate::check::{Verdict, no_time};
use crate::kernels::{Evaluator, Generator, Reducer, probe};
use crate::vulkan::Device;
use crate::{Error, Result};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Bases whose radical inverses are compared at every index: the smallest, and the largest that
/// points have.
pub const BASES: [u32; 4] = [2, 3, 5, 8161];

/// What a row is about.
#[derive(Clone, Copy, Debug)]
pub enum Subject {
    /// A function of the catalogue.
    Function(&'static Function, Domain),
    /// The radical inverses in a base, as the kernels of points make them.
    Inverses(u32),
    /// A map, with the parameter sets of `corput check`.
    Map(&'static Map),
    /// The sum of 2^28 equal floats.
    Terms,
}

impl Subject {
    /// The name of its row, by which its hash is published.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Function(function, _) => function.name.to_owned(),
            Self::Inverses(base) => format!("radical_inverse in base {base}"),
            Self::Map(map) => map.name.to_owned(),
            Self::Terms => "reduction of equal terms".into(),
        }
    }

    fn tier(&self) -> Tier {
        match self {
            Self::Function(function, _) => function.tier,
            Self::Inverses(_) | Self::Terms => Tier::Integer,
            Self::Map(map) => map.tier,
        }
    }

    fn contains(&self, part: &str) -> bool {
        let (header, kernel) = match self {
            Self::Function(function, _) => (function.header, function.kernel),
            Self::Inverses(_) => ("", ""),
            Self::Map(map) => ("", map.group.kernel(Profile::Exact)),
            Self::Terms => ("", "reduce"),
        };
        [&self.name(), header, kernel]
            .iter()
            .any(|name| name.contains(part))
    }
}

/// Every row, in the order of the catalogue; those of radical inverses by base come first, those
/// of maps later, and the sum last.
pub fn subjects() -> impl Iterator<Item = Subject> {
    let functions = FUNCTIONS.iter().map(|function| {
        let domain = match function.kind {
            Kind::Word | Kind::Float => Domain::EVERY_WORD,
            // Of one word: its kernel takes four at a time.
            Kind::Words if function.name == "hash" => Domain::EVERY_WORD,
            _ => Domain::Sampled,
        };
        Subject::Function(function, domain)
    });
    let inverses = BASES.map(Subject::Inverses).into_iter();
    inverses
        .chain(functions)
        .chain(maps().map(Subject::Map))
        .chain([Subject::Terms])
}

/// The rows whose name, header or kernel contains this, or all.
///
/// # Errors
/// [`Error::Arguments`] where there is none.
pub fn chosen(only: Option<&str>) -> Result<Vec<Subject>> {
    let found: Vec<Subject> = subjects()
        .filter(|subject| only.is_none_or(|part| subject.contains(part)))
        .collect();
    if found.is_empty() {
        return Err(Error::Arguments {
            asked: format!("--only {}", only.unwrap_or("")),
            limit: "no row's name, header or kernel contains that".into(),
            remedy: "leave --only out to see all rows".into(),
        });
    }
    Ok(found)
}

/// Compares these one after the other, and begins none after `time`: gives the rows, and the names
/// of those that were left out. `watch` hears of the inputs done of a row, and may stop
/// the work; `seen` gets each row as it ends.
///
/// # Errors
/// Those of the device, those of `watch`, and [`Error::Arguments`] where there was no time for any.
pub fn run(
    device: &Arc<Device>,
    subjects: &[Subject],
    time: Option<Duration>,
    watch: &mut dyn FnMut(&str, u64, u64) -> Result<()>,
    seen: &mut dyn FnMut(&Row),
) -> Result<(Vec<Row>, Vec<String>)> {
    device.keep_pipelines();
    let exact_floats = probe(device)?.tier_f();
    let begun = Instant::now();
    let (mut rows, mut left_out) = (Vec::new(), Vec::new());
    for subject in subjects {
        let name = subject.name();
        if time.is_some_and(|time| begun.elapsed() >= time) {
            left_out.push(name);
            continue;
        }
        let row = match subject {
            subject if subject.tier() == Tier::Float && !exact_floats => {
                let why = "the probe does not find rounding to nearest even";
                Row::refused(subject, why)
            }
            Subject::Function(function, domain) => {
                let evaluator = Evaluator::new(device, function.kernel, function.id)?;
                let watch = &mut |done, total| watch(&name, done, total);
                compare_function(&evaluator, function, *domain, watch)?
            }
            Subject::Inverses(base) => {
                let request = inverses(*base)?;
                let generator = Generator::new(device, &request)?;
                let watch = &mut |done, total| watch(&name, done, total);
                compare_inverses(generator, *base, INDICES, watch)?
            }
            Subject::Map(map) => {
                let fractions = Fractions::new(map)?;
                let mut mapper = mapper(device, &fractions)?;
                let watch = &mut |done, total| watch(&name, done, total);
                compare_map(&mut mapper, &fractions, watch)?
            }
            Subject::Terms => {
                let reducer = &mut |group| Reducer::with_group(device, group);
                let watch = &mut |done, total| watch(&name, done, total);
                compare_terms(1 << 28, reducer, watch)?
            }
        };
        seen(&row);
        rows.push(row);
    }
    if rows.is_empty() {
        return Err(no_time(time));
    }
    Ok((rows, left_out))
}

/// `Ok`, or how many of the rows failed.
///
/// # Errors
/// [`Error::CheckFailed`].
pub fn result(rows: &[Row]) -> Result<()> {
    let failed = |row: &&Row| row.verdict == Verdict::Failed;
    match rows.iter().filter(failed).count() {
        0 => Ok(()),
        failures => Err(Error::CheckFailed {
            failures,
            total: rows.len(),
        }),
    }
}

/// One row of a function, by an evaluator of the caller's.
///
/// # Errors
/// Those of the device, and those of `watch`.
pub fn compare_function(
    evaluator: &Evaluator,
    function: &'static Function,
    domain: Domain,
    watch: Watch,
) -> Result<Row> {
    let row = Row::new(&Subject::Function(function, domain));
    let critical = crate::check::critical(function.kind);
    let mut source = |start: u64, count: u64| {
        let results = match domain {
            Domain::Words { first, stride, .. } => {
                let first = first.wrapping_add((start as u32).wrapping_mul(stride));
                evaluator.run_indexed(first, stride, count as u32)?
            }
            Domain::Sampled => {
                let kind = function.kind;
                let at = |i| arguments(kind, &critical, i);
                evaluator.run(&(start..start + count).map(at).collect::<Vec<_>>())?
            }
        };
        Ok(results.into_flattened())
    };
    let part = judge::OfFunction {
        function,
        domain,
        critical: &critical,
    };
    compare(row, domain.inputs(function.kind), &mut source, &part, watch)
}

/// The request of the row of a base: fractions of every index.
///
/// # Errors
/// [`Error::Arguments`] for what is no base.
pub fn inverses(base: u32) -> Result<Request> {
    Request::new(&Points {
        bases: Some(vec![base.into()]),
        fractions: true,
        ..Points::new(Sequence::Halton, INDICES)
    })
}

/// All indices.
pub const INDICES: u64 = 1 << 32;

/// The row of a base, by a generator of [`inverses`], or of its first `count` indices.
///
/// # Errors
/// Those of the device, and those of `watch`.
pub fn compare_inverses(
    mut generator: Generator,
    base: u32,
    count: u64,
    watch: Watch,
) -> Result<Row> {
    let mut row = Row::new(&Subject::Inverses(base));
    let inputs = count.min(INDICES);
    if inputs < INDICES {
        row.inputs = format!("the first {inputs} indices");
    }
    let mut source = |start: u64, count: u64| {
        let mut all = Vec::with_capacity(count as usize);
        generator.make(start, count, &mut |words| {
            all.extend_from_slice(words);
            Ok(())
        })?;
        Ok(all)
    };
    compare(row, inputs, &mut source, &judge::OfBase::new(base), watch)
}
