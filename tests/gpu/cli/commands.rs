//! `generate` as documented: shapes, types, values and the three formats.

use super::parse::Column::{Base, Grid};
use super::parse::{Array, assert_points, csv, npy, words};
use super::{Desk, skips};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

#[test]
fn points_are_what_the_definitions_give() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let array = npy(&desk.make("vdc --count 16777216", "v.npy"));
    array.assert_is("<f4", 1 << 24, 1);
    assert_points(&array, 0, &[Base(2)]);

    let array = npy(&desk.make("halton --count 1000000 --dims 2", "p.npy"));
    array.assert_is("<f4", 1_000_000, 2);
    assert_points(&array, 0, &[Base(2), Base(3)]);

    let far = "halton --count 4096 --bases 2,3,8161 --first 4294963200 --fractions";
    let array = npy(&desk.make(far, "f.npy"));
    array.assert_is("<u4", 4096, 3);
    assert_points(&array, 4_294_963_200, &[Base(2), Base(3), Base(8161)]);

    let array = npy(&desk.make("hammersley --count 65536 --dims 2", "h.npy"));
    array.assert_is("<f4", 65536, 2);
    assert_points(&array, 0, &[Base(2), Grid(65536)]);

    let line = "hammersley --count 65536 --dims 2 --index-first";
    let turned = npy(&desk.make(line, "i.npy"));
    assert_points(&turned, 0, &[Grid(65536), Base(2)]);

    let part = "hammersley --count 1000 --first 7 --total 4294967296 --dims 3 --fractions";
    let array = npy(&desk.make(part, "t.npy"));
    assert_points(&array, 7, &[Base(2), Base(3), Grid(1 << 32)]);
}

#[test]
fn as_many_dimensions_as_there_are_primes() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let primes = (2..8162u32).filter(|n| (2..*n).take_while(|d| d * d <= *n).all(|d| n % d != 0));
    let mut columns: Vec<_> = primes.map(Base).collect();
    assert_eq!(columns.len(), 1024);
    // The last ones: so few of the first would be warned of.
    let range = "--first 4294966996 --count 300";
    let array = npy(&desk.make(&format!("halton {range} --dims 1024"), "p.npy"));
    assert_points(&array, 4_294_966_996, &columns);
    columns.push(Grid(1 << 32));
    let array = npy(&desk.make(&format!("hammersley {range} --dims 1025"), "h.npy"));
    assert_points(&array, 4_294_966_996, &columns);
}

fn assert_unit(array: &Array) {
    for row in 0..array.rows {
        let row = array.row(row);
        let [x, y, z] = [row[0], row[1], row[2]].map(|word| f64::from(f32::from_bits(word)));
        assert!((x * x + y * y + z * z - 1.0).abs() < 5e-7 && z >= 0.0);
    }
}

#[test]
fn directions_have_length_one_and_the_pdf_of_their_height() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "halton --count 1000000 --dims 2 --map cosine-hemisphere";
    let array = npy(&desk.make(line, "d.npy"));
    array.assert_is("<f4", 1_000_000, 3);
    assert_unit(&array);
    let heights = (0..array.rows).map(|row| f64::from(f32::from_bits(array.row(row)[2])));
    let mean = heights.sum::<f64>() / array.rows as f64;
    assert!((mean - 2.0 / 3.0).abs() < 1e-4, "{mean}");

    let line = "halton --count 1000 --dims 2 --map cosine-hemisphere-polar --with-pdf";
    let array = npy(&desk.make(line, "d4.npy"));
    array.assert_is("<f4", 1000, 4);
    assert_unit(&array);
    for row in 0..array.rows {
        let [z, pdf] = [array.row(row)[2], array.row(row)[3]].map(f32::from_bits);
        assert!((f64::from(pdf) - f64::from(z) / std::f64::consts::PI).abs() < 1e-7);
    }
}

#[test]
fn the_native_profile_is_near_the_exact_one() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for map in [
        "cosine-hemisphere",
        "cosine-hemisphere-polar",
        "uniform-hemisphere",
        "concentric-disk",
        "polar-disk",
    ] {
        let line = format!("halton --count 10000 --map {map} --with-pdf");
        let exact = npy(&desk.make(&line, "exact.npy"));
        let native = npy(&desk.make(&format!("{line} --profile native"), "native.npy"));
        assert_eq!((exact.rows, exact.columns), (native.rows, native.columns));
        let furthest = exact.floats().zip(native.floats());
        let furthest = furthest.fold(0f32, |most, (a, b)| most.max((a - b).abs()));
        assert!(furthest < 1e-3, "{map}: {furthest}");
    }
    let line = "halton --count 10000 --dims 5";
    let native = desk.make(&format!("{line} --profile native"), "n.npy");
    assert!(native == desk.make(line, "e.npy"), "points have no profile");
}

#[test]
fn raw_has_its_description_beside_it() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "halton --count 5000 --bases 3,2 --first 9 --fractions --scramble owen \
                --seed 18446744073709551615";
    let array = npy(&desk.make(line, "p.npy"));
    for device in ["", " --device cpu"] {
        let data = desk.make(&format!("{line}{device}"), "p.raw");
        assert_eq!(words(&data), array.words);
        let said: Value = serde_json::from_slice(&desk.bytes("p.raw.json")).unwrap();
        let hash: String = Sha256::digest(&data)
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        assert_eq!(said["sha256"], json!(hash));
        assert_eq!(said["shape"], json!([5000, 2]));
        assert_eq!(said["type"], "<u4");
        assert_eq!(said["version"], env!("CARGO_PKG_VERSION"));
        let arguments = &said["arguments"];
        for (name, value) in [
            ("sequence", json!("halton")),
            ("count", json!(5000)),
            ("first", json!(9)),
            ("bases", json!([3, 2])),
            ("scramble", json!("owen")),
            ("seed", json!(u64::MAX)),
            ("type", json!("u32")),
            ("map", Value::Null),
            ("profile", json!("exact")),
        ] {
            assert_eq!(arguments[name], value, "{name}");
        }
        let cpu = said["device"] == "cpu";
        assert_eq!(cpu, !device.is_empty() || is_cpu());
    }
    assert_eq!(desk.names(), ["p.npy", "p.npy.json", "p.raw", "p.raw.json"]);
    // The format outranks the ending, and an ending may be in capitals.
    desk.make(&format!("{line} --format raw"), "q.npy");
    desk.make(line, "Q.NPY");
    assert_eq!(words(&desk.bytes("q.npy")), array.words);
    assert_eq!(desk.bytes("Q.NPY"), desk.bytes("p.npy"));
}

fn is_cpu() -> bool {
    std::env::var_os("CORPUT_DEVICE").is_some_and(|device| device == "cpu")
}

#[test]
fn csv_reads_back_exactly() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for line in [
        "halton --count 20000 --dims 3",
        "halton --count 20000 --map cosine-hemisphere --with-pdf",
        "hammersley --count 20000 --dims 3 --fractions",
        "vdc --count 1",
    ] {
        let array = npy(&desk.make(line, "p.npy"));
        let text = desk.make(line, "p.csv");
        let rows = csv(&text);
        assert_eq!(rows.len(), array.rows);
        let parse = |field: &&str| match &*array.kind {
            "<u4" => field.parse().unwrap(),
            _ => field.parse::<f32>().unwrap().to_bits(),
        };
        let read: Vec<u32> = rows.iter().flatten().map(parse).collect();
        assert!(read == array.words, "{line}");
    }
}

#[test]
fn standard_output_gets_the_bytes_and_nothing_else() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "hammersley --count 30000 --dims 2";
    let file = desk.make(line, "p.npy");
    let text = desk.make(line, "p.csv");
    for (format, expected) in [
        ("", &file[..]),
        (" --format npy", &file[..]),
        (" --format raw", &file[4096..]),
        (" --format csv", &text[..]),
    ] {
        let run = desk.run(&format!("generate {line}{format} --out -"));
        run.expect(0, &[]);
        assert_eq!(run.stderr, "");
        assert!(run.stdout == expected, "{format}");
    }
    assert_eq!(desk.names(), ["p.csv", "p.csv.json", "p.npy", "p.npy.json"]);
}

#[test]
fn a_file_is_replaced() {
    let desk = Desk::new();
    std::fs::write(desk.path("p.npy"), "old").unwrap();
    let array = npy(&desk.make("vdc --count 3 --device cpu", "p.npy"));
    assert_points(&array, 0, &[Base(2)]);
    assert_eq!(desk.names(), ["p.npy", "p.npy.json"]);
}
