//! What must hold of each reader of JSON documents, whatever the bytes. The fuzz targets ask it of
//! what a fuzzer makes, and `tests/cpu/documents.rs` of damaged seeds.

use corput::bench::{Baseline, changes};
use corput::estimate::Recorded;
use corput::report::zarr::{self, Store};
use corput::report::{
    Comparison, Element, Form, Format, Keeping, Layout, Origin, Sidecar, Sink, Target, Whole,
    read_json,
};
use corput::{Error, Result};
use std::fs;
use std::path::{Path, PathBuf};

/// A folder of this thread, in memory where the system has such a place; empty before and after.
fn in_folder<T>(work: impl FnOnce(&Path) -> T) -> T {
    let memory = PathBuf::from("/dev/shm");
    let parent = if memory.is_dir() {
        memory
    } else {
        std::env::temp_dir()
    };
    let (process, thread) = (std::process::id(), std::thread::current().id());
    let folder = parent.join(format!("corput-{process}-{thread:?}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir(&folder).expect("a folder in memory");
    let done = work(&folder);
    let _ = fs::remove_dir_all(&folder);
    done
}

/// Refused before work began, or because something differs.
fn refused<T>(result: Result<T>) {
    if let Err(error) = result {
        assert!([1, 2].contains(&error.exit_code()), "{error}");
    }
}

/// FILE.json as what is made at once reads it; a file of rows of one chunk is read so too.
pub fn read_file(data: &[u8]) -> Result<()> {
    in_folder(|folder| {
        fs::write(folder.join("p.json"), data).expect("a file in memory");
        Whole::of(&folder.join("p")).map(drop)
    })
}

/// FILE.json: what it says fits together, and a file of other bytes differs.
pub fn file(data: &[u8]) {
    const BYTES: &[u8] = b"x0,x1\n0,0\n0.5,0.3\n";
    in_folder(|folder| {
        let path = folder.join("p");
        fs::write(&path, BYTES).expect("a file in memory");
        fs::write(folder.join("p.json"), data).expect("a file in memory");
        refused(Origin::of(&path));
        let form = Form {
            format: "png",
            shape: vec![4, 4],
            descr: ">u2",
            header: 0,
        };
        match Whole::of(&path) {
            Ok(whole) => refused(whole.compare(&path, BYTES, &form)),
            error => refused(error),
        }
        let sidecar = match Sidecar::of(&path) {
            Ok(sidecar) => sidecar,
            error => return refused(error),
        };
        let rows = sidecar.layout.rows;
        assert_eq!(
            sidecar.chunks.len() as u64,
            rows.div_ceil(sidecar.chunk_rows)
        );
        for rows in [0..rows, 0..1, rows.saturating_sub(1)..rows] {
            match Comparison::open(&path, &sidecar, rows) {
                Ok(mut comparison) => {
                    comparison.take(&[0; 4]).expect("the file is read");
                    refused(comparison.finish());
                }
                error => refused(error),
            }
        }
    });
}

/// Rows, chunks of them and columns of the file that a journal belongs to.
const ROWS: u64 = 20;
const CHUNK: u64 = 4;
const COLUMNS: u32 = 2;

/// The words of its data.
pub fn journal_words() -> Vec<u32> {
    (0..ROWS as u32 * COLUMNS).collect()
}

fn sink(path: &Path, resume: bool) -> Result<Sink> {
    Sink::keeping(
        &Target::from(path),
        Format::Raw,
        Layout {
            rows: ROWS,
            columns: COLUMNS,
            element: Element::U32,
        },
        Origin::default(),
        Keeping {
            resume,
            chunk_rows: Some(CHUNK),
        },
        &mut |_, _| Ok(()),
    )
}

/// Rows from which a run goes on with these lines in its journal: below the first line of a run of
/// the same arguments, or in its place.
pub fn journal_rows(data: &[u8], below: bool) -> Result<u64> {
    in_folder(|folder| {
        let path = folder.join("p");
        let (partial, journal) = (folder.join(".p.partial"), folder.join(".p.partial.json"));
        let mut left = sink(&path, false).expect("a file in memory");
        left.write(&journal_words()).expect("a file in memory");
        let kept = left.abandon(Error::ZeroCount { what: "test" });
        assert!(matches!(kept, Error::Kept { .. }), "{kept}");
        let mut text = Vec::new();
        if below {
            text = fs::read(&journal).expect("a journal");
            let first = text.iter().position(|byte| *byte == b'\n');
            text.truncate(first.expect("a line") + 1);
        }
        text.extend_from_slice(data);
        fs::write(&journal, text).expect("a file in memory");
        let sink = sink(&path, true)?;
        let rows = sink.rows();
        drop(sink);
        // What is kept is there, and nothing where nothing is.
        assert_eq!(partial.exists(), rows > 0);
        Ok(rows)
    })
}

/// Journals: whole chunks whose hashes are those of the data, or a refusal.
pub fn journal(data: &[u8]) {
    for below in [true, false] {
        match journal_rows(data, below) {
            Ok(rows) => assert!(rows.is_multiple_of(CHUNK) && rows <= ROWS, "{rows}"),
            error => refused(error),
        }
    }
}

/// A store with this `zarr.json`.
pub fn read_store(data: &[u8]) -> Result<()> {
    in_folder(|folder| {
        fs::write(folder.join("zarr.json"), data).expect("a file in memory");
        Store::open(folder).map(drop)
    })
}

/// Documents of stores: an array whose chunks are not there, or a refusal; records of chunks that
/// are theirs, or a fault.
pub fn zarr(data: &[u8]) {
    in_folder(|folder| {
        fs::write(folder.join("zarr.json"), data).expect("a file in memory");
        match Store::open(folder) {
            Ok(store) => {
                assert_eq!(
                    store.fault(0).expect("no chunk"),
                    Some(zarr::Fault::Missing)
                );
                if store.layout().rows > 0 {
                    // However many chunks it speaks of, none is looked for.
                    let survey = store.survey(&mut |_| Ok(())).expect("no chunk");
                    assert_eq!(survey.lacking(), store.chunks());
                    assert!(store.chunks() > 0 && store.rows(0).start == 0);
                    let mut comparison = zarr::Comparison::new(&store, 0..1).expect("a row");
                    let words = store.layout().columns.min(4) as usize;
                    comparison.take(&vec![0; words]).expect("nothing to read");
                    assert!(comparison.finish().is_err());
                }
            }
            error => refused(error),
        }
    });
    in_folder(|folder| {
        let layout = Layout {
            rows: 2,
            columns: 2,
            element: Element::U32,
        };
        let path = folder.join("s.zarr");
        let store = Store::create(&path, layout, &Origin::default().arguments).expect("a store");
        fs::create_dir_all(path.join("c/0")).expect("a folder");
        // A hole of the right length, so that it is the record that counts.
        let chunk = fs::File::create(path.join("c/0/0")).expect("a file");
        chunk.set_len(store.chunk_bytes()).expect("its length");
        fs::write(path.join("corput/0.json"), data).expect("a file in memory");
        assert!(store.fault(0).expect("it is read").is_some());
    });
}

/// Estimates, as `corput merge` reads them.
pub fn read_estimates(data: &[u8]) -> Result<Recorded> {
    in_folder(|folder| {
        let path = folder.join("e.json");
        fs::write(&path, data).expect("a file in memory");
        let document = read_json(&path, 1 << 20, Recorded::REMEDY)?;
        Recorded::parse(&document, &path)
    })
}

/// Documents of estimates: sums of as many points as their ranges have, or a refusal.
pub fn estimates(data: &[u8]) {
    match read_estimates(data) {
        Ok(recorded) => {
            let points = recorded.ranges.iter().map(|range| range.end - range.start);
            assert_eq!(points.sum::<u64>(), recorded.estimate.count());
            refused(recorded.estimate.merged(recorded.estimate));
        }
        error => refused(error),
    }
}

/// A document of `corput bench --json`.
pub fn read_baseline(data: &[u8]) -> Result<Baseline> {
    in_folder(|folder| {
        let path = folder.join("b.json");
        fs::write(&path, data).expect("a file in memory");
        Baseline::read(&path)
    })
}

/// Baselines: jobs with times, or a refusal.
pub fn baseline(data: &[u8]) {
    match read_baseline(data) {
        Ok(baseline) => assert!(changes(&[], &baseline).is_empty()),
        error => refused(error),
    }
}
