//! What is refused, and what is left behind when something goes wrong.

use super::*;

/// The message of an open that must be refused as unwritable.
pub(super) fn refusal(target: &Path, format: Format) -> String {
    let error = Sink::open(
        &Target::from(target),
        format,
        layout(1, 1, Element::F32),
        Value::Null,
    )
    .err()
    .unwrap();
    assert!(
        matches!(error, Error::Output { .. }) && error.exit_code() == 2,
        "{error}"
    );
    error.to_string()
}

#[test]
fn places_that_cannot_be_written_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let inside = |name: &str| folder.path().join(name);
    fs::write(inside("file"), "").unwrap();
    fs::create_dir(inside("folder")).unwrap();
    fs::create_dir(inside("p.raw.json")).unwrap();
    for (target, problem) in [
        (inside("missing/p.npy"), "does not exist"),
        (inside("file/p.npy"), "is not a folder"),
        (inside("folder"), "names a folder"),
        (inside("p.npy/"), "names a folder"),
        (inside(".."), "names a folder"),
        (PathBuf::new(), "names a folder"),
        (
            inside(&"n".repeat(300)),
            "its name has 300 bytes, what is written beside it 14 more, and any name 255 at most",
        ),
        (inside(&"n".repeat(242)), "give a name of at most 241 bytes"),
        (inside(&"n/".repeat(3000)).join("p"), "give a shorter one"),
    ] {
        let message = refusal(&target, Format::Npy);
        assert!(message.contains(problem), "{message}");
    }
    assert!(refusal(&inside("p.raw"), Format::Raw).contains("p.raw.json: it names a folder"));
    assert_eq!(names(&folder), ["file", "folder", "p.raw.json"]);
    #[cfg(target_os = "linux")]
    assert!(refusal(Path::new("/proc/p.npy"), Format::Npy).contains(
        "folder /proc is not writable: it takes no new files (No such file or directory"
    ));
    // The longest that it says can be written.
    let longest = inside(&"n".repeat(241));
    save(&longest, Format::Raw, layout(1, 1, Element::U32), &[&[7]]).unwrap();
    assert!(longest.exists() && inside(&("n".repeat(241) + ".json")).exists());
}

#[test]
fn a_second_writer_of_the_same_file_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.npy");
    let shape = layout(1, 1, Element::F32);
    let first = Sink::open(
        &Target::from(path.as_path()),
        Format::Npy,
        shape,
        Value::Null,
    )
    .unwrap();
    assert!(refusal(&path, Format::Npy).contains("another run"));
    assert_eq!(names(&folder), [".p.npy.partial", ".p.npy.partial.json"]);
    drop(first);
    assert!(names(&folder).is_empty());
}

#[test]
fn impossible_layouts_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for shape in [
        layout(1, 0, Element::F32),
        layout(u64::MAX, 2, Element::F32),
        layout(1 << 62, 1, Element::F32),
        layout((1 << 60) + 1, 1, Element::F64),
        layout((1 << 61) + 1, 1, Element::U16),
    ] {
        let error = save(&folder.path().join("p.npy"), Format::Npy, shape, &[]).unwrap_err();
        assert!(matches!(error, Error::Arguments { .. }), "{error}");
    }
    assert!(names(&folder).is_empty());
}

#[test]
fn what_was_there_stays_until_the_new_file_is_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.raw");
    let shape = layout(2, 1, Element::U32);
    save(&path, Format::Raw, shape, &[&[1, 2]]).unwrap();
    let before = (
        fs::read(&path).unwrap(),
        fs::read(path.with_extension("raw.json")).unwrap(),
    );
    let failures: [&[&[u32]]; 4] = [&[], &[&[1]], &[&[1, 2, 3]], &[&[1, 2], &[3]]];
    for chunks in failures {
        let error = save(&path, Format::Raw, shape, chunks).unwrap_err();
        assert!(matches!(error, Error::Arguments { .. }), "{error}");
        assert_eq!(
            (
                fs::read(&path).unwrap(),
                fs::read(path.with_extension("raw.json")).unwrap()
            ),
            before
        );
        assert_eq!(names(&folder), ["p.raw", "p.raw.json"]);
    }
    save(&path, Format::Raw, shape, &[&[3, 4]]).unwrap();
    assert_eq!(fs::read(&path).unwrap(), [3, 0, 0, 0, 4, 0, 0, 0]);
    assert_ne!(fs::read(path.with_extension("raw.json")).unwrap(), before.1);
}

#[test]
fn an_error_cannot_be_passed_over() {
    let folder = tempfile::tempdir().unwrap();
    let target = Target::File(folder.path().join("p.npy"));
    let mut sink = Sink::open(
        &target,
        Format::Npy,
        layout(2, 1, Element::U32),
        Value::Null,
    )
    .unwrap();
    assert!(sink.write(&[1, 2, 3]).is_err());
    assert!(matches!(sink.write(&[1, 2]), Err(Error::Io { .. })));
    assert!(matches!(sink.finish(), Err(Error::Io { .. })));
    assert!(names(&folder).is_empty());
}
