//! Reflection at those visible normals of a GGX lobe that may reflect above the horizon
//! in the native profile, with pdf and inverse.
//!
//! Source: Eto and Tokuyoshi 2023, as ggx_vndf_bounded.glsl. Domain: as
//! ggx_vndf_cap.glsl. A wo on or below the horizon has all visible normals. Range: unit
//! vectors to the device's precision. Pdf: with respect to solid angle; 0 outside the
//! cap. Errors: as ggx_vndf_cap.glsl.
//! Mirror: `shaders/corput/native/ggx_vndf_bounded.glsl`.

use crate::reference::native::ggx_lobe::{NativeGgx, native_ggx_pdf, native_ggx_prepare};
use crate::reference::native::ggx_vndf_cap::{native_ggx_vndf_cap, native_ggx_vndf_cap_invert};
use crate::reference::native::scattered::NativeScattered;
use glam::{UVec2, Vec2, Vec3};

/// A lobe of all visible normals, less those beyond the bound.
#[must_use]
pub fn native_ggx_vndf_bound(all: NativeGgx) -> NativeGgx {
    let mut g = all;
    if g.wo.z <= 0.0 {
        return g;
    }
    let a = (g.alpha.x.min(g.alpha.y)).min(1.0);
    let s = 1.0 + (g.wo.x * g.wo.x + g.wo.y * g.wo.y).sqrt();
    let sum = s * s + a * a * g.wo.z * g.wo.z;
    let k = (1.0 - a) * (1.0 + a) * s * s / sum;
    g.excess = g.view.z * (2.0 * a * a * s / sum);
    g.cap_above = 1.0 + k * g.view.z;
    g.cap_below = g.view_below + g.excess;
    g
}

/// The lobe of the normals within the bound.
#[must_use]
pub fn native_ggx_vndf_bounded_prepare(alpha: Vec2, wo: Vec3) -> NativeGgx {
    native_ggx_vndf_bound(native_ggx_prepare(alpha, wo))
}

/// Direction and pdf.
#[must_use]
pub fn native_ggx_vndf_bounded(g: NativeGgx, u: UVec2) -> NativeScattered {
    native_ggx_vndf_cap(g, u)
}

/// The pdf of a direction.
#[must_use]
pub fn native_ggx_vndf_bounded_pdf(g: NativeGgx, wi: Vec3) -> f32 {
    native_ggx_pdf(g, wi)
}

/// The fractions that give this direction.
#[must_use]
pub fn native_ggx_vndf_bounded_invert(g: NativeGgx, wi: Vec3) -> UVec2 {
    native_ggx_vndf_cap_invert(g, wi)
}
