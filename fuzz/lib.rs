//! What the targets ask of parsers: the same as `tests/cpu/parsers.rs`.

#[path = "../tests/cpu/parsers/properties.rs"]
mod properties;

pub use properties::{check, exr, hdr, npy, scene, study};
