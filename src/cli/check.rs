//! `corput check`.

use super::args::CheckArgs;
use super::devices::probe_document;
use super::{host, print, progress};
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use corput::check::{self, Options, Outcome, Row, Verdict};
use serde_json::json;

pub fn run(args: &CheckArgs) -> anyhow::Result<()> {
    let device = host::open(args.device.as_deref())?;
    let options = Options {
        only: args.only.clone(),
    };
    let bar = progress::rows();
    let outcome = check::run(&device, &options, &mut |row| {
        bar.inc(1);
        bar.set_message(row.name.clone());
    })?;
    bar.finish_and_clear();
    let line = host::line(device.info());
    if args.json {
        let rows: Vec<_> = outcome.rows.iter().map(Row::json).collect();
        let document = json!({
            "version": env!("CARGO_PKG_VERSION"),
            "device": line,
            "device_uuid": device.info().device_uuid,
            "probe": probe_document(&outcome.probe),
            "failures": outcome.failures(),
            "rows": rows,
        });
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        print(&line);
        print(&table(&outcome).to_string());
        print(&summary(&outcome));
    }
    host::validated(device.instance())?;
    Ok(outcome.result()?)
}

fn table(outcome: &Outcome) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Disabled)
        .set_header([
            "", "what", "kernel", "tier", "compared", "differ", "worst", "bound", "unit",
        ]);
    for row in &outcome.rows {
        let number = |value: Option<f64>| value.map_or(String::new(), figure);
        let sign = match &row.verdict {
            Verdict::Passed => "ok",
            Verdict::Failed => "FAILED",
            Verdict::Refused(_) => "refused",
        };
        table.add_row([
            sign.to_owned(),
            row.name.clone(),
            row.kernel.clone(),
            row.tier.to_owned(),
            row.compared.to_string(),
            row.mismatches.map_or("may".to_owned(), |n| n.to_string()),
            number(row.worst),
            number(row.bound),
            row.unit.to_owned(),
        ]);
        match &row.verdict {
            Verdict::Failed => {
                table.add_row(["", &format!("  {}", row.witness)]);
            }
            Verdict::Refused(reason) => {
                table.add_row(["", &format!("  {reason}")]);
            }
            Verdict::Passed => {}
        }
    }
    for column in 4..8 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

fn figure(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        v if (1e-2..1e4).contains(&v) => format!("{v:.3}"),
        v => format!("{v:.2e}"),
    }
}

fn summary(outcome: &Outcome) -> String {
    let count = |test: &dyn Fn(&&Row) -> bool| outcome.rows.iter().filter(test).count();
    let exact = count(&|row| row.profile == "exact");
    let differ: u64 = outcome.rows.iter().filter_map(|row| row.mismatches).sum();
    let compared: u64 = outcome
        .rows
        .iter()
        .filter(|row| row.mismatches.is_some())
        .map(|row| row.compared)
        .sum();
    let refused = count(&|row| matches!(row.verdict, Verdict::Refused(_)));
    format!(
        "{} of {} rows failed, {refused} refused; exact profile: {differ} of {compared} results in \
         {exact} rows differ from the CPU's",
        outcome.failures(),
        outcome.rows.len()
    )
}
