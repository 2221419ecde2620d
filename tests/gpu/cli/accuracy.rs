//! `corput accuracy`.

use super::refused::assert_refused;
use super::{Desk, skips};
use corput::accuracy::{SCHEMA, names};
use serde_json::Value;

const FILES: [&str; 5] = [
    "accuracy.csv",
    "accuracy.html",
    "accuracy.json",
    "accuracy.png",
    "accuracy.svg",
];

#[test]
fn what_there_is_is_listed() {
    let desk = Desk::new();
    assert!(desk.say("accuracy --list").lines().eq(names()));
}

#[test]
fn a_report_says_what_the_document_says() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    // What stands there is replaced.
    std::fs::create_dir(desk.path("r")).unwrap();
    std::fs::write(desk.path("r/accuracy.json"), "old").unwrap();
    let line = "accuracy --function divide,cos_sin,cone --json --report r";
    let said: Value = serde_json::from_str(&desk.say(line)).unwrap();
    let kept: Value = serde_json::from_slice(&desk.bytes("r/accuracy.json")).unwrap();
    assert_eq!(said, kept);
    assert_eq!(said["schema"], SCHEMA);
    assert_eq!(said["command"], format!("corput {line}"));
    for key in ["version", "device", "driver", "error_unit"] {
        assert!(
            said[key].as_str().is_some_and(|text| !text.is_empty()),
            "{key}"
        );
    }
    let functions = said["functions"].as_array().unwrap();
    let found: Vec<_> = functions.iter().map(|one| &one["name"]).collect();
    assert_eq!(found, ["divide", "cos_sin", "cone"]);
    for one in functions {
        assert_eq!(one["mismatches"], 0, "{one}");
        assert!(one["compared"].as_u64() > Some(1 << 16), "{one}");
        let number = |value: &Value| value.as_f64().unwrap_or_else(|| panic!("{one}"));
        assert!(number(&one["exact"]["worst_ulp"]) <= 0.55, "{one}");
        for profile in ["exact", "native"] {
            let of = &one[profile];
            assert!(number(&of["mean_ulp"]) <= number(&of["worst_ulp"]), "{one}");
            assert!(
                number(&of["worst_ulp"]) <= number(&of["worst_relative_ulp"]),
                "{one}"
            );
            assert!(
                number(&of["results_per_s"]) > 0.0 && number(&of["spread"]) >= 0.0,
                "{one}"
            );
            assert_eq!(
                of["worst_pdf_ulp"].is_null(),
                one["name"] != "cone",
                "{one}"
            );
        }
        assert!(number(&one["exact_takes"]) > 0.0 && number(&one["loop_results_per_s"]) > 0.0);
    }
    let names = std::fs::read_dir(desk.path("r")).unwrap();
    let mut names: Vec<_> = names.map(|file| file.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, FILES);
    assert!(desk.bytes("r/accuracy.png").starts_with(b"\x89PNG"));
    let page = String::from_utf8(desk.bytes("r/accuracy.html")).unwrap();
    let svg = String::from_utf8(desk.bytes("r/accuracy.svg")).unwrap();
    assert!(page.contains(&svg));
}

#[test]
fn a_table_has_a_line_for_each_function() {
    if skips() {
        return;
    }
    let text = Desk::new().say("accuracy --function sqrt");
    let line = text.lines().find(|line| line.contains(" sqrt ")).unwrap();
    assert!(line.trim_start().starts_with("ok"), "{text}");
    assert!(line.contains(" x "), "{text}");
}

#[test]
fn what_cannot_be_is_refused() {
    if skips() {
        return;
    }
    let unknown = ["unknown function `sqr`", "`sqrt`", "corput accuracy --list"];
    assert_refused("accuracy --function cone,sqr", &unknown);
    assert_refused(
        "accuracy --function sqrt --report file/r",
        &["cannot write", "file/r"],
    );
    assert_refused(
        "accuracy --function sqrt --device cpu",
        &["--device cpu", "corput devices"],
    );
    assert_refused("accuracy --list --json", &["--list"]);
}
