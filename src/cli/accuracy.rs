//! `corput accuracy`.

use super::args::AccuracyArgs;
use super::{host, interrupt, print, progress};
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use corput::accuracy::{
    self, About, Accuracy, Comparison, chart, csv, figure, floor, json, millions, names, page,
    subjects,
};
use corput::plot::to_png;
use corput::report::{Document, Target, create_folder};
use corput::vulkan::DeviceInfo;
use corput::{Error, Result};
use std::path::Path;

/// Pixels of the PNG per unit of the plot.
const SCALE: f32 = 2.0;

pub fn run(args: &AccuracyArgs) -> anyhow::Result<()> {
    if args.list {
        names().for_each(print);
        return Ok(());
    }
    let subjects = subjects(&args.function)?;
    interrupt::clean_up();
    let device = host::open(args.device.as_deref())?;
    let report = match &args.report {
        Some(folder) => Some(Report::open(folder)?),
        None => None,
    };
    let bar = progress::rows();
    let comparisons = accuracy::run(&device, &subjects, &mut |done, name| {
        interrupt::stop(done as u64, subjects.len() as u64)?;
        bar.inc(1);
        bar.set_message(name.to_owned());
        Ok(())
    })?;
    bar.finish_and_clear();
    host::validated(device.instance())?;
    let about = about(device.info());
    if args.json {
        print(&serde_json::to_string_pretty(&json(&about, &comparisons))?);
    } else {
        print(&format!("{}; {}", about.device, about.driver));
        print(&table(&comparisons).to_string());
        print(
            "errors in ULP, those before `relative` of the floor where a true result is smaller; \
             M/s: millions of results a second; loop: its share of the native time",
        );
    }
    if let Some(report) = report {
        report.write(&about, &comparisons)?;
    }
    let failures = comparisons.iter().filter(|one| one.mismatches > 0).count();
    if failures > 0 {
        return Err(Error::CheckFailed {
            failures,
            total: comparisons.len(),
        }
        .into());
    }
    Ok(())
}

fn about(info: &DeviceInfo) -> About {
    let (major, minor, patch) = info.api_version;
    About {
        device: format!("{} ({})", info.name, info.kind.name()),
        driver: format!(
            "{} {}, Vulkan {major}.{minor}.{patch}",
            info.driver_name, info.driver_info
        ),
        device_uuid: info.device_uuid.clone(),
        command: host::command(),
    }
}

/// The files of a report, opened before the work that fills them.
struct Report([Document; 5]);

impl Report {
    fn open(folder: &Path) -> Result<Self> {
        create_folder(folder, "--report")?;
        let open =
            |ending: &str| Document::open(&Target::File(folder.join(format!("accuracy.{ending}"))));
        Ok(Self([
            open("html")?,
            open("svg")?,
            open("png")?,
            open("json")?,
            open("csv")?,
        ]))
    }

    fn write(self, about: &About, comparisons: &[Comparison]) -> anyhow::Result<()> {
        let svg = chart(&about.device, comparisons)?;
        let document = serde_json::to_string_pretty(&json(about, comparisons))? + "\n";
        let png = to_png(&svg, SCALE)?;
        let Self([html_file, svg_file, png_file, json_file, csv_file]) = self;
        html_file.finish(page(about, comparisons, &svg).as_bytes())?;
        svg_file.finish(svg.as_bytes())?;
        png_file.finish(&png)?;
        json_file.finish(document.as_bytes())?;
        csv_file.finish(csv(comparisons).as_bytes())?;
        Ok(())
    }
}

fn table(comparisons: &[Comparison]) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Disabled)
        .set_header([
            "",
            "function",
            "floor",
            "exact: worst",
            "mean",
            "relative",
            "pdf",
            "M/s",
            "+-",
            "native: worst",
            "mean",
            "relative",
            "pdf",
            "M/s",
            "+-",
            "exact takes",
            "loop",
        ]);
    for one in comparisons {
        let sign = if one.mismatches == 0 { "ok" } else { "FAILED" };
        let mut row = vec![
            sign.to_owned(),
            one.name.to_owned(),
            floor(one.exact.judged.floor),
        ];
        row.extend(cells(&one.exact));
        row.extend(cells(&one.native));
        row.push(
            one.price()
                .map_or("-".into(), |price| format!("{price:.1} x")),
        );
        row.push(one.loop_share().map_or("-".into(), percent));
        table.add_row(row);
        if one.mismatches > 0 {
            let words = format!(
                "  {} of {} differ from the CPU's",
                one.mismatches, one.compared
            );
            table.add_row(["", &words]);
        }
    }
    for column in 2..17 {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

fn cells(one: &Accuracy) -> [String; 6] {
    let dash = |cell: Option<String>| cell.unwrap_or_else(|| "-".to_owned());
    [
        figure(one.judged.errors.worst_ulp),
        figure(one.judged.errors.mean_ulp),
        figure(one.judged.worst_relative_ulp),
        dash(one.judged.pdf.map(|pdf| figure(pdf.worst_ulp))),
        dash(one.speed.map(|speed| millions(speed.results_per_s()))),
        dash(one.speed.map(|speed| percent(speed.spread()))),
    ]
}

fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}
