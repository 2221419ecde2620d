//! `corput`: a sampling toolkit for Vulkan compute.

pub mod error;
pub mod interface;
pub mod judge;
pub mod reference;
pub mod spirv;
pub mod tables;
pub mod variant;

pub use error::{Error, Result};
pub use glam;
