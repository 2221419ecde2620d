//! The file formats, by name and by file ending.

use std::path::Path;
use std::str::FromStr;

use crate::error::{Error, Result, nearest};

/// How the data is laid out in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// NumPy's `.npy`, version 1.0, with the data at byte 4096 (ending `.npy`).
    Npy,
    /// Little-endian words and nothing else, described by `FILE.json` beside it
    /// (endings `.raw`, `.bin`).
    Raw,
    /// Text with the header `x0,x1,...` (ending `.csv`).
    Csv,
    /// A C header with one array of numbers that read back as the same bits (ending `.h`). The
    /// array of `a_b.h` is `points_a_b`; a name of more than letters, digits and single `_` has
    /// digits of its SHA-256 behind it, so that files of one folder whose names differ in
    /// punctuation or case have arrays of their own.
    C,
    /// A GLSL array of `uint`: the bits of floats, or integers (ending `.glsl`). It is
    /// called as that of a C header.
    Glsl,
}

/// Each name and the endings that stand for it.
const FORMATS: [(Format, &str, &[&str]); 5] = [
    (Format::Npy, "npy", &["npy"]),
    (Format::Raw, "raw", &["raw", "bin"]),
    (Format::Csv, "csv", &["csv"]),
    (Format::C, "c-header", &["h"]),
    (Format::Glsl, "glsl", &["glsl"]),
];

impl Format {
    /// The name that `--format` takes.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Npy => "npy",
            Self::Raw => "raw",
            Self::Csv => "csv",
            Self::C => "c-header",
            Self::Glsl => "glsl",
        }
    }

    /// Whether it is text, a row a line.
    #[must_use]
    pub const fn is_text(self) -> bool {
        matches!(self, Self::Csv | Self::C | Self::Glsl)
    }

    /// Whether a compiler reads it.
    #[must_use]
    pub const fn is_source(self) -> bool {
        matches!(self, Self::C | Self::Glsl)
    }

    /// The format that a file's ending stands for, in upper or lower case.
    ///
    /// # Errors
    ///
    /// [`Error::UnknownName`] for any other ending, or none.
    pub fn from_path(path: &Path) -> Result<Self> {
        let ending = path
            .extension()
            .map(|e| e.to_string_lossy().to_ascii_lowercase());
        let found = FORMATS
            .iter()
            .find(|(_, _, endings)| ending.as_deref().is_some_and(|e| endings.contains(&e)));
        if let Some((format, ..)) = found {
            return Ok(*format);
        }
        let name = match &ending {
            Some(ending) => format!(".{ending}"),
            None => path.display().to_string(),
        };
        let endings = FORMATS.iter().flat_map(|row| row.2).copied();
        Err(Error::UnknownName {
            kind: "format",
            nearest: ending
                .as_deref()
                .and_then(|e| nearest(e, endings))
                .map(|e| format!(".{e}")),
            name,
            known: "the file endings .npy, .raw, .bin, .csv, .h, .glsl and .zarr; or give --format npy, raw, csv, c-header, glsl or zarr"
                .to_owned(),
        })
    }
}

impl FromStr for Format {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        if let Some((format, ..)) = FORMATS.iter().find(|(_, known, _)| *known == name) {
            return Ok(*format);
        }
        Err(Error::UnknownName {
            kind: "format",
            name: name.to_owned(),
            nearest: nearest(name, FORMATS.iter().map(|row| row.1)).map(str::to_owned),
            known: "npy, raw, csv, c-header, glsl, zarr".to_owned(),
        })
    }
}

impl std::fmt::Display for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
