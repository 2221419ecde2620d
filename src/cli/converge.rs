//! `corput converge`.

mod asked;
mod shard;
mod text;

pub use shard::{lacking, lacking_document};

use super::args::ConvergeArgs;
use super::{host, interrupt, print, progress};
use corput::converge::{self, Engine, Kept, Results, Series, Setting, Study};
use corput::report::create_folder;
use corput::vulkan::Instance;
use corput::{Error, Result};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Replicates from which on bootstrap intervals are good.
const GOOD_REPLICATES: u32 = 32;

/// Finished cells of a study that was cut off, in the report's folder.
const UNFINISHED: &str = "unfinished.jsonl";

pub fn run(args: &ConvergeArgs) -> anyhow::Result<()> {
    let study = asked::study(args)?;
    if let (Some(shard), Some(folder)) = (args.shard, &args.report) {
        return shard::run(args, &study, shard, folder);
    }
    let (engine, device, instance) = engine(args)?;
    let mut kept = args
        .report
        .as_deref()
        .map(|folder| kept(folder, args.fresh))
        .transpose()?;
    let setting = Setting::new(&study, device, host::command());
    let results = measured(&engine, &study, setting, kept.as_mut(), args.fresh)?;
    if let Some(instance) = instance {
        host::validated(&instance)?;
    }
    conclude(&results, args.report.as_deref(), kept, args.json)
}

/// Warns, writes the report, after which what was kept is not needed, and prints.
pub fn conclude(
    results: &Results,
    report: Option<&Path>,
    kept: Option<Kept>,
    json: bool,
) -> anyhow::Result<()> {
    for line in warnings(results) {
        eprintln!("corput: warning: {line}");
    }
    if let Some(folder) = report {
        let files = converge::write(results, folder)?;
        if let Some(kept) = kept {
            kept.remove()?;
        }
        if !json {
            eprintln!(
                "corput: wrote {} files; open {}",
                files.len(),
                folder.join("report.html").display()
            );
        }
    }
    if json {
        print(&serde_json::to_string_pretty(&results.document())?);
    } else {
        print(&text::text(results));
    }
    Ok(finite(results)?)
}

/// That all means are.
fn finite(results: &Results) -> Result<()> {
    let point = |series: &Series| {
        let broken = |mean: &f64| !mean.is_finite();
        let found = series.cell.points.iter();
        let found = found.filter(|point| point.means.iter().any(broken));
        found.map(|point| point.count).next()
    };
    let first = results.series.iter().find_map(|series| {
        let count = point(series)?;
        let (name, integrand) = (series.label(), &series.integrand);
        Some(format!("{name} on {integrand} at {count} points"))
    });
    match first {
        None => Ok(()),
        Some(first) => Err(Error::NotFinite {
            failures: results.not_finite(),
            total: results.series.iter().map(means).sum(),
            first,
        }),
    }
}

fn means(series: &Series) -> u64 {
    let points = series.cell.points.iter();
    points.map(|point| point.means.len() as u64).sum()
}

fn engine(args: &ConvergeArgs) -> Result<(Engine, String, Option<Arc<Instance>>)> {
    if host::is_cpu(host::asked(args.device.as_deref()).as_deref()) {
        return Ok((Engine::Cpu, "cpu (the reference, every core)".into(), None));
    }
    let device = host::open(args.device.as_deref())?;
    let line = host::line(device.info());
    let instance = Arc::clone(device.instance());
    Ok((Engine::Device(device), line, Some(instance)))
}

fn kept(folder: &Path, fresh: bool) -> Result<Kept> {
    create_folder(folder, "--report")?;
    converge::check_folder(folder)?;
    let path = folder.join(UNFINISHED);
    if fresh && path.exists() {
        std::fs::remove_file(&path).map_err(|source| Error::Io {
            action: "remove",
            path: path.clone(),
            source,
        })?;
    }
    Kept::open(&path)
}

fn measured(
    engine: &Engine,
    study: &Study,
    setting: Setting,
    mut kept: Option<&mut Kept>,
    fresh: bool,
) -> Result<Results> {
    let path: Option<PathBuf> = kept.as_ref().map(|kept| kept.path().to_owned());
    let results = watched(study.cells() as u64, |watch| {
        converge::run(engine, study, setting, kept.as_deref_mut(), watch)
    });
    if let Some(line) = kept.and_then(|kept| outdated(kept)) {
        eprintln!("corput: {line}");
    }
    results.map_err(|error| match (error, path) {
        (error, Some(path)) => paused(error, path, fresh),
        (Error::Interrupted { done, total }, None) => Error::NotKept {
            done,
            total,
            option: "--report DIR",
        },
        (error, None) => error,
    })
}

/// Measures so many cells under a progress bar, until the user interrupts it.
fn watched<T>(
    cells: u64,
    measure: impl FnOnce(&mut converge::Watch<'_>) -> Result<T>,
) -> Result<T> {
    let bar = progress::cells(cells);
    interrupt::clean_up();
    let result = measure(&mut |name, done, total| {
        bar.set_position(done);
        bar.set_message(name.to_owned());
        interrupt::stop(done, total)
    });
    bar.finish_and_clear();
    result
}

/// The error of a run that keeps its cells in a file.
fn paused(error: Error, path: PathBuf, fresh: bool) -> Error {
    match error {
        Error::Interrupted { done, total } => Error::Paused {
            done,
            total,
            path,
            fresh,
        },
        error => error,
    }
}

/// That cells were there, and were measured anew.
fn outdated(kept: &Kept) -> Option<String> {
    let (number, was) = match kept.outdated() {
        0 => return None,
        1 => ("1 cell".to_owned(), "was"),
        many => (format!("{many} cells"), "were"),
    };
    let path = kept.path().display();
    Some(format!(
        "{number} of {path} {was} of other kernels or of another version: measured anew"
    ))
}

fn warnings(results: &Results) -> Vec<String> {
    let mut lines = Vec::new();
    if results.setting.replicates < GOOD_REPLICATES {
        lines.push(format!(
            "{} replicates: intervals of fewer than {GOOD_REPLICATES} are rough, and mostly too narrow",
            results.setting.replicates
        ));
    }
    for series in &results.series {
        for warning in series.cell.notices() {
            let line = format!("{}: {warning}", series.sampler);
            if !lines.contains(&line) {
                lines.push(line);
            }
        }
        if let Some((count, why)) = series.cell.refused.first() {
            lines.push(format!(
                "{} on {} has no {count} points{}: {why}",
                series.sampler,
                series.integrand,
                match series.cell.refused.len() {
                    1 => String::new(),
                    many => format!(", nor {} other counts", many - 1),
                },
            ));
        }
    }
    lines
}
