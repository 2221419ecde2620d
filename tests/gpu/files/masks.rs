//! Masks: their FILE.json, and `corput verify` of them.

use super::{Desk, devices, json_schema, sha256, sidecar};
use serde_json::{Value, json};
use std::fs;

/// Options, file, shape and type.
const MASKS: [(&str, &str, &[u32], &str); 5] = [
    ("--size 16 --seed 3", "m.npy", &[16, 16], "<f4"),
    (
        "--size 8 --fractions --frames 3 --channels 2",
        "m.npy",
        &[3, 8, 8, 2],
        "<u4",
    ),
    ("--size 16 --channels 2", "m.exr", &[16, 16, 2], "<f4"),
    ("--size 8 --frames 3", "m.png", &[24, 8], ">u2"),
    ("--size 8 --format png", "m", &[8, 8], ">u2"),
];

#[test]
fn masks_are_described_and_verified() {
    let schema: Value =
        serde_json::from_str(include_str!("../../../docs/schemas/file-1.json")).unwrap();
    for (options, name, shape, kind) in MASKS {
        for device in devices() {
            let desk = Desk::new();
            desk.quietly(&format!(
                "generate blue-noise-mask {options} {device} --out {name}"
            ));
            assert_eq!(desk.names(), [name.to_owned(), format!("{name}.json")]);
            let (bytes, document) = (desk.bytes(name), sidecar(&desk, name));
            let faults = json_schema::faults(&schema, &schema, &document, "");
            assert_eq!(faults, Vec::<String>::new());
            let start = if kind == ">u2" || name == "m.exr" {
                0
            } else {
                4096
            };
            let (data, whole) = (&bytes[start..], sha256(&bytes));
            let chunk = json!({ "bytes": data.len(), "sha256": sha256(data) });
            for (member, value) in [
                ("shape", json!(shape)),
                ("type", json!(kind)),
                ("bytes", json!(bytes.len())),
                ("sha256", json!(whole)),
                ("chunks", json!([chunk])),
                ("version", json!(env!("CARGO_PKG_VERSION"))),
            ] {
                assert_eq!(document[member], value, "{name}: {member}");
            }
            assert_eq!(document["device"] == "cpu", !device.is_empty());
            for device in devices() {
                let said = desk.say(&format!("verify {name} {device}"));
                let length = bytes.len();
                assert_eq!(
                    said,
                    format!("{name}: all {length} bytes are equal; SHA-256 {whole}\n")
                );
            }
        }
    }
}

#[test]
fn damage_and_other_arguments_are_found() {
    for (options, name, ..) in MASKS {
        let desk = Desk::new();
        desk.quietly(&format!(
            "generate blue-noise-mask {options} --device cpu --out {name}"
        ));
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
        fs::write(desk.path(name), [&whole[..], b"!"].concat()).unwrap();
        desk.run(&verify).expect(1, &["it has more bytes"]);
        fs::write(desk.path(name), &whole).unwrap();
        desk.run(&format!("{verify} --range 0..4"))
            .expect(2, &["--range of", "made whole", "drop --range"]);

        let document = sidecar(&desk, name);
        let run = |place: &str, value: Value| {
            let mut changed = document.clone();
            *changed.pointer_mut(place).expect("it has that") = value;
            let path = desk.path(&format!("{name}.json"));
            fs::write(path, changed.to_string()).unwrap();
            desk.run(&verify)
        };
        run("/sha256", json!("0".repeat(64))).expect(1, &["its SHA-256 is"]);
        run("/chunks/0/sha256", json!("0".repeat(64))).expect(1, &["its chunk is not"]);
        run("/bytes", json!(5)).expect(1, &["of 5 by its sidecar"]);
        run("/arguments/seed", json!(99)).expect(1, &["bytes differ"]);
        run("/arguments/size", json!(3)).expect(2, &["3 x 3", "4 to 256"]);
        run("/format", json!("gif")).expect(2, &["`gif`"]);
        run("/chunks", json!([])).expect(2, &["`chunks`"]);
        run("/version", json!("0.0.9")).expect(0, &["warning", "0.0.9"]);
    }
}

#[test]
fn files_of_others_stay() {
    let desk = Desk::new();
    let line = "generate blue-noise-mask --size 8 --device cpu --out";
    fs::write(desk.path("m.png.json"), "{ \"mine\": 1 }").unwrap();
    desk.run(&format!("{line} m.png"))
        .expect(2, &["m.png.json: it is there, and no FILE.json"]);
    assert_eq!(desk.names(), ["m.png.json"]);
    assert_eq!(desk.bytes("m.png.json"), b"{ \"mine\": 1 }");
    // A stream has none.
    desk.run(&format!("{line} -")).expect(0, &[]);
    assert_eq!(desk.names(), ["m.png.json"]);
}
