//! Directions of the whole sphere in the native profile, uniformly, with pdf and inverse.
//!
//! Source: Archimedes' projection; PBRT 4th ed., A.5. Domain: two fractions of 2^32.
//! Pdf: with respect to solid angle, 1/(4 pi).
//! Mirror: `shaders/corput/native/sphere.glsl`.

use crate::reference::native::disk::{
    native_fraction, native_signed_unit, native_turns, native_unit,
};
use crate::reference::native::hemisphere::native_complement;
use glam::{UVec2, Vec3, uvec2, vec3};
use std::f32::consts::{FRAC_1_PI, TAU};

/// 1 - z of a unit vector: z alone has no digits of it near +z.
#[must_use]
pub fn native_sphere_versine(direction: Vec3) -> f32 {
    if direction.z < 0.5 {
        return 1.0 - direction.z;
    }
    (direction.x * direction.x + direction.y * direction.y) / (1.0 + direction.z)
}

/// Uniform direction: z = 1 - 2 u.x, phi = 2 pi u.y.
#[must_use]
pub fn native_uniform_sphere(u: UVec2) -> Vec3 {
    let radius = 2.0 * (native_unit(u.x) * native_complement(u.x)).sqrt();
    let phi = TAU * native_unit(u.y);
    vec3(
        radius * phi.cos(),
        radius * phi.sin(),
        -native_signed_unit(u.x),
    )
}

/// 1/(4 pi).
#[must_use]
pub fn native_uniform_sphere_pdf() -> f32 {
    0.25 * FRAC_1_PI
}

/// The fractions that give this direction.
#[must_use]
pub fn native_uniform_sphere_invert(direction: Vec3) -> UVec2 {
    let turn = native_fraction(native_turns(direction.truncate()));
    if direction.z < 0.0 {
        let rest = 0.5 * native_sphere_versine(vec3(direction.x, direction.y, -direction.z));
        return uvec2(0u32.wrapping_sub(native_fraction(rest).max(1)), turn);
    }
    uvec2(
        native_fraction(0.5 * native_sphere_versine(direction)),
        turn,
    )
}
