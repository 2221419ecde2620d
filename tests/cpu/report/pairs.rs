//! A file and its FILE.json: always of one another, whatever fails.

use super::{layout, names};
use corput::Error;
use corput::report::{
    Document, Element, Form, Format, Keeping, Origin, Sidecar, Sink, Target, Whole,
};
use serde_json::json;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

const FORM: Form = Form {
    format: "png",
    shape: Vec::new(),
    descr: ">u2",
    header: 0,
};

fn origin(seed: u32) -> Origin {
    json!({ "seed": seed }).into()
}

fn open(path: &Path) -> Result<Document, Error> {
    Document::open_described(&Target::from(path))
}

/// That both are of this seed and these bytes.
fn is_pair(path: &Path, seed: u32, bytes: &[u8]) {
    let whole = Whole::of(path).unwrap();
    assert_eq!(whole.origin, origin(seed));
    whole.compare(path, bytes, &FORM).unwrap();
}

/// Takes away what is written aside, so that it cannot come to its name.
fn lose_partial(folder: &TempDir) {
    let partial: Vec<String> = names(folder)
        .into_iter()
        .filter(|name| name.starts_with('.') && name.ends_with(".partial"))
        .collect();
    let [name] = partial.as_slice() else {
        panic!("{partial:?}");
    };
    fs::remove_file(folder.path().join(name)).unwrap();
}

#[test]
fn two_runs_of_one_file_are_kept_apart() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("m.png");
    let first = open(&path).unwrap();
    let second = open(&path).err().expect("it is being written").to_string();
    assert!(
        second.contains("another run is writing this file"),
        "{second}"
    );
    // Nor may a file of rows come between.
    let rows = Sink::keeping(
        &Target::from(path.as_path()),
        Format::Raw,
        layout(1, 1, Element::U32),
        origin(3),
        Keeping::default(),
        &mut |_, _| Ok(()),
    );
    assert!(rows.is_err());
    first.finish_described(b"one", &FORM, &origin(1)).unwrap();
    is_pair(&path, 1, b"one");
    assert_eq!(names(&folder), ["m.png", "m.png.json"]);
    // One that gives up leaves the way free.
    drop(open(&path).unwrap());
    assert_eq!(names(&folder), ["m.png", "m.png.json"]);
    let third = open(&path).unwrap();
    third.finish_described(b"three", &FORM, &origin(3)).unwrap();
    is_pair(&path, 3, b"three");
}

#[test]
fn a_file_that_cannot_come_leaves_the_old_pair() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("m.png");
    let before = open(&path).unwrap();
    before.finish_described(b"old", &FORM, &origin(1)).unwrap();
    let document = open(&path).unwrap();
    lose_partial(&folder);
    let error = document.finish_described(b"new", &FORM, &origin(2));
    assert!(
        error
            .unwrap_err()
            .to_string()
            .contains("rename the finished file")
    );
    is_pair(&path, 1, b"old");
    assert_eq!(names(&folder), ["m.png", "m.png.json"]);
}

#[test]
fn a_first_file_that_cannot_come_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let document = open(&folder.path().join("m.png")).unwrap();
    lose_partial(&folder);
    let error = document.finish_described(b"new", &FORM, &origin(2));
    assert!(error.is_err());
    assert!(names(&folder).is_empty());
}

#[test]
fn rows_that_cannot_come_leave_the_old_pair() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.raw");
    let sink = |seed: u32| {
        let layout = layout(1, 1, Element::U32);
        let origin = json!({ "seed": seed });
        let mut sink =
            Sink::open(&Target::from(path.as_path()), Format::Raw, layout, origin).unwrap();
        sink.write(&[seed]).unwrap();
        sink
    };
    sink(1).finish().unwrap();
    let before = Sidecar::of(&path).unwrap();
    let second = sink(2);
    lose_partial(&folder);
    assert!(second.finish().is_err());
    assert_eq!(Sidecar::of(&path).unwrap(), before);
    assert_eq!(fs::read(&path).unwrap(), 1u32.to_le_bytes());
}

/// What a run of rows left to go on from is of no more use once a mask has the name, and not
/// before.
#[test]
fn what_can_be_taken_up_again_stays_until_the_name_is_taken() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p");
    let keeping = Keeping {
        chunk_rows: Some(1),
        ..Keeping::default()
    };
    let target = Target::from(path.as_path());
    let layout = layout(3, 1, Element::U32);
    let mut sink = Sink::keeping(
        &target,
        Format::Raw,
        layout,
        origin(1),
        keeping,
        &mut |_, _| Ok(()),
    )
    .unwrap();
    sink.write(&[1, 2]).unwrap();
    drop(sink);
    let left = [".p.partial", ".p.partial.json"];
    assert_eq!(names(&folder), left);
    drop(open(&path).unwrap());
    assert_eq!(names(&folder), left);
    let mask = open(&path).unwrap();
    mask.finish_described(b"mask", &FORM, &origin(2)).unwrap();
    assert_eq!(names(&folder), ["p", "p.json"]);
}
