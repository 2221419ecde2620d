//! Files: their bytes, judged by parsers that share nothing with the writers,
//! and what is left behind when something goes wrong.

#[path = "report/bytes.rs"]
mod bytes;
#[cfg(all(target_os = "linux", feature = "gpu"))]
#[path = "report/extents.rs"]
mod extents;
#[path = "report/failure.rs"]
mod failure;
#[path = "json_schema.rs"]
mod json_schema;
#[path = "report/kept.rs"]
mod kept;
#[path = "report/pairs.rs"]
mod pairs;
#[path = "report/schema.rs"]
mod schema;
#[path = "report/source.rs"]
mod source;
#[cfg(unix)]
#[path = "report/system.rs"]
mod system;

use std::fs;
use std::path::{Path, PathBuf};

use corput::Error;
use corput::report::{Element, Format, Layout, NPY_DATA_OFFSET, Sink, Summary, Target, npy_header};
use serde_json::{Value, json};
use tempfile::TempDir;

/// Every format.
const FORMATS: [Format; 5] = [
    Format::Npy,
    Format::Raw,
    Format::Csv,
    Format::C,
    Format::Glsl,
];

fn layout(rows: u64, columns: u32, element: Element) -> Layout {
    Layout {
        rows,
        columns,
        element,
    }
}

fn words(values: &[f32]) -> Vec<u32> {
    values.iter().map(|v| v.to_bits()).collect()
}

/// Writes `chunks` to `path`.
fn save(path: &Path, format: Format, layout: Layout, chunks: &[&[u32]]) -> Result<Summary, Error> {
    let mut sink = Sink::open(
        &Target::from(path),
        format,
        layout,
        json!({"count": layout.rows}),
    )?;
    for chunk in chunks {
        sink.write(chunk)?;
    }
    sink.finish()
}

/// Names in a folder, sorted.
fn names(folder: &TempDir) -> Vec<String> {
    let entries = fs::read_dir(folder.path()).unwrap();
    let mut names: Vec<_> = entries
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// A parser of `.npy` by its specification: type, shape, words.
fn parse_npy(bytes: &[u8]) -> (String, Vec<u64>, Vec<u32>) {
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let start = 10 + usize::from(bytes[8]) + 256 * usize::from(bytes[9]);
    assert_eq!(start % 64, 0);
    let header = std::str::from_utf8(&bytes[10..start]).unwrap();
    assert!(header.ends_with('\n'));
    assert!(header.contains("'fortran_order': False"));
    let after = |key: &str| header.split_once(key).unwrap().1;
    let descr = after("'descr': '").split_once('\'').unwrap().0.to_owned();
    let shape = after("'shape': (").split_once(')').unwrap().0;
    let shape = shape
        .split(',')
        .map(|n| n.trim().parse().unwrap())
        .collect();
    let data = bytes[start..]
        .chunks_exact(4)
        .map(|b| u32::from_le_bytes(b.try_into().unwrap()));
    assert_eq!((bytes.len() - start) % 4, 0);
    (descr, shape, data.collect())
}

/// A parser of CSV: the header, then rows of fields.
fn parse_csv(text: &str) -> (Vec<&str>, Vec<Vec<&str>>) {
    assert!(text.ends_with('\n') && !text.contains('\r'));
    let mut lines = text.lines().map(|line| line.split(',').collect());
    (lines.next().unwrap(), lines.collect())
}
