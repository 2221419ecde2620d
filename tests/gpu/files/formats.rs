//! Types and source text, of points that are known from other files.

use super::support::compile;
use super::{Desk, devices};

/// The data of an `.npy` file behind a header that says its type and shape.
fn npy<const SIZE: usize>(desk: &Desk, line: &str, descr: &str, shape: &str) -> Vec<[u8; SIZE]> {
    desk.run(&format!("generate {line} --out p.npy"))
        .expect(0, &[]);
    let bytes = desk.bytes("p.npy");
    let header = String::from_utf8_lossy(&bytes[10..4096]).into_owned();
    let said = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}");
    assert!(header.starts_with(&said), "{header}");
    desk.run("verify p.npy --device cpu").expect(0, &[]);
    let (elements, rest) = bytes[4096..].as_chunks::<SIZE>();
    assert!(rest.is_empty());
    elements.to_vec()
}

#[test]
fn types_are_those_of_the_fractions() {
    let desk = Desk::new();
    for device in devices() {
        for points in [
            "halton --dims 3 --count 5000 --first 9",
            "blue-noise --count 500",
        ] {
            let rows = if points.starts_with("blue") {
                "(500, 2)"
            } else {
                "(5000, 3)"
            };
            let line = |kind: &str| format!("{points} {kind} {device}");
            let fractions = npy::<4>(&desk, &line("--fractions"), "<u4", rows);
            assert!(fractions.len() >= 1000);
            assert_eq!(npy::<4>(&desk, &line("--type u32"), "<u4", rows), fractions);
            let words = || fractions.iter().map(|bytes| u32::from_le_bytes(*bytes));
            let short: Vec<u16> = npy::<2>(&desk, &line("--type u16"), "<u2", rows)
                .into_iter()
                .map(u16::from_le_bytes)
                .collect();
            assert!(words().map(|word| (word >> 16) as u16).eq(short));
            let long: Vec<f64> = npy::<8>(&desk, &line("--type f64"), "<f8", rows)
                .into_iter()
                .map(f64::from_le_bytes)
                .collect();
            assert!(
                words()
                    .map(|word| f64::from(word) * 0.5f64.powi(32))
                    .eq(long)
            );
            let floats = npy::<4>(&desk, &line(""), "<f4", rows);
            assert_eq!(npy::<4>(&desk, &line("--type f32"), "<f4", rows), floats);
        }
    }
}

#[test]
fn glslang_takes_the_array() {
    let desk = Desk::new();
    for (kind, read) in [
        ("f32", "uintBitsToFloat(points_p[2u * i + 1u])"),
        ("u32", "float(points_p[2u * i])"),
    ] {
        let line = format!("generate halton --count 300 --type {kind} --device cpu --out p.glsl");
        desk.run(&line).expect(0, &[]);
        let array = String::from_utf8(desk.bytes("p.glsl")).unwrap();
        let shader = |array: &str| {
            format!(
                "#version 450\nlayout(local_size_x = 64) in;\n\
                 layout(std430, binding = 0) buffer Results {{ float results[]; }};\n\
                 {array}\n{array}\n\
                 void main() {{ uint i = gl_GlobalInvocationID.x; results[i] = {read}; }}\n"
            )
        };
        let words = compile(&shader(&array));
        // Every value is among the module's constants.
        desk.run(&format!(
            "generate halton --count 300 --type {kind} --device cpu --out p.raw"
        ))
        .expect(0, &[]);
        let raw = desk.bytes("p.raw");
        let (raw, _) = raw.as_chunks::<4>();
        assert_eq!(raw.len(), 600);
        for bytes in raw {
            assert!(words.contains(&u32::from_le_bytes(*bytes)));
        }
        desk.run("verify p.glsl --device cpu").expect(0, &[]);
    }
}

#[test]
fn text_of_every_kind_is_verified() {
    let desk = Desk::new();
    for name in ["p.h", "p.csv"] {
        for kind in ["f32", "u32", "u16", "f64"] {
            let line = format!(
                "generate sobol --count 700 --dims 3 --type {kind} --device cpu --out {name} --chunk-rows 128"
            );
            desk.run(&line).expect(0, &[]);
            for range in ["", "--range 699..700", "--range 127..129"] {
                desk.run(&format!("verify {name} --device cpu {range}"))
                    .expect(0, &[]);
            }
            let text = String::from_utf8(desk.bytes(name)).unwrap();
            let end = text.trim_end().len() - 1;
            let mut broken = text.into_bytes();
            broken[end] = b'?';
            std::fs::write(desk.path(name), broken).unwrap();
            let found = if name == "p.h" {
                "the end of such a file"
            } else {
                "row 699 is"
            };
            desk.run(&format!("verify {name} --device cpu"))
                .expect(1, &[found]);
        }
    }
    let pipe = desk.run("generate halton --count 5 --device cpu --format c-header --out -");
    assert!(
        pipe.text()
            .contains("static const float points_stdout[5][2]"),
        "{}",
        pipe.text()
    );
}

#[test]
fn types_that_do_not_go_together_are_refused() {
    let desk = Desk::new();
    for (options, words) in [
        (
            "--type f16",
            &["unknown type `f16`", "f32, u32, u16, f64"][..],
        ),
        (
            "--type f64 --fractions",
            &["--type f64 with --fractions", "drop one"],
        ),
        (
            "--type u16 --map polar-disk",
            &["--type u16 with --map", "drop one"],
        ),
        (
            "--type f64 --format glsl",
            &["f64 in a GLSL array", "--type f32"],
        ),
        (
            "--count 600000 --format c-header",
            &["1200000 values as c-header", "2^20"],
        ),
    ] {
        let count = if options.contains("--count") {
            ""
        } else {
            "--count 5"
        };
        let line = format!("generate halton {count} --device cpu --out p.npy {options}");
        desk.run(&line).expect(2, words);
    }
    let mask = "generate blue-noise-mask --size 8 --device cpu --out m.png";
    for option in ["--type u16", "--resume", "--chunk-rows 5"] {
        desk.run(&format!("{mask} {option}"))
            .expect(2, &["--type, --resume, --chunk-rows"]);
    }
    assert!(desk.names().is_empty());
}
