//! The stock modules as files, for engines that compile nothing at run time: what a request of
//! points leaves out, it leaves out by specialization constants alone.
//!
//! A driver that specializes a module drops what its constants do not reach. The values are those
//! that [`crate::kernels::Generator`] sets, and every module of a sampler's family makes the same
//! bytes, whatever it is specialized to.

mod describe;

pub use describe::{SCHEMA, description};

use crate::catalog::{Output, Request, Sampler};
use crate::interface::KERNELS;
use crate::kernels::spirv;
use crate::variant::{Plan, Work, plan};
use crate::{Error, Result};
use serde_json::{Value, json};

/// A file of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// The name.
    pub name: String,
    /// All of it.
    pub bytes: Vec<u8>,
}

/// Words that an invocation can number.
const MOST: u64 = 1 << 32;

/// What a device of the engine's is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Target {
    /// A driver that computes on the CPU, which likes long runs of points per invocation.
    pub cpu: bool,
    /// It has integers of 64 bits.
    pub int64: bool,
}

/// Every module, `NAME.spv`, and `modules.json`, which describes them.
///
/// # Errors
/// None, if the stock kernels are as built.
pub fn all() -> Result<Vec<File>> {
    let mut files = Vec::new();
    let mut list = Vec::new();
    for kernel in KERNELS {
        list.push(description(kernel)?);
        files.push(module(kernel.name)?);
    }
    let document = json!({
        "schema": SCHEMA,
        "version": env!("CARGO_PKG_VERSION"),
        "modules": list,
    });
    files.push(document_file("modules.json", &document));
    Ok(files)
}

/// The module that makes the points of a request, the table that it reads, where it reads one, and
/// `constants.json`: what an engine passes to its pipelines and dispatches. They are those of the
/// request's range of indices, and of no other. A request's map and pdf are not taken.
///
/// # Errors
/// [`Error::Arguments`] for points of more words than a module counts, 2^32.
pub fn of_points(sampler: Sampler, request: &Request, target: Target) -> Result<Vec<File>> {
    let plan = plan(&Work {
        columns: &request.columns,
        first: request.first,
        points: request.count,
        fractions: request.output == Output::Fractions,
        map: None,
        native: false,
        cpu: target.cpu,
        int64: target.int64,
    });
    if room(&plan, request) > MOST {
        return Err(Error::Arguments {
            asked: format!(
                "{} points of {} words by one dispatch",
                request.count,
                request.columns.len()
            ),
            limit: "a module counts 2^32 words".into(),
            remedy: "ask for the constants of fewer points, and of the others by their first"
                .into(),
        });
    }
    let mut files = vec![module(plan.kernel.name)?];
    let mut table = Value::Null;
    if let Some(words) = &plan.table {
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let name = "columns.bin".to_owned();
        table = json!({ "binding": 1, "file": name, "bytes": bytes.len() });
        files.push(File { name, bytes });
    }
    let document = json!({
        "schema": SCHEMA,
        "version": env!("CARGO_PKG_VERSION"),
        "points": {
            "sampler": sampler.name(),
            "dimensions": request.columns.len(),
            "first": request.first,
            "count": request.count,
            "end": request.first + request.count,
            "seed": request.seed,
            "words": if request.output == Output::Fractions { "fractions of 2^32" } else { "floats" },
        },
        "module": description(plan.kernel)?,
        "table": table,
        "first_multiple": plan.aligned,
        "result_bytes": 4 * room(&plan, request),
        "dispatches": dispatches(&plan, request),
    });
    files.push(document_file("constants.json", &document));
    Ok(files)
}

/// A pipeline and a dispatch for each part of a row.
fn dispatches(plan: &Plan, request: &Request) -> Vec<Value> {
    let names = plan.kernel.specialization();
    let name = |id: u32| names.iter().find(|(known, ..)| *known == id);
    let constant = |&(id, value): &(u32, u32)| {
        let name = name(id).map(|(_, name, _)| name.as_str());
        json!({ "id": id, "name": name, "value": value })
    };
    let units = units(plan);
    let parts = plan.specializations.iter().zip(units);
    parts
        .map(|(constants, unit)| {
            let invocations = invocations(unit, request);
            json!({
                "constants": constants.iter().map(constant).collect::<Vec<_>>(),
                "points_of_an_invocation": unit,
                "invocations": invocations,
                "groups": invocations.div_ceil(plan.kernel.local_size.into()),
            })
        })
        .collect()
}

/// Points of an invocation in each dispatch; none of the general kernel, whose invocations make
/// four words.
fn units(plan: &Plan) -> Vec<Option<u64>> {
    match plan.tiles.is_empty() {
        true => vec![None; plan.specializations.len()],
        false => plan.tiles.iter().map(|&tile| Some(tile.into())).collect(),
    }
}

fn invocations(unit: Option<u64>, request: &Request) -> u64 {
    match unit {
        Some(tile) => request.count.div_ceil(tile),
        None => (request.count * request.columns.len() as u64).div_ceil(4),
    }
}

/// Words that whole invocations write.
fn room(plan: &Plan, request: &Request) -> u64 {
    let width = request.columns.len() as u64;
    let of = |unit: Option<u64>| match unit {
        Some(tile) => invocations(unit, request) * tile * width,
        None => 4 * invocations(unit, request),
    };
    units(plan).into_iter().map(of).max().unwrap_or(0)
}

fn module(name: &str) -> Result<File> {
    let words = spirv(name)?;
    Ok(File {
        name: format!("{name}.spv"),
        bytes: words.iter().flat_map(|word| word.to_le_bytes()).collect(),
    })
}

fn document_file(name: &str, document: &Value) -> File {
    File {
        name: name.to_owned(),
        bytes: format!("{document:#}\n").into_bytes(),
    }
}
