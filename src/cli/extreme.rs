//! `corput check --extreme`.

use super::{arguments, host, print};
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use corput::Error;
use corput::extreme::{self, COVERED, Counts, Row};

pub fn run(device: Option<&str>, json: bool) -> anyhow::Result<()> {
    let on_cpu = host::is_cpu(host::asked(device).as_deref());
    let device = match on_cpu {
        true => None,
        false => Some(host::open(device)?),
    };
    let rows = match &device {
        Some(device) => extreme::run(device)?,
        None => extreme::run_on_cpu()?,
    };
    let line = arguments::device(device.as_ref());
    let counts = Counts::of(&rows);
    if json {
        let document = extreme::json(&line, &host::command(), &rows);
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        print(&line);
        print(&table(&rows).to_string());
        for one in COVERED {
            print(&format!(
                "not judged here: case {}, {}: {}",
                one.number, one.input, one.by
            ));
        }
        print(&summary(counts));
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
        let verdict = if row.failure.is_none() {
            "ok"
        } else {
            "FAILED"
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
        if let Some(why) = &row.failure {
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
        "{} of {} rows failed; {} ran on the device, {} on the CPU alone; the common formula is beyond \
         the bound in {}, the native profile in {} of its {}; {} other cases are tested elsewhere",
        counts.failed,
        counts.rows,
        counts.device,
        counts.rows - counts.device,
        counts.naive_beyond,
        counts.native_beyond,
        counts.native,
        COVERED.len()
    )
}
