//! Directions of a cone around +z in the native profile, uniformly, with pdf and inverse.
//!
//! Source: PBRT 4th ed., A.5.4, in terms of h = 2 sin^2(theta_max/2). Domain: h from 0 to
//! 2, two fractions of 2^32; h <= 0 gives +z, with pdf 0; h > 2 counts as 2. Pdf: with
//! respect to solid angle, 1/(2 pi h) inside, the edge widened by 2^-10 of h.
//! Mirror: `shaders/corput/native/cone.glsl`.

use crate::reference::native::disk::{native_fraction, native_turns, native_unit};
use crate::reference::native::hemisphere::native_complement;
use crate::reference::native::sphere::native_sphere_versine;
use glam::{UVec2, Vec3, uvec2, vec3};
use std::f32::consts::{FRAC_1_PI, TAU};

/// h within its domain.
#[must_use]
pub fn native_cone_height(h: f32) -> f32 {
    if h > 0.0 { h.min(2.0) } else { 0.0 }
}

/// Uniform direction of the cone: 1 - z = u.x h, phi = 2 pi u.y.
#[must_use]
pub fn native_cone(h: f32, u: UVec2) -> Vec3 {
    let height = native_cone_height(h);
    let versine = native_unit(u.x) * height;
    let rest = (2.0 - height) + height * native_complement(u.x);
    let radius = (versine * rest).sqrt();
    let phi = TAU * native_unit(u.y);
    vec3(radius * phi.cos(), radius * phi.sin(), 1.0 - versine)
}

/// 1/(2 pi h) inside, else 0.
#[must_use]
pub fn native_cone_pdf(h: f32, direction: Vec3) -> f32 {
    let height = native_cone_height(h);
    let versine = native_sphere_versine(direction);
    let mut inside = versine <= height * 1.000_976_6;
    if direction.z < 0.0 {
        let rest = native_sphere_versine(vec3(direction.x, direction.y, -direction.z));
        inside = rest >= (2.0 - height) * 0.999_023_44;
    }
    if inside && height >= 1e-36 {
        0.5 * FRAC_1_PI / height
    } else {
        0.0
    }
}

/// The fractions that give this direction.
#[must_use]
pub fn native_cone_invert(h: f32, direction: Vec3) -> UVec2 {
    let height = native_cone_height(h).max(1e-36);
    let mut versine = native_sphere_versine(direction);
    if direction.z < 0.0 {
        versine = 2.0 - native_sphere_versine(vec3(direction.x, direction.y, -direction.z));
    }
    uvec2(
        native_fraction(versine / height),
        native_fraction(native_turns(direction.truncate())),
    )
}
