//! `corput`: a sampling toolkit for Vulkan compute.

pub mod error;
pub mod irradiance;

pub use error::{Error, Result};
pub use glam;
