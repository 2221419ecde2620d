//! A study in shards against a single run: the same errors, whoever was killed meanwhile.

#[path = "study/refused.rs"]
mod refused;

use super::{Desk, Run, Worker};
use serde_json::Value;
use std::fs;

/// Six cells.
const STUDY: &str = "converge --integrand x-squared --integrand genz-gaussian:d=3 \
                     --sampler random,halton,sobol:owen-hash --max-count 1024 --replicates 4";

fn shard(desk: &Desk, options: &str, shard: &str) -> Run {
    let line = format!("{STUDY} --device cpu --report out --shard {shard} {options}");
    desk.run(&line)
}

fn document(desk: &Desk, folder: &str) -> Value {
    serde_json::from_slice(&desk.bytes(&format!("{folder}/results.json"))).expect("JSON")
}

/// What of a document is of no machine: all but times, devices and how it was run.
fn errors(mut document: Value) -> Value {
    let all = document.as_object_mut().expect("an object");
    for name in ["command", "device", "shards", "standings"] {
        all.remove(name).expect(name);
    }
    for series in document["series"].as_array_mut().expect("series") {
        let series = series.as_object_mut().expect("an object");
        for name in ["device", "setup_ms", "first_dispatch_ms"] {
            series.remove(name).expect(name);
        }
        for point in series["points"].as_array_mut().expect("points") {
            let point = point.as_object_mut().expect("an object");
            for name in ["seconds", "host_seconds"] {
                point.remove(name).expect(name);
            }
        }
    }
    document
}

/// The errors of a single run.
fn whole(desk: &Desk) -> Value {
    desk.run(&format!("{STUDY} --device cpu --report whole"))
        .expect(0, &[]);
    errors(document(desk, "whole"))
}

#[test]
fn two_processes_and_a_merge_are_a_single_run() {
    let desk = Desk::new();
    let line = |shard| format!("{STUDY} --device cpu --report out --shard {shard}");
    let workers = ["0/2", "1/2"].map(|shard| (shard, Worker::start(&desk, &line(shard))));
    for (shard, worker) in workers {
        let run = worker.end(&line(shard));
        run.expect(0, &[]);
        let said = run.text();
        assert!(
            said.starts_with(&format!("shard {shard} has 3 cells:\n")),
            "{said}"
        );
        assert_eq!(said.matches(": measured\n").count(), 3, "{said}");
    }
    assert!(!desk.path("out/report.html").exists());
    let again = shard(&desk, "", "1/2");
    again.tells(
        0,
        &[
            "  x-squared, halton: kept\n  genz-gaussian:d=3, random: kept\n",
            "the study is complete: corput merge out writes its report",
        ],
    );
    let run = desk.run("merge out");
    run.expect(0, &["open out/report.html"]);
    assert!(run.text().contains("to 1e-2: use "), "{}", run.text());
    let merged = document(&desk, "out");
    assert_eq!(errors(merged.clone()), whole(&desk));
    assert_eq!(merged["shards"], 2);
    let device = "cpu (the reference, every core)";
    assert_eq!(merged["device"], device);
    assert_eq!(merged["series"][5]["device"], device);
    let command = merged["command"].as_str().expect("text");
    let lines: Vec<&str> = command.lines().collect();
    assert!(
        lines[0].ends_with("--shard 0/2") && lines[1].ends_with("--shard 1/2"),
        "{command}"
    );
    assert_eq!(lines[2], "corput merge out");
    let page = String::from_utf8(desk.bytes("out/report.html")).expect("text");
    assert!(page.contains("2 shards measured their cells apart"));
    // Cells stay, so that the report can be made again.
    let files = desk.tree("out");
    desk.run("merge out --json").expect(0, &[]);
    let times = |tree: &std::collections::BTreeMap<std::path::PathBuf, Vec<u8>>| {
        tree.get(std::path::Path::new("results.csv")).cloned()
    };
    assert_eq!(times(&desk.tree("out")), times(&files));
}

#[test]
fn a_killed_shard_goes_on_and_keeps_others_away() {
    let desk = Desk::new();
    // Cells of a second or so.
    let long = STUDY.replace("1024", "65536").replace("owen-hash", "owen");
    let line = format!("{long} --device cpu --report out --shard 0/2");
    let file = desk.path("out/cells-0-of-2.jsonl");
    let kept = || {
        let text = fs::read_to_string(&file).unwrap_or_default();
        text.matches('\n').count().saturating_sub(1)
    };
    let worker = Worker::start(&desk, &line);
    worker.wait_until(|| kept() >= 1);
    desk.run(&line).expect(
        2,
        &[
            "cells-0-of-2.jsonl: another run is writing this file",
            "wait for that run",
        ],
    );
    // With SIGKILL.
    drop(worker);
    let left = kept();
    assert!(
        (1..3).contains(&left),
        "killed too late to show anything: {left} cells"
    );
    // And in the middle of a line.
    let text = fs::read_to_string(&file).expect("cells");
    fs::write(&file, format!("{text}{{\"key\":\"0")).expect("written");
    let run = desk.run(&line);
    run.expect(0, &[]);
    let said = run.text();
    assert_eq!(said.matches(": kept\n").count(), left, "{said}");
    assert_eq!(said.matches(": measured\n").count(), 3 - left, "{said}");
    desk.run(&line.replace("0/2", "1/2")).expect(0, &[]);
    desk.run("merge out").expect(0, &[]);
    desk.run(&format!("{long} --device cpu --report whole"))
        .expect(0, &[]);
    assert_eq!(
        errors(document(&desk, "out")),
        errors(document(&desk, "whole"))
    );
}

#[test]
fn missing_cells_are_named_with_their_shard() {
    let desk = Desk::new();
    shard(&desk, "", "0/2").tells(
        0,
        &[
            "the study lacks 3 cells:",
            "  x-squared, halton: --shard 1/2 measures it",
        ],
    );
    let run = desk.run("merge out");
    run.tells(
        1,
        &[
            "3 of 6 cells are missing:",
            "  x-squared, halton: --shard 1/2 measures it",
            "  genz-gaussian:d=3, sobol:owen-hash: --shard 1/2 measures it",
            "corput: study in out: 3 of 6 cells are missing; run the shards",
        ],
    );
    assert!(!desk.path("out/report.html").exists());
    let named = desk.run("merge out --shards 6 --json");
    named.tells(1, &["\"complete\": false", "\"shard\": \"5/6\""]);
    // More shards than cells.
    shard(&desk, "", "6/7").expect(0, &["shard 6/7 is empty", "6 cells"]);
    // The others by another number of shards.
    shard(&desk, "--json", "1/3").tells(0, &["\"measured\": true", "\"shard\": \"5/7\""]);
    for (index, code) in [(3, 1), (5, 0)] {
        shard(&desk, "", &format!("{index}/6")).expect(0, &[]);
        assert_eq!(desk.run("merge out").code, Some(code));
    }
    assert_eq!(errors(document(&desk, "out")), whole(&desk));
}

#[test]
fn times_of_two_devices_are_not_compared() {
    if super::skips() {
        return;
    }
    let desk = Desk::new();
    shard(&desk, "", "0/2").expect(0, &[]);
    let line = format!("{STUDY} --device llvmpipe --report out --shard 1/2");
    desk.run(&line).expect(0, &[]);
    let run = desk.run("merge out");
    run.expect(0, &[]);
    let said = run.text();
    assert!(
        said.contains("of several devices, whose times are not comparable")
            && !said.contains(": use "),
        "{said}"
    );
    let merged = document(&desk, "out");
    let device = |index: usize| merged["series"][index]["device"].as_str().expect("text");
    assert!(device(0).starts_with("cpu (the reference") && device(1).contains("llvmpipe"));
    assert_eq!(merged["device"], format!("{}; {}", device(0), device(1)));
    assert_eq!(merged["standings"], serde_json::json!([]));
    assert_eq!(errors(merged.clone()), whole(&desk));
    let page = String::from_utf8(desk.bytes("out/report.html")).expect("text");
    assert!(
        page.contains("run times are not comparable") && !page.contains("<strong>random</strong>")
    );
    let row = format!("<td>{}</td>", corput::report::escape(device(1)));
    assert_eq!(page.matches(&row).count(), 3, "{row}");
}
