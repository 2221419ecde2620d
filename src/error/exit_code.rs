//! The contract of the command line.

use super::Error;

impl Error {
    /// Exit code of the command line for this error.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::CheckFailed { .. }
            | Self::Differs { .. }
            | Self::CardsDiffer { .. }
            | Self::Slower { .. }
            | Self::Incomplete { .. }
            | Self::Unmeasured { .. }
            | Self::NotFinite { .. }
            | Self::Unequal { .. } => 1,
            Self::ZeroCount { .. }
            | Self::IndexRange { .. }
            | Self::NotPrime { .. }
            | Self::BaseTooLarge { .. }
            | Self::RepeatedBase { .. }
            | Self::Dimensions { .. }
            | Self::MapDimensions { .. }
            | Self::Parameter { .. }
            | Self::Arguments { .. }
            | Self::UnknownName { .. }
            | Self::Output { .. }
            | Self::Image { .. }
            | Self::Points { .. }
            | Self::Document { .. }
            | Self::Glsl { .. }
            | Self::Study { .. }
            | Self::Scene { .. }
            | Self::UnknownDevice { .. } => 2,
            Self::NoDevice { .. } | Self::InadequateDevice { .. } => 3,
            Self::Vulkan { .. }
            | Self::Timeout { .. }
            | Self::Io { .. }
            | Self::Interrupted { .. }
            | Self::Paused { .. }
            | Self::NotKept { .. }
            | Self::Shader { .. } => 4,
            Self::Kept { cause, .. } => cause.exit_code(),
        }
    }
}
