//! Estimates of shards against that of all points.

use super::Desk;
use serde_json::{Value, json};
use std::fs;

/// Numbers that must have the bits of a single run.
const NUMBERS: [&str; 10] = [
    "count",
    "sum",
    "sum_of_squares",
    "mean",
    "variance",
    "error",
    "standard_error",
    "start",
    "ranges",
    "total",
];

fn estimate(desk: &Desk, arguments: &str, name: &str) -> Value {
    let line = format!("estimate --json --device cpu {arguments}");
    let text = desk.ask(&line);
    fs::write(desk.path(name), &text).expect("written");
    serde_json::from_str(&text).expect("JSON")
}

fn merge(desk: &Desk, names: &str, to: &str) -> Value {
    let text = desk.say(&format!("merge --json {names}"));
    fs::write(desk.path(to), &text).expect("written");
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn shards_add_up_to_the_bits_of_one_run() {
    for arguments in [
        "--integrand x-squared --sampler sobol --count 65536",
        "--integrand genz-gaussian:d=3,difficulty=2 --sampler random --seed 5 --count 3001",
        "--integrand sobol-g:d=5 --sampler sobol:owen --seed 9 --count 4099 --start 77",
        "--integrand disk-step --sampler hammersley --count 1000",
        "--integrand genz-oscillatory:d=2 --sampler latin-hypercube --seed 2 --count 999",
    ] {
        let desk = Desk::new();
        let whole = estimate(&desk, arguments, "whole");
        for index in 0..3 {
            let shard = estimate(
                &desk,
                &format!("{arguments} --shard {index}/3"),
                &index.to_string(),
            );
            assert_ne!(shard["sum"], whole["sum"]);
        }
        let all = merge(&desk, "2 0 1", "all");
        for name in NUMBERS {
            assert_eq!(all[name], whole[name], "{arguments}: {name}");
        }
        let text = |names: &str| desk.say(&format!("merge --json {names}"));
        // Any order and any grouping has the same text, and merging one alone changes nothing.
        merge(&desk, "0 2", "02");
        merge(&desk, "1 2", "12");
        for names in ["0 1 2", "1 02", "02 1", "0 12", "all", "whole"] {
            assert_eq!(text(names), text("2 0 1"), "{arguments}: {names}");
        }
        let two: Value =
            serde_json::from_slice(&fs::read(desk.path("02")).expect("a file")).expect("JSON");
        assert_eq!(two["ranges"].as_array().map(Vec::len), Some(2));
        let said = desk.say("merge 0 1 2");
        assert!(said.contains("in 1 range, of 3 files"), "{said}");
        let mean = format!("mean            {}\n", whole["mean"]);
        assert!(said.contains(&mean), "{said}");
    }
}

#[test]
fn ranges_of_a_sequence_need_no_shards() {
    let desk = Desk::new();
    let points = "--integrand x-squared --sampler halton";
    let whole = estimate(&desk, &format!("{points} --count 500"), "whole");
    estimate(&desk, &format!("{points} --count 200"), "a");
    estimate(&desk, &format!("{points} --first 200 --count 300"), "b");
    let both = merge(&desk, "b a", "both");
    for name in NUMBERS {
        assert_eq!(both[name], whole[name], "{name}");
    }
    // Of a set the points depend on how many there are.
    let points = "--integrand x-squared --sampler latin-hypercube";
    estimate(&desk, &format!("{points} --count 200"), "a");
    estimate(&desk, &format!("{points} --first 200 --count 300"), "b");
    desk.run("merge a b")
        .expect(2, &["its total is 500, and 200 in a"]);
}

#[test]
fn a_device_adds_to_the_cpu() {
    if super::skips() {
        return;
    }
    let desk = Desk::new();
    let points = "--integrand x-squared --sampler sobol --count 100000";
    let whole = estimate(&desk, points, "whole");
    estimate(&desk, &format!("{points} --shard 0/2"), "cpu");
    let line = format!("estimate --json {points} --shard 1/2 --device llvmpipe");
    fs::write(desk.path("device"), desk.ask(&line)).expect("written");
    let both = merge(&desk, "device cpu", "both");
    for name in NUMBERS {
        assert_eq!(both[name], whole[name], "{name}");
    }
}

#[test]
fn estimates_that_do_not_belong_together() {
    let desk = Desk::new();
    let points = "--integrand genz-gaussian:d=2 --sampler random --count 100 --seed 1";
    let whole = estimate(&desk, points, "whole");
    estimate(&desk, &format!("{points} --shard 0/2"), "half");
    for (other, words) in [
        (
            points.replace("--seed 1", "--seed 2 --start 100"),
            "its seed is 2, and 1 in whole",
        ),
        (
            points.replace("random", "pcg32"),
            "its sampler is \"pcg32\"",
        ),
        (
            points.replace("d=2", "d=2,difficulty=3"),
            "its parameters is",
        ),
        (
            points.replace("gaussian", "oscillatory"),
            "its integrand is",
        ),
        (
            points.replace("100", "101"),
            "its points 0 to 99 are in whole too",
        ),
        (points.to_owned(), "its points 0 to 99 are in whole too"),
    ] {
        estimate(&desk, &other, "other");
        desk.run("merge whole other")
            .expect(2, &["cannot use other", words]);
    }
    let run = desk.run("merge half whole");
    run.expect(2, &["its points 0 to 49 are in", "half", "whole"]);
    // Documents that were changed.
    for (name, value, words) in [
        ("count", json!(99), "its `count`"),
        ("sum", json!("12x"), "its `sum`"),
        ("sum_of_squares", json!("0"), "its `sum`"),
        ("scale", json!(2_000_000_000), "its `sum`"),
        (
            "ranges",
            json!([{ "first": 5, "count": 0 }]),
            "its `ranges`",
        ),
        (
            "ranges",
            json!([{ "first": 4_294_967_290_u32, "count": 100 }]),
            "its `ranges`",
        ),
        (
            "ranges",
            json!([{ "first": 50, "count": 50 }, { "first": 0, "count": 50 }]),
            "its `ranges`",
        ),
        ("version", json!("0.0.1"), "its version is \"0.0.1\""),
        ("pixels", json!([]), "it is a picture"),
    ] {
        let mut changed = whole.clone();
        changed[name] = value;
        fs::write(desk.path("changed"), changed.to_string()).expect("written");
        desk.run("merge whole changed").expect(2, &[words]);
    }
    let mut lacking = whole;
    lacking.as_object_mut().expect("an object").remove("seed");
    fs::write(desk.path("changed"), lacking.to_string()).expect("written");
    desk.run("merge changed").expect(2, &["it has no `seed`"]);
    let line = "estimate --integrand x-squared --sampler sobol --count 4 --device cpu --shard 0/5";
    desk.run(line)
        .expect(2, &["shard 0/5 of 4 points", "at most 4 shards"]);
}
