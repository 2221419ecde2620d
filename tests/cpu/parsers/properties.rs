//! What must hold of each parser of outside data, whatever the bytes. The fuzz targets ask it of
//! what a fuzzer makes, and `tests/cpu/parsers.rs` of damaged seeds.

use corput::check::compare;
use corput::image::{MAX_HEIGHT, MAX_WIDTH, load, load_raw};
use corput::report::read_points;
use std::path::{Path, PathBuf};

/// A file of this thread, in memory where the system has such a folder: the parsers take paths.
fn with_file(ending: &str, data: &[u8], parse: impl FnOnce(&Path)) {
    let memory = PathBuf::from("/dev/shm");
    let folder = if memory.is_dir() {
        memory
    } else {
        std::env::temp_dir()
    };
    let (process, thread) = (std::process::id(), std::thread::current().id());
    let path = folder.join(format!("corput-{process}-{thread:?}.{ending}"));
    std::fs::write(&path, data).expect("a file in memory");
    parse(&path);
    let _ = std::fs::remove_file(&path);
}

fn picture(ending: &str, data: &[u8]) {
    with_file(ending, data, |path| {
        if let Ok(image) = load(path) {
            assert!(image.width as usize <= MAX_WIDTH && image.height as usize <= MAX_HEIGHT);
            assert_eq!(
                image.texels.len(),
                image.width as usize * image.height as usize
            );
            assert!(
                image
                    .texels
                    .iter()
                    .flatten()
                    .all(|l| l.is_finite() && *l >= 0.0)
            );
            assert!(load_raw(path).is_ok());
        }
    });
}

/// OpenEXR: an image of finite light, or a refusal.
pub fn exr(data: &[u8]) {
    picture("exr", data);
}

/// Radiance: the same.
pub fn hdr(data: &[u8]) {
    picture("hdr", data);
}

/// Arrays: points in the unit cube, or a refusal.
pub fn npy(data: &[u8]) {
    with_file("npy", data, |path| {
        if let Ok(points) = read_points(path) {
            assert!(points.rows() > 0 && points.columns() > 0);
            assert!(points.values().iter().all(|x| (0.0..1.0).contains(x)));
        }
    });
}

/// Study files: rows that can run, or a refusal that says where.
pub fn study(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else {
        return;
    };
    match corput::converge::parse(text, Path::new("study.toml")) {
        Ok((rows, _)) => assert!(rows.iter().all(|row| !row.samplers.is_empty())),
        Err(error) => assert!(error.to_string().contains("line "), "{error}"),
    }
}

/// Documents of `corput check`: equal to themselves, or a refusal.
pub fn check(data: &[u8]) {
    with_file("json", data, |path| {
        if let Ok(found) = compare(path, path) {
            assert!(found.differ.is_empty() && found.native == 0);
        }
    });
}
