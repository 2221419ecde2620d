//! `corput measure`.

mod device;
mod figures;
mod names;

use super::args::MeasureArgs;
use super::{host, print, progress};
use comfy_table::{ContentArrangement, Table, presets};
use corput::report::read_points;
use corput::{Error, Result};
use device::OnDevice;
use figures::Job;
use names::Measure;
use serde_json::{Map, Value, json};

/// What came of a measure.
struct Outcome {
    /// Its value in a few words, for the table.
    value: String,
    /// What the value is, for the table.
    note: String,
    /// All of it.
    json: Value,
}

impl Outcome {
    /// One that was not measured, and why.
    fn skipped(reason: String) -> Self {
        Self {
            value: "-".to_owned(),
            json: json!({ "skipped": reason }),
            note: format!("skipped: {reason}"),
        }
    }
}

pub fn run(args: &MeasureArgs) -> anyhow::Result<()> {
    let measures = names::chosen(args.only.as_deref())?;
    let points = read_points(&args.file)?;
    let bases = bases(args, points.columns())?;
    let pair = pair(args, points.columns())?;
    let asked = host::asked(args.device.as_deref());
    let device = match asked.is_none() || host::is_cpu(asked.as_deref()) {
        true => None,
        false => Some(OnDevice::new(host::open(args.device.as_deref())?, &points)?),
    };
    let job = Job {
        bases,
        pair,
        device: device.as_ref(),
        all: args.all,
        points: &points,
    };
    let bar = progress::steps();
    let mut outcomes = Vec::new();
    for measure in measures {
        let name = measure.key();
        let mut seen = |done, total| {
            progress::step(&bar, name, done, total);
            Ok(())
        };
        outcomes.push((measure, job.measure(measure, &mut seen)?));
    }
    bar.finish_and_clear();
    let line = device.as_ref().map(OnDevice::line);
    if args.json {
        let list: Map<String, Value> = outcomes
            .iter()
            .map(|(measure, outcome)| (measure.key().to_owned(), outcome.json.clone()))
            .collect();
        let document = json!({
            "version": env!("CARGO_PKG_VERSION"),
            "file": args.file,
            "points": points.rows(),
            "dimensions": points.columns(),
            "source": points.source().name(),
            "device": line,
            "measures": list,
        });
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        let on = line.map_or(String::new(), |line| format!("; pairs by {line}"));
        print(&format!(
            "{}: {} x {} ({}){on}",
            args.file.display(),
            points.rows(),
            points.columns(),
            points.source().name()
        ));
        print(&table(&outcomes).to_string());
    }
    match device {
        Some(device) => Ok(device.validated()?),
        None => Ok(()),
    }
}

fn table(outcomes: &[(Measure, Outcome)]) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Disabled)
        .set_header(["measure", "value", ""]);
    for (measure, outcome) in outcomes {
        table.add_row([measure.name(), &outcome.value, &outcome.note]);
    }
    table
}

/// One base for each dimension.
fn bases(args: &MeasureArgs, columns: usize) -> Result<Vec<u32>> {
    let Some(given) = &args.base else {
        return Ok(vec![2; columns]);
    };
    let refused = |limit: String, remedy: &str| Error::Arguments {
        asked: format!("--base {}", list(given)),
        limit,
        remedy: remedy.to_owned(),
    };
    if given.len() != columns {
        return Err(refused(
            format!("the points have {columns} dimensions, and each takes one base"),
            "give as many bases",
        ));
    }
    let base = |&base: &u64| {
        let in_range = u32::try_from(base).ok().filter(|base| *base >= 2);
        in_range.ok_or_else(|| refused("bases are 2 to 2^32 - 1".into(), "choose primes"))
    };
    given.iter().map(base).collect()
}

/// The dimensions of the spectrum; `None` for points of one dimension.
fn pair(args: &MeasureArgs, columns: usize) -> Result<Option<[usize; 2]>> {
    let given = &args.pair;
    let valid = |at: usize| usize::try_from(given[at]).ok().filter(|k| *k < columns);
    if columns == 1 && given[..] == [0, 1] {
        return Ok(None);
    }
    match given.len() {
        2 if given[0] != given[1] => valid(0).zip(valid(1)),
        _ => None,
    }
    .map(|(first, second)| Some([first, second]))
    .ok_or_else(|| Error::Arguments {
        asked: format!("--pair {}", list(given)),
        limit: format!("the points have dimensions 0 to {}", columns - 1),
        remedy: "give two different ones of them".into(),
    })
}

fn list(numbers: &[u64]) -> String {
    let words: Vec<String> = numbers.iter().map(u64::to_string).collect();
    words.join(",")
}
