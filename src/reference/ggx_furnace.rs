//! Estimators of what a GGX surface reflects of a uniform sky of radiance 1, without
//! Fresnel's term and without light that meets the surface twice: the white furnace test.
//! For each sample, D G2 / (4 cos cos') times cos' over its pdf.
//!
//! Source: Heitz 2014, JCGT 3(2), section 5.3; Heitz 2018, JCGT 7(4). Domain: fractions of
//! 2^32; a lobe of `ggx_lobe` seen from above the horizon. Range: 0 to 1 by visible normals;
//! by the others up to 1 / (2 cos alpha^3) for alpha <= 1. Errors: 2^-24 / (alpha cos) of
//! the largest sample, for a view at this cosine: as directions are rounded. Tier I.
//! Mirror: `shaders/corput/ggx_furnace.glsl`.

use crate::reference::ggx::{ggx_density, ggx_stretched};
use crate::reference::ggx_lobe::{Ggx, ggx_weight};
use crate::reference::ggx_vndf::ggx_vndf;
use crate::reference::hemisphere::{cosine_hemisphere, uniform_hemisphere};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_multiply, real_shift, real_uint,
};
use crate::reference::real_vector::{Real3, real3, real3_add, real3_length};
use glam::UVec2;

/// pi D / (cos' |S wo| + cos |S wi|), with pi from the measure of directions.
#[inline]
#[must_use]
pub fn furnace_lobe(g: Ggx, i: Real3) -> Real {
    let density = ggx_density(g.alpha_x, g.alpha_y, real3_add(g.wo, i));
    let stretch = real3_length(ggx_stretched(g.alpha_x, g.alpha_y, i));
    let sum = real_add(
        real_multiply(i.z, g.stretch),
        real_multiply(g.wo.z, stretch),
    );
    real_divide(real_multiply(density, real_uint(3_373_259_426, -30)), sum)
}

/// By uniform directions of the hemisphere.
#[inline]
#[must_use]
pub fn furnace_uniform(g: Ggx, u: UVec2) -> Real {
    let i = real3(uniform_hemisphere(u));
    real_multiply(furnace_lobe(g, i), i.z)
}

/// By cosine-weighted directions.
#[inline]
#[must_use]
pub fn furnace_cosine(g: Ggx, u: UVec2) -> Real {
    real_shift(furnace_lobe(g, real3(cosine_hemisphere(u))), -1)
}

/// By reflection at visible normals: G2 / G1.
#[inline]
#[must_use]
pub fn furnace_visible(g: Ggx, u: UVec2) -> Real {
    real(ggx_weight(g, ggx_vndf(g, u).direction))
}
