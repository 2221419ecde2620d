//! `corput`: a sampling toolkit for Vulkan compute.
//!
//! GLSL that turns an index into low-discrepancy points and importance-sampled
//! directions, a host that runs it in bulk, and a CPU reference that agrees with it bit
//! for bit. The README says what that promise is; [`catalog`] lists what there is.
//!
//! - [`headers`]: the GLSL, for an engine to include.
//! - [`mod@reference`]: its twin in Rust, function by function.
//! - [`catalog::Request`]: a checked description of points; [`bulk::Reference`] makes them
//!   on the CPU, `kernels::Generator` on a device, and [`catalog::Chunks`] iterates over either.
//! - [`mod@environment`]: environment maps as distributions of directions.
//! - [`mod@estimate`]: exact sums of integrands over points, [`bulk::estimate`] on the CPU,
//!   `kernels::Estimator` on a device.
//! - `converge`: error against run time, of samplers on integrands in replicates; `accuracy`:
//!   errors of functions against their cost.
//! - `scene`: what a renderer of one scene draws, of a description or a glTF file.
//! - [`blue_noise`]: dither masks and point sets that are made once.
//! - [`stats`]: how good points are, of [`report::read_points`] or of one's own.
//! - [`mod@strip`]: a shader without what it does not reach, as one file.
//! - `check`: device against reference, judged by a third, slow implementation in
//!   [`judge`].
//! - `exhaustive`: functions of one word over every word, those of two and maps over every critical
//!   pair.
//! - `extreme`: extreme inputs as data, with what common formulas make of them, for the CPU and
//!   for a device.
//! - `vectors`: words of all of it, for ports to test themselves with.
//!
//! Features: `cli` (default) is the command line; `gpu` the Vulkan host and the stock
//! kernels, for which glslang's C++ is compiled; `images` reads environment maps and
//! draws plots; `scenes` reads scenes, of glTF too; `strip` writes shaders in other languages.
//! Without any, the crate needs neither a C++ compiler nor Vulkan.
//!
//! ```
//! use corput::bulk::Reference;
//! use corput::catalog::{Engine, Options, Request, Sequence};
//!
//! let request = Request::new(&Options::new(Sequence::Halton, 4))?;
//! let mut words = [0; 8];
//! Reference::new(&request).fill(0, &mut words)?;
//! let points: Vec<f32> = words.iter().map(|word| f32::from_bits(*word)).collect();
//! assert_eq!(points[..4], [0.0, 0.0, 0.5, 0.33333337]);
//! # Ok::<(), corput::Error>(())
//! ```

#[cfg(feature = "gpu")]
pub mod accuracy;
#[cfg(feature = "gpu")]
pub mod bench;
pub mod blue_noise;
pub mod bulk;
#[cfg(feature = "gpu")]
pub mod card;
pub mod catalog;
#[cfg(feature = "gpu")]
pub mod check;
#[cfg(feature = "gpu")]
pub mod compile;
#[cfg(feature = "gpu")]
pub mod converge;
#[cfg(all(feature = "gpu", feature = "images"))]
pub mod demo;
pub mod environment;
pub mod error;
pub mod estimate;
#[cfg(feature = "gpu")]
pub mod exhaustive;
#[cfg(feature = "gpu")]
pub mod extreme;
#[cfg(feature = "images")]
pub mod image;
pub mod interface;
pub mod irradiance;
pub mod judge;
#[cfg(feature = "gpu")]
pub mod kernels;
#[cfg(feature = "gpu")]
pub mod modules;
#[cfg(feature = "images")]
pub mod picture;
#[cfg(feature = "images")]
pub mod plot;
pub mod reference;
pub mod report;
#[cfg(feature = "scenes")]
pub mod scene;
pub mod spirv;
pub mod stats;
pub mod strip;
pub mod tables;
pub mod variant;
#[cfg(feature = "gpu")]
pub mod vectors;
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
