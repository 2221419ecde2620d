//! What must hold of each parser of outside data, whatever the bytes. The fuzz targets ask it of
//! what a fuzzer makes, and `tests/cpu/parsers.rs` of damaged seeds.

use corput::check::compare;
use corput::image::{MAX_HEIGHT, MAX_WIDTH, load, load_raw};
use corput::report::read_points;
use corput::scene::{self, Needs, Scene};
use std::path::{Path, PathBuf};

/// A file of this thread, in memory where the system has such a folder: the parsers take paths.
fn with_file<T>(ending: &str, data: &[u8], parse: impl FnOnce(&Path) -> T) -> T {
    let memory = PathBuf::from("/dev/shm");
    let folder = if memory.is_dir() {
        memory
    } else {
        std::env::temp_dir()
    };
    let (process, thread) = (std::process::id(), std::thread::current().id());
    let path = folder.join(format!("corput-{process}-{thread:?}.{ending}"));
    std::fs::write(&path, data).expect("a file in memory");
    let parsed = parse(&path);
    let _ = std::fs::remove_file(&path);
    parsed
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

/// A scene by what its bytes begin with: glTF, or a scene file.
pub fn read_scene(data: &[u8]) -> corput::Result<Scene> {
    match data {
        [b'g', b'l', b'T', b'F', ..] => with_file("glb", data, scene::read),
        [b'{', ..] => with_file("gltf", data, scene::read),
        _ => scene::parse(&String::from_utf8_lossy(data), Path::new("scene.toml")),
    }
}

/// Scenes: domains within the points' dimensions, or a refusal before work begins.
pub fn scene(data: &[u8]) {
    match read_scene(data).and_then(|scene| Needs::of(&scene)) {
        Ok(needs) => {
            let end = needs.domains.iter().map(|one| one.range().end).max();
            assert_eq!(end, Some(needs.dimensions()));
            assert!(needs.domains.iter().all(|one| !one.cause.text.is_empty()));
        }
        Err(error) => assert_eq!(error.exit_code(), 2, "{error}"),
    }
}
