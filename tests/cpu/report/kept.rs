//! Files of several chunks that are left and taken up again.

use super::*;
use corput::report::{Keeping, MAX_CHUNKS, Sidecar, chunk_rows};

const ROWS: u64 = 10_000;
const CHUNK: u64 = 1024;

fn open(path: &Path, format: Format, count: u64, resume: bool) -> Result<Sink, Error> {
    let keeping = Keeping {
        resume,
        chunk_rows: Some(CHUNK),
    };
    Sink::keeping(
        &Target::from(path),
        format,
        layout(ROWS, 3, Element::U32),
        json!({ "count": count }).into(),
        keeping,
        &mut |_, _| Ok(()),
    )
}

fn data() -> Vec<u32> {
    (0..ROWS as u32 * 3)
        .map(|i| i.wrapping_mul(0x9e37_79b9))
        .collect()
}

/// Writes so many rows, and ends as a run does that fails.
fn leave(path: &Path, format: Format, rows: u64) -> Error {
    let mut sink = open(path, format, 1, false).unwrap();
    sink.write(&data()[..rows as usize * 3]).unwrap();
    sink.abandon(Error::ZeroCount { what: "test" })
}

/// Goes on to the end, and returns the rows that were there and the file.
fn go_on(path: &Path, format: Format) -> (u64, Vec<u8>) {
    let mut sink = open(path, format, 1, true).unwrap();
    let start = sink.rows();
    // In pieces that are not those of the chunks.
    for piece in data()[start as usize * 3..].chunks(1000) {
        sink.write(piece).unwrap();
    }
    let summary = sink.finish().unwrap();
    let bytes = fs::read(path).unwrap();
    assert_eq!(summary.bytes, bytes.len() as u64);
    let sidecar = Sidecar::of(path).unwrap();
    assert_eq!(summary.sha256, Some(sidecar.sha256));
    assert_eq!(sidecar.chunks.len() as u64, ROWS.div_ceil(CHUNK));
    (start, bytes)
}

fn whole(format: Format) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p");
    go_on(&path, format).1
}

#[test]
fn complete_chunks_are_kept_and_gone_on_from() {
    for format in FORMATS {
        let expected = whole(format);
        for (rows, kept) in [
            (0, 0),
            (1023, 0),
            (1024, 1024),
            (5000, 4096),
            (9999, 9216),
            (ROWS, 9216),
        ] {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("p");
            let error = leave(&path, format, rows);
            match kept {
                0 => assert!(names(&folder).is_empty() && matches!(error, Error::ZeroCount { .. })),
                _ => {
                    let text = error.to_string();
                    let said = format!("{kept} of {ROWS} rows stay in");
                    assert!(text.contains(&said) && text.contains("--resume"), "{text}");
                    assert_eq!(error.exit_code(), 2, "that of the cause");
                    assert_eq!(names(&folder), [".p.partial", ".p.partial.json"]);
                }
            }
            let (start, bytes) = go_on(&path, format);
            assert_eq!(start, kept);
            assert!(bytes == expected, "{format} after {rows} rows");
            assert_eq!(names(&folder), ["p", "p.json"]);
        }
    }
}

/// As where too many files are open.
#[test]
fn a_partial_file_that_cannot_be_opened_keeps_its_journal() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p");
    leave(&path, Format::Npy, 5000);
    let (partial, aside) = (
        folder.path().join(".p.partial"),
        folder.path().join("aside"),
    );
    fs::rename(&partial, &aside).unwrap();
    fs::create_dir(&partial).unwrap();
    let error = open(&path, Format::Npy, 1, true).err().expect("a folder");
    assert_eq!(error.exit_code(), 2);
    fs::remove_dir(&partial).unwrap();
    fs::rename(&aside, &partial).unwrap();
    assert_eq!(go_on(&path, Format::Npy).0, 4096);
}

#[test]
fn files_of_others_are_not_replaced() {
    for text in ["precious", "{ \"mine\": 1 }", ""] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("p.json"), text).unwrap();
        let path = folder.path().join("p");
        let error = open(&path, Format::Npy, 1, false).err().expect("another's");
        let said = error.to_string();
        assert!(
            said.contains("p.json: it is there, and no FILE.json"),
            "{said}"
        );
        assert_eq!(names(&folder), ["p.json"]);
        assert_eq!(
            fs::read(folder.path().join("p.json")).unwrap(),
            text.as_bytes()
        );
    }
}

/// What befalls the files that a run left.
type Damage<'a> = dyn Fn(&TempDir) + 'a;

#[test]
fn damage_is_found_and_made_again() {
    let expected = whole(Format::Npy);
    let partial = |folder: &TempDir| folder.path().join(".p.partial");
    let journal = |folder: &TempDir| folder.path().join(".p.partial.json");
    let flip = |path: &Path, at: usize| {
        let mut bytes = fs::read(path).unwrap();
        bytes[at] ^= 0x10;
        fs::write(path, bytes).unwrap();
    };
    let cut = |path: &Path, less: u64| {
        let file = fs::OpenOptions::new().write(true).open(path).unwrap();
        file.set_len(file.metadata().unwrap().len() - less).unwrap();
    };
    let chunk = CHUNK as usize * 12;
    let cases: [(&str, &Damage, u64); 8] = [
        ("nothing", &|_| {}, 4096),
        (
            "a bit of the third chunk",
            &|f| flip(&partial(f), 4096 + 2 * chunk + 5),
            2048,
        ),
        ("a bit of the header", &|f| flip(&partial(f), 20), 0),
        ("the end of the data", &|f| cut(&partial(f), 1), 3072),
        ("the end of the journal", &|f| cut(&journal(f), 40), 3072),
        ("its last line feed", &|f| cut(&journal(f), 1), 3072),
        (
            "the first line of the journal",
            &|f| flip(&journal(f), 0),
            0,
        ),
        ("the data", &|f| fs::remove_file(partial(f)).unwrap(), 0),
    ];
    for (what, damage, kept) in cases {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("p");
        leave(&path, Format::Npy, 5000);
        damage(&folder);
        let (start, bytes) = go_on(&path, Format::Npy);
        assert_eq!(start, kept, "{what}");
        assert!(bytes == expected, "{what}");
    }
}

#[test]
fn what_another_run_left_is_refused_or_discarded() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p");
    leave(&path, Format::Npy, 5000);
    for (format, count, words) in [
        (Format::Npy, 2, "arguments.count is 1 there and 2 here"),
        (Format::Raw, 1, "format is \"npy\" there and \"raw\" here"),
    ] {
        let error = open(&path, format, count, true).err().unwrap();
        let text = error.to_string();
        assert!(error.exit_code() == 2 && text.contains(words), "{text}");
        assert!(text.contains("drop --resume"), "{text}");
        assert_eq!(names(&folder), [".p.partial", ".p.partial.json"]);
    }
    assert_eq!(go_on(&path, Format::Npy).0, 4096);
    leave(&path, Format::Npy, 5000);
    drop(open(&path, Format::Npy, 1, false).unwrap());
    assert_eq!(names(&folder), ["p", "p.json"]);
}

#[test]
fn what_is_stopped_while_it_is_checked_stays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p");
    leave(&path, Format::Npy, 5000);
    let stopped = Sink::keeping(
        &Target::from(path.as_path()),
        Format::Npy,
        layout(ROWS, 3, Element::U32),
        json!({ "count": 1 }).into(),
        Keeping {
            resume: true,
            chunk_rows: Some(CHUNK),
        },
        &mut |done, total| Err(Error::Interrupted { done, total }),
    );
    let text = stopped.err().unwrap().to_string();
    assert!(text.contains("4096 of 10000 rows stay"), "{text}");
    assert_eq!(go_on(&path, Format::Npy).0, 4096);
}

#[test]
fn a_finished_file_is_known() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p");
    let target = Target::from(path.as_path());
    let finished = |count: u64, rows: u64| {
        let origin = json!({ "count": count }).into();
        Sink::is_finished(&target, Format::Npy, layout(rows, 3, Element::U32), &origin).unwrap()
    };
    assert!(!finished(1, ROWS));
    go_on(&path, Format::Npy);
    assert!(finished(1, ROWS));
    assert!(!finished(2, ROWS) && !finished(1, ROWS - 1));
    // As a kill between the last rename and the removal leaves it.
    fs::write(folder.path().join(".p.partial.json"), "{}\n").unwrap();
    assert!(finished(1, ROWS));
    assert_eq!(names(&folder), ["p", "p.json"]);
    leave(&path, Format::Npy, 5000);
    assert!(!finished(1, ROWS), "a partial goes first");
    go_on(&path, Format::Npy);
    let file = fs::OpenOptions::new().append(true).open(&path).unwrap();
    file.set_len(5000).unwrap();
    assert!(!finished(1, ROWS), "it was cut");
}

#[test]
fn chunks_follow_from_the_layout() {
    assert_eq!(chunk_rows(&layout(1 << 28, 4, Element::F32)), 1 << 22);
    assert_eq!(chunk_rows(&layout(10, 3, Element::F32)), 5_591_040);
    assert_eq!(chunk_rows(&layout(10, 65_536, Element::F32)), 256);
    assert_eq!(chunk_rows(&layout(10, u32::MAX, Element::F32)), 1);
    // 2^48 words: chunks grow rather than their number.
    let many = layout(1 << 32, 65_536, Element::F32);
    assert_eq!((1u64 << 32).div_ceil(chunk_rows(&many)), MAX_CHUNKS);

    let folder = tempfile::tempdir().unwrap();
    for (rows, remedy) in [(0, "ask for 2 or more"), (1, "ask for 2 or more")] {
        let opened = Sink::keeping(
            &Target::from(folder.path().join("p")),
            Format::Raw,
            layout(MAX_CHUNKS + 1, 1, Element::F32),
            Value::Null.into(),
            Keeping {
                resume: false,
                chunk_rows: Some(rows),
            },
            &mut |_, _| Ok(()),
        );
        let text = opened.err().unwrap().to_string();
        assert!(text.contains(remedy), "{text}");
    }
    assert!(names(&folder).is_empty());
}
