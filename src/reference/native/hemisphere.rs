//! Directions of the hemisphere around +z in the native profile, with pdf and inverse.
//!
//! Source: Malley's method over the disk maps. Domain: two fractions of 2^32.
//! Pdf: with respect to solid angle, 1/(2 pi) and z/pi; 0 below the horizon.
//! Mirror: `shaders/corput/native/hemisphere.glsl`.

use crate::reference::native::disk::{
    native_concentric_disk, native_concentric_disk_invert, native_fraction, native_polar_disk,
    native_polar_disk_invert, native_signed_unit, native_turns,
};
use crate::reference::unit::unit_floor;
use glam::{UVec2, Vec3, uvec2, vec3};
use std::f32::consts::{FRAC_1_PI, TAU};

/// Uniform direction: z = u.x, phi = 2 pi u.y.
#[must_use]
pub fn native_uniform_hemisphere(u: UVec2) -> Vec3 {
    let z = unit_floor(u.x);
    let radius = ((1.0 - z) * (1.0 + z)).sqrt();
    let phi = TAU * unit_floor(u.y);
    vec3(radius * phi.cos(), radius * phi.sin(), z)
}

/// 1/(2 pi) above the horizon.
#[must_use]
pub fn native_uniform_hemisphere_pdf(direction: Vec3) -> f32 {
    if direction.z >= 0.0 {
        0.5 * FRAC_1_PI
    } else {
        0.0
    }
}

/// The fractions that give this direction.
#[must_use]
pub fn native_uniform_hemisphere_invert(direction: Vec3) -> UVec2 {
    uvec2(
        native_fraction(direction.z),
        native_fraction(native_turns(direction.truncate())),
    )
}

/// Cosine-weighted direction over the concentric disk.
#[must_use]
pub fn native_cosine_hemisphere(u: UVec2) -> Vec3 {
    let radius = native_signed_unit(u.x)
        .abs()
        .max(native_signed_unit(u.y).abs());
    native_concentric_disk(u).extend(((1.0 - radius) * (1.0 + radius)).sqrt())
}

/// z/pi for z > 0, else 0.
#[must_use]
pub fn native_cosine_hemisphere_pdf(direction: Vec3) -> f32 {
    direction.z.max(0.0) * FRAC_1_PI
}

/// The fractions that give this direction.
#[must_use]
pub fn native_cosine_hemisphere_invert(direction: Vec3) -> UVec2 {
    native_concentric_disk_invert(direction.truncate())
}

/// Cosine-weighted direction over the polar disk: z = sqrt(1 - u.x).
#[must_use]
pub fn native_cosine_hemisphere_polar(u: UVec2) -> Vec3 {
    native_polar_disk(u).extend((1.0 - unit_floor(u.x)).sqrt())
}

/// z/pi for z > 0, else 0.
#[must_use]
pub fn native_cosine_hemisphere_polar_pdf(direction: Vec3) -> f32 {
    direction.z.max(0.0) * FRAC_1_PI
}

/// The fractions that give this direction.
#[must_use]
pub fn native_cosine_hemisphere_polar_invert(direction: Vec3) -> UVec2 {
    native_polar_disk_invert(direction.truncate())
}
