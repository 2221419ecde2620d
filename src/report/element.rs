//! The types of array elements.

use crate::error::{Error, Result};

/// What an array holds for a 32-bit word of the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Element {
    /// An unsigned integer, such as a u0.32 fraction.
    U32,
    /// An IEEE single, handed over as its bits.
    F32,
    /// The leading 16 bits of a u0.32 fraction.
    U16,
    /// A u0.32 fraction as an IEEE double in [0, 1): exact.
    F64,
}

/// Every type.
const ELEMENTS: [Element; 4] = [Element::F32, Element::U32, Element::U16, Element::F64];

impl Element {
    /// The name that `--type` takes.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::U32 => "u32",
            Self::F32 => "f32",
            Self::U16 => "u16",
            Self::F64 => "f64",
        }
    }

    /// The type with this name.
    ///
    /// # Errors
    /// [`Error::UnknownName`].
    pub fn from_name(name: &str) -> Result<Self> {
        let found = ELEMENTS.into_iter().find(|one| one.name() == name);
        found.ok_or_else(|| Error::unknown_name("type", name, &ELEMENTS.map(Self::name)))
    }

    /// NumPy's name of the type, little-endian: `<u4`, `<f4`, `<u2` or `<f8`.
    #[must_use]
    pub const fn descr(self) -> &'static str {
        match self {
            Self::U32 => "<u4",
            Self::F32 => "<f4",
            Self::U16 => "<u2",
            Self::F64 => "<f8",
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
            Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Appends words as elements of a binary file, little-endian.
    pub(super) fn append(self, words: &[u32], out: &mut Vec<u8>) {
        match self {
            // A copy of memory.
            Self::U32 | Self::F32 if cfg!(target_endian = "little") => {
                out.extend_from_slice(bytemuck::cast_slice(words));
            }
            Self::U32 | Self::F32 => out.extend(words.iter().flat_map(|word| word.to_le_bytes())),
            Self::U16 => out.extend(words.iter().flat_map(|word| leading(*word).to_le_bytes())),
            Self::F64 => out.extend(words.iter().flat_map(|word| double(*word).to_le_bytes())),
        }
    }

    /// A value of a binary file as a message shows it, with its bits.
    pub(super) fn show(self, bytes: &[u8]) -> String {
        let digits = bytes.iter().rev().map(|byte| format!("{byte:02x}"));
        let digits: String = digits.collect();
        let bits = u64::from_str_radix(&digits, 16).unwrap_or(0);
        match self {
            Self::U32 | Self::U16 => format!("{bits} (0x{digits})"),
            Self::F32 => format!("{} (0x{digits})", f32::from_bits(bits as u32)),
            Self::F64 => format!("{} (0x{digits})", f64::from_bits(bits)),
        }
    }
}

/// The leading 16 bits of a fraction.
pub(super) fn leading(fraction: u32) -> u16 {
    (fraction >> 16) as u16
}

/// A fraction as a number: 32 bits of the 53 that a double has.
pub(super) fn double(fraction: u32) -> f64 {
    f64::from(fraction) / 4_294_967_296.0
}
