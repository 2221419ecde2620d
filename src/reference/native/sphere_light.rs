//! Directions from the origin towards a sphere in the native profile, uniformly over its solid
//! angle, with pdf and inverse.
//!
//! Source: PBRT 4th ed., 6.2.4, by h = r^2 / (d^2 + d sqrt(d^2 - r^2)). Domain: a centre at 1e-9
//! to 1e9 from the origin, a radius; two fractions of 2^32; from within, uniform over all
//! directions; r <= 0: the direction of the centre, with pdf 0. Pdf: with respect to solid
//! angle, 1/(2 pi h) inside, 1/(4 pi) from within.
//! Mirror: `shaders/corput/native/sphere_light.glsl`.

use crate::reference::native::cone::{native_cone, native_cone_invert};
use crate::reference::native::frame::{
    NativeFrame, native_frame, native_frame_to_local, native_frame_to_world,
};
use glam::{UVec2, Vec3, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeSphereLight {
    /// Its normal points to the centre.
    pub frame: NativeFrame,
    /// 1 - cos(theta_max).
    pub h: f32,
}

/// The sphere with this centre and radius.
#[must_use]
pub fn native_sphere_light_prepare(center: Vec3, radius: f32) -> NativeSphereLight {
    let square = center.dot(center);
    let distance = square.sqrt();
    let r = radius.max(0.0);
    let mut axis = vec3(0.0, 0.0, 1.0);
    let mut h = 2.0;
    if distance > 0.0 {
        axis = center / distance;
        if distance >= r {
            let rest = (distance - r) * (distance + r);
            h = r * r / (square + distance * rest.sqrt());
        }
    }
    NativeSphereLight {
        frame: native_frame(axis),
        h,
    }
}

/// Uniform direction towards the sphere.
#[must_use]
pub fn native_sphere_light(light: NativeSphereLight, u: UVec2) -> Vec3 {
    native_frame_to_world(light.frame, native_cone(light.h, u))
}

/// 1/(2 pi h) towards the sphere, else 0.
#[must_use]
pub fn native_sphere_light_pdf(light: NativeSphereLight, direction: Vec3) -> f32 {
    let local = native_frame_to_local(light.frame, direction);
    // The sine of the edge, and that of the direction less its rounding.
    let edge = (light.h * (2.0 - light.h)).sqrt();
    let sine = (local.x * local.x + local.y * local.y).sqrt() - 9.5367432e-7;
    let mut inside = if light.h > 0.75 {
        local.z >= 1.0 - light.h * 1.0009766
    } else {
        local.z > 0.0 && sine <= edge * 1.0009766
    };
    inside = inside || light.h >= 2.0;
    if inside && light.h >= 1e-36 {
        0.15915494 / light.h
    } else {
        0.0
    }
}

/// The fractions that give this direction.
#[must_use]
pub fn native_sphere_light_invert(light: NativeSphereLight, direction: Vec3) -> UVec2 {
    native_cone_invert(light.h, native_frame_to_local(light.frame, direction))
}
