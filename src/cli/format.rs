//! The formats of pictures: masks, and estimates for each pixel.

use corput::report::Target;
use corput::{Error, Result};

/// How a picture is written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// NumPy's array.
    Npy,
    /// 16 bits, grey.
    Png,
    /// `f32`.
    Exr,
}

const FORMATS: [(&str, Format); 3] = [
    ("npy", Format::Npy),
    ("png", Format::Png),
    ("exr", Format::Exr),
];

impl Format {
    /// The one with the name that was given, or else of the file's ending; of standard output
    /// an array.
    pub fn of(target: &Target, given: Option<&str>) -> Result<Self> {
        let name = match (given, target) {
            (Some(name), _) => name.to_owned(),
            (None, Target::Stdout) => "npy".to_owned(),
            (None, Target::File(path)) => {
                let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
                ending.unwrap_or_else(|| path.display().to_string())
            }
        };
        let found = FORMATS.iter().find(|(known, _)| *known == name);
        found.map(|(_, format)| *format).ok_or_else(|| {
            Error::unknown_name("format of a picture", &name, &FORMATS.map(|(name, _)| name))
        })
    }
}
