//! `corput bench`.

use super::args::BenchArgs;
use super::{host, print, progress};
use comfy_table::{CellAlignment, Table, presets};
use corput::bench::{self, Goal, Measurement};
use serde_json::json;

pub fn run(args: &BenchArgs) -> anyhow::Result<()> {
    let device = host::open(args.device.as_deref())?;
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
