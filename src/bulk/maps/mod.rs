//! The maps over the reference: sample, pdf and inverse, as the map kernels have them.

mod environment;
mod filter;
mod hemisphere;
mod line;
mod lobe;
mod mitchell;
mod planar;
mod scattering;
mod spherical;

use crate::catalog::{Group, Mapping, Profile, Words};

/// Words of a sample: its coordinates, and then its pdf, as float bits.
#[must_use]
pub fn map_sample(mapping: &Mapping, profile: Profile, u: [u32; 3]) -> [u32; 4] {
    let (id, p) = (mapping.map().id, mapping.parameters());
    match mapping.map().group {
        Group::Hemisphere => hemisphere::sample(profile, id, u),
        Group::Planar => planar::sample(profile, id, p, u),
        Group::Spherical => spherical::sample(mapping, profile, u),
        Group::Lobe => lobe::sample(profile, p, u),
        Group::WindowFilter => filter::sample(profile, p, u),
        Group::MitchellFilter => mitchell::sample(profile, p, u),
        Group::Line | Group::Normal | Group::Filter | Group::GaussianFilter => {
            line::sample(mapping, profile, u)
        }
        Group::Environment => environment::sample(mapping, profile, u),
        Group::Phase | Group::Ggx | Group::GgxCap | Group::Beckmann => {
            scattering::sample(profile, id, p, u)
        }
    }
}

/// Bits of the pdf at coordinates, given as float bits.
#[must_use]
pub fn map_pdf(mapping: &Mapping, profile: Profile, s: [u32; 3]) -> u32 {
    let (id, p) = (mapping.map().id, mapping.parameters());
    let s = s.map(f32::from_bits);
    let pdf = match mapping.map().group {
        Group::Hemisphere => hemisphere::pdf(profile, id, s),
        Group::Planar => planar::pdf(profile, id, p, s),
        Group::Spherical => spherical::pdf(mapping, profile, s),
        Group::Lobe => lobe::pdf(profile, p, s),
        Group::WindowFilter => filter::pdf(profile, p, s),
        Group::MitchellFilter => mitchell::pdf(profile, p, s),
        Group::Line | Group::Normal | Group::Filter | Group::GaussianFilter => {
            line::pdf(mapping, profile, s)
        }
        Group::Environment => environment::pdf(mapping, profile, s),
        Group::Phase | Group::Ggx | Group::GgxCap | Group::Beckmann => {
            scattering::pdf(profile, id, p, s)
        }
    };
    pdf.to_bits()
}

/// The fractions that give coordinates, given as float bits.
#[must_use]
pub fn map_invert(mapping: &Mapping, profile: Profile, s: [u32; 3]) -> [u32; 3] {
    let (id, p) = (mapping.map().id, mapping.parameters());
    let s = s.map(f32::from_bits);
    match mapping.map().group {
        Group::Hemisphere => hemisphere::invert(profile, id, s),
        Group::Planar => planar::invert(profile, id, p, s),
        Group::Spherical => spherical::invert(mapping, profile, s),
        Group::Lobe => lobe::invert(profile, p, s),
        Group::WindowFilter => filter::invert(profile, p, s),
        Group::MitchellFilter => mitchell::invert(profile, p, s),
        Group::Line | Group::Normal | Group::Filter | Group::GaussianFilter => {
            line::invert(mapping, profile, s)
        }
        Group::Environment => environment::invert(mapping, s),
        Group::Phase | Group::Ggx | Group::GgxCap | Group::Beckmann => {
            scattering::invert(profile, id, p, s)
        }
    }
}

/// What is prepared of the parameters.
fn prepared<T: Words>(mapping: &Mapping) -> T {
    T::of(mapping.tables().first().map_or(&[], Vec::as_slice))
}
