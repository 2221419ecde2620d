//! Directions by the light of an environment map in the native profile: the tables of the
//! exact one, the device's own sin, cos and sqrt.
//!
//! Source: `reference::environment`. Domain: as there. Pdf: with respect to solid angle,
//! of the texel that was drawn.
//! Mirror: `shaders/corput/native/environment.glsl`.

use crate::reference::discrete::{
    alias_index, alias_weight, cdf, cdf_weight, discrete_divide, discrete_scale,
};
use crate::reference::environment::{
    Environment, environment_cap, environment_first, environment_invert, environment_row,
    environment_z,
};
use crate::reference::envmap::envmap_texel;
use crate::reference::fixed::{add64, shr64, sub64};
use crate::reference::native::disk::native_unit;
use glam::{UVec2, UVec3, Vec3, uvec2, vec3};

/// v in units of 2^-62.
#[must_use]
pub fn native_environment_wide(v: UVec2) -> f32 {
    v.y as f32 * 9.313_225_746_154_785e-10 + v.x as f32 * 2.168_404_344_971_009e-19
}

/// v as a fraction of 2^32, which may be 2^32 itself.
#[must_use]
pub fn native_environment_weight(v: UVec2) -> f32 {
    if v.y != 0 { 1.0 } else { native_unit(v.x) }
}

/// The direction at a place of a texel: fractions from its left and upper edges.
#[must_use]
pub fn native_environment_direction(
    size: UVec2,
    texel: UVec2,
    place: UVec2,
    words: &[u32],
) -> Vec3 {
    let cap = environment_cap(size, texel.y, words);
    let extent = sub64(environment_cap(size, texel.y + 1, words), cap);
    let mut down = add64(cap, discrete_scale(extent, place.y));
    down = add64(down, shr64(extent, 33));
    let up = sub64(uvec2(0, 0x8000_0000), down);
    let z = if down.y >= 0x4000_0000 {
        native_environment_wide(up) - 1.0
    } else {
        1.0 - native_environment_wide(down)
    };
    let radius = (native_environment_wide(down) * native_environment_wide(up)).sqrt();
    let turns = discrete_divide(uvec2(place.x, texel.x), size.x) as i32;
    let phi = 1.462_918_079_267_159_6e-9 * turns as f32;
    vec3(
        radius * phi.cos(),
        radius * phi.sin(),
        environment_z(size, texel.y, z, words),
    )
}

/// Probability over the solid angle of a texel of this row.
#[must_use]
pub fn native_environment_density(size: UVec2, row: u32, probability: f32, words: &[u32]) -> f32 {
    let extent = sub64(
        environment_cap(size, row + 1, words),
        environment_cap(size, row, words),
    );
    probability * (0.5 * std::f32::consts::FRAC_1_PI * size.x as f32)
        / native_environment_wide(extent)
}

/// Pdf of the hierarchical tables in a texel, as column and row.
#[must_use]
pub fn native_environment_texel_pdf(size: UVec2, texel: UVec2, words: &[u32]) -> f32 {
    let row = cdf_weight(environment_first(size), texel.y, words);
    let column = cdf_weight(environment_row(size, texel.y), texel.x, words);
    native_environment_density(
        size,
        texel.y,
        native_environment_weight(row) * native_environment_weight(column),
        words,
    )
}

/// Direction by the hierarchical tables: u.x gives the row, u.y the column.
#[must_use]
pub fn native_environment(size: UVec2, u: UVec2, words: &[u32]) -> Environment {
    let row = cdf(environment_first(size), u.x, words);
    let column = cdf(environment_row(size, row.index), u.y, words);
    let probability =
        native_environment_weight(row.weight) * native_environment_weight(column.weight);
    Environment {
        direction: native_environment_direction(
            size,
            uvec2(column.index, row.index),
            uvec2(column.rest, row.rest),
            words,
        ),
        pdf: native_environment_density(size, row.index, probability, words),
    }
}

/// The density with which `native_environment` draws in the texel of a direction.
#[must_use]
pub fn native_environment_pdf(size: UVec2, direction: Vec3, edges: &[f32], words: &[u32]) -> f32 {
    native_environment_texel_pdf(size, envmap_texel(direction, size, edges), words)
}

/// The fractions that give this direction by the hierarchical tables.
#[must_use]
pub fn native_environment_invert(
    size: UVec2,
    direction: Vec3,
    edges: &[f32],
    words: &[u32],
) -> UVec2 {
    environment_invert(size, direction, edges, words)
}

/// Pdf of the alias table in a texel, as column and row.
#[must_use]
pub fn native_environment_alias_texel_pdf(size: UVec2, texel: UVec2, words: &[u32]) -> f32 {
    let index = texel.y * size.x + texel.x;
    let weight = alias_weight(environment_first(size), index, words);
    native_environment_density(size, texel.y, native_environment_weight(weight), words)
}

/// Direction by the alias table: u.x gives the texel, u.y the place across, u.z down.
#[must_use]
pub fn native_environment_alias(size: UVec2, u: UVec3, words: &[u32]) -> Environment {
    let index = alias_index(environment_first(size), size.x * size.y, u.x, words);
    let row = index / size.x;
    let texel = uvec2(index - row * size.x, row);
    Environment {
        direction: native_environment_direction(size, texel, uvec2(u.y, u.z), words),
        pdf: native_environment_alias_texel_pdf(size, texel, words),
    }
}

/// The density with which `native_environment_alias` draws in the texel of a direction.
#[must_use]
pub fn native_environment_alias_pdf(
    size: UVec2,
    direction: Vec3,
    edges: &[f32],
    words: &[u32],
) -> f32 {
    native_environment_alias_texel_pdf(size, envmap_texel(direction, size, edges), words)
}
