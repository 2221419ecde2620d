//! Files to documents that are checked.

use super::names::short;
use super::{MOST_BYTES, MOST_JSON, SUPPORTED};
use crate::report::bounded_bytes;
use crate::scene::refused;
use crate::{Error, Result};
use gltf::json::{Root, mesh::Semantic, validation::Checked};
use gltf::{Document, Gltf};
use std::path::Path;

/// What to do with a file that breaks the format.
pub(super) const BROKEN: &str = "check it with the Khronos glTF validator, or export it anew";

/// A file, read.
pub(super) struct Opened {
    /// Its JSON, whose indices are within bounds.
    pub(super) document: Document,
    /// The binary chunk of a `.glb`.
    pub(super) blob: Option<Vec<u8>>,
    /// What it uses and nobody here reads, in a sentence.
    pub(super) unread: Vec<String>,
}

/// Reads a file, and checks it.
pub(super) fn open(path: &Path) -> Result<Opened> {
    let failed = |error: std::io::Error| refused(path, error.to_string(), "give a glTF file");
    let about = std::fs::metadata(path).map_err(failed)?;
    if !about.is_file() {
        return Err(refused(path, "it is no regular file", "give a glTF file"));
    }
    if about.len() > MOST_BYTES {
        return Err(too_large(path, "the file", about.len(), "2^30"));
    }
    // It may have grown.
    let file = std::fs::File::open(path).map_err(failed)?;
    let bytes = bounded_bytes(file, MOST_BYTES)
        .map_err(|problem| refused(path, problem, "give a glTF file"))?;
    sizes(&bytes, path)?;
    let Gltf { document, blob } = Gltf::from_slice_without_validation(&bytes)
        .map_err(|error| refused(path, short_error(&error), BROKEN))?;
    let mut root = document.into_json();
    let version = root.asset.version.as_str();
    if version.split('.').next() != Some("2") {
        let problem = format!("it is of glTF {}", short(version));
        return Err(refused(path, problem, "export it as glTF 2.0"));
    }
    let required = std::mem::take(&mut root.extensions_required);
    if let Some(unknown) = required
        .iter()
        .find(|one| !SUPPORTED.contains(&one.as_str()))
    {
        let problem = format!("it requires the extension {}", short(unknown));
        let remedy = format!("export it without; read are {}", SUPPORTED.join(", "));
        return Err(refused(path, problem, remedy));
    }
    let unread: Vec<String> = root
        .extensions_used
        .iter()
        .filter(|one| !SUPPORTED.contains(&one.as_str()))
        .map(|one| format!("not read: {}, which it does not require", short(one)))
        .collect();
    positions(&root, path)?;
    let document = Document::from_json(root).map_err(|error| invalid(path, &error))?;
    Ok(Opened {
        document,
        blob,
        unread,
    })
}

pub(super) fn too_large(path: &Path, what: &str, bytes: u64, limit: &str) -> Error {
    let problem = format!("{what} has {bytes} bytes; the most are {limit}");
    refused(
        path,
        problem,
        "split the scene, or leave out what does not emit",
    )
}

/// Refuses headers of `.glb` that lie: the crate subtracts from the length before it checks it.
fn sizes(bytes: &[u8], path: &Path) -> Result<()> {
    let word = |at: usize| {
        let four = bytes.get(at..at + 4).and_then(|four| four.try_into().ok());
        four.map(|four| u64::from(u32::from_le_bytes(four)))
    };
    let json = if bytes.starts_with(b"glTF") {
        let (Some(whole), Some(json)) = (word(8), word(12)) else {
            return Err(refused(path, "its header is cut off", BROKEN));
        };
        if whole < 20 || whole > bytes.len() as u64 {
            let problem = format!("its header says {whole} bytes; it has {}", bytes.len());
            return Err(refused(path, problem, BROKEN));
        }
        json
    } else {
        bytes.len() as u64
    };
    match json > MOST_JSON {
        true => Err(too_large(path, "its JSON", json, "2^26")),
        false => Ok(()),
    }
}

/// Refuses positions that are no accessor, at which the crate's validation panics.
fn positions(root: &Root, path: &Path) -> Result<()> {
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    for primitive in primitives {
        let position = primitive
            .attributes
            .get(&Checked::Valid(Semantic::Positions));
        if position.is_some_and(|index| index.value() >= root.accessors.len()) {
            let problem = "a primitive's POSITION is an accessor that is not there";
            return Err(refused(path, problem, BROKEN));
        }
    }
    Ok(())
}

fn invalid(path: &Path, error: &gltf::Error) -> Error {
    let problem = match error {
        gltf::Error::Validation(all) => match &all[..] {
            [] => "it is invalid".to_owned(),
            [(at, error), rest @ ..] => {
                let first = format!("{}: {}", short_path(at.as_str()), error);
                match rest.len() {
                    0 => first,
                    more => format!("{first}, and {more} more"),
                }
            }
        },
        other => short_error(other),
    };
    refused(path, problem, BROKEN)
}

fn short_path(path: &str) -> String {
    path.chars().filter(|c| !c.is_control()).take(96).collect()
}

fn short_error(error: &gltf::Error) -> String {
    short_path(&error.to_string())
}
