//! The maps: from fractions to samples of a distribution.
//!
//! A map is a row here; a group of maps has a kernel. A new group needs its ids in
//! `interface::map` and in `shaders/kernels/map_GROUP.comp` (modelled on
//! `map_hemisphere.comp`; parameters are `push.p0` and on), two rows of `MAPPERS` in
//! `interface/kernels`, a variant of [`Group`], a file of rows beside this one, a file in
//! `bulk/maps` with the three functions over the twins, and one in `judge` that
//! `check/maps/truth.rs` calls. Then `generate`, `maps` and `check` know it.

mod hemisphere;
mod line;
mod mapping;
mod scattering;
mod spherical;

pub use mapping::Mapping;

use super::{Profile, Tier};
use crate::interface::MAP_PARAMETERS;
use crate::{Error, Result};

/// Maps that one kernel knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Disk and hemisphere.
    Hemisphere,
    /// Uniform directions of solid angles.
    Spherical,
    /// Phase functions and microsurfaces.
    Scattering,
