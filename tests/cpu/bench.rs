//! Jobs of `corput bench` by name, and measurements against earlier ones.

use corput::Error;
use corput::bench::{
    Baseline, Goal, Machine, Measurement, Verdict, changes, chosen, jobs, json, slower,
};
use serde_json::{Value, json};

fn machine() -> Machine {
    Machine {
        device: "a device".into(),
        threads: 2,
        command: "corput bench".into(),
    }
}

/// A measurement of these times.
fn measured(name: &str, median_s: f64, deviation_s: f64, fill_s: f64) -> Measurement {
    Measurement {
        name: name.into(),
        kernel: "kernel".into(),
        points: 1 << 20,
        bytes: 1 << 22,
        cold_s: 1.0,
        median_s,
        deviation_s,
        fill_s,
        goal: Some(Goal::Fill(1.5)),
    }
}

/// A document as a baseline.
fn baseline(document: &Value) -> corput::Result<Baseline> {
    let desk = tempfile::tempdir().expect("a folder");
    let path = desk.path().join("before.json");
    std::fs::write(&path, document.to_string()).expect("written");
    Baseline::read(&path)
}

/// The verdict on a job of these seconds after one of 0.1 s, with fills of 50 ms before.
fn verdict(median_s: f64, deviation_s: f64, fill_s: f64) -> Verdict {
    let before = [measured("job", 0.1, 0.001, 0.05)];
    let before = baseline(&json(&machine(), &before, None)).expect("a baseline");
    let now = [measured("job", median_s, deviation_s, fill_s)];
    changes(&now, &before)[0].verdict
}

#[test]
fn noise_and_other_machines_are_no_change() {
    assert_eq!(verdict(0.1, 0.001, 0.05), Verdict::Same);
    assert_eq!(verdict(0.109, 0.001, 0.05), Verdict::Same);
    assert_eq!(verdict(0.15, 0.001, 0.05), Verdict::Slower);
    assert_eq!(verdict(0.06, 0.001, 0.05), Verdict::Faster);
    // Half as slow again, with a spread that explains it.
    assert_eq!(verdict(0.15, 0.03, 0.05), Verdict::Same);
    assert_eq!(verdict(0.06, 0.02, 0.05), Verdict::Same);
    // All of the machine is slower, or faster; or its memory alone is.
    assert_eq!(verdict(0.2, 0.001, 0.1), Verdict::Same);
    assert_eq!(verdict(0.05, 0.001, 0.025), Verdict::Same);
    assert_eq!(verdict(0.1, 0.001, 0.02), Verdict::Same);
    // Slower on a machine that is faster.
    assert_eq!(verdict(0.2, 0.001, 0.02), Verdict::Slower);
}

#[test]
fn slower_jobs_are_an_error_and_new_ones_are_named() {
    let document = json(&machine(), &[measured("a", 0.1, 0.001, 0.05)], None);
    let before = baseline(&document).expect("a baseline");
    assert_eq!(before.device, "a device");
    assert!(before.has("a") && !before.has("b"));
    let now = [
        measured("a", 0.1, 0.001, 0.05),
        measured("b", 0.2, 0.001, 0.05),
    ];
    let found = changes(&now, &before);
    assert_eq!(found[1].verdict, Verdict::New);
    assert_eq!((found[1].seconds, found[1].fills), (None, None));
    slower(&found).expect("nothing is slower");
    let found = changes(&[measured("a", 0.3, 0.001, 0.05)], &before);
    let error = slower(&found).expect_err("it is slower");
    assert_eq!(error.exit_code(), 1);
    assert!(error.to_string().contains("1 of 1 jobs"), "{error}");
    let document = json(&machine(), &now, Some(&found));
    assert_eq!(document["changes"][0]["verdict"], "slower");
    assert_eq!(document["jobs"][1]["goal_reached"], false);
    assert_eq!(document["jobs"][1]["times_fill"], 4.0);
}

#[test]
fn what_is_no_baseline_is_refused() {
    let whole = json(&machine(), &[measured("a", 0.1, 0.001, 0.05)], None);
    baseline(&whole).expect("a baseline");
    let broken = |path: &str, value: Value| {
        let mut document = whole.clone();
        *document.pointer_mut(path).expect("it is there") = value;
        let error = baseline(&document).expect_err(path);
        assert_eq!(error.exit_code(), 2);
        error.to_string()
    };
    assert!(broken("/schema", json!("corput-bench/0")).contains("its schema"));
    for (path, value) in [
        ("/jobs", json!([])),
        ("/jobs", json!(7)),
        ("/jobs/0/name", json!(null)),
        ("/jobs/0/median_s", json!(0.0)),
        ("/jobs/0/median_s", json!("0.1")),
        ("/jobs/0/deviation_s", json!(-1.0)),
        ("/jobs/0/fill_s", json!(null)),
    ] {
        let said = broken(path, value);
        assert!(said.contains("lacks its name or times"), "{said}");
        assert!(said.contains("corput bench --json"), "{said}");
    }
    let none = Baseline::read("nowhere.json".as_ref()).expect_err("no file");
    assert!(matches!(none, Error::Document { .. }), "{none}");
}

#[test]
fn jobs_are_chosen_by_parts_of_their_names() {
    let all = jobs().expect("jobs");
    assert_eq!(chosen(&[]).expect("all").len(), all.len());
    let names = |only: &[&str]| {
        let only: Vec<String> = only.iter().map(|&text| text.into()).collect();
        let found = chosen(&only).expect("some");
        found.into_iter().map(|job| job.name).collect::<Vec<_>>()
    };
    assert_eq!(
        names(&["halton"]),
        [
            "Halton d=2",
            "Halton d=4",
            "Halton d=8",
            "Halton d=32",
            "Halton d=2, permuted",
            "Halton d=8, permuted"
        ]
    );
    assert_eq!(names(&["R2", "van der"]), ["van der Corput", "R2 d=2"]);
    let error = chosen(&["halton".into(), "faure".into()]).expect_err("none");
    assert!(error.to_string().contains("unknown job `faure`"), "{error}");
    // No two have one name, by which baselines find them.
    let mut unique: Vec<_> = all.iter().map(|job| &job.name).collect();
    unique.sort();
    unique.dedup();
    assert_eq!(unique.len(), all.len());
    // Enough words that a dispatch's start does not show.
    for job in &all {
        let words = job.request.count * u64::from(job.request.words_per_point());
        assert!(
            (1 << 22..=1 << 25).contains(&words),
            "{}: {words}",
            job.name
        );
    }
}
