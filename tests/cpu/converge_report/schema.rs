//! `docs/schemas/converge-2.json` describes what is written.

use super::json_schema::faults;
use super::{plain, results, written};
use corput::converge::{Engine, Results, Setting, Settings, Study, rows};
use serde_json::{Value, json};

const SCHEMA: &str = include_str!("../../../docs/schemas/converge-2.json");

fn check(document: &Value) -> Vec<String> {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    faults(&schema, &schema, document, "")
}

fn document(results: &Results) -> Value {
    let files = written(results);
    let file = files.iter().find(|(name, _)| name == "results.json");
    serde_json::from_slice(&file.unwrap().1).unwrap()
}

/// A study of the reference.
fn measured() -> Results {
    let samplers = ["random", "halton", "stratified", "sobol:owen"];
    let samplers = samplers.map(|name| corput::catalog::Sampler::parse(name).unwrap());
    let mut all = rows("x-squared", &[], &samplers).unwrap();
    all.extend(rows("disk-step", &[], &samplers).unwrap());
    let settings = Settings {
        max_count: 256,
        replicates: 4,
        targets: vec![1e-1, 1e-9],
        ..Settings::default()
    };
    let study = Study::new(all, settings).unwrap();
    let setting = Setting::new(&study, "cpu".into(), "corput converge".into());
    corput::converge::run(&Engine::Cpu, &study, setting, None, &mut |_, _, _| Ok(())).unwrap()
}

#[test]
fn a_study_is_as_the_schema_says() {
    let document = document(&measured());
    assert_eq!(check(&document), Vec::<String>::new());
    let reached = |index: usize| {
        document["standings"][index]["reached_by"]
            .as_array()
            .unwrap()
    };
    assert!(!reached(0).is_empty() && reached(1).is_empty());
}

#[test]
fn what_is_rare_is_as_the_schema_says() {
    let mut study = plain();
    for series in &mut study.series {
        series.cell.refused = vec![(16, "none".into())];
        series.cell.warnings = vec!["careful".into()];
        series.truth.uncertainty = Some(1e-3);
        series.estimator = Some("mis");
        for point in &mut series.cell.points {
            point.means.fill(f64::NAN);
        }
        let statistic = corput::converge::Statistic::MedianAbsolute;
        let (cell, truth) = (&series.cell, &series.truth);
        series.analysis = corput::converge::Analysis::new(cell, truth, true, statistic, None);
    }
    assert_eq!(check(&document(&study)), Vec::<String>::new());
    let empty = document(&results(Vec::new()));
    assert_eq!(check(&empty), Vec::<String>::new());
}

#[test]
fn broken_documents_are_not() {
    let whole = document(&plain());
    assert_eq!(check(&whole), Vec::<String>::new());
    let breaks: [(&str, Value); 8] = [
        ("/schema", json!("corput-converge/1")),
        ("/replicates", json!(1)),
        ("/counts", json!([])),
        ("/series/0/statistic", json!("mean")),
        ("/series/0/points/1/seconds/median", json!(-1.0)),
        ("/series/0/points/1/means/0", json!("0.5")),
        ("/series/0/slope", json!({ "value": 1, "odd": 2 })),
        ("/standings/0/relative_error", json!(0)),
    ];
    for (place, value) in breaks {
        let mut broken = whole.clone();
        *broken.pointer_mut(place).unwrap() = value;
        assert_ne!(check(&broken), Vec::<String>::new(), "{place}");
    }
    for place in ["", "/series/0", "/series/0/points/0", "/standings/0"] {
        let mut names: Vec<String> = Vec::new();
        names.extend(
            whole
                .pointer(place)
                .unwrap()
                .as_object()
                .unwrap()
                .keys()
                .cloned(),
        );
        for name in names {
            let mut broken = whole.clone();
            let object = broken.pointer_mut(place).unwrap().as_object_mut().unwrap();
            let value = object.remove(&name).unwrap();
            assert_ne!(check(&broken), Vec::<String>::new(), "no {name}");
            let object = broken.pointer_mut(place).unwrap().as_object_mut().unwrap();
            object.insert(format!("{name}2"), value);
            assert!(check(&broken).len() > 1, "{name}2");
        }
    }
}
