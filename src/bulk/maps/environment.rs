//! Environment maps: `shaders/kernels/map_environment.comp`, line by line.

use crate::catalog::{Mapping, Profile};
use crate::interface::map;
use crate::reference::environment::{
    Environment, environment, environment_alias, environment_alias_pdf, environment_invert,
    environment_pdf,
};
use crate::reference::native::environment as native;
use glam::{UVec2, Vec3, uvec2, uvec3};

/// Size, words and row edges of a mapping's tables.
fn tables(mapping: &Mapping) -> (UVec2, &[u32], &[f32]) {
    let [width, height, ..] = mapping.words();
    let words = mapping.tables().first().map_or(&[][..], Vec::as_slice);
    let edges = bytemuck::cast_slice(&words[..height as usize]);
    (uvec2(width, height), words, edges)
}

/// Coordinates and pdf.
pub(super) fn sample(mapping: &Mapping, profile: Profile, [x, y, z]: [u32; 3]) -> [u32; 4] {
    let (size, words, _) = tables(mapping);
    let Environment { direction: d, pdf } = match (profile, mapping.map().id) {
        (Profile::Exact, map::ENVIRONMENT) => environment(size, uvec2(x, y), words),
        (Profile::Exact, _) => environment_alias(size, uvec3(x, y, z), words),
        (Profile::Native, map::ENVIRONMENT) => native::native_environment(size, uvec2(x, y), words),
        (Profile::Native, _) => native::native_environment_alias(size, uvec3(x, y, z), words),
    };
    [d.x, d.y, d.z, pdf].map(f32::to_bits)
}

/// The pdf.
pub(super) fn pdf(mapping: &Mapping, profile: Profile, d: [f32; 3]) -> f32 {
    let (size, words, edges) = tables(mapping);
    let d = Vec3::from_array(d);
    match (profile, mapping.map().id) {
        (Profile::Exact, map::ENVIRONMENT) => environment_pdf(size, d, edges, words),
        (Profile::Exact, _) => environment_alias_pdf(size, d, edges, words),
        (Profile::Native, map::ENVIRONMENT) => {
            native::native_environment_pdf(size, d, edges, words)
        }
        (Profile::Native, _) => native::native_environment_alias_pdf(size, d, edges, words),
    }
}

/// The fractions; 0 by an alias table, which has no inverse.
pub(super) fn invert(mapping: &Mapping, d: [f32; 3]) -> [u32; 3] {
    if mapping.map().id != map::ENVIRONMENT {
        return [0; 3];
    }
    let (size, words, edges) = tables(mapping);
    let u = environment_invert(size, Vec3::from_array(d), edges, words);
    [u.x, u.y, 0]
}
