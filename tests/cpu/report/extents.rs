//! Files whose words somebody else writes in place.

use super::{layout, names};
use corput::Error;
use corput::report::{Element, Extent, Format, Keeping, Layout, Sink, Summary, Target};
use serde_json::json;
use std::fs;
use std::os::unix::fs::FileExt;
use std::path::Path;
use tempfile::TempDir;

/// Chunks of 1 MiB and an end, of 3.5 MB in all.
const SHAPE: Layout = Layout {
    rows: 220_001,
    columns: 4,
    element: Element::U32,
};
const CHUNK: u64 = 65_536;

fn word(at: u64) -> u32 {
    (at as u32).wrapping_mul(0x9e37_79b9)
}

/// The words of some rows.
fn rows(from: u64, to: u64) -> Vec<u32> {
    (4 * from..4 * to).map(word).collect()
}

fn open(path: &Path, format: Format, resume: bool) -> Result<Sink, Error> {
    let keeping = Keeping {
        resume,
        chunk_rows: Some(CHUNK),
    };
    let (target, origin) = (Target::from(path), json!({}).into());
    Sink::keeping(&target, format, SHAPE, origin, keeping, &mut |_, _| Ok(()))
}

/// Writes the words of an extent past the sink.
fn fill(extent: &Extent) {
    let rows = extent.rows();
    let words = self::rows(rows.start, rows.end);
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    assert_eq!(bytes.len() as u64, extent.bytes());
    extent.file().write_all_at(&bytes, extent.offset()).unwrap();
}

/// Writes the rows that a sink lacks: by extents where `in_place` says so of the first row, and
/// else piece by piece.
fn write(sink: &mut Sink, in_place: impl Fn(u64) -> bool) -> Result<(), Error> {
    write_until(sink, SHAPE.rows, in_place)
}

fn write_until(sink: &mut Sink, end: u64, in_place: impl Fn(u64) -> bool) -> Result<(), Error> {
    while sink.rows() < end {
        let row = sink.rows();
        if in_place(row) {
            let extent = sink.extent(row)?.expect("an extent");
            fill(&extent);
            sink.take(extent)?;
        } else {
            let end = SHAPE.rows.min(row + sink.chunk_left() / 4);
            // In two, the first of which ends within a row.
            let words = rows(row, end);
            let (one, two) = words.split_at(words.len() / 3 + 1);
            sink.write(one)?;
            sink.write(two)?;
        }
    }
    Ok(())
}

fn made(path: &Path, format: Format, in_place: impl Fn(u64) -> bool) -> (Summary, Vec<u8>, String) {
    let mut sink = open(path, format, false).unwrap();
    write(&mut sink, in_place).unwrap();
    let summary = sink.finish().unwrap();
    let document = fs::read_to_string(format!("{}.json", path.display())).unwrap();
    (summary, fs::read(path).unwrap(), document)
}

#[test]
fn extents_and_pieces_make_the_same_file() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("p");
    for format in [Format::Npy, Format::Raw] {
        let wanted = made(&path, format, |_| false);
        assert!(wanted.1.ends_with(&word(4 * SHAPE.rows - 1).to_le_bytes()));
        let chunk = |row: u64| row / CHUNK;
        assert!(made(&path, format, |_| true) == wanted, "{format:?}");
        assert!(made(&path, format, |row| chunk(row) % 2 == 0) == wanted);
        assert!(made(&path, format, |row| chunk(row) % 2 == 1) == wanted);
    }
}

/// In one chunk, which is longer than an extent.
#[test]
fn a_chunk_may_have_both() {
    let shape = Layout {
        rows: 1_200_000,
        ..SHAPE
    };
    let folder = TempDir::new().unwrap();
    let mut files = Vec::new();
    for name in ["pieces", "both"] {
        let path = folder.path().join(name);
        let mut sink = Sink::open(&Target::from(&*path), Format::Npy, shape, json!({})).unwrap();
        // A page, and then most of the rest.
        sink.write(&rows(0, 256)).unwrap();
        if name == "both" {
            let extent = sink.extent(256).unwrap().unwrap();
            assert_eq!((extent.offset(), extent.bytes()), (8192, 16 << 20));
            fill(&extent);
            sink.take(extent).unwrap();
            assert_eq!(sink.rows(), 256 + (1 << 20));
        }
        sink.write(&rows(sink.rows(), shape.rows)).unwrap();
        files.push((sink.finish().unwrap(), fs::read(&path).unwrap()));
    }
    assert!(files[0] == files[1]);
    assert_eq!(files[0].1.len(), 4096 + 16 * 1_200_000);
}

#[test]
fn what_extents_left_is_taken_up_by_pieces_and_back() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("p");
    let wanted = made(&path, Format::Npy, |_| false);
    for first in [true, false] {
        fs::remove_file(&path).unwrap();
        let mut sink = open(&path, Format::Npy, false).unwrap();
        let stop = || Error::ZeroCount { what: "a test" };
        let chunks = write_until(&mut sink, 2 * CHUNK, |_| first);
        let error = sink.abandon(chunks.err().unwrap_or_else(stop));
        assert!(
            matches!(error, Error::Kept { kept: 131_072, .. }),
            "{error}"
        );
        let mut sink = open(&path, Format::Npy, true).unwrap();
        write(&mut sink, |_| !first).unwrap();
        let summary = sink.finish().unwrap();
        assert_eq!(summary, wanted.0);
        assert!(fs::read(&path).unwrap() == wanted.1);
    }
}

#[test]
fn extents_are_taken_in_order_and_of_one_file() {
    let folder = TempDir::new().unwrap();
    let [one, two] = ["one", "two"].map(|name| folder.path().join(name));
    let fresh = |path: &Path| open(path, Format::Raw, false).unwrap();
    let refused = |sink: &mut Sink, extent: Extent, words: &str| {
        let error = sink.take(extent).unwrap_err();
        assert!(matches!(error, Error::Arguments { .. }), "{error}");
        assert!(error.to_string().contains(words), "{error}");
    };
    let mut sink = fresh(&one);
    let later = sink.extent(CHUNK).unwrap().unwrap();
    refused(&mut sink, later, "row 0 of that file is the next");
    drop(sink);
    let (mut sink, other) = (fresh(&one), fresh(&two));
    let foreign = other.extent(0).unwrap().unwrap();
    refused(&mut sink, foreign, "extents of one sink");
    drop((sink, other));
    // Once a row has begun, its extent is none of the next.
    let mut sink = fresh(&one);
    sink.write(&[word(0)]).unwrap();
    let begun = sink.extent(0).unwrap().unwrap();
    refused(&mut sink, begun, "row 0 of that file is the next");
    drop(sink);
    let mut sink = fresh(&one);
    let first = sink.extent(0).unwrap().unwrap();
    fill(&first);
    let second = sink.extent(CHUNK).unwrap().unwrap();
    sink.take(first).unwrap();
    assert!(sink.extent(0).unwrap().is_none(), "it was taken");
    assert_eq!((sink.rows(), second.rows()), (CHUNK, CHUNK..2 * CHUNK));
    drop((sink, second));
    let stream = Sink::open(
        &Target::Stdout,
        Format::Csv,
        layout(9, 1, Element::U32),
        json!({}),
    );
    assert!(stream.unwrap().extent(0).unwrap().is_none());
}

/// While somebody may still write to an extent the file keeps its length, and its lock.
#[test]
fn a_file_is_not_shortened_under_an_extent() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("p");
    let cause = || Error::ZeroCount { what: "a test" };
    let partial = folder.path().join(".p.partial");
    let length = || fs::metadata(&partial).unwrap().len();
    for held in [true, false] {
        let mut sink = open(&path, Format::Raw, false).unwrap();
        let first = sink.extent(0).unwrap().unwrap();
        fill(&first);
        sink.take(first).unwrap();
        let second = sink.extent(CHUNK).unwrap().unwrap();
        let second = held.then_some(second);
        let error = sink.abandon(cause());
        assert!(matches!(error, Error::Kept { kept: CHUNK, .. }), "{error}");
        let chunks = if held { 2 } else { 1 };
        assert_eq!(length(), chunks << 20);
        let again = open(&path, Format::Raw, true);
        match second {
            Some(extent) => {
                let error = again.err().expect("it is locked").to_string();
                assert!(error.contains("another run is writing"), "{error}");
                drop(extent);
                fs::remove_file(folder.path().join(".p.partial.json")).unwrap();
                fs::remove_file(&partial).unwrap();
            }
            None => {
                let mut sink = again.unwrap();
                assert_eq!(sink.rows(), CHUNK);
                write(&mut sink, |_| true).unwrap();
                sink.finish().unwrap();
            }
        }
    }
    assert_eq!(names(&folder), ["p", "p.json"]);
}
