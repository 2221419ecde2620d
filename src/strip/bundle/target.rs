//! What a stripped scene is written for.

use crate::{Error, Result};

/// A language or engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// One file of GLSL for Vulkan.
    Glsl,
    /// A module of SPIR-V 1.3.
    Spirv,
    /// GLSL for Godot 4, parameters in a uniform buffer.
    Godot,
    /// WGSL, parameters in a uniform buffer.
    Wgsl,
    /// HLSL, shader model 5.1, the same.
    Hlsl,
    /// Metal 2.1, the same.
    Msl,
    /// A header of C11 and C++11 for the module.
    C,
    /// A module of Rust for it.
    Rust,
}

/// Every target.
pub const TARGETS: [Target; 8] = [
    Target::Glsl,
    Target::Spirv,
    Target::Godot,
    Target::Wgsl,
    Target::Hlsl,
    Target::Msl,
    Target::C,
    Target::Rust,
];

impl Target {
    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Glsl => "glsl",
            Self::Spirv => "spirv",
            Self::Godot => "godot",
            Self::Wgsl => "wgsl",
            Self::Hlsl => "hlsl",
            Self::Msl => "msl",
            Self::C => "c",
            Self::Rust => "rust",
        }
    }

    /// The target of that name.
    ///
    /// # Errors
    /// [`Error::UnknownName`], with the nearest name.
    pub fn from_name(name: &str) -> Result<Self> {
        let found = TARGETS.into_iter().find(|target| target.name() == name);
        found.ok_or_else(|| {
            let known: Vec<&str> = TARGETS.iter().map(|target| target.name()).collect();
            Error::unknown_name("target", name, &known)
        })
    }

    /// What its file's name ends in, after a full stop.
    #[must_use]
    pub fn ending(self) -> &'static str {
        match self {
            Self::Spirv => "spv",
            Self::Godot => "godot.glsl",
            Self::C => "h",
            Self::Rust => "rs",
            other => other.name(),
        }
    }

    /// Whether naga writes it.
    #[must_use]
    pub fn is_translated(self) -> bool {
        matches!(self, Self::Wgsl | Self::Hlsl | Self::Msl)
    }

    /// Whether its parameters are in a uniform buffer.
    #[must_use]
    pub fn has_uniform(self) -> bool {
        self.is_translated() || self == Self::Godot
    }

    /// Who has read the file when it was written, in a few words.
    #[must_use]
    pub fn checked_by(self) -> &'static str {
        match self {
            Self::Glsl => "compiled by glslang, as the module",
            Self::Spirv => "compiled by glslang, linted",
            Self::Godot => "generated, not run in Godot",
            Self::Wgsl => "read again and validated by naga",
            Self::Hlsl | Self::Msl => "generated, not compiled here",
            Self::C | Self::Rust => "asserts its layout when it is compiled",
        }
    }

    /// What is promised of the bits of its results.
    #[must_use]
    pub fn promise(self) -> &'static str {
        match self {
            Self::Spirv => "that of the module's profile",
            Self::Glsl | Self::Godot => {
                "that of the profile; of tier F only where float results are NoContraction"
            }
            Self::Wgsl | Self::Hlsl | Self::Msl => "tier I alone: naga drops NoContraction",
            Self::C | Self::Rust => "none is made: it has no results",
        }
    }
}
