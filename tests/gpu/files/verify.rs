//! `corput verify`: what it finds, and what it refuses.

use super::{Desk, devices};
use serde_json::{Value, json};
use std::fs;

/// Two chunks of floats, rows of 8 bytes.
const LINE: &str = "generate halton --count 1000 --dims 2 --chunk-rows 600 --device cpu";

fn desk(name: &str) -> Desk {
    let desk = Desk::new();
    desk.run(&format!("{LINE} --out {name}")).expect(0, &[]);
    desk
}

fn flip(desk: &Desk, name: &str, at: usize) {
    let mut bytes = desk.bytes(name);
    bytes[at] ^= 1;
    fs::write(desk.path(name), bytes).unwrap();
}

#[test]
fn what_is_whole_is_said_to_be_equal() {
    for name in ["p.npy", "p.raw", "p.csv"] {
        let desk = desk(name);
        let sidecar: Value = serde_json::from_slice(&desk.bytes(&format!("{name}.json"))).unwrap();
        let sum = sidecar["sha256"].as_str().unwrap();
        for device in devices() {
            let run = desk.run(&format!("verify {name} {device}"));
            run.expect(0, &[]);
            assert_eq!(
                run.text(),
                format!("{name}: all 1000 rows are equal; SHA-256 {sum}\n")
            );
            assert_eq!(run.stderr, "");
            for range in ["0..1", "999..1000", "0..1000", "590..610"] {
                let run = desk.run(&format!("verify {name} {device} --range {range}"));
                run.expect(0, &[]);
                assert!(
                    run.text().contains(&format!("rows {range} are equal")),
                    "{}",
                    run.text()
                );
            }
        }
    }
}

#[test]
fn a_flipped_bit_is_found() {
    let desk = desk("p.npy");
    // The last bit of row 700, column 1, and of row 702.
    flip(&desk, "p.npy", 4096 + 700 * 8 + 4);
    flip(&desk, "p.npy", 4096 + 702 * 8);
    let words = [
        "p.npy differs: row 700, column 1 is ",
        "and must be ",
        "2 of 1000 rows differ",
    ];
    for device in devices() {
        desk.run(&format!("verify p.npy {device}"))
            .expect(1, &words);
    }
    let line = "verify p.npy --device cpu --range";
    desk.run(&format!("{line} 0..700")).expect(0, &[]);
    desk.run(&format!("{line} 701..702")).expect(0, &[]);
    desk.run(&format!("{line} 700..701"))
        .expect(1, &["row 700", "1 of 1 rows differ"]);
    desk.run(&format!("{line} 701..1000"))
        .expect(1, &["row 702, column 0", "1 of 299 rows"]);
}

#[test]
fn a_header_and_a_digit_are_found() {
    let desk = desk("p.npy");
    flip(&desk, "p.npy", 70);
    desk.run("verify p.npy --device cpu")
        .expect(1, &["its header is not"]);

    let desk = self::desk("p.csv");
    let text = String::from_utf8(desk.bytes("p.csv")).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let changed = text.replacen(lines[501], &lines[501].replacen('5', "6", 1), 1);
    assert_ne!(changed, text);
    fs::write(desk.path("p.csv"), changed).unwrap();
    desk.run("verify p.csv --device cpu")
        .expect(1, &["row 500 is `", "1 of 1000 rows differ"]);
    desk.run("verify p.csv --device cpu --range 501..1000")
        .expect(0, &[]);
}

#[test]
fn a_cut_file_differs_and_a_missing_one_is_refused() {
    let desk = desk("p.npy");
    let bytes = desk.bytes("p.npy");
    fs::write(desk.path("p.npy"), &bytes[..bytes.len() - 1]).unwrap();
    desk.run("verify p.npy --device cpu")
        .expect(1, &["it has 12095 bytes, and 12096 by its sidecar"]);
    // With a sidecar that says so it is still no such array.
    let sidecar = String::from_utf8(desk.bytes("p.npy.json")).unwrap();
    let shorter = sidecar.replace("\"bytes\": 12096", "\"bytes\": 12095");
    assert_ne!(shorter, sidecar);
    fs::write(desk.path("p.npy.json"), shorter).unwrap();
    desk.run("verify p.npy --device cpu --range 0..5")
        .expect(1, &["it has 12095 bytes, and 12096 by its shape"]);
    fs::remove_file(desk.path("p.npy")).unwrap();
    desk.run("verify p.npy --device cpu")
        .expect(2, &["p.npy", "can be read"]);
}

#[test]
#[cfg(unix)]
fn links_lead_to_files_and_folders_are_no_files() {
    let desk = desk("p.npy");
    std::os::unix::fs::symlink("p.npy", desk.path("l.npy")).unwrap();
    desk.run("verify l.npy --device cpu").expect(0, &[]);
    flip(&desk, "p.npy", 5000);
    desk.run("verify l.npy --device cpu")
        .expect(1, &["p.npy differs"]);
    fs::create_dir(desk.path("s.zarr")).unwrap();
    desk.run("verify s.zarr")
        .expect(2, &["s.zarr/zarr.json: there is no such file"]);
}

#[test]
fn ranges_outside_are_refused() {
    let desk = desk("p.npy");
    for (range, words) in [
        ("0..1001", "it has the rows 0..1000"),
        ("1000..1001", "it has the rows 0..1000"),
        ("5..5", "a range has one at least"),
        ("6..5", "a range has one at least"),
        ("5", "is no range"),
        ("a..b", "is no range"),
        ("-1..5", "is no range"),
    ] {
        desk.run(&format!("verify p.npy --device cpu --range {range}"))
            .expect(2, &[words]);
    }
}

#[test]
fn sidecars_that_do_not_fit_are_told() {
    let desk = desk("p.npy");
    let whole: Value = serde_json::from_slice(&desk.bytes("p.npy.json")).unwrap();
    let run = |place: &str, value: Value| {
        let mut changed = whole.clone();
        match changed.pointer_mut(place) {
            Some(old) => *old = value,
            None => changed["arguments"][place] = value,
        }
        fs::write(desk.path("p.npy.json"), changed.to_string()).unwrap();
        desk.run("verify p.npy --device cpu")
    };
    let other = "0".repeat(64);
    run("/sha256", json!(other)).expect(1, &["its SHA-256 is", "by its sidecar"]);
    run("/chunks/1/sha256", json!(other)).expect(1, &["chunk 1 has not the SHA-256"]);
    run("/chunks/1/bytes", json!(3201)).expect(1, &["other chunks"]);
    run("/chunks", json!([])).expect(2, &["`chunks` is missing or of a wrong kind"]);
    run("/chunk_rows", json!(5)).expect(2, &["`chunks`"]);
    run("/chunk_rows", json!(0)).expect(2, &["`chunks`"]);
    run("/version", json!("0.0.9")).expect(0, &["warning", "0.0.9", "points may differ"]);
    run("/arguments/first", json!(1)).expect(1, &["1000 of 1000 rows differ"]);
    run("/arguments/count", json!(999)).expect(2, &["999 x 2 of <f4", "1000 x 2"]);
    run("/arguments/sequence", json!("haltn")).expect(2, &["unknown sequence"]);
    run("/arguments", Value::Null).expect(2, &["recorded arguments", "use the version"]);
    run("later_option", json!(5)).expect(2, &["later_option", "use the version"]);
    run("/schema", json!("corput-file/9")).expect(2, &["corput-file/9"]);
    fs::remove_file(desk.path("p.npy.json")).unwrap();
    desk.run("verify p.npy --device cpu")
        .expect(2, &["p.npy.json", "FILE.json beside it"]);
}
