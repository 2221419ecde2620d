//! Directions of the hemisphere around +z in the native profile, with pdf and inverse.
//!
//! Source: Malley's method over the disk maps. Domain: two fractions of 2^32.
//! Pdf: with respect to solid angle, 1/(2 pi) and z/pi; 0 below the horizon.
//! Mirror: `shaders/corput/native/hemisphere.glsl`.

use crate::reference::native::disk::{
    native_concentric_disk, native_concentric_disk_invert, native_fraction, native_polar_disk,
    native_polar_disk_invert, native_turns, native_unit,
};
use glam::{UVec2, Vec3, uvec2, vec3};
use std::f32::consts::{FRAC_1_PI, TAU};

/// 1 - u as a fraction of 2^32, from the integer, so that nothing cancels.
#[must_use]
pub fn native_complement(u: u32) -> f32 {
    if u == 0 {
        1.0
    } else {
        native_unit(0u32.wrapping_sub(u))
    }
}

/// Uniform direction: z = u.x, phi = 2 pi u.y.
#[must_use]
pub fn native_uniform_hemisphere(u: UVec2) -> Vec3 {
    let z = native_unit(u.x);
    let radius = (native_complement(u.x) * (1.0 + z)).sqrt();
    let phi = TAU * native_unit(u.y);
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
    let x = if u.x < 0x8000_0000 {
        0x8000_0000 - u.x
    } else {
        u.x - 0x8000_0000
    };
    let y = if u.y < 0x8000_0000 {
        0x8000_0000 - u.y
    } else {
        u.y - 0x8000_0000
    };
    let radius = x.max(y);
    let z = ((0x8000_0000 - radius) as f32 * 4.656_613e-10 * (1.0 + radius as f32 * 4.656_613e-10))
        .sqrt();
    native_concentric_disk(u).extend(z)
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
    native_polar_disk(u).extend(native_complement(u.x).sqrt())
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
