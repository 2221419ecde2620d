//! One edit of the shaders' text, compiled, linted, run and compared, all in memory.

use std::path::Path;
use std::sync::Arc;

use corput::bulk::{Columns, NearestWords, pair_kind_of};
use corput::catalog::{
    Engine, FUNCTIONS, Function, Integrand, Map, Options, Output, Profile, Request, Sequence,
    examples,
};
use corput::check::{self, Case, ELEMENTARY, ElementaryFunction, NATIVE, Row, arguments};
use corput::interface::{Column, Kernel, Profile as KernelProfile, task};
use corput::kernels::{
    Elementary, Estimator, Evaluator, Generator, Mapper, Pairs, Reducer, VoidAndCluster, kernel,
};
use corput::variant::{FusedMap, Plan, Work, general, general_estimate, plan, plan_estimate};
use corput::vulkan::{Device, DeviceKind};
use corput::{compile, headers};

/// A change of a file under `shaders/`.
#[derive(Clone, Copy, Debug)]
pub struct Edit<'a> {
    /// The file, from `shaders/` on.
    pub file: &'a str,
    /// Exact text.
    pub find: &'a str,
    /// What stands there instead.
    pub replace: &'a str,
    /// How often the text occurs.
    pub times: usize,
}

impl Edit<'_> {
    /// The edit as a diff.
    pub fn diff(&self) -> String {
        let lines = |mark: char, text: &str| -> String {
            text.lines().map(|line| format!("{mark}{line}\n")).collect()
        };
        format!(
            "--- shaders/{}\n{}{}",
            self.file,
            lines('-', self.find),
            lines('+', self.replace)
        )
    }

    fn apply(&self, file: &str, text: String) -> String {
        if file != self.file {
            return text;
        }
        let found = text.matches(self.find).count();
        assert_eq!(found, self.times, "occurrences of\n{}", self.diff());
        text.replace(self.find, self.replace)
    }
}

/// What is compared with the reference.
#[derive(Clone, Copy, Debug)]
pub enum Target {
    /// A function of the catalogue, in its kernel.
    Function(&'static str),
    /// The same as `evaluate_portable` has it.
    Portable(&'static str),
    /// A native function, which only the judge knows.
    Native(&'static str),
    /// An elementary function of the device's own.
    NativeElementary(&'static str),
    /// Dither masks.
    Mask,
    /// Points by the general kernel.
    Generate(fn() -> Options),
    /// Points by the kernel that the request gets: a tile, or fused with a map.
    Tile(fn() -> Options),
    /// Points, by a kernel without a loop where the device has one.
    Wide(fn() -> Options),
    /// A task of a map, with all its example parameters.
    Map(&'static str, u32),
    /// An integrand with all its examples, by the general kernel.
    Estimate(&'static str),
    /// The same by tiles, where it has one or two dimensions.
    EstimateTile(&'static str),
    /// Sums over pairs of points.
    Pairs,
    /// The nearest pair.
    Nearest,
    /// Exact sums of floats, of a set of terms by its name.
    Reduce(&'static str),
}

/// How a module fared.
pub enum Outcome {
    /// The linter's words.
    Refused(String),
    /// It ran.
    Ran(Box<Row>),
}

/// Compiles the target's kernel with an edit and runs it as `corput check` does.
pub fn run(device: &Arc<Device>, edit: Option<&Edit>, target: Target) -> Outcome {
    let words = match compile::check(
        &spirv(row(device, target), edit),
        row(device, target).profile,
    ) {
        Ok(words) => words,
        Err(refusal) => return Outcome::Refused(refusal),
    };
    let ran = match target {
        Target::Function(name) => function(device, name, function_row(name).kernel, &words),
        Target::Portable(name) => function(device, name, "evaluate_portable", &words),
        Target::Native(name) => {
            let row = native_row(name);
            Evaluator::with_module(device, "evaluate_native", row.id, &words)
                .and_then(|evaluator| check::compare_native(&evaluator, row, &arguments(row.kind)))
        }
        Target::NativeElementary(name) => {
            let function = elementary(name);
            Elementary::with_module(device, function.id, Profile::Native, task::SAMPLE, &words)
                .and_then(|kernel| check::compare_native_elementary(&kernel, function))
        }
        Target::Map(name, task) => mapped(device, name, task, &words),
        Target::Estimate(name) | Target::EstimateTile(name) => {
            check::compare_estimates(integrand(name), &mut |problem, request| {
                let plan = estimated(target, problem.id(), &request.columns);
                // Points of other families are another kernel's.
                if plan.kernel.name != row(device, target).name {
                    return Ok(Vec::new());
                }
                let mut estimator = Estimator::with_module(device, problem, request, plan, &words)?;
                Ok(vec![estimator.run(0, request.count, &mut |_| Ok(()))?.0])
            })
        }
        Target::Pairs => check::compare_pair_sums(&mut |kind, columns, scale| {
            let kind = pair_kind_of(kind);
            pairs(device, "pairs", columns, kind, &words)?.sum(scale, &mut |_, _| Ok(()))
        }),
        Target::Nearest => check::compare_nearest(&mut |columns, toroidal| {
            let mut best = None;
            pairs(device, "nearest", columns, u32::from(toroidal), &words)?.search(
                &mut |row, square, other| NearestWords::keep(&mut best, row, square, other),
                &mut |_, _| Ok(()),
            )?;
            Ok(best)
        }),
        Target::Reduce(name) => {
            let found = check::REDUCTIONS.iter().find(|one| one.name == name);
            let reduction = found.unwrap_or_else(|| panic!("no reduction {name}"));
            Reducer::with_module(device, *row(device, target), &words).and_then(|reducer| {
                check::compare_reduction(reduction, &mut |terms, split| {
                    Ok(vec![reducer.reduce_in(terms, split)?])
                })
            })
        }
        Target::Mask => VoidAndCluster::with_module(device, &words)
            .and_then(|kernel| check::compare_mask(&kernel)),
        Target::Generate(options) | Target::Tile(options) | Target::Wide(options) => {
            let case = Case {
                name: "points".into(),
                kernel: "points",
                request: request(options),
            };
            check::compare_points(&case, |start, points| {
                let plan = planned(device, target, &case.request);
                let mut all = Vec::new();
                Generator::with_module(device, &case.request, plan, &words)?.make(
                    start,
                    points,
                    &mut |part| {
                        all.extend_from_slice(part);
                        Ok(())
                    },
                )?;
                Ok(all)
            })
        }
    };
    Outcome::Ran(Box::new(ran.unwrap_or_else(|error| panic!("{error}"))))
}

/// Whether the device has no kernel of this kind.
pub fn is_missing(device: &Device, target: Target) -> bool {
    matches!(target, Target::Wide(_)) && row(device, target).profile != KernelProfile::Wide
}

/// The row of the kernel that a target runs.
pub fn row(device: &Device, target: Target) -> &'static Kernel {
    let named = |name| kernel(name).unwrap_or_else(|error| panic!("{error}"));
    match target {
        Target::Function(name) => named(function_row(name).kernel),
        Target::Portable(_) => named("evaluate_portable"),
        Target::Native(_) => named("evaluate_native"),
        Target::NativeElementary(_) => named(Elementary::kernel(Profile::Native)),
        Target::Map(name, _) => named(map(name).group.kernel(Profile::Exact)),
        Target::Estimate(name) | Target::EstimateTile(name) => {
            let problems = examples(integrand(name)).unwrap_or_else(|error| panic!("{error}"));
            let columns = sobol(problems[0].dimensions()).columns;
            estimated(target, problems[0].id(), &columns).kernel
        }
        Target::Pairs => named("pairs"),
        Target::Nearest => named("nearest"),
        Target::Reduce(_) => named("reduce"),
        Target::Mask => named("void_and_cluster"),
        Target::Generate(options) | Target::Tile(options) | Target::Wide(options) => {
            planned(device, target, &request(options)).kernel
        }
    }
}

/// A kernel's words as the compiler gives them; text that does not compile is no mutant.
pub fn spirv(row: &Kernel, edit: Option<&Edit>) -> Vec<u32> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders/kernels");
    let mut read = |name: &str| -> Option<String> {
        let header = headers().iter().find(|(header, _)| *header == name);
        let (file, text) = match header {
            Some((_, text)) => (name.to_owned(), (*text).to_owned()),
            None if name == "interface.glsl" => (name.to_owned(), row.glsl()),
            None => (
                format!("kernels/{name}"),
                std::fs::read_to_string(folder.join(name)).ok()?,
            ),
        };
        Some(match edit {
            Some(edit) => edit.apply(&file, text),
            None => text,
        })
    };
    let source = read(row.source).expect("the kernel's source");
    compile::to_spirv(&source, row.defines, &mut read).unwrap_or_else(|error| {
        let diff = edit.map(Edit::diff).unwrap_or_default();
        panic!("{}: {error}\n{diff}", row.name)
    })
}

fn function(device: &Arc<Device>, name: &str, kernel: &str, words: &[u32]) -> corput::Result<Row> {
    let row = function_row(name);
    let evaluator = Evaluator::with_module(device, kernel, row.id, words)?;
    check::compare_function(&evaluator, row, kernel, &arguments(row.kind))
}

fn pairs(
    device: &Arc<Device>,
    kernel: &str,
    columns: &Columns,
    choice: u32,
    words: &[u32],
) -> corput::Result<Pairs> {
    let dimensions = columns.dimensions();
    Pairs::with_module(device, kernel, columns.words(), dimensions, choice, words)
}

fn mapped(device: &Arc<Device>, name: &str, task: u32, words: &[u32]) -> corput::Result<Row> {
    let mappings = check::examples(map(name))?;
    let first = mappings.first().expect("an example");
    let mut mapper = Mapper::with_module(device, first, true, Profile::Exact, task, words)?;
    check::compare_map(&mut mapper, map(name), &mappings, task)
}

fn map(name: &str) -> &'static Map {
    Map::from_name(name).unwrap_or_else(|error| panic!("{error}"))
}

fn integrand(name: &str) -> &'static Integrand {
    Integrand::from_name(name).unwrap_or_else(|error| panic!("{error}"))
}

fn sobol(dimensions: u32) -> Request {
    let options = Options {
        dimensions: Some(dimensions.into()),
        ..Options::new(Sequence::Sobol, 1)
    };
    Request::new(&options).unwrap_or_else(|error| panic!("{error}"))
}

fn estimated(target: Target, id: u32, columns: &[Column]) -> Plan {
    match target {
        Target::EstimateTile(_) => plan_estimate(columns, id, true),
        Target::Estimate(_) => general_estimate(columns, id),
        _ => unreachable!("only estimates"),
    }
}

fn function_row(name: &str) -> &'static Function {
    let found = FUNCTIONS.iter().find(|function| function.name == name);
    found.unwrap_or_else(|| panic!("no function {name}"))
}

fn native_row(name: &str) -> &'static check::NativeRow {
    let found = NATIVE.iter().find(|row| row.name == name);
    found.unwrap_or_else(|| panic!("no native function {name}"))
}

fn elementary(name: &str) -> &'static ElementaryFunction {
    let found = ELEMENTARY.iter().find(|function| function.name == name);
    found.unwrap_or_else(|| panic!("no elementary function {name}"))
}

fn request(options: fn() -> Options) -> Request {
    Request::new(&options()).unwrap_or_else(|error| panic!("{error}"))
}

fn planned(device: &Device, target: Target, request: &Request) -> Plan {
    let work = Work {
        columns: &request.columns,
        first: request.first,
        points: request.count,
        fractions: request.output == Output::Fractions,
        map: request.map.as_ref().map(|mapping| FusedMap {
            id: mapping.map().id,
            coordinates: mapping.map().coordinates,
            with_pdf: request.with_pdf,
        }),
        native: false,
        cpu: device.info().kind == DeviceKind::Cpu,
        int64: device.has_int64(),
    };
    match target {
        Target::Generate(_) => general(&work),
        // As for many more points.
        Target::Wide(_) => plan(&Work {
            points: 1 << 26,
            ..work
        }),
        // As for fewer, or for devices without integers of 64 bits.
        _ => plan(&Work {
            int64: false,
            ..work
        }),
    }
}
