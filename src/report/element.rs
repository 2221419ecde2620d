//! The types of array elements.

/// What a 32-bit word of the data is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Element {
    /// An unsigned integer, such as a u0.32 fraction.
    U32,
    /// An IEEE single, handed over as its bits.
    F32,
}

/// Every type.
const ELEMENTS: [Element; 2] = [Element::U32, Element::F32];

impl Element {
    /// NumPy's name of the type, little-endian: `<u4` or `<f4`.
    #[must_use]
    pub const fn descr(self) -> &'static str {
        match self {
            Self::U32 => "<u4",
            Self::F32 => "<f4",
        }
    }

    /// The type with this name of NumPy's.
    #[must_use]
    pub fn from_descr(descr: &str) -> Option<Self> {
        ELEMENTS.into_iter().find(|one| one.descr() == descr)
    }

    /// Bytes of one in a binary file.
    #[must_use]
    pub const fn bytes(self) -> u64 {
        match self {
            Self::U32 | Self::F32 => 4,
        }
    }

    /// A value of a binary file as a message shows it, with its bits.
    pub(super) fn show(self, bytes: &[u8]) -> String {
        let bits = bytes
            .iter()
            .rev()
            .map(|byte| format!("{byte:02x}"))
            .collect::<String>();
        let low = bytes
            .first_chunk()
            .map_or(0, |word| u32::from_le_bytes(*word));
        match self {
            Self::U32 => format!("{low} (0x{bits})"),
            Self::F32 => format!("{} (0x{bits})", f32::from_bits(low)),
        }
    }
}
