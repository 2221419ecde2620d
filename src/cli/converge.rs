//! `corput converge`.

use super::args::ConvergeArgs;
use super::{host, interrupt, print, progress};
use comfy_table::{CellAlignment, Table, presets};
use corput::catalog::Sampler;
use corput::converge::{
    self, DEFAULT, Engine, Kept, Results, Row, Series, Setting, Settings, Study, standings,
};
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
    let study = study(args)?;
    let (engine, device, instance) = engine(args)?;
    let mut kept = args
        .report
        .as_deref()
        .map(|folder| kept(folder, args.fresh));
    let mut kept = kept.take().transpose()?;
    let setting = Setting::new(&study, device, host::command());
    let results = measured(&engine, &study, setting, kept.as_mut(), args.fresh)?;
    if let Some(instance) = instance {
        host::validated(&instance)?;
    }
    for line in warnings(&results) {
        eprintln!("corput: warning: {line}");
    }
    if let Some(folder) = &args.report {
        let files = converge::write(&results, folder)?;
        if let Some(kept) = kept {
            kept.remove()?;
        }
        if !args.json {
            eprintln!(
                "corput: wrote {} files; open {}",
                files.len(),
                folder.join("report.html").display()
            );
        }
    }
    if args.json {
        print(&serde_json::to_string_pretty(&results.document())?);
    } else {
        print(&text(&results));
    }
    Ok(finite(&results)?)
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

/// The study of the arguments: a file, names, or the default.
fn study(args: &ConvergeArgs) -> Result<Study> {
    let (rows, settings) = match &args.study {
        Some(path) => converge::read(path)?,
        None if args.integrand.is_empty() => {
            let (rows, settings) = converge::parse(DEFAULT, Path::new("(the default study)"))?;
            (named_samplers(args, rows)?, settings)
        }
        None => (named(args)?, Settings::default()),
    };
    let given = |value: Option<u64>, otherwise| value.unwrap_or(otherwise);
    Study::new(
        rows,
        Settings {
            min_count: given(args.min_count, settings.min_count),
            max_count: given(args.max_count, settings.max_count),
            replicates: match args.replicates {
                // A number past the limit is refused as such.
                Some(many) => u32::try_from(many).unwrap_or(u32::MAX),
                None => settings.replicates,
            },
            seed: given(args.seed, settings.seed),
            targets: args.target.clone().unwrap_or(settings.targets),
        },
    )
}

/// The default samplers are those of the default study.
fn named(args: &ConvergeArgs) -> Result<Vec<Row>> {
    // A name that is none is told before a sampler that does not fit it.
    for integrand in &args.integrand {
        converge::rows(
            integrand,
            args.estimator.as_deref().unwrap_or_default(),
            &[],
        )?;
    }
    let samplers = match samplers(args)? {
        Some(samplers) => samplers,
        None => {
            let (rows, _) = converge::parse(DEFAULT, Path::new("(the default study)"))?;
            rows.into_iter()
                .next()
                .map_or(Vec::new(), |row| row.samplers)
        }
    };
    let mut all = Vec::new();
    for integrand in &args.integrand {
        let estimators = args.estimator.as_deref().unwrap_or_default();
        all.extend(converge::rows(integrand, estimators, &samplers)?);
    }
    Ok(all)
}

fn named_samplers(args: &ConvergeArgs, mut rows: Vec<Row>) -> Result<Vec<Row>> {
    if let Some(samplers) = samplers(args)? {
        for row in &mut rows {
            row.samplers.clone_from(&samplers);
        }
    }
    Ok(rows)
}

fn samplers(args: &ConvergeArgs) -> Result<Option<Vec<Sampler>>> {
    let parsed = |names: &Vec<String>| names.iter().map(|name| Sampler::parse(name)).collect();
    args.sampler.as_ref().map(parsed).transpose()
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
    let bar = progress::cells(study.cells() as u64);
    interrupt::clean_up();
    let watch = &mut |name: &str, done, total| {
        bar.set_position(done);
        bar.set_message(name.to_owned());
        interrupt::stop(done, total)
    };
    let results = converge::run(engine, study, setting, kept.as_deref_mut(), watch);
    bar.finish_and_clear();
    if let Some(line) = kept.and_then(|kept| outdated(kept)) {
        eprintln!("corput: {line}");
    }
    results.map_err(|error| match (error, path) {
        (Error::Interrupted { done, total }, Some(path)) => Error::Paused {
            done,
            total,
            path,
            fresh,
        },
        (Error::Interrupted { done, total }, None) => Error::NotKept {
            done,
            total,
            option: "--report DIR",
        },
        (error, _) => error,
    })
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

fn text(results: &Results) -> String {
    let setting = &results.setting;
    let mut lines = vec![
        setting.device.clone(),
        format!(
            "{} replicates, seeds from {}; times are medians of one replicate on the device",
            setting.replicates, setting.seed
        ),
    ];
    for (integrand, group) in results.by_integrand() {
        let Some(first) = group.first() else { continue };
        let truth = &first.truth;
        lines.push(format!(
            "\n{integrand}, {}: {} {}; {}",
            dimensions(&group),
            match truth.uncertainty {
                None => format!("integral {}", truth.value),
                Some(half) => format!("no known integral, reference {} +- {half:.1e}", truth.value),
            },
            match first.analysis.statistic {
                converge::Statistic::Rmse => "",
                converge::Statistic::MedianAbsolute => "(infinite variance: median |error|)",
            },
            floors(&group),
        ));
        lines.push(table(&group, &setting.targets).to_string());
        lines.extend(
            setting
                .targets
                .iter()
                .map(|&target| verdict(&group, target)),
        );
    }
    lines.join("\n")
}

/// The relative floor, of each estimator where there are several.
fn floors(group: &[&Series]) -> String {
    let mut all: Vec<(Option<&str>, f64)> = Vec::new();
    for one in group {
        if !all.iter().any(|(estimator, _)| *estimator == one.estimator) {
            all.push((one.estimator, one.truth.floor() / one.scale()));
        }
    }
    let each = all.iter().map(|(estimator, floor)| match estimator {
        Some(name) => format!("{floor:.1e} of {name}"),
        None => format!("{floor:.1e}"),
    });
    format!("relative floor {}", each.collect::<Vec<_>>().join(", "))
}

/// "2 dimensions", or "2 to 3 dimensions" where estimators differ.
fn dimensions(group: &[&Series]) -> String {
    let all = || group.iter().map(|one| one.dimensions);
    let (least, most) = (all().min().unwrap_or(0), all().max().unwrap_or(0));
    match (least, most) {
        (1, 1) => "1 dimension".to_owned(),
        _ if least == most => format!("{least} dimensions"),
        _ => format!("{least} to {most} dimensions"),
    }
}

fn table(group: &[&Series], targets: &[f64]) -> Table {
    let mut table = Table::new();
    let mut head = vec![
        "sampler".to_owned(),
        "N".into(),
        "relative error".into(),
        "slope".into(),
    ];
    head.extend(targets.iter().map(|target| format!("ms to {target:.0e}")));
    table.load_style(presets::NOTHING).set_header(head);
    for one in group {
        let analysis = &one.analysis;
        let Some(last) = analysis.errors.last() else {
            continue;
        };
        let relative = |value: f64| value / one.scale();
        let few = if last.few_hits() { ", few hits" } else { "" };
        let broken = match analysis.not_finite {
            0 => String::new(),
            many => format!("; {many} not finite"),
        };
        let error = match analysis.random {
            true => format!(
                "{:.2e} ({:.1e} to {:.1e}{few})",
                relative(last.error.value),
                relative(last.error.low),
                relative(last.error.high)
            ),
            false => format!("{:.2e} (one run{few})", relative(last.error.value)),
        };
        let error = error + &broken;
        let slope = match (analysis.slope, analysis.slope_has_interval) {
            (Some(s), true) => format!("{:.2} ({:.2} to {:.2})", s.value, s.low, s.high),
            (Some(s), false) => format!("{:.2}", s.value),
            (None, _) => "-".into(),
        };
        let mut row = vec![one.label(), last.count.to_string(), error, slope];
        row.extend(targets.iter().map(|target| {
            let reached = analysis.reached(target * one.scale());
            reached.map_or("-".into(), |r| format!("{:.3}", r.seconds.value * 1e3))
        }));
        table.add_row(row);
    }
    for column in 1..4 + targets.len() {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

/// Who reaches an error first, in a line.
fn verdict(group: &[&Series], target: f64) -> String {
    let list = standings(group, target);
    let Some(best) = list.first() else {
        return format!("  to {target:.0e}: none reaches it within the study");
    };
    let others = list.iter().skip(1).map(|one| match one.tied {
        true => format!("{} ties", name(one.series)),
        false if one.slower < 1.0 => {
            let faster = one.slower.recip();
            format!("{} {faster:.1} x faster, perhaps by luck", name(one.series))
        }
        false => format!("{} {:.1} x slower", name(one.series), one.slower),
    });
    let others: Vec<String> = others.collect();
    format!(
        "  to {target:.0e}: use {}; {}",
        name(best.series),
        match others.is_empty() {
            true => "no other reaches it".to_owned(),
            false => others.join(", "),
        }
    )
}

/// A series without a comma, since names stand in lists, and whether a single run speaks
/// for it.
fn name(series: &Series) -> String {
    let run = if series.analysis.random {
        ""
    } else {
        " (one run)"
    };
    format!("{}{run}", series.label().replace(", ", " with "))
}
