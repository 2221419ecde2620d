//! `corput bench`.

mod files;

use super::args::BenchArgs;
use super::{host, print, progress, strip};
use comfy_table::{CellAlignment, Table, presets};
use corput::Error;
use corput::bench::scene::{compare, document, suited};
use corput::bench::{self, Baseline, Change, Goal, Machine, Measurement, changes};
use corput::scene::{self, Needs};
use corput::vulkan::Device;
use serde_json::json;
use std::sync::Arc;

pub fn run(args: &BenchArgs) -> anyhow::Result<()> {
    if !args.scene.is_empty() {
        return scenes(args, &host::open(args.device.as_deref())?);
    }
    if let Some(folder) = &args.files {
        return files::run(args, folder);
    }
    if args.scaling {
        return scaling(args, &host::open(args.device.as_deref())?);
    }
    // What cannot be used is said before anything is timed.
    let jobs = bench::chosen(&args.only)?;
    let baseline = args.against.as_deref().map(Baseline::read).transpose()?;
    if let (Some(baseline), Some(path)) = (&baseline, &args.against)
        && !jobs.iter().any(|job| baseline.has(&job.name))
    {
        return Err(Error::Document {
            path: path.clone(),
            problem: "it has none of the jobs that are to be measured".into(),
            remedy: "give a file that `corput bench --json` wrote of the same jobs",
        }
        .into());
    }
    let asked = host::asked(args.device.as_deref());
    let device = match host::is_cpu(asked.as_deref()) {
        true => None,
        false => Some(host::open(args.device.as_deref())?),
    };
    let bar = progress::rows();
    let mut measured = Vec::new();
    for job in &jobs {
        bar.inc(1);
        bar.set_message(job.name.clone());
        measured.push(match &device {
            Some(device) => bench::on_device(device, job)?,
            None => bench::on_cpu(job)?,
        });
    }
    bar.finish_and_clear();
    if let Some(device) = &device {
        host::validated(device.instance())?;
    }
    let cpu = || "cpu, the reference in blocks".to_owned();
    let machine = machine(device.map_or_else(cpu, |device| host::line(device.info())));
    let changes = baseline.as_ref().map(|before| changes(&measured, before));
    if args.json {
        let document = bench::json(&machine, &measured, changes.as_deref());
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        let threads = machine.threads;
        print(&format!(
            "{}; fills by {threads} threads of the host",
            machine.device
        ));
        print(&table(&measured).to_string());
    }
    let (Some(before), Some(changes)) = (baseline, changes) else {
        return Ok(());
    };
    if before.device != machine.device {
        eprintln!(
            "corput: warning: the baseline is of another device: {}",
            before.device
        );
    }
    if !args.json {
        print(&format!("\n{}", compared(&changes)));
    }
    Ok(bench::slower(&changes)?)
}

fn machine(device: String) -> Machine {
    Machine {
        device,
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        command: host::command(),
    }
}

/// More and more words of one sequence.
fn scaling(args: &BenchArgs, device: &Arc<Device>) -> anyhow::Result<()> {
    let scales = bench::scaling(device, bench::SIZES)?;
    host::validated(device.instance())?;
    let machine = machine(host::line(device.info()));
    if args.json {
        let document = bench::scaling_json(&machine, &scales);
        print(&serde_json::to_string_pretty(&document)?);
        return Ok(());
    }
    let mut table = Table::new();
    let header = ["words", "median ms", "deviation", "ns a word", "x fill"];
    table.load_style(presets::NOTHING).set_header(header);
    for scale in &scales {
        table.add_row([
            scale.words.to_string(),
            format!("{:.2}", scale.median_s * 1e3),
            format!("{:.2}", scale.deviation_s * 1e3),
            format!("{:.4}", scale.word_ns()),
            format!("{:.2}", scale.fills()),
        ]);
    }
    align_right(&mut table, 0..5);
    let spread = bench::spread(&scales);
    let reached = spread <= bench::MOST;
    print(&format!("{}\n{table}", machine.device));
    print(&format!(
        "a word takes at most {spread:.3} times the least, goal {}: {}",
        bench::MOST,
        if reached { "reached" } else { "MISSED" }
    ));
    Ok(())
}

fn table(measured: &[Measurement]) -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header([
        "job",
        "kernel",
        "median ms",
        "deviation",
        "x fill",
        "G points/s",
        "cold ms",
        "goal",
    ]);
    for m in measured {
        let goal = m.goal.map_or(String::new(), |goal| {
            let text = match goal {
                Goal::Fill(most) => format!("<= {most} x fill"),
                Goal::Rate(least) => format!(">= {:.2} G/s", least / 1e9),
            };
            let reached = m.reached() == Some(true);
            format!("{text}: {}", if reached { "reached" } else { "MISSED" })
        });
        table.add_row([
            m.name.clone(),
            m.kernel.clone(),
            format!("{:.2}", m.median_s * 1e3),
            format!("{:.2}", m.deviation_s * 1e3),
            format!("{:.2}", m.fills()),
            format!("{:.3}", m.rate() / 1e9),
            format!("{:.2}", m.cold_s * 1e3),
            goal,
        ]);
    }
    align_right(&mut table, 2..7);
    table
}

/// What changed since a baseline.
fn compared(changes: &[Change]) -> Table {
    let mut table = Table::new();
    let header = ["job", "time, x before", "x fill, x before", "verdict"];
    table.load_style(presets::NOTHING).set_header(header);
    for change in changes {
        let ratio = |value: Option<f64>| value.map_or(String::new(), |x| format!("{x:.2}"));
        table.add_row([
            change.name.clone(),
            ratio(change.seconds),
            ratio(change.fills),
            change.verdict.name().to_owned(),
        ]);
    }
    align_right(&mut table, 1..3);
    table
}

fn align_right(table: &mut Table, columns: std::ops::Range<usize>) {
    for column in columns {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
}

/// Each scene's kernel against the stock ones.
fn scenes(args: &BenchArgs, device: &Arc<Device>) -> anyhow::Result<()> {
    let mut all = Vec::new();
    // What cannot be read is said before anything is timed.
    for file in &args.scene {
        let scene = scene::read(file)?;
        let needs = Needs::of(&scene)?;
        all.push((scene.name, needs));
    }
    let line = host::line(device.info());
    if !args.json {
        print(&line);
    }
    let mut documents = Vec::new();
    for (name, needs) in &all {
        let (program, words) = suited(device, name, needs)?;
        let made = compare(device, needs, &program, &words)?;
        host::validated(device.instance())?;
        match args.json {
            true => documents.push(document(&made)),
            false => print(&format!("\n{}", strip::table(&made))),
        }
    }
    if args.json {
        let document = json!({
            "version": env!("CARGO_PKG_VERSION"),
            "device": line,
            "scenes": documents,
        });
        print(&serde_json::to_string_pretty(&document)?);
    }
    Ok(())
}
