//! Directions of the hemisphere around +z by a power of their cosine in the native
//! profile, with pdf and inverse.
//!
//! Source: as cosine_power.glsl; 1 - e^-w and -ln(1 - v) by Taylor's series near 0, where
//! devices have no digits of them. Domain: n >= 0, n < 0 counts as 0; two fractions of
//! 2^32. Range: unit vectors to the device's precision. Pdf: with respect to solid angle;
//! that of a sample by its fractions. Errors: 2^-17 a coordinate, 2^-14 of the pdf of a
//! sample, within what Vulkan allows log and exp.
//! Mirror: `shaders/corput/native/cosine_power.glsl`.

use crate::reference::native::disk::{native_fraction, native_turns};
use crate::reference::native::free_flight::native_negative_log;
use crate::reference::native::scattered::{NativeScattered, native_around, native_fraction_of};
use glam::{UVec2, Vec3, Vec3Swizzles, uvec2};

/// The exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeCosinePower {
    /// At least 0.
    pub n: f32,
}

/// By n.
#[inline]
#[must_use]
pub fn native_cosine_power_prepare(n: f32) -> NativeCosinePower {
    NativeCosinePower { n: n.max(0.0) }
}

/// 1 - e^-w, for w >= 0.
#[inline]
#[must_use]
pub fn native_cosine_power_mass(w: f32) -> f32 {
    if w < 0.25 {
        return w * (1.0 - w * (0.5 - w * (0.16666667 - w * (0.041666668 - w * 0.008333333))));
    }
    1.0 - (-w).exp()
}

/// -ln z of a unit vector.
#[inline]
#[must_use]
pub fn native_cosine_power_log(direction: Vec3) -> f32 {
    let z = direction.z.max(1e-30);
    let v = (direction.x * direction.x + direction.y * direction.y) / (1.0 + z);
    if v < 0.125 {
        return v * (1.0 + v * (0.5 + v * (0.33333334 + v * (0.25 + v * (0.2 + v * 0.16666667)))));
    }
    (-z.ln()).max(0.0)
}

/// Direction and pdf.
#[inline]
#[must_use]
pub fn native_cosine_power(lobe: NativeCosinePower, u: UVec2) -> NativeScattered {
    let next = lobe.n + 1.0;
    let w = native_negative_log(u.x) / next;
    let versine = native_cosine_power_mass(w);
    let z = (-w).exp();
    let pdf = 0.15915494 * next * (-(lobe.n * w)).exp();
    NativeScattered {
        direction: native_around((versine * (1.0 + z)).sqrt(), u.y, z),
        pdf,
    }
}

/// The pdf of a direction.
#[inline]
#[must_use]
pub fn native_cosine_power_pdf(lobe: NativeCosinePower, direction: Vec3) -> f32 {
    if direction.z < 0.0 {
        return 0.0;
    }
    0.15915494 * (lobe.n + 1.0) * (-(lobe.n * native_cosine_power_log(direction))).exp()
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn native_cosine_power_invert(lobe: NativeCosinePower, direction: Vec3) -> UVec2 {
    let w = (lobe.n + 1.0) * native_cosine_power_log(direction);
    uvec2(
        native_fraction_of(native_cosine_power_mass(w), (-w).exp()),
        native_fraction(native_turns(direction.xy())),
    )
}
