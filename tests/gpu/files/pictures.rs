//! Pictures of `corput estimate --pixels`: their FILE.json, and `corput verify` of them.

use super::{Desk, devices, json_schema, sha256, sidecar};
use serde_json::{Value, json};
use std::fs;

const LINE: &str = "estimate --integrand soft-shadow:elevation=0.6 --estimator light \
                    --sampler sobol:owen-hash --seed 4 --count 16 --pixels 6x5";

/// File, shape, type, and where its data begin.
const FILES: [(&str, &[u32], &str, usize); 3] = [
    ("p.npy", &[5, 6, 3], "<f4", 4096),
    ("p.exr", &[5, 6], "<f4", 0),
    ("p.png", &[5, 6], ">u2", 0),
];

/// One of the files, made on the CPU.
fn desk(name: &str) -> Desk {
    let desk = Desk::new();
    desk.say(&format!("{LINE} --device cpu --out {name}"));
    desk
}

/// What is told of a picture is not among its bytes.
#[test]
fn standard_output_has_the_picture_alone() {
    let desk = desk("p.npy");
    for (form, told) in [("", "RMS error"), ("--json", "\"rms_error\"")] {
        let run = desk.run(&format!("{LINE} --device cpu --out - {form}"));
        run.expect(0, &[told]);
        assert_eq!(run.stdout, desk.bytes("p.npy"));
    }
    assert_eq!(desk.names(), ["p.npy", "p.npy.json"]);
}

#[test]
fn pictures_are_described_and_verified() {
    let schema: Value =
        serde_json::from_str(include_str!("../../../docs/schemas/file-1.json")).unwrap();
    for (name, shape, kind, start) in FILES {
        let desk = desk(name);
        assert_eq!(desk.names(), [name.to_owned(), format!("{name}.json")]);
        let (bytes, document) = (desk.bytes(name), sidecar(&desk, name));
        let faults = json_schema::faults(&schema, &schema, &document, "");
        assert_eq!(faults, Vec::<String>::new());
        let (data, whole) = (&bytes[start..], sha256(&bytes));
        let chunk = json!({ "bytes": data.len(), "sha256": sha256(data) });
        // No device, and no file.
        let arguments = json!({
            "integrand": "soft-shadow:elevation=0.6",
            "estimator": "light",
            "sampler": "sobol:owen-hash",
            "count": 16,
            "seed": 4,
            "start": 0,
            "pixels": [6, 5],
        });
        for (member, value) in [
            ("arguments", arguments),
            ("device", json!("cpu")),
            ("format", json!(&name[2..])),
            ("shape", json!(shape)),
            ("type", json!(kind)),
            ("bytes", json!(bytes.len())),
            ("sha256", json!(whole)),
            ("chunks", json!([chunk])),
            ("version", json!(env!("CARGO_PKG_VERSION"))),
        ] {
            assert_eq!(document[member], value, "{name}: {member}");
        }
        let length = bytes.len();
        assert_eq!(
            desk.say(&format!("verify {name} --device cpu")),
            format!("{name}: all {length} bytes are equal; SHA-256 {whole}\n")
        );
    }
}

#[test]
fn any_device_makes_the_recorded_bytes() {
    let (desk, files) = (Desk::new(), desk("p.npy"));
    for maker in devices() {
        desk.say(&format!("{LINE} {maker} --out p.npy"));
        assert_eq!(desk.bytes("p.npy"), files.bytes("p.npy"));
        let document = sidecar(&desk, "p.npy");
        assert_eq!(document["device"] == "cpu", !maker.is_empty());
        for device in devices() {
            desk.say(&format!("verify p.npy {device}"));
        }
    }
}

#[test]
fn damage_and_other_arguments_are_found() {
    for (name, ..) in FILES {
        let desk = desk(name);
        let verify = format!("verify {name} --device cpu");
        let whole = desk.bytes(name);
        let mut bytes = whole.clone();
        let at = bytes.len() - 3;
        bytes[at] ^= 1;
        fs::write(desk.path(name), &bytes).unwrap();
        let said = [
            format!("{name} differs: byte {at} is 0x"),
            format!("1 of {} bytes differ", bytes.len()),
        ];
        desk.run(&verify).expect(1, &[&said[0], &said[1]]);
        fs::write(desk.path(name), &whole[..at]).unwrap();
        desk.run(&verify).expect(1, &["it has fewer bytes"]);
        fs::write(desk.path(name), &whole).unwrap();
        desk.run(&format!("{verify} --range 0..4"))
            .expect(2, &["--range of", "a picture is made whole"]);
        desk.run(&format!("{verify} --env p.exr"))
            .expect(2, &["no picture is recorded", "drop --env"]);

        let document = sidecar(&desk, name);
        let run = |place: &str, value: Value| {
            let mut changed = document.clone();
            match changed.pointer_mut(place) {
                Some(old) => *old = value,
                None => changed["arguments"][place] = value,
            }
            let path = desk.path(&format!("{name}.json"));
            fs::write(path, changed.to_string()).unwrap();
            desk.run(&verify)
        };
        run("/sha256", json!("0".repeat(64))).expect(1, &["its SHA-256 is"]);
        run("/chunks/0/sha256", json!("0".repeat(64))).expect(1, &["its chunk is not"]);
        run("/shape/0", json!(6)).expect(1, &["`shape` of its sidecar"]);
        run("/arguments/seed", json!(99)).expect(1, &["bytes differ"]);
        run("/arguments/integrand", json!("soft-shadw")).expect(2, &["`soft-shadow`"]);
        run("/arguments/integrand", json!("x-squared")).expect(2, &["it has only one"]);
        run("/arguments/pixels", json!([6, 0])).expect(2, &["1 to 16777216 pixels"]);
        run("/arguments/pixels", Value::Null).expect(2, &["no pixels", "use the version"]);
        run("later_option", json!(5)).expect(2, &["later_option", "use the version"]);
        run("/format", json!("gif")).expect(2, &["`gif`"]);
        run("/version", json!("0.0.9")).expect(0, &["warning", "0.0.9"]);
    }
}

/// Of seeds, scrambles and sets, with what was chosen by default.
#[test]
fn recorded_arguments_make_the_same_picture() {
    let desk = Desk::new();
    for (arguments, sampler) in [
        ("pixel-edge --sampler random --count 7", "random"),
        (
            "soft-shadow --estimator mis --sampler random --seed 5 --count 7",
            "random",
        ),
        (
            "pixel-edge:radius=2 --estimator uniform --sampler sobol --count 8 --start 77",
            "sobol:none",
        ),
        (
            "soft-shadow --estimator cosine --sampler halton:permute --count 8 \
             --seed 18446744073709551615",
            "halton:permute",
        ),
        ("soft-shadow --sampler lattice --count 8", "lattice:none"),
        (
            "soft-shadow --sampler lattice --seed 3 --count 8",
            "lattice:rotate",
        ),
        (
            "pixel-edge --sampler latin-hypercube --start 2 --count 6",
            "latin-hypercube",
        ),
        ("pixel-edge --sampler sobol:owen --count 1", "sobol:owen"),
    ] {
        let line =
            format!("estimate --pixels 4x3 --device cpu --out p.npy --integrand {arguments}");
        desk.ask(&line);
        let document = sidecar(&desk, "p.npy");
        assert_eq!(document["arguments"]["sampler"], sampler, "{line}");
        assert!(document["arguments"]["estimator"].is_string(), "{line}");
        let run = desk.run("verify p.npy --device cpu");
        assert_eq!(run.code, Some(0), "`{line}`: {}", run.stderr);
    }
}

#[test]
fn files_of_others_stay() {
    let desk = Desk::new();
    fs::write(desk.path("p.png.json"), "{ \"mine\": 1 }").unwrap();
    desk.run(&format!("{LINE} --device cpu --out p.png"))
        .expect(2, &["p.png.json: it is there, and no FILE.json"]);
    assert_eq!(desk.bytes("p.png.json"), b"{ \"mine\": 1 }");
    // A stream has none, and what cannot be made leaves nothing.
    desk.run(&format!("{LINE} --device cpu --out -"))
        .expect(0, &[]);
    desk.run(&format!("{LINE} --device cpu --out none/p.npy"))
        .expect(2, &["folder none does not exist"]);
    assert_eq!(desk.names(), ["p.png.json"]);
}
