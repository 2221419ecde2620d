//! Reflection at those visible normals of a GGX lobe that may reflect above the horizon,
//! with pdf and inverse: spherical caps, bounded.
//!
//! Source: Eto and Tokuyoshi 2023, Bounded VNDF sampling for Smith-GGX reflections,
//! SIGGRAPH Asia Technical Communications, eq. 5 and 6: the cap is z > -k V.z with k = (1 -
//! a^2) s^2 / (s^2 + a^2 wo.z^2), a = min(alpha, 1), s = 1 + |wo.xy|. V.z - b is V.z (1 -
//! k), and 1 - k = 2 a^2 s / (s^2 + a^2 wo.z^2) since wo is unit. Domain: as
//! ggx_vndf_cap.glsl. A wo on or below the horizon has all visible normals. Range: unit
//! vectors to 2^-23. Some still lie below the horizon, none more than without the bound;
//! for alpha_x = alpha_y seen from +z, none. Pdf: with respect to solid angle: D / (2 (k
//! wo.z + |S wo|)); 0 outside the cap. Errors: as ggx_vndf_cap.glsl. Tier I.
//! Mirror: `shaders/corput/ggx_vndf_bounded.glsl`.

use crate::reference::ggx_lobe::{Ggx, ggx_pdf, ggx_prepare};
use crate::reference::ggx_vndf_cap::{ggx_vndf_cap, ggx_vndf_cap_invert};
use crate::reference::real::{
    real_add, real_divide, real_min, real_multiply, real_shift, real_sqrt, real_square,
    real_subtract, real_uint,
};
use crate::reference::scattered::Scattered;
use glam::{UVec2, Vec2, Vec3};

/// A lobe of all visible normals, less those beyond the bound.
#[inline]
#[must_use]
pub fn ggx_vndf_bound(all: Ggx) -> Ggx {
    let mut g = all;
    if g.wo.z.negative || g.wo.z.m == 0 {
        return g;
    }
    let one = real_uint(1, 0);
    let a = real_min(real_min(g.alpha_x, g.alpha_y), one);
    let a_square = real_square(a);
    let s = real_add(
        one,
        real_sqrt(real_add(real_square(g.wo.x), real_square(g.wo.y))),
    );
    let s_square = real_square(s);
    let sum = real_add(s_square, real_multiply(a_square, real_square(g.wo.z)));
    // 1 - k, and k with 1 - a^2 as a product.
    let rest = real_divide(real_shift(real_multiply(a_square, s), 1), sum);
    let narrowed = real_multiply(real_subtract(one, a), real_add(one, a));
    let k = real_divide(real_multiply(narrowed, s_square), sum);
    g.excess = real_multiply(g.view.z, rest);
    g.cap_above = real_add(one, real_multiply(k, g.view.z));
    g.cap_below = real_add(g.view_below, g.excess);
    g
}

/// The lobe of the normals within the bound.
#[inline]
#[must_use]
pub fn ggx_vndf_bounded_prepare(alpha: Vec2, wo: Vec3) -> Ggx {
    ggx_vndf_bound(ggx_prepare(alpha, wo))
}

/// Direction and pdf.
#[inline]
#[must_use]
pub fn ggx_vndf_bounded(g: Ggx, u: UVec2) -> Scattered {
    ggx_vndf_cap(g, u)
}

/// The pdf of a direction.
#[inline]
#[must_use]
pub fn ggx_vndf_bounded_pdf(g: Ggx, wi: Vec3) -> f32 {
    ggx_pdf(g, wi)
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn ggx_vndf_bounded_invert(g: Ggx, wi: Vec3) -> UVec2 {
    ggx_vndf_cap_invert(g, wi)
}
