//! The bytes of each format.

use proptest::prelude::*;
use sha2::{Digest, Sha256};

use super::*;

#[test]
fn npy_header_is_golden() {
    let header = npy_header(&layout(16_777_216, 1, Element::F32));
    assert_eq!(header.len(), 4096);
    assert_eq!(
        header[..10],
        [0x93, b'N', b'U', b'M', b'P', b'Y', 1, 0, 0xf6, 0x0f]
    );
    let text = b"{'descr': '<f4', 'fortran_order': False, 'shape': (16777216, 1), }";
    assert_eq!(&header[10..10 + text.len()], text);
    assert!(header[10 + text.len()..4095].iter().all(|b| *b == b' '));
    assert_eq!(header[4095], b'\n');
    assert!(npy_header(&layout(5, 3, Element::U32))[10..].starts_with(b"{'descr': '<u4', "));
    assert_eq!(
        npy_header(&layout(u64::MAX, u32::MAX, Element::U32)).len(),
        NPY_DATA_OFFSET
    );
}

fn sha256(bytes: &[u8]) -> String {
    let digits = Sha256::digest(bytes);
    digits.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[test]
fn npy_reads_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("d.npy");
    let data = words(&[0.0, -0.0, 1.0, f32::from_bits(1), f32::MAX, -0.25]);
    let summary = save(&path, Format::Npy, layout(2, 3, Element::F32), &[&data]).unwrap();
    assert_eq!(summary.bytes, 4096 + 24);
    assert_eq!(summary.sha256, Some(sha256(&fs::read(&path).unwrap())));
    assert_eq!(
        parse_npy(&fs::read(&path).unwrap()),
        ("<f4".to_owned(), vec![2, 3], data)
    );
    assert_eq!(names(&folder), ["d.npy", "d.npy.json"]);
}

#[test]
fn other_types_are_of_fractions() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("d.npy");
    let data = [0, 1, 0x8000_0000, 0x1234_5678, u32::MAX, 0xffff];
    let bytes = |element| {
        save(&path, Format::Npy, layout(3, 2, element), &[&data]).unwrap();
        fs::read(&path).unwrap()
    };
    let short = bytes(Element::U16);
    assert!(short[10..].starts_with(b"{'descr': '<u2', "));
    assert_eq!(
        short[4096..],
        [0, 0, 0, 0, 0, 0x80, 0x34, 0x12, 0xff, 0xff, 0, 0]
    );
    let long = bytes(Element::F64);
    assert!(long[10..].starts_with(b"{'descr': '<f8', "));
    let (values, rest) = long[4096..].as_chunks::<8>();
    assert!(rest.is_empty());
    for (value, word) in values.iter().zip(data) {
        let value = f64::from_le_bytes(*value);
        assert_eq!(value * 4_294_967_296.0, f64::from(word));
        assert!((0.0..1.0).contains(&value));
    }
    for element in ["f32", "u32", "u16", "f64"] {
        assert_eq!(Element::from_name(element).unwrap().name(), element);
    }
    let error = Element::from_name("u17").unwrap_err().to_string();
    assert!(error.contains("did you mean `u16`"), "{error}");
}

#[test]
fn no_rows_make_a_valid_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("none.npy");
    save(&path, Format::Npy, layout(0, 2, Element::U32), &[]).unwrap();
    assert_eq!(
        parse_npy(&fs::read(&path).unwrap()),
        ("<u4".to_owned(), vec![0, 2], vec![])
    );
}

#[test]
fn raw_has_a_sidecar_that_describes_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("f.raw");
    let summary = save(
        &path,
        Format::Raw,
        layout(3, 1, Element::U32),
        &[&[1, 0x0403_0201], &[u32::MAX]],
    )
    .unwrap();
    let bytes = fs::read(&path).unwrap();
    assert_eq!(bytes, [1, 0, 0, 0, 1, 2, 3, 4, 255, 255, 255, 255]);
    let sha256 = sha256(&bytes);
    assert_eq!(
        summary,
        Summary {
            bytes: 12,
            sha256: Some(sha256.clone())
        }
    );
    let sidecar: Value =
        serde_json::from_slice(&fs::read(folder.path().join("f.raw.json")).unwrap()).unwrap();
    let version = env!("CARGO_PKG_VERSION");
    // Without header or footer the one chunk is the file.
    let expected = json!({
        "schema": "corput-file/1",
        "arguments": {"count": 3},
        "device": "",
        "version": version,
        "format": "raw",
        "name": null,
        "shape": [3, 1],
        "type": "<u4",
        "bytes": 12,
        "chunk_rows": 3,
        "chunks": [{"bytes": 12, "sha256": sha256}],
        "sha256": sha256,
    });
    assert_eq!(sidecar, expected);
    assert_eq!(names(&folder), ["f.raw", "f.raw.json"]);
}

#[test]
fn sha256_is_that_of_the_standard() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("abcd.bin");
    let summary = save(
        &path,
        Format::Raw,
        layout(1, 1, Element::U32),
        &[&[u32::from_le_bytes(*b"abcd")]],
    )
    .unwrap();
    // sha256sum of the four letters.
    let known = "88d4266fd4e6338d13b845fcf289579d209c897823b9217da3e161936f031589";
    assert_eq!(summary.sha256.as_deref(), Some(known));
}

#[test]
fn csv_reads_back_exactly() {
    let special = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.1,
        1.0 / 3.0,
        0.5f32.powi(24),
        1.0 - 0.5f32.powi(24),
        1e-4,
        9.999_999e-5,
        1e16,
        9.999_999e15,
        16_777_216.0,
        f32::EPSILON,
        f32::MIN_POSITIVE,
        f32::MAX,
        f32::MIN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::from_bits(1),
        f32::from_bits(0x007f_ffff),
    ];
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.csv");
    let data = words(&special);
    let summary = save(&path, Format::Csv, layout(7, 3, Element::F32), &[&data]).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    assert_eq!(summary.bytes, text.len() as u64);
    let (header, rows) = parse_csv(&text);
    assert_eq!(header, ["x0", "x1", "x2"]);
    let fields = rows.concat();
    assert_eq!(
        fields
            .iter()
            .map(|f| f.parse::<f32>().unwrap().to_bits())
            .collect::<Vec<_>>(),
        data
    );
    assert!(fields.iter().all(|f| f.len() <= 17), "{fields:?}");
    assert_eq!(
        fields[..8],
        [
            "0",
            "-0",
            "1",
            "-1",
            "0.1",
            "0.33333334",
            "5.9604645e-8",
            "0.99999994"
        ]
    );
}

#[test]
fn csv_of_integers_and_of_nan() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("f.csv");
    save(
        &path,
        Format::Csv,
        layout(2, 2, Element::U32),
        &[&[0, 1, u32::MAX], &[7]],
    )
    .unwrap();
    assert_eq!(
        fs::read_to_string(&path).unwrap(),
        "x0,x1\n0,1\n4294967295,7\n"
    );
    save(
        &path,
        Format::Csv,
        layout(1, 1, Element::F32),
        &[&[f32::NAN.to_bits()]],
    )
    .unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "x0\nNaN\n");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn chunks_do_not_show(
        data in proptest::collection::vec(any::<u32>(), 1..200),
        cuts in proptest::collection::vec(any::<prop::sample::Index>(), 0..8),
        columns in 1u32..5,
    ) {
        let data = &data[..data.len() / columns as usize * columns as usize];
        let shape = layout(data.len() as u64 / u64::from(columns), columns, Element::U32);
        let mut cuts: Vec<usize> = cuts.iter().map(|c| c.index(data.len() + 1)).collect();
        cuts.extend([0, data.len()]);
        cuts.sort_unstable();
        let chunks: Vec<&[u32]> = cuts.windows(2).map(|w| &data[w[0]..w[1]]).collect();
        let folder = tempfile::tempdir().unwrap();
        for format in FORMATS {
            // Of the same name, which is in source text.
            let (whole, cut) = (folder.path().join("p"), folder.path().join("p.x"));
            let expected = save(&whole, format, shape, &[data]).unwrap();
            prop_assert_eq!(save(&cut, format, shape, &chunks).unwrap(), expected);
            prop_assert_eq!(fs::read(&cut).unwrap(), fs::read(&whole).unwrap());
        }
    }

    #[test]
    fn every_float_survives_csv(data in proptest::collection::vec(any::<u32>(), 1..100)) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("p.csv");
        save(&path, Format::Csv, layout(data.len() as u64, 1, Element::F32), &[&data]).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        for (field, word) in parse_csv(&text).1.concat().iter().zip(&data) {
            let (read, value) = (field.parse::<f32>().unwrap(), f32::from_bits(*word));
            prop_assert!(read.to_bits() == *word || (read.is_nan() && value.is_nan()), "{} for {}", field, value);
        }
    }
}

#[test]
fn formats_by_name_and_by_ending() {
    for format in FORMATS {
        assert_eq!(format.name().parse::<Format>().unwrap(), format);
    }
    for (file, format) in [
        ("a.npy", Format::Npy),
        ("a.RAW", Format::Raw),
        ("a.b.bin", Format::Raw),
        ("a/b.csv", Format::Csv),
        ("b.h", Format::C),
        ("b.glsl", Format::Glsl),
    ] {
        assert_eq!(Format::from_path(Path::new(file)).unwrap(), format);
    }
    let message = |e: Error| (e.exit_code(), e.to_string());
    let (code, text) = message("nyp".parse::<Format>().unwrap_err());
    assert_eq!(
        (code, text.as_str()),
        (
            2,
            "unknown format `nyp`, did you mean `npy`?; known: npy, raw, csv, c-header, glsl, zarr"
        )
    );
    assert!(
        !message("parquet".parse::<Format>().unwrap_err())
            .1
            .contains("did you mean")
    );
    assert!(
        !message("".parse::<Format>().unwrap_err())
            .1
            .contains("did you mean")
    );
    assert!(
        message(Format::from_path(Path::new("a.cvs")).unwrap_err())
            .1
            .contains("`.cvs`, did you mean `.csv`?")
    );
    for file in ["a.txt", "points", ".npy", ""] {
        let (code, text) = message(Format::from_path(Path::new(file)).unwrap_err());
        assert!(code == 2 && text.contains("--format npy"), "{text}");
    }
}

#[test]
fn targets() {
    assert_eq!(Target::from("-"), Target::Stdout);
    assert_eq!(Target::from("./-"), Target::File(PathBuf::from("./-")));
}
