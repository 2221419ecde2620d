//! Reflection at the visible normals of a GGX lobe by spherical caps in the native
//! profile, with pdf and inverse.
//!
//! Source: Dupuy and Benyoub 2023, as ggx_vndf_cap.glsl. Domain: two fractions of 2^32:
//! u.x height, u.y angle around +z. Lobes as ggx_lobe.glsl. Range: unit vectors to the
//! device's precision. Pdf: with respect to solid angle. Errors: as ggx_lobe.glsl; where
//! the sampled normal is nearly perpendicular to wo, the pdf has few digits.
//! Mirror: `shaders/corput/native/ggx_vndf_cap.glsl`.

use crate::reference::native::disk::{native_fraction, native_turns, native_unit};
use crate::reference::native::ggx_lobe::{
    NativeGgx, native_ggx_half, native_ggx_pdf, native_ggx_reflected, native_ggx_sphere_sum,
};
use crate::reference::native::hemisphere::native_complement;
use crate::reference::native::scattered::{
    NativeScattered, native_around, native_fraction_of, native_quotient,
};
use glam::{UVec2, Vec3, uvec2, vec2, vec3};

/// V + V' for a point V' of the cap.
#[must_use]
pub fn native_ggx_cap_sum(g: NativeGgx, u: UVec2) -> Vec3 {
    let height = native_complement(u.x) * g.cap_above;
    let below = native_unit(u.x) * g.cap_above;
    let radius = (below * (height + g.cap_below)).sqrt();
    let around = native_around(radius, u.y, height + g.excess);
    vec3(around.x + g.view.x, around.y + g.view.y, around.z)
}

/// Direction and pdf.
#[must_use]
pub fn native_ggx_vndf_cap(g: NativeGgx, u: UVec2) -> NativeScattered {
    let n = native_ggx_cap_sum(g, u);
    let square = n.dot(n);
    let made = native_ggx_reflected(g, n, square, 0.5 * square);
    // Of a small n half its square is not V.n to all its digits.
    let size = made.direction.dot(made.direction).sqrt();
    NativeScattered {
        direction: made.direction * native_quotient(1.0, size),
        pdf: made.pdf,
    }
}

/// The pdf of a direction.
#[must_use]
pub fn native_ggx_vndf_cap_pdf(g: NativeGgx, wi: Vec3) -> f32 {
    native_ggx_pdf(g, wi)
}

/// The fractions that give this direction.
#[must_use]
pub fn native_ggx_vndf_cap_invert(g: NativeGgx, wi: Vec3) -> UVec2 {
    let n = native_ggx_sphere_sum(g, native_ggx_half(g, wi));
    let around = vec2(n.x - g.view.x, n.y - g.view.y);
    let height = n.z - g.excess;
    let below = native_quotient(around.dot(around), height + g.cap_below);
    uvec2(
        native_fraction_of(
            native_quotient(below, g.cap_above),
            native_quotient(height, g.cap_above),
        ),
        native_fraction(native_turns(around)),
    )
}
