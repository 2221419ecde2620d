//! `corput`: a sampling toolkit for Vulkan compute.

pub mod error;
#[cfg(feature = "images")]
pub mod image;
pub mod irradiance;
#[cfg(feature = "images")]
pub mod plot;

pub use error::{Error, Result};
pub use glam;
