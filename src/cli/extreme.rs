//! `corput check --extreme`.

use super::args::CheckArgs;
use super::check::{junit_file, left_out};
use super::{arguments, host, print};
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use corput::Error;
use corput::check::junit;
use corput::extreme::{self, Counts, Row};
use std::time::Duration;

pub fn run(args: &CheckArgs, time: Option<Duration>) -> anyhow::Result<()> {
    let device = args.device.as_deref();
    let on_cpu = host::is_cpu(host::asked(device).as_deref());
    if on_cpu && time.is_some() {
        return Err(Error::Arguments {
            asked: "--seconds with --extreme on the CPU".into(),
            limit: "its rows are made all at once, in seconds".into(),
            remedy: "drop --seconds".into(),
        }
        .into());
    }
    let document = junit_file(args)?;
    let device = match on_cpu {
        true => None,
        false => Some(host::open(device)?),
    };
    let (rows, later) = match &device {
        Some(device) => extreme::run_within(device, time)?,
        None => (extreme::run_on_cpu()?, Vec::new()),
    };
    let line = arguments::device(device.as_ref());
    let counts = Counts::of(&rows);
    if let Some(document) = document {
        let further: Vec<_> = rows.iter().map(Row::further).collect();
        document.finish(junit(&[], &later, &further, &line).as_bytes())?;
    }
    if args.json {
        let document = extreme::json(&line, &host::command(), &rows, &later);
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        print(&line);
        print(&table(&rows).to_string());
        print(&(summary(counts) + &left_out(&later)));
    }
    if let Some(device) = &device {
        host::validated(device.instance())?;
    }
    if counts.failed > 0 {
        return Err(Error::CheckFailed {
            failures: counts.failed,
            total: counts.rows,
        }
        .into());
    }
    Ok(())
}

fn table(rows: &[Row]) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Disabled)
        .set_header([
            "", "case", "input", "common", "CPU", "device", "native", "bound",
        ]);
    for row in rows {
        let case = &row.case;
        let error = |error: Option<f64>, none: &str| match error {
            Some(error) => format!("{error:.1e}"),
            None => none.to_owned(),
        };
        let verdict = match row.verdict() {
            "passed" => "ok",
            "failed" => "FAILED",
            other => other,
        };
        table.add_row([
            verdict.to_owned(),
            case.number.to_string(),
            case.input.clone(),
            error(Some(case.naive), ""),
            error(Some(case.ours), ""),
            error(row.device, "-"),
            error(row.native, "-"),
            format!("{:.0e}", case.bound),
        ]);
        if let Some(why) = row.failure.as_ref().or(row.refused.as_ref()) {
            table.add_row(["", "", &format!("  {why}")]);
        }
    }
    for column in [1, 3, 4, 5, 6, 7] {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

fn summary(counts: Counts) -> String {
    format!(
        "{} of {} rows failed, {} refused; {} ran on the device, {} on the CPU alone; the common formula is beyond \
         the bound in {}, the native profile in {} of its {}",
        counts.failed,
        counts.rows,
        counts.refused,
        counts.device,
        counts.rows - counts.device - counts.refused,
        counts.naive_beyond,
        counts.native_beyond,
        counts.native
    )
}
