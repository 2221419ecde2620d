//! `corput verify` of a store: its chunks made again.

use super::{Desk, raw_hash, skips};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::fs;

const POINTS: &str = "sobol --count 5000000 --dims 2 --scramble shift --seed 4 --device cpu";

/// Three chunks of 2^21 rows of 8 bytes, the last not full.
fn store() -> Desk {
    let desk = Desk::new();
    desk.say(&format!("generate {POINTS} --out s.zarr"));
    desk
}

fn flip(desk: &Desk, name: &str, at: usize) {
    let mut bytes = desk.bytes(name);
    bytes[at] ^= 1;
    fs::write(desk.path(name), bytes).expect("written");
}

fn verify(desk: &Desk, options: &str, code: i32, words: &[&str]) {
    let line = format!("verify s.zarr --device cpu {options}");
    desk.run(&line).tells(code, words);
}

#[test]
fn what_is_whole_is_said_to_be_equal() {
    let desk = store();
    let before = desk.tree("s.zarr");
    let hash = raw_hash(&desk, POINTS);
    let devices = if skips() {
        &["--device cpu"][..]
    } else {
        &["--device cpu", ""]
    };
    for device in devices {
        assert_eq!(
            desk.say(&format!("verify s.zarr {device}")),
            format!("s.zarr: all 5000000 rows are equal; SHA-256 {hash}\n")
        );
        for range in ["0..1", "2097151..2097153", "4999999..5000000"] {
            let said = desk.say(&format!("verify s.zarr {device} --range {range}"));
            assert!(said.contains(&format!("rows {range} are equal")), "{said}");
        }
    }
    assert!(desk.tree("s.zarr") == before, "it only reads");
}

#[test]
fn a_damaged_chunk_is_named_with_its_rows() {
    let desk = store();
    // Rows 1000 and 1001 of chunk 1.
    flip(&desk, "s.zarr/c/1/0", 8004);
    flip(&desk, "s.zarr/c/1/0", 8008);
    let words = [
        "s.zarr differs: chunk 1 is damaged (its hash is not the one recorded)",
        "row 2098152, column 1 is ",
        "and must be ",
        "2 of 5000000 rows and 1 of 3 chunks differ",
    ];
    verify(&desk, "", 1, &words);
    // Of a range only the rows count.
    verify(&desk, "--range 0..2098152", 0, &[]);
    verify(&desk, "--range 2098154..5000000", 0, &[]);
    verify(
        &desk,
        "--range 2098153..2098154",
        1,
        &[
            "chunk 1: row 2098153, column 0",
            "1 of 1 rows and 1 of 1 chunks",
        ],
    );
    // The padding counts by the chunk's hash.
    let desk = store();
    flip(&desk, "s.zarr/c/2/0", (1 << 24) - 1);
    verify(
        &desk,
        "",
        1,
        &["chunk 2 is damaged", "; 1 of 3 chunks differ"],
    );
    verify(&desk, "--range 4194304..5000000", 0, &[]);
}

#[test]
fn chunks_that_are_not_as_recorded_are_named() {
    let desk = store();
    let whole = desk.tree("s.zarr");
    let restore = |name: &str| {
        let bytes = &whole[std::path::Path::new(name)];
        fs::write(desk.path("s.zarr").join(name), bytes).expect("written");
    };
    fs::remove_file(desk.path("s.zarr/c/0/0")).expect("removed");
    fs::write(desk.path("s.zarr/c/2/0"), [0; 100]).expect("written");
    verify(&desk, "", 1, &["chunk 0 is missing; 2 of 3 chunks differ"]);
    verify(
        &desk,
        "--range 0..9",
        1,
        &["chunk 0 is missing; 1 of 1 chunks"],
    );
    verify(&desk, "--range 5000..4200000", 1, &["2 of 3 chunks"]);
    restore("c/0/0");
    verify(
        &desk,
        "",
        1,
        &["chunk 2 is of the wrong length (100 bytes)"],
    );
    restore("c/2/0");
    fs::remove_file(desk.path("s.zarr/corput/1.json")).expect("removed");
    verify(&desk, "", 1, &["chunk 1 is without a record"]);
    verify(&desk, "--range 2097152..2097162", 0, &[]);
    let other = String::from_utf8_lossy(&whole[std::path::Path::new("corput/1.json")]).into_owned();
    let other = other.replace("\"array\": \"", "\"array\": \"0");
    fs::write(desk.path("s.zarr/corput/1.json"), other).expect("written");
    verify(
        &desk,
        "",
        1,
        &["chunk 1 is of an array with other arguments"],
    );
    restore("corput/1.json");
    verify(&desk, "", 0, &[]);
}

/// As of a broken device, or of a hand that also changed the record.
#[test]
fn a_chunk_of_other_points_with_the_hash_of_its_record_is_found() {
    let desk = store();
    flip(&desk, "s.zarr/c/1/0", 5);
    let mut record: Value =
        serde_json::from_slice(&desk.bytes("s.zarr/corput/1.json")).expect("JSON");
    let hash = Sha256::digest(desk.bytes("s.zarr/c/1/0"));
    record["sha256"] = json!(corput::report::hexadecimal(&hash));
    fs::write(desk.path("s.zarr/corput/1.json"), record.to_string()).expect("written");
    // A merge compares hashes alone.
    desk.merged("s.zarr");
    let words = [
        "chunk 1 has its recorded hash, so remove s.zarr/c/1/0 before it is made again: row 2097152",
        "1 of 5000000 rows and 1 of 3 chunks differ",
    ];
    verify(&desk, "", 1, &words);
    fs::remove_file(desk.path("s.zarr/c/1/0")).expect("removed");
    desk.run(&format!("generate {POINTS} --out s.zarr"))
        .expect(0, &["2 of 3 chunks were there"]);
    verify(&desk, "", 0, &[]);
}

#[test]
fn what_is_no_store_of_these_points_is_refused() {
    let desk = Desk::new();
    let line = "generate halton --count 10 --device cpu --out s.zarr";
    desk.say(line);
    verify(&desk, "--range 5..11", 2, &["it has the rows 0..10"]);
    let text = String::from_utf8(desk.bytes("s.zarr/zarr.json")).expect("UTF-8");
    let path = desk.path("s.zarr/zarr.json");
    for (from, to, words) in [
        (
            "\"count\": 10",
            "\"count\": 11",
            "its arguments make 11 x 2 of <f4, and it says 10 x 2",
        ),
        ("\"halton\"", "\"haltn\"", "unknown sequence `haltn`"),
        ("\"count\"", "\"counts\"", "use the version"),
        ("\"corput\"", "\"mine\"", "no attribute `corput`"),
    ] {
        let changed = text.replace(from, to);
        assert_ne!(changed, text);
        fs::write(&path, changed).expect("written");
        verify(&desk, "", 2, &[words]);
    }
    let version = format!("\"version\": \"{}\"", env!("CARGO_PKG_VERSION"));
    let changed = text.replace(&version, "\"version\": \"0.0.9\"");
    assert_ne!(changed, text);
    fs::write(&path, changed).expect("written");
    verify(
        &desk,
        "",
        1,
        &["0.0.9", "points may differ", "other arguments"],
    );
    fs::remove_file(path).expect("removed");
    verify(
        &desk,
        "",
        2,
        &["s.zarr/zarr.json", "corput generate --out STORE.zarr"],
    );
}

/// Native functions have the bits of the device that is recorded.
#[test]
fn another_device_of_native_functions_is_told() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "generate sobol --count 50 --map cone --param theta_max=0.5 --profile native";
    desk.say(&format!("{line} --device cpu --out s.zarr"));
    desk.say("verify s.zarr --device cpu");
    let run = desk.run("verify s.zarr");
    assert!(
        run.stderr.contains("native functions of cpu"),
        "{}",
        run.stderr
    );
}
