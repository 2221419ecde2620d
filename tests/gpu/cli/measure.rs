//! `measure`: its figures, conventions, refusals and what it leaves out.

use super::{Desk, skips};
use serde_json::Value;

/// The document of `measure NAME OPTIONS --json`.
fn document(desk: &Desk, line: &str) -> Value {
    serde_json::from_str(&desk.say(&format!("measure {line} --json"))).unwrap()
}

/// A desk with the Hammersley set of 1,024 points.
fn hammersley() -> Desk {
    let desk = Desk::new();
    desk.make("hammersley --count 1024 --dims 2 --device cpu", "h.npy");
    desk
}

const NAMES: [&str; 11] = [
    "star",
    "l2-star",
    "centred",
    "wrap-around",
    "mixture",
    "modified-l2",
    "t-value",
    "intervals",
    "distance",
    "projections",
    "spectrum",
];

#[test]
fn figures_of_a_net_that_is_known() {
    let desk = hammersley();
    let all = document(&desk, "h.npy");
    assert_eq!(
        (&all["points"], &all["dimensions"]),
        (&1024.into(), &2.into())
    );
    assert_eq!(
        (&all["source"], &all["device"]),
        (&"f32".into(), &Value::Null)
    );
    let measures = &all["measures"];
    let keys: Vec<String> = NAMES.map(|name| name.replace('-', "_")).into();
    let found = measures.as_object().unwrap();
    assert!(found.len() == NAMES.len() && keys.iter().all(|key| found.contains_key(key)));
    // De Clerck 1986: (m/3 + 13/9 - 4/(9 N)) / N for m = 10.
    let star = measures["star"]["value"].as_f64().unwrap();
    let truth = (10.0 / 3.0 + 13.0 / 9.0 - 4.0 / 9216.0) / 1024.0;
    assert!((star - truth).abs() < 1e-12 && measures["star"]["exact"] == true);
    assert_eq!(measures["t_value"]["t"], 0);
    assert_eq!(measures["intervals"]["fair_shapes"], 11);
    assert_eq!(
        measures["intervals"]["shapes"].as_array().unwrap().len(),
        11
    );
    assert_eq!(
        measures["projections"]["worst"]["dimensions"],
        serde_json::json!([0, 1])
    );
    assert!(
        measures["spectrum"]["low_frequency_power"]
            .as_f64()
            .unwrap()
            < 0.1
    );
    let [torus, cube] =
        ["torus", "cube"].map(|k| measures["distance"][k]["value"].as_f64().unwrap());
    assert!(0.0 < torus && torus <= cube);
    for (key, is) in [
        ("star", "supremum"),
        ("l2_star", "square root"),
        ("centred", "square"),
        ("wrap_around", "square"),
        ("mixture", "square"),
        ("modified_l2", "square"),
    ] {
        assert_eq!(measures[key]["is"], is, "{key}");
    }
    let l2 = &measures["l2_star"];
    let [value, square] = ["value", "square"].map(|key| l2[key].as_f64().unwrap());
    assert!((value * value / square - 1.0).abs() < 1e-12);
}

#[test]
fn the_table_says_what_each_value_is() {
    let desk = hammersley();
    let table = desk.say("measure h.npy");
    for name in NAMES {
        let line = table
            .lines()
            .find(|line| line.trim_start().starts_with(name));
        assert!(
            line.is_some_and(|line| !line.contains("skipped")),
            "{name}: {table}"
        );
    }
    let line = |name: &str| {
        let found = table
            .lines()
            .find(|line| line.trim_start().starts_with(name));
        found.unwrap_or_default().to_owned()
    };
    assert!(line("l2-star").contains("square root"));
    assert!(line("star").contains("exact"));
    assert!(line("t-value").contains("(0, 10, 2)-net"));
    assert!(line("intervals").contains("11 of 11"));
    let only = desk.say("measure h.npy --only centred,star");
    assert_eq!(only.lines().count(), 4, "{only}");
    let halton = desk.make("halton --count 1000 --device cpu", "t.npy");
    assert!(!halton.is_empty());
    let only = desk.say("measure t.npy --only intervals,t-value --base 2,3");
    assert!(
        only.contains("40 of 40") && only.contains("no power of 2"),
        "{only}"
    );
}

#[test]
fn three_dimensions_have_bounds() {
    let desk = Desk::new();
    desk.make("halton --count 256 --dims 3 --device cpu", "p.npy");
    let found = document(&desk, "p.npy --only star,distance,spectrum --pair 2,0");
    let star = &found["measures"]["star"];
    let [lower, upper] = ["lower", "upper"].map(|key| star[key].as_f64().unwrap());
    assert!(
        0.0 < lower && lower <= upper && upper < 0.2,
        "{lower} {upper}"
    );
    assert_eq!(
        found["measures"]["distance"]["torus"]["ratio_to_hexagonal"],
        Value::Null
    );
    assert_eq!(
        found["measures"]["spectrum"]["dimensions"],
        serde_json::json!([2, 0])
    );
}

#[test]
fn what_takes_long_is_left_out_aloud() {
    let desk = Desk::new();
    desk.make("halton --count 200000 --device cpu", "p.npy");
    let line = "p.npy --only star,centred,distance,projections";
    let found = &document(&desk, line)["measures"];
    for key in ["star", "centred", "projections"] {
        let reason = found[key]["skipped"].as_str().unwrap();
        assert!(
            reason.contains("4.0e10 steps") && reason.contains("--all"),
            "{reason}"
        );
    }
    assert!(found["distance"]["torus"]["value"].as_f64().unwrap() > 0.0);
    let table = desk.say(&format!("measure {line}"));
    assert_eq!(table.matches("skipped: N^2").count(), 3, "{table}");
}

#[test]
fn a_device_agrees_with_the_cpu() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    desk.make(
        "halton --count 3000 --dims 5 --fractions --device cpu",
        "p.npy",
    );
    let line = "p.npy --only l2-star,centred,wrap-around,mixture,modified-l2,distance";
    let cpu = document(&desk, line);
    let gpu = document(&desk, &format!("{line} --device 0"));
    assert!(cpu["device"].is_null() && gpu["device"].is_string());
    for key in [
        "l2_star",
        "centred",
        "wrap_around",
        "mixture",
        "modified_l2",
    ] {
        let [a, b] = [&cpu, &gpu].map(|document| {
            let found = &document["measures"][key];
            let number = |name: &str| found[name].as_f64().unwrap();
            assert_eq!(found["points_are"], "as in the file");
            (number("square"), number("square_error_at_most"))
        });
        assert!(
            (a.0 - b.0).abs() <= a.1 + b.1 && b.1 < 1e-12,
            "{key}: {a:?} {b:?}"
        );
    }
    for place in ["torus", "cube"] {
        let [a, b] = [&cpu, &gpu].map(|document| {
            let found = &document["measures"]["distance"][place];
            (found["value"].as_f64().unwrap(), found["rows"].clone())
        });
        assert!(
            (a.0 / b.0 - 1.0).abs() < 1e-14 && a.1 == b.1,
            "{place}: {a:?} {b:?}"
        );
    }
    let same = document(&desk, &format!("{line} --device cpu"));
    assert_eq!(same, cpu);
}

#[test]
fn bad_input_is_refused() {
    let desk = hammersley();
    std::fs::write(desk.path("text.npy"), "0.5,0.5\n").unwrap();
    desk.make(
        "halton --count 10 --map uniform-hemisphere --device cpu",
        "d.npy",
    );
    let bytes = desk.bytes("h.npy");
    std::fs::write(desk.path("cut.npy"), &bytes[..bytes.len() - 3]).unwrap();
    let mut nan = bytes.clone();
    let at = nan.len() - 4;
    nan[at..].copy_from_slice(&f32::NAN.to_le_bytes());
    std::fs::write(desk.path("nan.npy"), nan).unwrap();
    for (line, words) in [
        ("gone.npy", &["gone.npy", "can be read"][..]),
        (".", &["cannot use points .", "can be read"]),
        ("text.npy", &["text.npy", "no .npy file"]),
        ("cut.npy", &["cut.npy", "truncated", "8192 bytes"]),
        ("nan.npy", &["row 1023, column 1 is NaN", "[0, 1)"]),
        ("d.npy", &["d.npy", "[0, 1)", "scale"]),
        ("h.npy --only stra", &["unknown measure `stra`", "`star`"]),
        ("h.npy --base 2", &["--base 2", "2 dimensions", "as many"]),
        ("h.npy --base 2,1", &["--base 2,1", "2 to 2^32 - 1"]),
        ("h.npy --base 2,4294967296", &["2 to 2^32 - 1"]),
        ("h.npy --base 2,-3", &["-3 is negative"]),
        ("h.npy --pair 0,2", &["--pair 0,2", "0 to 1"]),
        ("h.npy --pair 1,1", &["--pair 1,1", "two different"]),
        ("h.npy --pair 1", &["--pair 1", "two different"]),
    ] {
        let run = desk.run(&format!("measure {line}"));
        run.expect(2, words);
        assert_eq!(run.stdout, b"", "`{line}` wrote to standard output");
    }
}
