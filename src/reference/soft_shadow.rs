//! Estimators of the irradiance of a surface that faces +z under a spherical light of
//! radiance 1, behind an edge that hides a part of it: for each sample that meets the light
//! on the open side, cos t over its pdf.
//!
//! Source: Cook, Porter and Carpenter 1984, SIGGRAPH; PBRT 4th ed., 6.2.4; Veach and Guibas
//! 1995, SIGGRAPH. Domain: fractions of 2^32; a light of `sphere_light` above the horizon,
//! seen from outside; the edge's plane through the origin, given its normal to the open side.
//! Range: a direction within 2^-22 of the light's rim, or of the edge, may count as on its
//! other side. Tier I.
//! Mirror: `shaders/corput/soft_shadow.glsl`.

use crate::reference::cone::cone_density;
use crate::reference::hemisphere::{cosine_hemisphere, uniform_hemisphere};
use crate::reference::real::{
    Real, real_add, real_divide, real_less, real_multiply, real_shift, real_subtract, real_uint,
    real_zero,
};
use crate::reference::real_vector::{Real3, real3, real3_dot};
use crate::reference::sphere_light::{SphereLight, sphere_light};
use glam::{UVec2, UVec3, Vec3Swizzles};

/// A weight where a direction is on the open side, else 0.
#[inline]
#[must_use]
pub fn shadow_open(edge: Real3, d: Real3, weight: Real) -> Real {
    let mut value = weight;
    if real3_dot(edge, d).negative {
        value = real_zero();
    }
    value
}

/// A weight where a direction meets the light on the open side, else 0.
#[inline]
#[must_use]
pub fn shadow_met(light: SphereLight, edge: Real3, d: Real3, weight: Real) -> Real {
    let mut value = shadow_open(edge, d, weight);
    let versine = real_subtract(real_uint(1, 0), real3_dot(light.frame.normal, d));
    if !real_less(versine, light.h) {
        value = real_zero();
    }
    value
}

/// By uniform directions of the hemisphere: 2 pi cos t.
#[inline]
#[must_use]
pub fn shadow_uniform(light: SphereLight, edge: Real3, u: UVec2) -> Real {
    let d = real3(uniform_hemisphere(u));
    let weight = real_multiply(d.z, real_uint(3_373_259_426, -29));
    shadow_met(light, edge, d, weight)
}

/// By cosine-weighted directions: pi.
#[inline]
#[must_use]
pub fn shadow_cosine(light: SphereLight, edge: Real3, u: UVec2) -> Real {
    let d = real3(cosine_hemisphere(u));
    shadow_met(light, edge, d, real_uint(3_373_259_426, -30))
}

/// By directions of the light: cos t times its solid angle, 2 pi h.
#[inline]
#[must_use]
pub fn shadow_light(light: SphereLight, edge: Real3, u: UVec2) -> Real {
    let d = real3(sphere_light(light, u));
    let angle = real_multiply(light.h, real_uint(3_373_259_426, -29));
    shadow_open(edge, d, real_multiply(d.z, angle))
}

/// A cosine-weighted direction for half of all u.z and one of the light for the others, with
/// the balance heuristic: cos t over the mean of both pdfs.
#[inline]
#[must_use]
pub fn shadow_mis(light: SphereLight, edge: Real3, u: UVec3) -> Real {
    let mut d = real3(cosine_hemisphere(u.xy()));
    let versine = real_subtract(real_uint(1, 0), real3_dot(light.frame.normal, d));
    let mut inside = real_less(versine, light.h);
    let other = sphere_light(light, u.xy());
    if u.z >= 0x8000_0000 {
        d = real3(other);
        inside = true;
    }
    // 1/pi to 32 bits.
    let cosine = real_multiply(d.z, real_uint(2_734_261_102, -33));
    let both = real_add(cosine, cone_density(light.h));
    let mut value = shadow_open(edge, d, real_divide(real_shift(d.z, 1), both));
    if !inside {
        value = real_zero();
    }
    value
}
