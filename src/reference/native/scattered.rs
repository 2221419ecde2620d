//! A direction with its pdf, and a direction from height, radius and angle, in the native
//! profile.
//!
//! Source: cylindrical coordinates; Taylor's polynomials for an eighth of a turn, as
//! Vulkan allows sin and cos to be off by 2^-11, many times the width of a narrow lobe.
//! Domain: any floats. Errors: sine and cosine 2^-22.
//! Mirror: `shaders/corput/native/scattered.glsl`.

use crate::reference::native::disk::native_fraction;
use glam::{Vec2, Vec3, vec2, vec3};

/// A direction, and the density there with respect to solid angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeScattered {
    /// The unit vector.
    pub direction: Vec3,
    /// The density.
    pub pdf: f32,
}

/// (cos 2 pi phi, sin 2 pi phi), phi a fraction of 2^32.
#[must_use]
pub fn native_cos_sin(phi: u32) -> Vec2 {
    // Nearest quarter turn, and the signed rest, in integers: no reduction error.
    let quarter = phi.wrapping_add(0x2000_0000) >> 30;
    let x = phi.wrapping_sub(quarter << 30) as i32 as f32 * 2.3283064365386963e-10;
    let w = x * x;
    let s = x
        * (std::f32::consts::TAU
            + w * (-41.341702 + w * (81.605249 + w * (-76.705860 + w * 42.058694))));
    let c = 1.0 + w * (-19.739209 + w * (64.939394 + w * (-85.456817 + w * 60.244641)));
    if quarter == 1 {
        return vec2(-s, c);
    }
    if quarter == 2 {
        return vec2(-c, -s);
    }
    if quarter == 3 {
        return vec2(s, -c);
    }
    vec2(c, s)
}

/// (radius cos 2 pi phi, radius sin 2 pi phi, z), phi a fraction of 2^32.
#[must_use]
pub fn native_around(radius: f32, phi: u32, z: f32) -> Vec3 {
    let circle = native_cos_sin(phi);
    vec3(radius * circle.x, radius * circle.y, z)
}

/// a / b; 0 for b <= 0.
#[must_use]
pub fn native_quotient(a: f32, b: f32) -> f32 {
    if b > 0.0 {
        return a / b;
    }
    0.0
}

/// The fraction a of 2^32, where b = 1 - a: from the smaller.
#[must_use]
pub fn native_fraction_of(a: f32, b: f32) -> u32 {
    if a < b {
        return native_fraction(a);
    }
    0u32.wrapping_sub(native_fraction(b).max(1))
}
