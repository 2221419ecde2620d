//! Scene files.
//!
//! ```toml
//! sampler = "sobol:owen-hash"        # each of these may be left out
//! samples = 1024                     # of a pixel, at most 2^32
//! seed = 1
//! profile = "exact"
//! gltf = "room.glb"                  # begins with its camera, lights and materials
//!
//! [target]                           # limits of the device, those that matter
//! group-invocations = 128
//! push-constant-bytes = 128
//! storage-buffers = 4
//! storage-buffer-bytes = 134217728
//!
//! [camera]
//! filter = { kind = "gaussian", radius = 1.5, sigma = 0.5 }
//! lens = { shape = "disk" }
//! shutter = [0.0, 0.02]              # opens and closes, in seconds
//!
//! [environment]
//! map = "sunrise.exr"                # paths count from the file's own folder
//!
//! [[light]]
//! kind = "sphere"                    # area lights by shape, parameters as of `corput maps`
//! center = [0, 2, 0]
//! radius = 0.5
//! power = 40
//!
//! [[material]]
//! name = "varnish"
//! lobes = [{ kind = "diffuse", weight = 3 }, { kind = "ggx", alpha = 0.1 }]
//!
//! [[medium]]
//! distance = { sigma = 0.1 }
//! phase = { kind = "henyey-greenstein", g = 0.8 }
//! ```
//!
//! What is not there is not drawn. A lobe with `alpha = 0` is a mirror, point lights and single
//! lights need no choice: none of them has a domain.

use super::table::{Source, Table, Value};
use super::{Camera, Scene, Stated, Target, gltf, light, name_of, refused, surface};
use crate::Result;
use crate::catalog::{Profile, Sampler};
use crate::report::bounded_text;
use std::path::Path;
use toml::de::DeTable;

/// A scene file of more bytes is none: 2^20.
pub const LONGEST: u64 = 1 << 20;

/// Reads a scene file.
pub(super) fn read(path: &Path) -> Result<Scene> {
    let remedy = "give a scene file, .gltf or .glb";
    let failed = |problem: String| refused(path, problem, remedy);
    let text = match std::fs::metadata(path) {
        Ok(about) if !about.is_file() => Err("it is no regular file".to_owned()),
        Ok(_) => bounded_text(path, LONGEST),
        Err(error) => Err(error.to_string()),
    };
    parse(&text.map_err(failed)?, path)
}

/// A scene of a scene file's text; maps count from the folder of the path, and messages name
/// it.
///
/// # Errors
/// [`Error::Scene`](crate::Error::Scene) with line and column: an unknown key with the nearest
/// known one, a value or a parameter out of its domain, a light without area, an image that
/// cannot be read.
pub fn parse(text: &str, path: &Path) -> Result<Scene> {
    let source = Source { text, path };
    let document = DeTable::parse(text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        source.refuse(at, error.message())
    })?;
    let mut table = Table::new(&source, 0, document.get_ref());
    let mut scene = match table.take("gltf") {
        None => Scene::new(name_of(path))?,
        Some(value) => Scene {
            name: name_of(path),
            ..placed(&value, gltf::read(&path.with_file_name(value.text()?)))?
        },
    };
    let before = [scene.lights.len(), scene.materials.len()];
    if let Some(value) = table.take("sampler") {
        scene.sampler = Stated {
            value: placed(&value, Sampler::parse(value.text()?))?,
            cause: value.cause(),
        };
    }
    if let Some(value) = table.take("samples") {
        scene.samples = Stated {
            value: value.whole(1..=1 << 32)?,
            cause: value.cause(),
        };
    }
    if let Some(value) = table.take("seed") {
        scene.seed = value.whole(0..=u64::MAX)?;
    }
    if let Some(value) = table.take("profile") {
        scene.profile = placed(&value, Profile::from_name(value.text()?))?;
    }
    if let Some(value) = table.take("target") {
        scene.target = target(value.table()?)?;
    }
    if let Some(value) = table.take("camera") {
        let stated = surface::camera(value.table()?)?;
        let known = std::mem::take(&mut scene.camera);
        scene.camera = Camera {
            filter: stated.filter.or(known.filter),
            lens: stated.lens.or(known.lens),
            shutter: stated.shutter.or(known.shutter),
        };
    }
    if let Some(value) = table.take("environment") {
        scene.lights.push(light::environment(&value)?);
    }
    for (index, table) in tables(&mut table, "light")?.into_iter().enumerate() {
        scene.lights.push(light::light(table, before[0] + index)?);
    }
    for (index, table) in tables(&mut table, "material")?.into_iter().enumerate() {
        scene
            .materials
            .push(surface::material(table, before[1] + index)?);
    }
    for (index, table) in tables(&mut table, "medium")?.into_iter().enumerate() {
        scene.media.push(surface::medium(table, index)?);
    }
    table.finish()?;
    Ok(scene)
}

fn tables<'s>(table: &mut Table<'s>, key: &'static str) -> Result<Vec<Table<'s>>> {
    let tables = table.take(key).map(|value| value.tables());
    Ok(tables.transpose()?.unwrap_or_default())
}

/// An error of a value, with its place.
pub(super) fn placed<T>(value: &Value, result: Result<T>) -> Result<T> {
    result.map_err(|error| value.refuse(&error.to_string()))
}

/// The name of a table: letters, digits, `-` and `_`, after a letter; by default its number.
pub(super) fn name(table: &mut Table, index: usize) -> Result<String> {
    let Some(value) = table.take("name") else {
        return Ok(index.to_string());
    };
    let name = value.text()?;
    let letters = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic());
    if !begins || !name.chars().all(letters) || name.len() > 64 {
        let limit = "a name is a letter, then up to 63 letters, digits, `-` and `_`";
        return Err(value.refuse(&format!("name `{name}`: {limit}")));
    }
    Ok(name.to_owned())
}

fn target(mut table: Table) -> Result<Target> {
    let mut limit = |key| {
        let value = table.take(key);
        value.map(|value| value.whole(0..=u64::MAX)).transpose()
    };
    let target = Target {
        group_invocations: limit("group-invocations")?,
        push_constant_bytes: limit("push-constant-bytes")?,
        storage_buffers: limit("storage-buffers")?,
        storage_buffer_bytes: limit("storage-buffer-bytes")?,
    };
    table.finish()?;
    Ok(target)
}
