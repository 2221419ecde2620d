//! Directions from the origin towards a disk in the native profile, uniformly over its area,
//! with the pdf of the direction, and inverse.
//!
//! Source: PBRT 4th ed., 6.3 and 12.2.3. Domain: a centre, a normal, a radius, of lengths from
//! 1e-6 to 1e6; two fractions of 2^32; the origin in the plane of the disk, r <= 0 or a
//! normal of 0: pdf 0. Pdf: with respect to solid angle, |p|^3 / (pi r^2 |n . p|).
//! Mirror: `shaders/corput/native/disk_light.glsl`.

use crate::reference::native::disk::{native_concentric_disk, native_concentric_disk_invert};
use crate::reference::native::frame::{NativeFrame, native_frame};
use glam::{UVec2, Vec2, Vec3, vec2, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeDiskLight {
    /// The centre.
    pub center: Vec3,
    /// Its normal is that of the disk.
    pub frame: NativeFrame,
    /// The radius.
    pub radius: f32,
    /// The distance of the plane from the origin.
    pub height: f32,
}

/// A direction and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeLightSample {
    /// A unit vector.
    pub direction: Vec3,
    /// With respect to solid angle.
    pub pdf: f32,
}

/// The disk with this centre, normal and radius.
#[must_use]
pub fn native_disk_light_prepare(center: Vec3, normal: Vec3, radius: f32) -> NativeDiskLight {
    let size = (normal.dot(normal)).sqrt();
    let mut n = vec3(0.0, 0.0, 1.0);
    let mut height = 0.0;
    if size > 0.0 {
        n = normal / size;
        height = (center.dot(n)).abs();
    }
    NativeDiskLight {
        center,
        frame: native_frame(n),
        radius: radius.max(0.0),
        height,
    }
}

/// The pdf of the direction to a point at this distance.
#[must_use]
pub fn native_disk_light_density(light: NativeDiskLight, distance: f32) -> f32 {
    let area = light.radius * light.radius * light.height;
    if area >= 1e-37 {
        (std::f32::consts::FRAC_1_PI * distance * distance * distance / area).min(3.4e38)
    } else {
        0.0
    }
}

/// A point of the disk, as a direction.
#[must_use]
pub fn native_disk_light(light: NativeDiskLight, u: UVec2) -> NativeLightSample {
    let p = light.radius * native_concentric_disk(u);
    let point = light.center + (p.x * light.frame.tangent + p.y * light.frame.bitangent);
    let distance = (point.dot(point)).sqrt();
    let apart = distance > 0.0;
    if !apart {
        return NativeLightSample {
            direction: vec3(0.0, 0.0, 1.0),
            pdf: 0.0,
        };
    }
    NativeLightSample {
        direction: point / distance,
        pdf: native_disk_light_density(light, distance),
    }
}

/// The distance at which a direction meets the plane of the disk; 0 where it does not.
#[must_use]
pub fn native_disk_light_distance(light: NativeDiskLight, direction: Vec3) -> f32 {
    let along = direction.dot(light.frame.normal);
    let side = light.center.dot(light.frame.normal);
    let signed_along = if side < 0.0 { -along } else { along };
    if signed_along > 0.0 {
        (light.height / signed_along).min(1e12)
    } else {
        0.0
    }
}

/// Where a direction meets the plane of the disk, from its centre, over its radius.
#[must_use]
pub fn native_disk_light_point(light: NativeDiskLight, direction: Vec3, distance: f32) -> Vec2 {
    let point = distance * direction - light.center;
    let scale = 1.0 / light.radius.max(1e-18);
    scale
        * vec2(
            point.dot(light.frame.tangent),
            point.dot(light.frame.bitangent),
        )
}

/// |p|^3 / (pi r^2 |n . p|) for the point p that a direction meets, else 0.
#[must_use]
pub fn native_disk_light_pdf(light: NativeDiskLight, direction: Vec3) -> f32 {
    let distance = native_disk_light_distance(light, direction);
    let p = native_disk_light_point(light, direction, distance);
    let slack = 9.5367432e-7 * distance * distance / (light.radius * light.height).max(1e-37);
    let inside = distance > 0.0 && (p.dot(p)).sqrt() <= 1.0009766 + slack;
    if inside {
        native_disk_light_density(light, distance)
    } else {
        0.0
    }
}

/// The fractions that give this direction.
#[must_use]
pub fn native_disk_light_invert(light: NativeDiskLight, direction: Vec3) -> UVec2 {
    let distance = native_disk_light_distance(light, direction);
    native_concentric_disk_invert(native_disk_light_point(light, direction, distance))
}
