//! The published vectors: their manifest is the committed one, and files hold what it says.

use corput::Error;
use corput::report::{hexadecimal, read_points};
use corput::vectors::{self, SCHEMA};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;
use std::path::Path;

const MANIFEST: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/vectors.json");

/// `CORPUT_WRITE_TABLES=1 cargo test --all-features --test vectors` writes it.
#[test]
fn the_manifest_is_the_committed_one() {
    let manifest = vectors::manifest().expect("the catalogue is right");
    if std::env::var_os("CORPUT_WRITE_TABLES").is_some() {
        std::fs::write(MANIFEST, format!("{manifest:#}\n")).expect("it is written");
    }
    let committed = std::fs::read_to_string(MANIFEST).expect("it is there");
    let committed: Value = serde_json::from_str(&committed).expect("it is JSON");
    let entries = |document: &Value| document["entries"].as_array().expect("entries").clone();
    for (one, other) in entries(&manifest).iter().zip(&entries(&committed)) {
        assert_eq!(one, other, "a value has changed: is that meant?");
    }
    assert_eq!(manifest, committed);
}

#[test]
fn the_readme_counts_them() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
    let readme = std::fs::read_to_string(path).expect("it is there");
    let manifest = vectors::manifest().expect("the catalogue is right");
    let text = manifest.to_string();
    let files: BTreeSet<&str> = text
        .split("\"file\":\"")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .collect();
    let line = format!("# {} .npy files", files.len());
    assert!(readme.contains(&line), "{line}");
}

/// Every file that the manifest names, and the sources, are there and no others.
#[test]
fn files_hold_what_the_manifest_says() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = vectors::write(folder.path(), &mut |_| Ok(())).expect("they are written");
    let manifest = std::fs::read_to_string(folder.path().join("vectors.json")).expect("it");
    let manifest: Value = serde_json::from_str(&manifest).expect("it is JSON");
    assert_eq!(manifest["schema"], SCHEMA);
    assert_eq!(
        manifest,
        vectors::manifest().expect("the catalogue is right")
    );
    let mut named = BTreeSet::new();
    let mut kinds = BTreeSet::new();
    for entry in manifest["entries"].as_array().expect("entries") {
        kinds.insert(entry["kind"].as_str().expect("a kind"));
        let reads = entry["reads"].as_array().into_iter().flatten();
        for table in entry.get("table").into_iter().chain(reads) {
            let name = table["file"].as_str().expect("a file");
            assert!(named.insert(name.to_owned()), "{name} twice");
            let bytes = std::fs::read(folder.path().join(name)).expect("it is there");
            assert_eq!(
                table["sha256"],
                hexadecimal(&Sha256::digest(&bytes)),
                "{name}"
            );
            let shape = table["shape"].as_array().expect("a shape");
            let words: u64 = shape
                .iter()
                .map(|axis| axis.as_u64().expect("a number"))
                .product();
            assert_eq!(bytes.len() as u64, 4096 + 4 * words, "{name}");
            assert!(words > 0, "{name}");
        }
        if let Some(kernel) = entry["kernel"].as_str() {
            assert!(
                folder.path().join("kernels").join(kernel).exists(),
                "{kernel}"
            );
        }
    }
    let expected = ["blue noise", "function", "integrand", "map", "sequence"];
    assert_eq!(kinds, BTreeSet::from(expected));
    // With the nine sources and the manifest.
    assert_eq!(files.len(), named.len() + 10);
}

/// NumPy's reader and ours see fractions where `generate` writes them.
#[test]
fn sequences_are_read_as_points() {
    let folder = tempfile::tempdir().expect("a folder");
    vectors::write(folder.path(), &mut |_| Ok(())).expect("they are written");
    let points = read_points(&folder.path().join("sequences/halton.npy")).expect("points");
    assert_eq!((points.columns(), points.rows()), (5, 1024));
    assert_eq!(
        points.values()[5..7],
        [0.5, f64::from(1431655766u32) / f64::powi(2.0, 32)]
    );
}

/// Points far from each other, and masks in which each rank is once.
#[test]
fn blue_noise_is_among_them() {
    let (mut masks, mut sets) = (0, 0);
    vectors::each(&mut |entry| {
        if let (Some(table), "blue-noise-mask") = (&entry.table, entry.name.as_str()) {
            let pixels = table.words.len();
            let ranks = table
                .words
                .iter()
                .map(|&word| (u64::from(word) * pixels as u64) >> 32);
            assert_eq!(
                ranks.collect::<BTreeSet<u64>>().len(),
                pixels,
                "{}",
                table.file
            );
            masks += 1;
        }
        if let (Some(table), "blue-noise") = (&entry.table, entry.name.as_str()) {
            let points: Vec<&[u32]> = table.words.chunks_exact(2).collect();
            let squares = (0..points.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
            let apart = |(i, j): (usize, usize)| {
                let axis = |k: usize| f64::from(points[i][k].wrapping_sub(points[j][k]) as i32);
                axis(0).hypot(axis(1)) / f64::powi(2.0, 32)
            };
            // Of random points the least would be some 1 / 1500.
            let least = squares.map(apart).fold(1.0, f64::min);
            assert!(least > 0.02, "{least}");
            sets += 1;
        }
        Ok(())
    })
    .expect("the catalogue is right");
    assert_eq!((masks, sets), (2, 1));
}

#[test]
fn another_word_is_another_hash() {
    let mut seen = 0u64;
    vectors::each(&mut |entry| {
        if let Some(table) = &entry.table {
            let mut other = table.clone();
            let last = other.words.last_mut().expect("words");
            *last ^= 1;
            assert_ne!(table.sha256(), other.sha256(), "{}", table.file);
            seen += 1;
        }
        Ok(())
    })
    .expect("the catalogue is right");
    assert!(seen > 100 && seen < vectors::number().expect("the catalogue is right"));
}

#[test]
fn a_folder_that_cannot_be_is_refused() {
    let file = tempfile::NamedTempFile::new().expect("a file");
    let below = file.path().join("below");
    let error = vectors::write(Path::new(&below), &mut |_| Ok(())).expect_err("it is no folder");
    assert!(matches!(error, Error::Output { .. }), "{error}");
}

#[test]
fn a_stop_is_heard() {
    let folder = tempfile::tempdir().expect("a folder");
    let stop = Error::Interrupted { done: 0, total: 0 };
    let mut stop = Some(stop);
    let stopped = vectors::write(folder.path(), &mut |_| stop.take().map_or(Ok(()), Err));
    assert!(matches!(stopped, Err(Error::Interrupted { .. })));
    assert!(!folder.path().join("vectors.json").exists());
}
