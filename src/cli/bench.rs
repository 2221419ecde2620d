//! `corput bench`.

use super::args::BenchArgs;
use super::{host, print, progress, strip};
use comfy_table::{CellAlignment, Table, presets};
use corput::bench::scene::{compare, document, suited};
use corput::bench::{self, Goal, Measurement};
use corput::scene::{self, Needs};
use corput::vulkan::Device;
use serde_json::json;
use std::sync::Arc;

pub fn run(args: &BenchArgs) -> anyhow::Result<()> {
    let device = host::open(args.device.as_deref())?;
    if !args.scene.is_empty() {
        return scenes(args, &device);
    }
    let bar = progress::rows();
    let measurements = bench::run(&device, &mut |name| {
        bar.inc(1);
        bar.set_message(name.to_owned());
    })?;
    bar.finish_and_clear();
    host::validated(device.instance())?;
    let line = host::line(device.info());
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    if args.json {
        let jobs: Vec<_> = measurements.iter().map(Measurement::json).collect();
        let document = json!({
            "version": env!("CARGO_PKG_VERSION"),
            "device": line,
            "host_threads": threads,
            "jobs": jobs,
        });
        print(&serde_json::to_string_pretty(&document)?);
        return Ok(());
    }
    print(&format!("{line}; fills by {threads} threads of the host"));
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
    for m in &measurements {
        let goal = match (m.goal, m.reached()) {
            (Some(goal), reached) => {
                let text = match goal {
                    Goal::Fill(most) => format!("<= {most} x fill"),
                    Goal::Rate(least) => format!(">= {:.2} G/s", least / 1e9),
                };
                format!(
                    "{text}: {}",
                    if reached == Some(true) {
                        "reached"
                    } else {
                        "MISSED"
                    }
                )
            }
            (None, _) => String::new(),
        };
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
    for column in 2..7 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    print(&table.to_string());
    Ok(())
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
