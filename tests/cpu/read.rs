//! Files of points: what is read from them, and what is refused.

use corput::Error;
use corput::report::{Element, Format, Layout, MAX_VALUES, Sink, Target, npy_header, read_points};
use corput::stats::{Points, Source};
use tempfile::TempDir;

/// A file of version 1 with this dictionary and these data.
fn npy(dictionary: &str, data: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend_from_slice(&(dictionary.len() as u16).to_le_bytes());
    bytes.extend_from_slice(dictionary.as_bytes());
    bytes.extend_from_slice(data);
    bytes
}

fn dictionary(descr: &str, fortran: &str, shape: &str) -> String {
    format!("{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': {shape}, }}\n")
}

fn singles(values: &[f32]) -> Vec<u8> {
    values
        .iter()
        .flat_map(|value| value.to_le_bytes())
        .collect()
}

fn read(bytes: &[u8]) -> Result<Points, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.npy");
    std::fs::write(&path, bytes).unwrap();
    read_points(&path)
}

/// Demands a refusal before work, with the file's name and these words.
fn refuses(bytes: &[u8], words: &[&str]) {
    let error = read(bytes).expect_err("a refusal");
    assert!(matches!(error, Error::Points { .. }), "{error:?}");
    assert_eq!(error.exit_code(), 2);
    let said = error.to_string();
    for word in words.iter().chain(&["p.npy"]) {
        assert!(said.contains(word), "no `{word}` in: {said}");
    }
}

#[test]
fn what_a_sink_writes_is_read() {
    let folder = TempDir::new().unwrap();
    for (element, words, source, expected) in [
        (
            Element::U32,
            [0, 1, 0x8000_0000, u32::MAX],
            Source::U32,
            [0.0, 2f64.powi(-32), 0.5, 1.0 - 2f64.powi(-32)],
        ),
        (
            Element::F32,
            [0.0f32, 1e-40, 0.1, 1.0 - f32::EPSILON / 2.0].map(f32::to_bits),
            Source::F32,
            [0.0f32, 1e-40, 0.1, 1.0 - f32::EPSILON / 2.0].map(f64::from),
        ),
    ] {
        let path = folder.path().join("s.npy");
        let layout = Layout {
            rows: 2,
            columns: 2,
            element,
        };
        let target = Target::from(path.as_path());
        let mut sink = Sink::open(&target, Format::Npy, layout, serde_json::Value::Null).unwrap();
        sink.write(&words).unwrap();
        sink.finish().unwrap();
        let points = read_points(&path).unwrap();
        assert_eq!(points, Points::new(2, expected.to_vec(), source).unwrap());
    }
}

#[test]
fn types_orders_and_versions() {
    let values = [0.0, 0.25, 0.5, 0.75, 0.125, 1.0 - f64::EPSILON];
    let rows = Points::new(3, values.to_vec(), Source::F64).unwrap();
    let little: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
    let big: Vec<u8> = values.iter().flat_map(|v| v.to_be_bytes()).collect();
    assert_eq!(
        read(&npy(&dictionary("<f8", "False", "(2, 3)"), &little)).unwrap(),
        rows
    );
    assert_eq!(
        read(&npy(&dictionary(">f8", "False", "(2, 3)"), &big)).unwrap(),
        rows
    );
    let columns: Vec<u8> = [0, 3, 1, 4, 2, 5]
        .iter()
        .flat_map(|&i: &usize| values[i].to_le_bytes())
        .collect();
    assert_eq!(
        read(&npy(&dictionary("<f8", "True", "(2, 3)"), &columns)).unwrap(),
        rows
    );

    let word = read(&npy(
        &dictionary(">u4", "False", "(1, 1)"),
        &[0x40, 0, 0, 0],
    ))
    .unwrap();
    assert_eq!((word.values(), word.source()), (&[0.25][..], Source::U32));
    let zero = read(&npy(
        &dictionary("<f4", "False", "(1, 1)"),
        &singles(&[-0.0]),
    ))
    .unwrap();
    assert!(zero.values()[0].is_sign_positive());

    // Quotes, order, spaces and Python 2's long integers.
    let odd = "{\"shape\":(1L,2L) , \"fortran_order\" :False,'descr':'<f4'}   ";
    assert_eq!(read(&npy(odd, &singles(&[0.5, 0.0]))).unwrap().rows(), 1);
    for version in [2, 3] {
        let text = dictionary("<f4", "False", "(2, 1)");
        let mut bytes = b"\x93NUMPY".to_vec();
        bytes.extend_from_slice(&[version, 0]);
        bytes.extend_from_slice(&(text.len() as u32).to_le_bytes());
        bytes.extend_from_slice(text.as_bytes());
        bytes.extend_from_slice(&singles(&[0.5, 0.25]));
        assert_eq!(read(&bytes).unwrap().values(), [0.5, 0.25]);
    }
}

#[test]
fn more_values_than_a_chunk() {
    let values: Vec<f32> = (0..100_003).map(|i| i as f32 / 100_003.0).collect();
    let bytes = npy(
        &dictionary("<f4", "False", "(100003, 1)"),
        &singles(&values),
    );
    let points = read(&bytes).unwrap();
    assert!(
        points
            .values()
            .iter()
            .zip(&values)
            .all(|(a, b)| *a == f64::from(*b))
    );
    let bytes = npy(&dictionary("<f4", "True", "(1, 100003)"), &singles(&values));
    assert_eq!(read(&bytes).unwrap().columns(), 100_003);
}

#[test]
fn what_is_no_array_of_points() {
    refuses(b"", &["no .npy file"]);
    refuses(b"x0,x1\n0.5,0.5\n", &["no .npy file", "numpy.save"]);
    refuses(b"\x93NUMPY\x04\x00\x00\x00", &["version 4", "1 to 3"]);
    refuses(b"\x93NUMPY\x01\x00\xff\xff", &["ends within its header"]);
    refuses(
        b"\x93NUMPY\x02\x00\xff\xff\xff\xff",
        &["4294967295", "at most 65536"],
    );
    for descr in ["<f2", "<i4", "<u8", "|u1", "<c8", "f4", "|O"] {
        let bytes = npy(&dictionary(descr, "False", "(1, 1)"), &[0; 16]);
        refuses(&bytes, &[descr, "f4, f8 or u4", "astype"]);
    }
    let record = "{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (1, 1)}";
    refuses(&npy(record, &[0; 4]), &["a record", "astype"]);
    for (shape, dimensions) in [("()", "0"), ("(4,)", "1"), ("(1, 2, 2)", "3")] {
        let bytes = npy(&dictionary("<f4", "False", shape), &[0; 16]);
        refuses(&bytes, &[dimensions, "2-D", "reshape(-1, 1)"]);
    }
    for shape in ["(0, 2)", "(2, 0)"] {
        refuses(
            &npy(&dictionary("<f4", "False", shape), &[]),
            &["empty", shape],
        );
    }
    for text in [
        "",
        "{",
        "{'descr': '<f4'",
        "{'descr': '<f4', 'fortran_order': False}",
        "{'descr': '<f4', 'fortran_order': 0, 'shape': (1, 1)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (1 1)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (-1, 1)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (99999999999999999999, 1)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 1)} x",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 1), 'other': 1}",
        "{'descr': '<f4', 'fortran_order': False, 'shape",
        "\u{e9}",
    ] {
        refuses(&npy(text, &[0; 4]), &["malformed", "numpy.save"]);
    }
    refuses(&npy("{'descr': '<f4\u{fffd}'", &[]), &["f4"]);
    let mut foreign = npy("{}", &[]);
    foreign[10] = 0xff;
    refuses(&foreign, &["malformed", "UTF-8"]);
}

#[test]
fn data_that_do_not_fit_the_shape() {
    let whole = npy(&dictionary("<f4", "False", "(2, 2)"), &[0; 16]);
    for cut in 1..=16 {
        refuses(
            &whole[..whole.len() - cut],
            &["truncated", "needs 16 bytes"],
        );
    }
    let mut long = whole.clone();
    long.push(0);
    refuses(&long, &["holds more", "one array a file"]);
    // No memory is taken for what a header only claims.
    let claimed = npy(&dictionary("<f4", "False", "(268435456, 1)"), &[0; 16]);
    refuses(
        &claimed,
        &["truncated", "needs 1073741824 bytes", "holds 16"],
    );
    for shape in ["(268435457, 1)", "(18446744073709551615, 2)"] {
        let bytes = npy(&dictionary("<f4", "False", shape), &[0; 16]);
        refuses(&bytes, &[shape, &MAX_VALUES.to_string(), "a part"]);
    }
}

#[test]
fn values_outside_the_unit_cube_are_named() {
    for (value, word, remedy) in [
        (1.0, "is 1;", "scale"),
        (f32::NAN, "NaN", "replace"),
        (-f32::MIN_POSITIVE, "-0.0000", "scale"),
        (f32::INFINITY, "inf", "replace"),
    ] {
        let data = singles(&[0.5, 0.5, 0.5, value, 2.0, 2.0]);
        let bytes = npy(&dictionary("<f4", "False", "(3, 2)"), &data);
        refuses(&bytes, &["row 1, column 1", word, "[0, 1)", remedy]);
    }
    let columns = singles(&[0.5, 0.5, 0.5, 1.0]);
    let bytes = npy(&dictionary("<f4", "True", "(2, 2)"), &columns);
    refuses(&bytes, &["row 1, column 1 is 1"]);
}

#[test]
fn files_that_are_not_there() {
    let folder = TempDir::new().unwrap();
    for path in [folder.path().join("p.npy"), folder.path().to_owned()] {
        let error = read_points(&path).expect_err("a refusal");
        assert_eq!(error.exit_code(), 2, "{error}");
        assert!(error.to_string().contains("can be read"), "{error}");
    }
}

/// A pipe has no size to compare with, and its end is found by reading.
#[cfg(unix)]
#[test]
fn pipes_are_read_to_their_end() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("pipe");
    assert!(
        std::process::Command::new("mkfifo")
            .arg(&path)
            .status()
            .unwrap()
            .success()
    );
    let header = npy_header(&Layout {
        rows: 3,
        columns: 1,
        element: Element::F32,
    });
    for (values, ok) in [
        (&[0.5, 0.25, 0.0][..], true),
        (&[0.5, 0.25], false),
        (&[0.0; 4], false),
    ] {
        let bytes = [header.clone(), singles(values)].concat();
        let to = path.clone();
        let writer = std::thread::spawn(move || std::fs::write(to, bytes));
        assert_eq!(read_points(&path).is_ok(), ok, "{values:?}");
        writer.join().unwrap().unwrap();
    }
}
