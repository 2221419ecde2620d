//! Small files that are made at once, with a FILE.json beside them: pictures, and arrays of any
//! number of axes.

use super::chunked::{
    Chunk, Origin, Turn, check_free, describe, document, recorded, whole_description,
};
use super::place::{Place, failed};
use super::{Document, Sidecar, Target, hexadecimal};
use crate::error::{Error, Result};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// What a small file holds, as its FILE.json says it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Form {
    /// `npy`, `png` or `exr`.
    pub format: &'static str,
    /// Axes of the array; of a picture height and width, and channels where it has several.
    pub shape: Vec<u32>,
    /// NumPy's name of the element.
    pub descr: &'static str,
    /// Bytes before the data that its one chunk is.
    pub header: usize,
}

impl Form {
    /// What a FILE.json says of the file, less its hashes.
    fn description(&self, origin: &Origin) -> Value {
        let rows = self.shape.first().copied().unwrap_or(1);
        whole_description(origin, self.format, &self.shape, self.descr, rows)
    }
}

impl Document {
    /// As [`Document::open`], for a file that gets a FILE.json: no other run can write either of
    /// them meanwhile.
    ///
    /// # Errors
    ///
    /// As there, and [`Error::Output`] where that name is taken by a file of others, or another
    /// run writes the file.
    pub fn open_described(target: &Target) -> Result<Self> {
        let mut document = Self::open(target)?;
        if let Place::Aside(aside) = &document.place {
            check_free(&Sidecar::path_of(aside.real()))?;
            document.turn = Some(Turn::take(aside.real(), &document.path)?);
        }
        Ok(document)
    }

    /// Writes all bytes and the FILE.json, and gives both their names. What is no regular file
    /// has none.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if they cannot be written; what was there before is then as it was, unless it
    /// was the folder that could not be synced: then the new ones may have their names already,
    /// and may lose them when the power fails.
    pub fn finish_described(self, bytes: &[u8], form: &Form, origin: &Origin) -> Result<()> {
        let Place::Aside(mut aside) = self.place else {
            return self.finish(bytes);
        };
        aside.fill(bytes)?;
        let chunk = chunk(bytes, form.header);
        let text = document(
            form.description(origin),
            &origin.device,
            bytes.len() as u64,
            &[&chunk],
            &hexadecimal(&Sha256::digest(bytes)),
        );
        let described = describe(aside.real(), &text)?;
        if let Err(error) = aside.rename() {
            described.take_back();
            return Err(error);
        }
        aside.last()?;
        if let Some(turn) = self.turn {
            turn.done();
        }
        Ok(())
    }
}

fn chunk(bytes: &[u8], header: usize) -> Chunk {
    let data = bytes.get(header..).unwrap_or_default();
    Chunk {
        bytes: data.len() as u64,
        sha256: hexadecimal(&Sha256::digest(data)),
    }
}

/// What the FILE.json of such a file says.
#[derive(Clone, Debug, PartialEq)]
pub struct Whole {
    /// What made it.
    pub origin: Origin,
    /// Version of corput that did.
    pub version: String,
    /// `npy`, `png` or `exr`.
    pub format: String,
    /// Bytes of the file.
    pub bytes: u64,
    /// SHA-256 of the file, in hexadecimal digits.
    pub sha256: String,
    chunk: Chunk,
    layout: [Value; LAYOUT.len()],
}

/// What a FILE.json says of a file's bytes besides.
const LAYOUT: [&str; 4] = ["shape", "type", "chunk_rows", "name"];

impl Whole {
    /// Reads the FILE.json of a file.
    ///
    /// # Errors
    /// [`Error::Document`] where there is none, or one of another form.
    pub fn of(file: &Path) -> Result<Self> {
        let value = recorded(file)?;
        Self::read(&value).map_err(|name| Error::Document {
            path: Sidecar::path_of(file),
            problem: format!("`{name}` is missing or of a wrong kind"),
            remedy: "take the FILE.json that was written with the file",
        })
    }

    fn read(value: &Value) -> Result<Self, &'static str> {
        let text = |name: &'static str| {
            let text = value[name].as_str();
            text.map(str::to_owned).ok_or(name)
        };
        let chunks = value["chunks"].as_array().ok_or("chunks")?;
        let [chunk] = chunks.as_slice() else {
            return Err("chunks");
        };
        Ok(Self {
            origin: Origin {
                arguments: value.get("arguments").ok_or("arguments")?.clone(),
                device: text("device")?,
            },
            version: text("version")?,
            format: text("format")?,
            bytes: value["bytes"].as_u64().ok_or("bytes")?,
            sha256: text("sha256")?,
            chunk: Chunk::read(chunk).ok_or("chunks")?,
            layout: LAYOUT.map(|name| value[name].clone()),
        })
    }

    /// Compares a file with bytes that were made again, and its hashes with those of this.
    ///
    /// # Errors
    /// [`Error::Differs`] where anything is not equal, [`Error::Points`] where the file cannot be
    /// opened, [`Error::Io`] where it cannot be read.
    pub fn compare(&self, path: &Path, made: &[u8], form: &Form) -> Result<()> {
        let differs = |problem: String| Error::Differs {
            path: path.to_owned(),
            problem,
        };
        let file = File::open(path).map_err(|source| Error::Points {
            path: path.to_owned(),
            problem: source.to_string(),
            remedy: "name a file that can be read".into(),
        })?;
        let mut found = Vec::new();
        // No more than tells that there is more.
        file.take(made.len() as u64 + 1)
            .read_to_end(&mut found)
            .map_err(|source| failed("read", path, source))?;
        let pairs = found.iter().zip(made).enumerate();
        let mut wrong = pairs.filter(|(_, (is, must))| is != must);
        if let Some((at, (is, must))) = wrong.next() {
            let (more, total) = (wrong.count() + 1, made.len());
            return Err(differs(format!(
                "byte {at} is {is:#04x} and must be {must:#04x}; {more} of {total} bytes differ"
            )));
        }
        if found.len() != made.len() {
            let is = if found.len() > made.len() {
                "more"
            } else {
                "fewer"
            };
            return Err(differs(format!(
                "it has {is} bytes than the {} that its arguments make",
                made.len()
            )));
        }
        let must = form.description(&self.origin);
        for (name, is) in LAYOUT.iter().zip(&self.layout) {
            if must[name] != *is {
                let must = &must[name];
                return Err(differs(format!(
                    "`{name}` of its sidecar is {is}, and must be {must}"
                )));
            }
        }
        if chunk(&found, form.header) != self.chunk {
            return Err(differs("its chunk is not that of its sidecar".into()));
        }
        let sha256 = hexadecimal(&Sha256::digest(&found));
        if (found.len() as u64, &sha256) != (self.bytes, &self.sha256) {
            return Err(differs(format!(
                "its SHA-256 is {sha256} of {} bytes, and {} of {} by its sidecar",
                found.len(),
                self.sha256,
                self.bytes
            )));
        }
        Ok(())
    }
}
