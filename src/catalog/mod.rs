//! What there is: sequences, maps, and one row per function, as plain data.

mod chunks;
mod columns;
mod engine;
mod functions;
mod guide;
mod integrands;
mod maps;
mod request;
mod sampler;
mod scramble;
mod sequence;
mod shard;

pub use chunks::Chunks;
pub use engine::Engine;
pub(crate) use engine::{check_points, whole_points};
pub use functions::{FUNCTIONS, Function, Kind};
pub use guide::Guide;
pub use integrands::{
    AXES, Coefficients, Integrand, LightMap, MIS, Picture, Problem, Raster, Setting, examples,
    integrands,
};
pub use maps::{Group, Map, Mapping, Parameter, Words, maps};
pub use request::{Options, Output, Request, check_map};
pub use sampler::Sampler;
pub use scramble::{Order, SCRAMBLES, Scramble};
pub use sequence::{SEQUENCES, Sequence};
pub use shard::Shard;

/// Where bits are promised to be the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tier {
    /// Integers and exactly representable floats: every conformant device.
    Integer,
    /// Float + - * besides: devices whose probe finds rounding to nearest even.
    Float,
}

impl Tier {
    /// `I` or `F`.
    #[must_use]
    pub fn letter(self) -> &'static str {
        match self {
            Self::Integer => "I",
            Self::Float => "F",
        }
    }
}

/// Whose functions a map uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Profile {
    /// This crate's: the same bits everywhere.
    #[default]
    Exact,
    /// The device's own: its bits, within Vulkan's precision tables.
    Native,
}

impl Profile {
    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Native => "native",
        }
    }

    /// The profile with this name.
    ///
    /// # Errors
    /// [`crate::Error::UnknownName`].
    pub fn from_name(name: &str) -> crate::Result<Self> {
        [Self::Exact, Self::Native]
            .into_iter()
            .find(|profile| profile.name() == name)
            .ok_or_else(|| crate::Error::unknown_name("profile", name, &["exact", "native"]))
    }
}
