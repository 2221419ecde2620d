//! `corput check --exhaustive`.

use super::args::CheckArgs;
use super::check::{junit_file, left_out, sign};
use super::{host, interrupt, print, progress};
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use corput::check::{Verdict, figure, junit};
use corput::exhaustive::{self, About, Hash, Row};
use std::time::Duration;

pub fn run(args: &CheckArgs, time: Option<Duration>) -> anyhow::Result<()> {
    let subjects = exhaustive::chosen(args.only.as_deref())?;
    let document = junit_file(args)?;
    interrupt::clean_up();
    let device = host::open(args.device.as_deref())?;
    let bar = progress::steps();
    let mut finished = Vec::new();
    let found = exhaustive::run(
        &device,
        &subjects,
        time,
        &mut |name, done, total| {
            progress::step(&bar, name, done, total);
            interrupt::stop(done, total)
        },
        &mut |row| {
            // A hidden bar prints nothing.
            match bar.is_hidden() {
                true => eprintln!("{}", line(row)),
                false => bar.println(line(row)),
            }
            finished.push(row.clone());
        },
    );
    bar.finish_and_clear();
    let (rows, later) = match found {
        Ok(found) => found,
        Err(error) => {
            if !args.json && !finished.is_empty() {
                print(&table(&finished).to_string());
            }
            return Err(error.into());
        }
    };
    let about = About {
        device: host::line(device.info()),
        command: host::command(),
    };
    if let Some(document) = document {
        let further: Vec<_> = rows.iter().map(Row::further).collect();
        document.finish(junit(&[], &later, &further, &about.device).as_bytes())?;
    }
    if args.json {
        print(&serde_json::to_string_pretty(&exhaustive::json(
            &about, &rows, &later,
        ))?);
    } else {
        print(&about.device);
        print(&table(&rows).to_string());
        print(&(summary(&rows) + &left_out(&later)));
    }
    host::validated(device.instance())?;
    Ok(exhaustive::result(&rows)?)
}

/// A row as the terminal sees it while others run.
fn line(row: &Row) -> String {
    format!("{} {}, {:.0} s", sign(&row.verdict), row.name, row.seconds)
}

/// Characters of four words.
const WORDS: usize = 40;

fn table(rows: &[Row]) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Disabled)
        .set_header([
            "", "what", "compared", "differ", "worst", "bound", "unit", "at", "rounded", "unknown",
            "hash", "s",
        ]);
    for row in rows {
        let number = |value: Option<f64>| value.map_or(String::new(), figure);
        let hash = match row.hash {
            Hash::Equal => "published",
            Hash::Unpublished => "not published",
            Hash::Differs(_) => "DIFFERS",
        };
        let [.., undecided] = row.figures.roundings;
        let correct = row.correct();
        // What has parameters would widen the column.
        let is_long = row.worst_at.len() > WORDS;
        table.add_row([
            sign(&row.verdict).to_owned(),
            row.name.clone(),
            row.figures.compared.to_string(),
            row.figures.mismatches.to_string(),
            number(row.worst),
            number(row.bound),
            row.unit.to_owned(),
            if is_long {
                String::new()
            } else {
                row.worst_at.clone()
            },
            correct.map_or(String::new(), |share| format!("{:.4} %", 100.0 * share)),
            correct.map_or(String::new(), |_| undecided.to_string()),
            hash.to_owned(),
            format!("{:.0}", row.seconds),
        ]);
        table.add_row(["", &format!("  {}", inputs(row))]);
        if is_long {
            table.add_row(["", &format!("  worst at {}", row.worst_at)]);
        }
        match &row.verdict {
            Verdict::Failed if !row.witness.is_empty() => {
                table.add_row(["", &format!("  {}", row.witness)]);
            }
            Verdict::Refused(reason) => {
                table.add_row(["", &format!("  {reason}")]);
            }
            _ => {}
        }
    }
    for column in [2, 3, 4, 5, 8, 9, 11] {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

/// What a row's inputs are, and how many of them were judged, where not all.
fn inputs(row: &Row) -> String {
    match row.figures.judged {
        0 => row.inputs.clone(),
        judged if judged == row.figures.compared => row.inputs.clone(),
        judged => format!("{}; {judged} judged", row.inputs),
    }
}

fn summary(rows: &[Row]) -> String {
    let count = |test: &dyn Fn(&&Row) -> bool| rows.iter().filter(test).count();
    let differ: u64 = rows.iter().map(|row| row.figures.mismatches).sum();
    let compared: u64 = rows.iter().map(|row| row.figures.compared).sum();
    let seconds: f64 = rows.iter().map(|row| row.seconds).sum();
    format!(
        "{} of {} rows failed, {} refused; {differ} of {compared} results differ from the CPU's; the \
         hashes of {} rows are the published ones, of {} none is published; {seconds:.0} s",
        count(&|row| row.verdict == Verdict::Failed),
        rows.len(),
        count(&|row| matches!(row.verdict, Verdict::Refused(_))),
        count(&|row| row.hash == Hash::Equal),
        count(&|row| row.hash == Hash::Unpublished),
    )
}
