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
    let (header, data) = bytes.split_at(bytes.len() - 8192);
    let file = |name: &str, bytes: &[u8]| std::fs::write(desk.path(name), bytes).unwrap();
    file("empty.npy", b"");
    file("cut.npy", &bytes[..bytes.len() - 3]);
    file("long.npy", &[&bytes[..], b"more"].concat());
    file("header.npy", &header[..40]);
    file(
        "huge.npy",
        b"\x93NUMPY\x02\x00\xff\xff\xff\xff{'descr': '<f4'",
    );
    for (name, value) in [
        ("nan.npy", f32::NAN),
        ("infinite.npy", f32::INFINITY),
        ("one.npy", 1.0),
        ("negative.npy", -0.25),
    ] {
        file(
            name,
            &[&bytes[..bytes.len() - 4], &value.to_le_bytes()].concat(),
        );
    }
    // Other shapes and types in a header of the same length.
    let text = String::from_utf8_lossy(&header[10..]).into_owned();
    for (name, old, new) in [
        ("flat.npy", "(1024, 2), }", "(2048,), }  "),
        ("solid.npy", "(1024, 2), }  ", "(512, 2, 2), }"),
        ("none.npy", "(1024, 2), }", "(0, 2), }   "),
        (
            "terabytes.npy",
            "(1024, 2), }       ",
            "(999999999999, 2),}",
        ),
        (
            "endless.npy",
            "(1024, 2), }                ",
            "(18446744073709551615, 2), }",
        ),
        ("integers.npy", "'<f4'", "'<i4'"),
        ("objects.npy", "'<f4'", "'|O' "),
    ] {
        let turned = text.replacen(old, new, 1);
        assert!(turned != text && turned.len() == text.len(), "{name}");
        file(name, &[&header[..10], turned.as_bytes(), data].concat());
    }
    let before = desk.names();
    for (line, words) in [
        ("gone.npy", &["gone.npy", "can be read"][..]),
        (".", &["cannot use points .", "can be read"]),
        ("text.npy", &["text.npy", "no .npy file"]),
        ("cut.npy", &["cut.npy", "truncated", "8192 bytes"]),
        ("empty.npy", &["no .npy file"]),
        (
            "long.npy",
            &["8192 bytes of data", "more", "one array a file"],
        ),
        ("header.npy", &["ends within its header"]),
        ("huge.npy", &["4294967295 bytes", "65536"]),
        (
            "nan.npy",
            &["row 1023, column 1 is NaN", "[0, 1)", "replace"],
        ),
        ("infinite.npy", &["row 1023, column 1 is inf", "[0, 1)"]),
        ("one.npy", &["row 1023, column 1 is 1;", "[0, 1)", "scale"]),
        ("negative.npy", &["row 1023, column 1 is -0.25", "[0, 1)"]),
        ("flat.npy", &["1 dimension ", "must be 2-D", "reshape"]),
        ("solid.npy", &["3 dimensions", "must be 2-D"]),
        ("none.npy", &["empty: shape (0, 2)", "at least one point"]),
        ("terabytes.npy", &["(999999999999, 2)", "268435456 values"]),
        (
            "endless.npy",
            &["(18446744073709551615, 2)", "268435456 values"],
        ),
        ("integers.npy", &["'<i4'", "f4, f8 or u4", "astype"]),
        ("objects.npy", &["'|O'", "f4, f8 or u4"]),
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
        assert_eq!(desk.names(), before, "`{line}` left files");
    }
}
