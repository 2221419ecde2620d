//! What the targets ask of parsers: the same as `tests/cpu/parsers.rs` and
//! `tests/cpu/documents.rs`.

#[path = "../tests/cpu/documents/properties.rs"]
pub mod documents;
#[path = "../tests/cpu/parsers/properties.rs"]
mod properties;

pub use properties::{check, exr, hdr, npy, scene, study};
