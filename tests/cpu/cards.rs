//! The committed report cards: of the rows that there are, with the reference's hashes; and
//! the README's table, which is made of them.

use corput::bulk::Reference;
use corput::card::{SCHEMA, kernels};
use corput::catalog::{Engine, FUNCTIONS};
use corput::check::{Row, arguments, cases, compare_points, function_words};
use serde_json::Value;
use std::collections::BTreeMap;

/// The drivers in the README's order.
const DRIVERS: [&str; 2] = ["llvmpipe", "swiftshader"];

const AGAIN: &str = "run scripts/cards";

fn path(name: &str) -> String {
    format!("{}/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn card(driver: &str) -> Value {
    let text = std::fs::read_to_string(path(&format!("docs/cards/{driver}.json")));
    serde_json::from_str(&text.expect("it is there")).expect("it is JSON")
}

/// Hashes of the exact rows by name and kernel.
fn hashes(card: &Value) -> BTreeMap<(String, String), String> {
    let rows = card["rows"].as_array().expect("rows");
    let text = |row: &Value, key: &str| row[key].as_str().unwrap_or("").to_owned();
    rows.iter()
        .filter(|row| row["profile"] == "exact")
        .map(|row| {
            (
                (text(row, "name"), text(row, "kernel")),
                text(row, "sha256"),
            )
        })
        .collect()
}

#[test]
fn both_drivers_gave_the_same_bits() {
    let cards = DRIVERS.map(card);
    for card in &cards {
        assert_eq!(card["schema"], SCHEMA);
        assert_eq!(card["failures"], 0);
        assert_eq!(card["left_out"], Value::Array(Vec::new()));
        assert_eq!(
            card["command"]
                .as_str()
                .map(|line| line.starts_with("corput check")),
            Some(true)
        );
    }
    let [one, other] = &cards;
    assert_eq!(one["fingerprint"], other["fingerprint"]);
    let [one, other] = [hashes(one), hashes(other)];
    assert!(one.len() > 500, "{}", one.len());
    assert_eq!(one, other);
    assert!(one.values().all(|hash| hash.len() == 64));
}

/// Cards of other kernels would say nothing of these.
#[test]
fn the_kernels_are_those_of_today() {
    let today = kernels().expect("the stock kernels are as built");
    for driver in DRIVERS {
        let card = card(driver);
        let listed = card["kernels"].as_array().expect("kernels");
        for (one, other) in listed.iter().zip(&today) {
            assert_eq!(one, other, "{driver}: {AGAIN}");
        }
        assert_eq!(listed.len(), today.len(), "{driver}: {AGAIN}");
    }
}

/// llvmpipe's vectors of other widths and other numbers of threads, in their order.
const OTHERS: [&str; 6] = [
    "llvmpipe-0-threads",
    "llvmpipe-1-threads",
    "llvmpipe-128-bits",
    "llvmpipe-2-threads",
    "llvmpipe-256-bits",
    "llvmpipe-512-bits",
];

#[test]
fn vectors_and_threads_do_not_show() {
    let text = std::fs::read_to_string(path("docs/cards/fingerprints.json"));
    let found: BTreeMap<String, String> =
        serde_json::from_str(&text.expect("it is there")).expect("it is JSON");
    let names: Vec<&str> = found.keys().map(String::as_str).collect();
    let mut expected = [&DRIVERS[..], &OTHERS[..]].concat();
    expected.sort_unstable();
    assert_eq!(names, expected, "{AGAIN}");
    let fingerprint = &card(DRIVERS[0])["fingerprint"];
    assert!(found.values().all(|one| one == fingerprint), "{found:?}");
}

/// Functions and points: what the drivers gave is what the reference gives today.
#[test]
fn the_hashes_are_the_reference_s() {
    let hashes = hashes(&card(DRIVERS[0]));
    let of = |name: &str, kernel: &str| {
        let found = hashes.get(&(name.to_owned(), kernel.to_owned()));
        found.unwrap_or_else(|| panic!("no row {name} ({kernel}): {AGAIN}"))
    };
    for function in FUNCTIONS {
        let mut row = Row::exact(function.name, function.kernel);
        for call in arguments(function.kind) {
            row.hash(&function_words(function.name, call));
        }
        let expected = row.judged().sha256.expect("a hash");
        assert_eq!(
            *of(function.name, function.kernel),
            expected,
            "{}: {AGAIN}",
            function.name
        );
    }
    for case in cases().expect("the catalogue is right") {
        let mut reference = Reference::new(&case.request);
        let width = case.request.words_per_point() as usize;
        let row = compare_points(&case, |start, points| {
            let mut words = vec![0; points as usize * width];
            reference.fill(start, &mut words)?;
            Ok(words)
        });
        let expected = row.expect("points").sha256.expect("a hash");
        assert_eq!(
            *of(&case.name, case.kernel),
            expected,
            "{}: {AGAIN}",
            case.name
        );
    }
}

const BEGIN: &str = "<!-- made of docs/cards by scripts/cards -->\n";
const END: &str = "<!-- end -->\n";

/// `CORPUT_WRITE_TABLES=1 cargo test --all-features --test cards` writes it.
#[test]
fn the_readme_has_their_figures() {
    let mut defects = String::new();
    let mut table = "| driver | exact rows | results compared | that differ from the CPU's | native rows within what Vulkan allows | hash of all exact rows |\n|---|---|---|---|---|---|\n".to_owned();
    for driver in DRIVERS {
        let card = card(driver);
        let rows = card["rows"].as_array().expect("rows");
        let sum = |key: &str| -> u64 {
            let exact = rows.iter().filter(|row| row["profile"] == "exact");
            exact.map(|row| row[key].as_u64().unwrap_or(0)).sum()
        };
        let native: Vec<_> = rows
            .iter()
            .filter(|row| row["profile"] == "native")
            .collect();
        let kept = native
            .iter()
            .filter(|row| row["verdict"] == "passed")
            .count();
        for row in native.iter().filter(|row| row["verdict"] == "defect") {
            defects += &format!(
                "- {driver}: `{}`, {:.3} {} at {}\n",
                row["name"].as_str().expect("a name"),
                // What is no number is `null`.
                row["worst"].as_f64().unwrap_or(f64::INFINITY),
                row["unit"].as_str().expect("a unit"),
                row["witness"].as_str().expect("an input"),
            );
        }
        let device = &card["device"];
        let text = |value: &Value| value.as_str().expect("a text").to_owned();
        let title = text(&device["name"]) + " " + &text(&device["driver"]["info"]);
        table += &format!(
            "| [{}](docs/cards/{}.html) | {} | {} | {} | {kept} of {} | `{}` |\n",
            title.trim_end(),
            driver,
            rows.len() - native.len(),
            grouped(sum("compared")),
            sum("mismatches"),
            native.len(),
            &card["fingerprint"].as_str().expect("a fingerprint")[..16],
        );
    }
    if !defects.is_empty() {
        table += &format!("\nDefects of the drivers, in functions of their own:\n\n{defects}");
    }
    let readme = std::fs::read_to_string(path("README.md")).expect("it is there");
    let (before, rest) = readme.split_once(BEGIN).expect("the table's beginning");
    let (found, after) = rest.split_once(END).expect("the table's end");
    if std::env::var_os("CORPUT_WRITE_TABLES").is_some() {
        std::fs::write(
            path("README.md"),
            format!("{before}{BEGIN}\n{table}\n{END}{after}"),
        )
        .expect("it is written");
    } else {
        assert_eq!(found.trim(), table.trim(), "{AGAIN}");
    }
}

/// 1234567 as 1,234,567.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
