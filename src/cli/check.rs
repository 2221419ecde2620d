//! `corput check`.

use super::args::CheckArgs;
use super::{host, print, progress};
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use corput::Error;
use corput::card::{Card, Files, Supplement};
use corput::check::{self, Options, Outcome, Row, Verdict, figure};
use corput::report::{Document, Target};
use serde_json::json;
use std::path::Path;
use std::time::Duration;

pub fn run(args: &CheckArgs) -> anyhow::Result<()> {
    if let Some([one, other]) = args.compare.as_deref() {
        return compared(one, other, args.json);
    }
    let time = args.seconds.map(seconds).transpose()?;
    if args.extreme {
        return super::extreme::run(args, time);
    }
    if args.exhaustive {
        return super::exhaustive::run(args, time);
    }
    // The folder first: the other file may be in it.
    let files = args.report.as_deref().map(Files::open).transpose()?;
    let junit = junit_file(args)?;
    let device = host::open(args.device.as_deref())?;
    let options = Options {
        only: args.only.clone(),
        time,
    };
    let bar = progress::rows();
    let outcome = check::run(&device, &options, &mut |row| {
        bar.inc(1);
        bar.set_message(row.name.clone());
    })?;
    bar.finish_and_clear();
    // A part of the check has none.
    let whole = args.report.is_some() && args.only.is_none() && args.seconds.is_none();
    let supplement = whole.then(|| Supplement::measure(&device)).transpose()?;
    let line = host::line(device.info());
    let card = Card {
        info: device.info(),
        outcome: &outcome,
        supplement: supplement.as_ref(),
        command: &host::command(),
    };
    if let Some(junit) = junit {
        junit.finish(card.junit(&line).as_bytes())?;
    }
    if let Some(files) = files {
        card.write(files)?;
    }
    if args.json {
        print(&serde_json::to_string_pretty(&card.document()?)?);
    } else {
        print(&line);
        print(&table(&outcome).to_string());
        print(&format!(
            "fingerprint of the exact rows: {}",
            card.fingerprint()
        ));
        print(&summary(&outcome));
        if let Some(more) = &supplement {
            print(&supplemented(more));
        }
    }
    host::validated(device.instance())?;
    outcome.result()?;
    Ok(supplement.map_or(Ok(()), |more| more.result())?)
}

/// The file of `--junit`, opened before any work.
pub fn junit_file(args: &CheckArgs) -> corput::Result<Option<Document>> {
    let path = args.junit.clone();
    path.map(|path| Document::open(&Target::File(path)))
        .transpose()
}

/// A time that is one.
fn seconds(asked: f64) -> corput::Result<Duration> {
    Duration::try_from_secs_f64(asked).map_err(|_| Error::Arguments {
        asked: format!("--seconds {asked}"),
        limit: "it is from 0 to below 2^64".into(),
        remedy: "give a number of seconds, as 30".into(),
    })
}

fn compared(one: &Path, other: &Path, json: bool) -> anyhow::Result<()> {
    let found = check::compare(one, other)?;
    if json {
        print(&serde_json::to_string_pretty(&json!({
            "equal": found.equal,
            "differ": found.differ,
            "only_in_one": found.only,
            "native_that_differ": found.native,
        }))?);
    } else {
        for name in &found.differ {
            print(&format!("differs      {name}"));
        }
        for name in &found.only {
            print(&format!("only in one  {name}"));
        }
        print(&format!(
            "{} exact rows have equal hashes, {} differ, {} are in one alone; {} native rows differ, as \
             they may",
            found.equal,
            found.differ.len(),
            found.only.len(),
            found.native
        ));
    }
    Ok(found.result()?)
}

/// How a row ended, in a word.
pub fn sign(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Passed => "ok",
        Verdict::Failed => "FAILED",
        Verdict::Defect => "DEFECT",
        Verdict::Refused(_) => "refused",
    }
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
        table.add_row([
            sign(&row.verdict).to_owned(),
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
            Verdict::Failed | Verdict::Defect => {
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

/// What failed of the rest, and how much of it there is.
fn supplemented(more: &Supplement) -> String {
    let mut lines: Vec<String> = Vec::new();
    for row in &more.catalogue {
        lines.extend(
            row.failure
                .as_ref()
                .map(|why| format!("FAILED  {}: {why}", row.case.input)),
        );
    }
    for one in more.statistics.iter().filter(|one| !one.passes()) {
        lines.push(format!(
            "FAILED  {}, {}: {}",
            one.of,
            one.what,
            figure(one.value)
        ));
    }
    lines.push(format!(
        "{} extreme inputs and {} statistics: {} failed",
        more.catalogue.len(),
        more.statistics.len(),
        more.failures()
    ));
    lines.join("\n")
}

/// What there was no time for, as the end of a sentence.
pub fn left_out(names: &[String]) -> String {
    match names.len() {
        0 => String::new(),
        left => format!("; no time was left for {left} more: {}", names.join(", ")),
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
    let defects = match outcome.defects() {
        0 => String::new(),
        1 => "; 1 function of the driver's own is beyond what Vulkan allows".to_owned(),
        many => format!("; {many} functions of the driver's own are beyond what Vulkan allows"),
    };
    let left_out = left_out(&outcome.left_out);
    format!(
        "{} of {} rows failed, {refused} refused; exact profile: {differ} of {compared} results in \
         {exact} rows differ from the CPU's{defects}{left_out}",
        outcome.failures(),
        outcome.rows.len()
    )
}
