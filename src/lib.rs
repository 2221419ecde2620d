//! `corput`: a sampling toolkit for Vulkan compute.

#[cfg(feature = "gpu")]
pub mod bench;
pub mod bulk;
pub mod catalog;
#[cfg(feature = "gpu")]
pub mod check;
#[cfg(feature = "gpu")]
pub mod compile;
#[cfg(all(feature = "gpu", feature = "images"))]
pub mod demo;
pub mod error;
#[cfg(feature = "images")]
pub mod image;
pub mod interface;
pub mod irradiance;
pub mod judge;
#[cfg(feature = "gpu")]
pub mod kernels;
#[cfg(feature = "images")]
pub mod plot;
pub mod reference;
pub mod report;
pub mod spirv;
pub mod tables;
pub mod variant;
#[cfg(feature = "gpu")]
pub mod vulkan;

pub use error::{Error, Result};
pub use glam;

/// The GLSL headers: include name (`corput/sobol.glsl`) and text.
///
/// An engine writes them where its shader compiler looks for includes, or hands them to
/// its include callback.
#[must_use]
pub fn headers() -> &'static [(&'static str, &'static str)] {
    include!(concat!(env!("OUT_DIR"), "/headers.rs"))
}
