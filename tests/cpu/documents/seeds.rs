//! Small documents of every kind that are read. `CORPUT_WRITE_TABLES=1 cargo test --release
//! --all-features --test documents` writes them.

use super::properties::journal_words;
use corput::report::zarr::Store;
use corput::report::{
    Document, Element, Form, Format, Layout, Origin, Sidecar, Sink, Target, hexadecimal,
};
use serde_json::json;
use sha2::{Digest, Sha256};
use std::fs;
use std::num::NonZero;

type Seed = (&'static str, &'static str, Vec<u8>);

/// Reader, file name and bytes of each.
pub fn seeds() -> Vec<Seed> {
    let mut seeds = files();
    seeds.extend(journals());
    seeds.extend(stores());
    let text = |reader, name, text: &str| (reader, name, text.as_bytes().to_vec());
    seeds.push(text("estimates", "two-ranges.json", TWO_RANGES));
    seeds.push(text("estimates", "whole.json", WHOLE));
    seeds.push(text("baseline", "one.json", ONE));
    seeds.push(text("baseline", "two.json", TWO));
    seeds
}

/// FILE.json of rows, and of a picture.
fn files() -> Vec<Seed> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("p.csv");
    let layout = Layout {
        rows: 2,
        columns: 2,
        element: Element::F32,
    };
    let arguments = json!({ "sequence": "halton", "count": 2, "seed": null });
    let origin = Origin {
        arguments,
        device: "cpu".into(),
    };
    let words = [0.0, 0.0, 0.5, 0.3].map(f32::to_bits);
    let target = Target::from(path.as_path());
    let mut sink = Sink::open(&target, Format::Csv, layout, origin.clone()).expect("a file");
    sink.write(&words).expect("a file");
    sink.finish().expect("a file");
    let picture = folder.path().join("m.png");
    let form = Form {
        format: "png",
        shape: vec![4, 4],
        descr: ">u2",
        header: 0,
    };
    let document = Document::open_described(&Target::from(picture.as_path())).expect("a file");
    document
        .finish_described(b"a picture", &form, &origin)
        .expect("a file");
    let read = |path| fs::read(Sidecar::path_of(path)).expect("a document");
    vec![
        ("file", "rows.json", read(&path)),
        ("file", "picture.json", read(&picture)),
    ]
}

/// Lines of chunks, the last of them cut off or with another number.
fn journals() -> Vec<Seed> {
    let line = |(number, words): (usize, &[u32])| {
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let sha256 = hexadecimal(&Sha256::digest(&bytes));
        let line = json!({ "chunk": number, "bytes": bytes.len(), "sha256": sha256 });
        format!("{line}\n")
    };
    let words = journal_words();
    let lines: Vec<String> = words.chunks(8).enumerate().map(line).collect();
    let two = lines[..2].concat();
    let cut = format!("{two}{}", &lines[2][..40]);
    vec![
        ("journal", "two.jsonl", two.into_bytes()),
        ("journal", "cut.jsonl", cut.into_bytes()),
        ("journal", "four.jsonl", lines[..4].concat().into_bytes()),
    ]
}

/// Descriptions of arrays.
fn stores() -> Vec<Seed> {
    let folder = tempfile::tempdir().expect("a folder");
    let describe = |name: &str, columns, element, shards: Option<u64>| {
        let path = folder.path().join(name);
        let layout = Layout {
            rows: 5_000_000,
            columns,
            element,
        };
        let arguments = json!({ "sequence": "sobol", "count": 5_000_000 });
        let origin = json!({ "version": "0.1.0", "arguments": arguments });
        let store = match shards {
            Some(shards) => {
                let shards = NonZero::new(shards).expect("some");
                Store::create_in_shards(&path, layout, &origin, shards)
            }
            None => Store::create(&path, layout, &origin),
        };
        assert_eq!(store.expect("a store").shards(), shards);
        fs::read(path.join("zarr.json")).expect("a document")
    };
    vec![
        ("zarr", "f32.json", describe("a", 2, Element::F32, None)),
        (
            "zarr",
            "u16.json",
            describe("b", 20_000, Element::U16, None),
        ),
        (
            "zarr",
            "shards.json",
            describe("c", 2, Element::F32, Some(8)),
        ),
    ]
}

const WHOLE: &str = r#"{"version": "0.1.0", "integrand": "x-squared", "estimator": null, "dimensions": 1,
 "parameters": {}, "sampler": "sobol", "scramble": "none", "seed": null, "total": null,
 "independent": false, "truth": 0.3333333333333333, "term_error": 0.0, "scale": 32, "start": 0,
 "count": 4, "sum": "6", "sum_of_squares": "14", "ranges": [{"first": 0, "count": 4}]}
"#;

const TWO_RANGES: &str = r#"{"version": "0.1.0", "integrand": "genz-oscillatory", "estimator": null,
 "dimensions": 2, "parameters": {"difficulty": 2.0}, "sampler": "random", "scramble": null, "seed": 5,
 "total": 9, "independent": true, "truth": 0.5, "term_error": 1e-9, "scale": -3,
 "count": 5, "sum": "-170141183460469231731", "sum_of_squares": "28948022309329048855892746252171976962977",
 "ranges": [{"first": 1, "count": 2}, {"first": 7, "count": 3}]}
"#;

const ONE: &str = r#"{"schema": "corput-bench/1", "command": "corput bench --json", "device": "cpu",
 "jobs": [{"name": "Halton d=2", "bytes": 134217728, "median_s": 0.25, "deviation_s": 0.001, "fill_s": 0.125}]}
"#;

const TWO: &str = r#"{"schema": "corput-bench/1", "device": "llvmpipe", "jobs": [
 {"name": "a", "median_s": 1e-3, "deviation_s": 0, "fill_s": 1e-4},
 {"name": "b", "median_s": 2, "deviation_s": 0.1, "fill_s": 1}]}
"#;
