//! Blue noise that a host makes once: dither masks by void-and-cluster, point sets by
//! sample elimination. Integers throughout, so the bits are the same on every machine.
//!
//! Engines look masks up by `corput/blue_noise.glsl`.

mod elimination;
mod energy;
mod mask;
mod random;
mod void_and_cluster;

pub use elimination::{MAX_POINTS, blue_noise_points, check_count};
pub use energy::energies;
pub use mask::MaskShape;
pub use void_and_cluster::{scattered_words, void_and_cluster};
