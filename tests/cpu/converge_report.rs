//! The report of a study: its page, figures and document.

#[path = "converge_report/folder.rs"]
mod folder;
#[path = "converge_report/hits.rs"]
mod hits;
#[path = "json_schema.rs"]
mod json_schema;
#[path = "converge_report/page.rs"]
mod page;
#[path = "converge_report/schema.rs"]
mod schema;

use corput::converge::{Analysis, Cell, Point, Results, Series, Setting, Statistic, Truth};
use std::fs;
use std::path::Path;

/// Replicates around 0.5 whose error falls with this power of the count.
fn cell(slope: f64, random: bool) -> Cell {
    let point = |log: u32| {
        let count = 1u64 << log;
        let size = 0.1 * (count as f64 / 16.0).powf(slope);
        let sign = |r: u32| if r.is_multiple_of(2) { 1.0 } else { -1.0 };
        let replicates = if random { 8 } else { 1 };
        let mean = |r: u32| 0.5 + size * sign(r) * (1.0 + 0.1 * f64::from(r));
        Point {
            count,
            means: (0..replicates).map(mean).collect(),
            variances: vec![0.25; replicates as usize],
            device_ns: vec![2e3 * count as f64; 3],
            host_ns: vec![3e3 * count as f64; 3],
        }
    };
    Cell {
        setup_ms: 12.5,
        first_ms: 0.75,
        points: (4..=12).map(point).collect(),
        refused: Vec::new(),
        warnings: Vec::new(),
    }
}

fn series(integrand: &str, sampler: &str, cell: Cell, random: bool) -> Series {
    let truth = Truth::stated(0.5, 1e-9);
    Series {
        integrand: integrand.to_owned(),
        summary: "a function",
        estimator: None,
        dimensions: 2,
        sampler: sampler.to_owned(),
        device: "a device".into(),
        analysis: Analysis::new(&cell, &truth, random, Statistic::Rmse, None),
        truth,
        cell,
    }
}

fn results(series: Vec<Series>) -> Results {
    Results {
        setting: Setting {
            device: "a device".into(),
            command: "corput converge".into(),
            counts: (4..=12).map(|log| 1 << log).collect(),
            replicates: 8,
            seed: 3,
            targets: vec![1e-2, 1e-5],
            shards: 1,
        },
        series,
    }
}

/// A random and a fixed sampler.
fn plain() -> Results {
    results(vec![
        series("one", "random", cell(-0.5, true), true),
        series("one", "halton", cell(-1.0, false), false),
    ])
}

/// The names and bytes of a report's files, in a folder that is gone again.
fn written(results: &Results) -> Vec<(String, Vec<u8>)> {
    let folder = tempfile::tempdir().unwrap();
    let files = corput::converge::write(results, folder.path()).unwrap();
    let read = |path: &Path| {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        (name, fs::read(path).unwrap())
    };
    let files: Vec<_> = files.iter().map(|path| read(path)).collect();
    let entries = fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(entries, files.len(), "files that were not named");
    files
}

fn page_of(results: &Results) -> String {
    let files = written(results);
    let page = files.iter().find(|(name, _)| name == "report.html");
    String::from_utf8(page.unwrap().1.clone()).unwrap()
}
