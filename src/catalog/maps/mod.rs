//! The maps: from fractions to samples of a distribution.
//!
//! A map is a row here; a group of maps has a kernel. A new group needs its ids in
//! `interface::map` and in `shaders/kernels/map_GROUP.comp` (modelled on
//! `map_hemisphere.comp`; parameters are `push.p0` and on), two rows of `MAPPERS` in
//! `interface/kernels`, a variant of [`Group`], a file of rows beside this one, a file in
//! `bulk/maps` with the three functions over the twins, and one in `judge` that
//! `check/maps/truth.rs` calls. What takes long to prepare is in [`Words`]. Then `generate`, `maps` and `check` know it.

mod environment;
mod filter;
mod hemisphere;
mod line;
mod lobe;
mod mapping;
mod planar;
mod prepared;
mod scattering;
mod spherical;

pub use mapping::Mapping;
pub use prepared::Words;

use super::{Profile, Tier};
use crate::interface::MAP_PARAMETERS;
use crate::{Error, Result};

/// Maps that one kernel knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Disk and hemisphere.
    Hemisphere,
    /// Uniform points of plane figures.
    Planar,
    /// Uniform directions of solid angles.
    Spherical,
    /// Powers of the cosine.
    Lobe,
    /// Free flight, and one normal distribution.
    Line,
    /// Two normal distributions.
    Normal,
    /// Pixel filters of polynomials.
    Filter,
    /// The truncated Gaussian as a pixel filter.
    GaussianFilter,
    /// The window of Blackman and Harris as a pixel filter.
    WindowFilter,
    /// The filter of Mitchell and Netravali.
    MitchellFilter,
    /// Environment maps.
    Environment,
    /// Phase functions.
    Phase,
    /// Visible normals of GGX by a disk.
    Ggx,
    /// Visible normals of GGX by spherical caps.
    GgxCap,
    /// Microsurfaces of Beckmann.
    Beckmann,
}

impl Group {
    /// The kernel that maps points in memory.
    #[must_use]
    pub fn kernel(self, profile: Profile) -> &'static str {
        let names = match self {
            Self::Hemisphere => ["map_hemisphere", "map_hemisphere_native"],
            Self::Phase => ["map_phase", "map_phase_native"],
            Self::Ggx => ["map_ggx", "map_ggx_native"],
            Self::GgxCap => ["map_ggx_cap", "map_ggx_cap_native"],
            Self::Beckmann => ["map_beckmann", "map_beckmann_native"],
            Self::Planar => ["map_planar", "map_planar_native"],
            Self::Spherical => ["map_spherical", "map_spherical_native"],
            Self::Lobe => ["map_lobe", "map_lobe_native"],
            Self::Line => ["map_line", "map_line_native"],
            Self::Normal => ["map_normal", "map_normal_native"],
            Self::Filter => ["map_filter", "map_filter_native"],
            Self::GaussianFilter => ["map_filter_gaussian", "map_filter_gaussian_native"],
            Self::WindowFilter => ["map_filter_window", "map_filter_window_native"],
            Self::MitchellFilter => ["map_filter_mitchell", "map_filter_mitchell_native"],
            Self::Environment => ["map_environment", "map_environment_native"],
        };
        match profile {
            Profile::Exact => names[0],
            Profile::Native => names[1],
        }
    }

    /// Whether kernels that make points also know these maps.
    #[must_use]
    pub fn fused(self) -> bool {
        self == Self::Hemisphere
    }
}

/// A parameter of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// The name on the command line.
    pub name: &'static str,
    /// Numbers that it consists of.
    pub size: usize,
    /// Its value where none is given; `None` where one must be.
    pub default: Option<&'static [f64]>,
    /// What it may be, in words: what a refusal states.
    pub domain: &'static str,
    /// What it is, with its unit.
    pub summary: &'static str,
}

/// The words that a map's functions take, from the numbers of its parameters in order;
/// or the number of the parameter that is outside its domain.
pub type Prepare = fn(&[f64]) -> core::result::Result<[f32; MAP_PARAMETERS], usize>;

/// A map of fractions to a sample of a distribution.
#[derive(Clone, Copy, Debug)]
pub struct Map {
    /// The name on the command line.
    pub name: &'static str,
    /// The kernel that knows it.
    pub group: Group,
    /// Value of the specialization constant `MAP`.
    pub id: u32,
    /// Fractions that it takes per sample: 1 to 3.
    pub dimensions: u32,
    /// Coordinates of a sample: 1, 2 or, of a direction, 3.
    pub coordinates: u32,
    /// Its parameters.
    pub parameters: &'static [Parameter],
    /// Checks the parameters, and makes of them what the functions take.
    pub prepare: Prepare,
    /// Values of the parameters that checks try: usual ones, and the most extreme.
    pub examples: &'static [&'static [f64]],
    /// Measure that the pdf is taken with respect to.
    pub measure: &'static str,
    /// The density.
    pub pdf: &'static str,
    /// Worst error of a coordinate in the exact profile, in ULP.
    pub ulp: f64,
    /// Coordinates below this in magnitude have their error counted in ULP of it: 0 where
    /// the error is relative, 1 where unit vectors are rotated.
    pub floor: f64,
    /// Worst error of the pdf of a sample in the exact profile, in ULP.
    pub pdf_ulp: f64,
    /// Worst error of a coordinate in the native profile: absolute, and of samples longer than
    /// 1 a share of their length.
    pub native: f64,
    /// Worst relative error of the pdf in the native profile.
    pub native_pdf: f64,
    /// Where its bits are promised.
    pub tier: Tier,
    /// What it is, in a line.
    pub summary: &'static str,
    /// The paper.
    pub source: &'static str,
}

impl Map {
    /// How a coordinate's error is counted, as the end of a phrase: empty, or with
    /// [`floor`](Self::floor).
    #[must_use]
    pub fn counted(&self) -> String {
        if self.floor == 0.0 {
            return String::new();
        }
        format!(" of coordinates from {} on, and of that below", self.floor)
    }

    /// The map with this name.
    ///
    /// # Errors
    /// [`Error::UnknownName`], with the nearest name.
    pub fn from_name(name: &str) -> Result<&'static Self> {
        maps()
            .find(|candidate| candidate.name == name)
            .ok_or_else(|| {
                let known: Vec<&str> = maps().map(|m| m.name).collect();
                Error::unknown_name("map", name, &known)
            })
    }
}

/// Two maps of the same name are the same.
impl PartialEq for Map {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// The groups in the order of the documentation.
const GROUPS: &[&[Map]] = &[
    hemisphere::MAPS,
    planar::MAPS,
    spherical::MAPS,
    lobe::MAPS,
    scattering::MAPS,
    line::MAPS,
    filter::MAPS,
    environment::MAPS,
];

/// Every map.
pub fn maps() -> impl Iterator<Item = &'static Map> {
    GROUPS.iter().flat_map(|group| group.iter())
}

/// Takes no parameters.
fn none(_: &[f64]) -> core::result::Result<[f32; MAP_PARAMETERS], usize> {
    Ok([0.0; MAP_PARAMETERS])
}

/// sin and cos of a device may be off by 2^-11, to which square root and products add
/// less than 2^-19.
pub(super) const NATIVE_SINE: f64 = 1.0 / 2048.0 + 1.0 / 524_288.0;
