//! Stores against the specification of Zarr v3, by a reader of it that is written here, and by
//! zarr-python.

use super::python::python;
use super::{Desk, raw_hash};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::process::Command;

/// The bytes of a two-dimensional array in C order, as the specification reads them: keys by
/// the default encoding, chunks of a regular grid, those that overhang cropped, a missing one
/// all fill value.
fn read(store: &Path) -> Vec<u8> {
    let text = fs::read(store.join("zarr.json")).expect("metadata");
    let meta: Value = serde_json::from_slice(&text).expect("JSON");
    assert_eq!(meta["zarr_format"], 3);
    assert_eq!(meta["node_type"], "array");
    assert_eq!(meta["chunk_grid"]["name"], "regular");
    assert_eq!(meta["chunk_key_encoding"]["name"], "default");
    assert_eq!(
        meta["chunk_key_encoding"]["configuration"]["separator"],
        "/"
    );
    let codec = json!([{ "name": "bytes", "configuration": { "endian": "little" } }]);
    assert_eq!(meta["codecs"], codec);
    let pair = |value: &Value| -> [usize; 2] {
        assert_eq!(value.as_array().map(Vec::len), Some(2), "{value}");
        [0, 1].map(|axis| value[axis].as_u64().expect("a number") as usize)
    };
    let shape = pair(&meta["shape"]);
    let chunk = pair(&meta["chunk_grid"]["configuration"]["chunk_shape"]);
    let float = || meta["fill_value"].as_f64().expect("a float");
    let integer = || meta["fill_value"].as_u64().expect("an integer");
    let fill = match meta["data_type"].as_str() {
        Some("float32") => (float() as f32).to_le_bytes().to_vec(),
        Some("float64") => float().to_le_bytes().to_vec(),
        Some("uint32") => (integer() as u32).to_le_bytes().to_vec(),
        Some("uint16") => (integer() as u16).to_le_bytes().to_vec(),
        other => panic!("data type {other:?}"),
    };
    let size = fill.len();
    let mut array = Vec::new();
    for row in 0..shape[0] {
        assert_eq!(shape[1], chunk[1], "one chunk across");
        if row % chunk[0] == 0 {
            let index = row / chunk[0];
            let path = store.join(format!("c/{index}/0"));
            let bytes = fs::read(path).unwrap_or_else(|_| fill.repeat(chunk[0] * chunk[1]));
            // Every chunk has the whole shape.
            assert_eq!(bytes.len(), size * chunk[0] * chunk[1], "chunk {index}");
            let rows = chunk[0].min(shape[0] - row);
            let (inside, padding) = bytes.split_at(size * rows * shape[1]);
            array.extend_from_slice(inside);
            assert!(padding.chunks(size).all(|word| word == fill), "padding");
        }
    }
    array
}

/// Requests whose last chunk overhangs, the rows of a chunk, and the type.
const CASES: [(&str, u64, &str); 6] = [
    (
        "halton --count 1000 --dims 3 --fractions --device cpu",
        1 << 20,
        "uint32",
    ),
    (
        "sobol --count 2097153 --dims 2 --device cpu",
        1 << 21,
        "float32",
    ),
    (
        "sobol --count 300 --dims 20000 --scramble owen-hash --seed 7 --device cpu",
        128,
        "float32",
    ),
    (
        "sobol --count 4194305 --dims 2 --type u16 --device cpu",
        1 << 22,
        "uint16",
    ),
    (
        "sobol --count 1048577 --dims 2 --type f64 --device cpu",
        1 << 20,
        "float64",
    ),
    (
        "halton --count 1000 --dims 3 --first 9 --type f64 --device cpu",
        1 << 19,
        "float64",
    ),
];

#[test]
fn the_chunks_are_the_points() {
    for (arguments, rows, _) in CASES {
        let desk = Desk::new();
        desk.say(&format!("generate {arguments} --out a.zarr"));
        let text = fs::read(desk.path("a.zarr/zarr.json")).expect("metadata");
        let meta: Value = serde_json::from_slice(&text).expect("JSON");
        assert_eq!(meta["chunk_grid"]["configuration"]["chunk_shape"][0], rows);
        let hash = raw_hash(&desk, arguments);
        let raw = fs::read(desk.path("points.raw")).expect("a raw file");
        assert!(read(&desk.path("a.zarr")) == raw, "{arguments}");
        assert_eq!(desk.merged("a.zarr"), hash, "{arguments}");
        let said = desk.say("verify a.zarr --device cpu");
        assert!(said.ends_with(&format!("SHA-256 {hash}\n")), "{said}");
    }
}

#[test]
fn the_attributes_say_how_to_make_it_again() {
    let desk = Desk::new();
    let picture = super::repository("tests/data/sunrise.exr");
    let line = format!(
        "generate sobol --count 64 --map environment --env {} --seed 5 --scramble owen --device cpu \
         --format zarr --out e",
        picture.display()
    );
    desk.ask(&line);
    let text = fs::read(desk.path("e/zarr.json")).expect("metadata");
    let meta: Value = serde_json::from_slice(&text).expect("JSON");
    let origin = &meta["attributes"]["corput"];
    assert_eq!(origin["version"], env!("CARGO_PKG_VERSION"));
    let arguments = &origin["arguments"];
    for (name, value) in [
        ("sequence", json!("sobol")),
        ("count", json!(64)),
        ("seed", json!(5)),
        ("scramble", json!("owen")),
        ("map", json!("environment")),
    ] {
        assert_eq!(arguments[name], value, "{name}");
    }
    // What differs between machines is not there: the device, and where the picture lies.
    assert!(arguments.get("device").is_none(), "{arguments}");
    assert_eq!(arguments["env"], "sunrise.exr");
    assert_eq!(arguments["env_sha256"].as_str().map(str::len), Some(64));
}

#[test]
fn zarr_python_reads_the_same() {
    let check = "import zarr; assert zarr.__version__ >= '3'";
    let Some(python) = python("zarr-python", &["zarr==3.*"], check) else {
        eprintln!("SKIPPED: zarr-python could not be installed; the reader above stands alone");
        return;
    };
    let script = "import hashlib, sys, zarr\n\
                  a = zarr.open_array(sys.argv[1], mode='r+')\n\
                  a.attrs['note'] = 'mine'\n\
                  print(a.shape, a.dtype, a.chunks, hashlib.sha256(a[:].tobytes()).hexdigest())";
    for (arguments, rows, kind) in CASES {
        let desk = Desk::new();
        desk.say(&format!("generate {arguments} --out a.zarr --shard 0/1"));
        let run = Command::new(&python)
            .args(["-c", script])
            .arg(desk.path("a.zarr"))
            .output()
            .expect("python runs");
        let said = String::from_utf8_lossy(&run.stdout).into_owned();
        let hash = raw_hash(&desk, arguments);
        assert!(
            said.contains(&hash) && said.contains(kind) && said.contains(&format!("({rows}, ")),
            "{said}{}",
            String::from_utf8_lossy(&run.stderr)
        );
        // An attribute of others changes nothing, and leaves ours.
        desk.run("merge a.zarr").expect(0, &[]);
        let meta: Value = serde_json::from_slice(&desk.bytes("a.zarr/zarr.json")).expect("JSON");
        let attributes = &meta["attributes"];
        assert_eq!(
            (&attributes["note"], &attributes["corput_shards"]),
            (&json!("mine"), &json!(1))
        );
    }
}
