//! The GGX microsurface over the plane z = 0 in the native profile, anisotropic: its
//! normals and Smith's shadowing.
//!
//! Source: as ggx.glsl: forms in which nothing cancels and nothing divides by cos.
//! Domain: alpha along x and y; its sign does not count, and for D what is below 1e-9
//! counts as that. Directions of any length near 1. Errors: about 2^-20 of the result, by
//! the device's sqrt and division.
//! Mirror: `shaders/corput/native/ggx.glsl`.

use crate::reference::native::disk::native_density;
use crate::reference::native::scattered::native_quotient;
use glam::{Vec2, Vec3, vec3};

/// |stretched w|.
#[must_use]
pub fn native_ggx_stretch(alpha: Vec2, w: Vec3) -> f32 {
    let x = w.x * alpha.x;
    let y = w.y * alpha.y;
    (x * x + y * y + w.z * w.z).sqrt()
}

/// |alpha|, at least 1e-9.
#[must_use]
pub fn native_ggx_alpha(alpha: f32) -> f32 {
    (alpha.abs()).max(1e-9)
}

/// D at h; 0 for h.z <= 0.
#[must_use]
pub fn native_ggx_distribution(alpha: Vec2, h: Vec3) -> f32 {
    if h.z <= 0.0 {
        return 0.0;
    }
    let x = native_ggx_alpha(alpha.x);
    let y = native_ggx_alpha(alpha.y);
    let n = vec3(h.x / x, h.y / y, h.z);
    let ratio = native_quotient(h.dot(h), n.dot(n));
    native_density(std::f32::consts::FRAC_1_PI * (ratio / x) * (ratio / y))
}

/// Smith's Lambda; the largest float for w.z <= 0.
#[must_use]
pub fn native_ggx_lambda(alpha: Vec2, w: Vec3) -> f32 {
    if w.z <= 0.0 {
        return f32::from_bits(0x7f7f_ffff);
    }
    let x = w.x * alpha.x;
    let y = w.y * alpha.y;
    native_density((x * x + y * y) / (2.0 * w.z * (w.z + native_ggx_stretch(alpha, w))))
}

/// Smith's G1; 0 for w.z <= 0.
#[must_use]
pub fn native_ggx_g1(alpha: Vec2, w: Vec3) -> f32 {
    if w.z <= 0.0 {
        return 0.0;
    }
    native_density(2.0 * w.z / (w.z + native_ggx_stretch(alpha, w)))
}

/// Smith's G2; 0 where wo.z or wi.z <= 0.
#[must_use]
pub fn native_ggx_g2(alpha: Vec2, wo: Vec3, wi: Vec3) -> f32 {
    if wo.z <= 0.0 || wi.z <= 0.0 {
        return 0.0;
    }
    native_density(
        2.0 * wo.z * wi.z
            / (wi.z * native_ggx_stretch(alpha, wo) + wo.z * native_ggx_stretch(alpha, wi)),
    )
}
