//! `corput check --extreme`.

use super::{host, print};
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use corput::Error;
use corput::extreme::{self, COVERED, Counts, Row};

pub fn run(device: Option<&str>, json: bool) -> anyhow::Result<()> {
    let device = host::open(device)?;
    let rows = extreme::run(&device)?;
    let line = host::line(device.info());
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
    host::validated(device.instance())?;
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
            error(row.device, "host"),
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
        "{} of {} rows failed; {} ran on the device, {} on the host alone; the common formula is beyond \
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
