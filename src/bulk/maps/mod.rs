//! The maps over the reference: sample, pdf and inverse, as the map kernels have them.

mod hemisphere;

use crate::catalog::{Group, Mapping, Profile};

/// Words of a sample: its coordinates, and then its pdf, as float bits.
#[must_use]
pub fn map_sample(mapping: &Mapping, profile: Profile, u: [u32; 3]) -> [u32; 4] {
    let id = mapping.map().id;
    match mapping.map().group {
        Group::Hemisphere => hemisphere::sample(profile, id, u),
    }
}

/// Bits of the pdf at coordinates, given as float bits.
#[must_use]
pub fn map_pdf(mapping: &Mapping, profile: Profile, s: [u32; 3]) -> u32 {
    let (id, s) = (mapping.map().id, s.map(f32::from_bits));
    match mapping.map().group {
        Group::Hemisphere => hemisphere::pdf(profile, id, s).to_bits(),
    }
}

/// The fractions that give coordinates, given as float bits.
#[must_use]
pub fn map_invert(mapping: &Mapping, profile: Profile, s: [u32; 3]) -> [u32; 3] {
    let (id, s) = (mapping.map().id, s.map(f32::from_bits));
    match mapping.map().group {
        Group::Hemisphere => hemisphere::invert(profile, id, s),
    }
}
