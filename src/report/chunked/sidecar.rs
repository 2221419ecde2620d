//! `FILE.json`: what a file holds, what made it, and its hashes.

use super::{Chunk, PARTIAL, beside};
use crate::error::{Error, Result};
use crate::report::aside::Aside;
use crate::report::bounded;
use crate::report::encode::Encoder;
use crate::report::place::{Existing, existing, failed, refused as unwritable};
use crate::report::{Element, Format, Layout, read_json};
use serde_json::{Value, json};
use std::ffi::OsString;
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

/// Name and version of the form, which `docs/schemas/file-1.json` describes.
pub const SIDECAR_SCHEMA: &str = "corput-file/1";

/// The most that is read of a sidecar: of 2^16 chunks with some arguments.
pub(super) const MAX_BYTES: u64 = 64 << 20;

const REMEDY: &str =
    "give a file that has its FILE.json beside it, as `corput generate --out FILE` writes it";

/// What made the data of a file; recorded beside it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Origin {
    /// What decides the bytes. A run goes on only from what one of equal arguments left.
    pub arguments: Value,
    /// Who made them; not compared.
    pub device: String,
}

impl Origin {
    /// What made a file, by the FILE.json beside it.
    ///
    /// # Errors
    /// [`Error::Document`] where there is none, or one of another form.
    pub fn of(file: &Path) -> Result<Self> {
        let value = recorded(file)?;
        Ok(Self {
            arguments: value["arguments"].clone(),
            device: value["device"].as_str().unwrap_or_default().to_owned(),
        })
    }
}

impl From<Value> for Origin {
    fn from(arguments: Value) -> Self {
        Self {
            arguments,
            device: String::new(),
        }
    }
}

/// A sidecar, read back.
#[derive(Clone, Debug, PartialEq)]
pub struct Sidecar {
    /// What made the data.
    pub origin: Origin,
    /// Version of corput that did.
    pub version: String,
    /// Form of the file.
    pub format: Format,
    /// Shape and type.
    pub layout: Layout,
    /// The array's name, in source text.
    pub name: Option<String>,
    /// Bytes of the file.
    pub bytes: u64,
    /// Rows of each chunk but the last.
    pub chunk_rows: u64,
    /// The chunks, header and footer apart.
    pub chunks: Vec<Chunk>,
    /// SHA-256 of the whole file, in hexadecimal digits.
    pub sha256: String,
}

impl Sidecar {
    /// Where the sidecar of a file is: `FILE.json`.
    #[must_use]
    pub fn path_of(file: &Path) -> PathBuf {
        let mut name = OsString::from(file);
        name.push(".json");
        PathBuf::from(name)
    }

    /// Reads the sidecar of a file of rows.
    ///
    /// # Errors
    /// [`Error::Document`] where there is none, or one of another form.
    pub fn of(file: &Path) -> Result<Self> {
        let value = recorded(file)?;
        read(&value)
            .map_err(|name| refused(file, format!("`{name}` is missing or of a wrong kind")))
    }
}

fn refused(file: &Path, problem: String) -> Error {
    Error::Document {
        path: Sidecar::path_of(file),
        problem,
        remedy: REMEDY,
    }
}

/// The document beside a file, whatever it describes.
pub(in crate::report) fn recorded(file: &Path) -> Result<Value> {
    let value = read_json(&Sidecar::path_of(file), MAX_BYTES, REMEDY)?;
    if value["schema"] != SIDECAR_SCHEMA {
        return Err(refused(
            file,
            format!(
                "its schema is {}, not \"{SIDECAR_SCHEMA}\"",
                value["schema"]
            ),
        ));
    }
    Ok(value)
}

/// The fields, or the name of the first that is not as it must be.
fn read(value: &Value) -> Result<Sidecar, &'static str> {
    let text = |name: &'static str| value[name].as_str().ok_or(name);
    let number = |name: &'static str| value[name].as_u64().ok_or(name);
    let shape = value["shape"].as_array().ok_or("shape")?;
    let [rows, columns] = shape.as_slice() else {
        return Err("shape");
    };
    let layout = Layout {
        rows: rows.as_u64().ok_or("shape")?,
        columns: columns
            .as_u64()
            .and_then(|columns| u32::try_from(columns).ok())
            .ok_or("shape")?,
        element: Element::from_descr(text("type")?).ok_or("type")?,
    };
    layout.words().map_err(|_| "shape")?;
    let chunks = value["chunks"].as_array().ok_or("chunks")?;
    let chunk_rows = number("chunk_rows")?;
    if chunk_rows == 0 || chunks.len() as u64 != layout.rows.div_ceil(chunk_rows) {
        return Err("chunks");
    }
    Ok(Sidecar {
        origin: Origin {
            arguments: value.get("arguments").ok_or("arguments")?.clone(),
            device: text("device")?.to_owned(),
        },
        version: text("version")?.to_owned(),
        name: match value.get("name") {
            Some(Value::Null) => None,
            _ => Some(text("name")?.to_owned()),
        },
        format: text("format")?.parse().map_err(|_| "format")?,
        layout,
        bytes: number("bytes")?,
        chunk_rows,
        chunks: chunks
            .iter()
            .map(Chunk::read)
            .collect::<Option<_>>()
            .ok_or("chunks")?,
        sha256: text("sha256")?.to_owned(),
    })
}

/// Refuses a name of a sidecar under which something is that `generate` may not replace.
pub(in crate::report) fn check_free(sidecar: &Path) -> Result<()> {
    if let Existing::Device = existing(sidecar)? {
        let remedy = "give the output another name";
        return Err(unwritable(sidecar, "it is no regular file", remedy));
    }
    if is_of_others(sidecar) {
        let problem = "it is there, and no FILE.json of corput";
        let remedy = "move it, or give the output another name";
        return Err(unwritable(sidecar, problem, remedy));
    }
    Ok(())
}

/// Whether a file of that name is there that no `generate` wrote.
fn is_of_others(path: &Path) -> bool {
    let found = || read_json(path, MAX_BYTES, REMEDY);
    path.exists() && found().map_or(true, |value| value.get("arguments").is_none())
}

/// What a run must share with an earlier one to go on from it.
pub(super) fn description(origin: &Origin, encoder: &Encoder, chunk_rows: u64) -> Value {
    let layout = &encoder.layout;
    json!({
        "arguments": origin.arguments,
        "version": env!("CARGO_PKG_VERSION"),
        "format": encoder.format.name(),
        "name": encoder.name,
        "shape": [layout.rows, layout.columns],
        "type": layout.element.descr(),
        "chunk_rows": chunk_rows,
    })
}

/// The same of a file that is made at once, of one chunk.
pub(in crate::report) fn whole_description(
    origin: &Origin,
    format: &str,
    shape: &[u32],
    descr: &str,
    rows: u32,
) -> Value {
    json!({
        "arguments": origin.arguments,
        "version": env!("CARGO_PKG_VERSION"),
        "format": format,
        "name": null,
        "shape": shape,
        "type": descr,
        "chunk_rows": rows,
    })
}

/// The sidecar of a finished file.
pub(in crate::report) fn document(
    mut description: Value,
    device: &str,
    bytes: u64,
    chunks: &[&Chunk],
    sha256: &str,
) -> Vec<u8> {
    let chunk = |chunk: &&Chunk| json!({ "bytes": chunk.bytes, "sha256": chunk.sha256 });
    description["schema"] = json!(SIDECAR_SCHEMA);
    description["device"] = json!(device);
    description["bytes"] = json!(bytes);
    description["chunks"] = chunks.iter().map(chunk).collect();
    description["sha256"] = json!(sha256);
    format!("{description:#}\n").into_bytes()
}

/// A sidecar that has its name before its file does.
pub(in crate::report) struct Described {
    name: PathBuf,
    /// What was under its name.
    before: Option<Vec<u8>>,
}

impl Described {
    /// Puts back what was there: the file did not come, and an older one is still described by
    /// that.
    pub(in crate::report) fn take_back(self) {
        let put_back = self
            .before
            .is_some_and(|before| put(&self.name, &before).is_ok());
        if !put_back {
            // It describes data that is not there.
            let _ = std::fs::remove_file(&self.name);
        }
    }
}

/// Writes the sidecar of a file aside and then under its name. The file's journal keeps others
/// away.
pub(in crate::report) fn save(file: &Path, document: &[u8]) -> Result<Described> {
    let name = Sidecar::path_of(file);
    let Existing::File(name) = existing(&name)? else {
        let problem = io::Error::other("it is no regular file any more");
        return Err(failed("write", &name, problem));
    };
    let before = File::open(&name).ok();
    // That of others is none, which was refused before.
    let before = before.and_then(|file| bounded::bytes(file, MAX_BYTES).ok());
    put(&name, document)?;
    Ok(Described { name, before })
}

fn put(name: &Path, document: &[u8]) -> Result<()> {
    let aside = Aside::create(beside(name, PARTIAL), name, name.to_owned());
    let mut aside = aside.map_err(|source| failed("write", name, source))?;
    aside.fill(document)?;
    aside.commit()
}
