//! A direction with its pdf, and a direction from height, radius and angle, in the native
//! profile.
//!
//! Source: cylindrical coordinates. Domain: any floats. Errors: Vulkan allows sin and cos
//! an absolute error of 2^-11.
//! Mirror: `shaders/corput/native/scattered.glsl`.

use crate::reference::native::disk::{native_fraction, native_unit};
use glam::{Vec3, vec3};

/// A direction, and the density there with respect to solid angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeScattered {
    /// The unit vector.
    pub direction: Vec3,
    /// The density.
    pub pdf: f32,
}

/// (radius cos 2 pi phi, radius sin 2 pi phi, z), phi a fraction of 2^32.
#[must_use]
pub fn native_around(radius: f32, phi: u32, z: f32) -> Vec3 {
    let angle = 6.2831853 * native_unit(phi);
    vec3(radius * angle.cos(), radius * angle.sin(), z)
}

/// The fraction a of 2^32, where b = 1 - a: from the smaller.
#[must_use]
pub fn native_fraction_of(a: f32, b: f32) -> u32 {
    if a < b {
        return native_fraction(a);
    }
    0u32.wrapping_sub((native_fraction(b)).max(1))
}
