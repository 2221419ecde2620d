//! Estimators of the highlight that a GGX surface shows of a spherical light of radiance 1,
//! without Fresnel's term: for each sample that meets the light, D G2 / (4 cos cos') times
//! cos' over its pdf. With w = G2 / G1, the weight by visible normals, and q their pdf over
//! that of the light, w of a visible normal, w q of a direction of the light, and by the
//! balance heuristic 2 w q / (1 + q), the harmonic mean of both.
//!
//! Source: Heitz 2018, JCGT 7(4); Veach and Guibas 1995, SIGGRAPH. Domain: fractions of 2^32;
//! a lobe of `ggx_lobe` seen from above the horizon; a light of `sphere_light` above it, seen
//! from outside. Range: 0 to 1, q, and 2 q / (1 + q) at the q of the lobe's peak, and 2 pi
//! times the peak of the pdf by uniform directions. A direction within 2^-26 of the light's
//! rim may count as on its other side. Errors: 2^-29 + 2^-30 / (alpha cos) of the largest
//! sample, for a view at this cosine, as reals are rounded. No direction is rounded to float,
//! which a sharp lobe would show. Tier I.
//! Mirror: `shaders/corput/highlight.glsl`.

use crate::reference::cone::cone_around;
use crate::reference::ggx::{ggx_density, ggx_stretched};
use crate::reference::ggx_lobe::{Ggx, ggx_over_area, ggx_reflected, ggx_weight_of};
use crate::reference::ggx_vndf::ggx_vndf_visible;
use crate::reference::real::{
    Real, real_add, real_divide, real_less, real_multiply, real_shift, real_uint, real_zero,
};
use crate::reference::real_frame::real_frame_to_world;
use crate::reference::real_vector::{Real3, real3_add, real3_dot, real3_subtract};
use crate::reference::sphere_light::SphereLight;
use glam::{UVec2, UVec3, Vec3Swizzles};

/// wo reflected at a visible normal.
#[inline]
#[must_use]
pub fn highlight_reflected(g: Ggx, u: UVec2) -> Real3 {
    let v = ggx_vndf_visible(g, u);
    let s = ggx_stretched(g.alpha_x, g.alpha_y, v.normal);
    ggx_reflected(g, s, real3_dot(s, s), v.cosine)
}

/// A uniform direction of the light.
#[inline]
#[must_use]
pub fn highlight_drawn(light: SphereLight, u: UVec2) -> Real3 {
    real_frame_to_world(light.frame, cone_around(light.h, u))
}

/// Whether a direction meets the light: by the chord to its centre, whose square is
/// 2 (1 - cos) and does not cancel where the light is small.
#[inline]
#[must_use]
pub fn highlight_met(light: SphereLight, d: Real3) -> bool {
    let chord = real3_subtract(d, light.frame.normal);
    real_less(real3_dot(chord, chord), real_shift(light.h, 1))
}

/// The pdf of a reflected direction over the 1 / (2 pi h) of a cone.
#[inline]
#[must_use]
pub fn highlight_ratio(g: Ggx, h: Real, d: Real3) -> Real {
    let density = ggx_density(g.alpha_x, g.alpha_y, real3_add(g.wo, d));
    let angle = real_multiply(h, real_uint(3_373_259_426, -30));
    ggx_over_area(g, real_multiply(density, angle))
}

/// By uniform directions of the hemisphere, the cone of h = 1.
#[inline]
#[must_use]
pub fn highlight_uniform(g: Ggx, light: SphereLight, u: UVec2) -> Real {
    let one = real_uint(1, 0);
    let d = cone_around(one, u);
    let mut value = real_multiply(ggx_weight_of(g, d), highlight_ratio(g, one, d));
    if !highlight_met(light, d) {
        value = real_zero();
    }
    value
}

/// By reflection at visible normals: w.
#[inline]
#[must_use]
pub fn highlight_visible(g: Ggx, light: SphereLight, u: UVec2) -> Real {
    let d = highlight_reflected(g, u);
    let mut value = ggx_weight_of(g, d);
    if !highlight_met(light, d) {
        value = real_zero();
    }
    value
}

/// By directions of the light: w q.
#[inline]
#[must_use]
pub fn highlight_light(g: Ggx, light: SphereLight, u: UVec2) -> Real {
    let d = highlight_drawn(light, u);
    real_multiply(ggx_weight_of(g, d), highlight_ratio(g, light.h, d))
}

/// A visible normal for half of all u.z and a direction of the light for the others, with the
/// balance heuristic: 2 w q / (1 + q).
#[inline]
#[must_use]
pub fn highlight_mis(g: Ggx, light: SphereLight, u: UVec3) -> Real {
    let mut d = highlight_reflected(g, u.xy());
    let mut met = highlight_met(light, d);
    let drawn = highlight_drawn(light, u.xy());
    if u.z >= 0x8000_0000 {
        d = drawn;
        met = true;
    }
    let q = highlight_ratio(g, light.h, d);
    let share = real_divide(real_shift(q, 1), real_add(real_uint(1, 0), q));
    let mut value = real_multiply(ggx_weight_of(g, d), share);
    if !met {
        value = real_zero();
    }
    value
}
