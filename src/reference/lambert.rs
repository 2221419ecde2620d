//! Estimators of the irradiance of a surface that faces +z: under a sky of radiance
//! 1 + gradient cos t, and under a light of radiance 1 that is seen as a spherical triangle.
//! For each sample, radiance times cos t over its pdf.
//!
//! Source: Moon and Spencer 1942, gradient 2 is the overcast sky of the CIE; Lambert 1760,
//! Photometria; Veach and Guibas 1995, SIGGRAPH. Domain: fractions of 2^32; a gradient of at
//! least 0; a triangle above the horizon. Range: each sample within 2^-22 of itself but for
//! directions that lie within 2^-23 of a side of the triangle, which may count as on its
//! other side. Tier I.
//! Mirror: `shaders/corput/lambert.glsl`.

use crate::reference::hemisphere::{cosine_hemisphere, uniform_hemisphere};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_multiply, real_shift, real_uint, real_zero,
};
use crate::reference::real_vector::{Real3, real3, real3_dot};
use crate::reference::spherical_triangle::{SphericalTriangle, spherical_triangle};
use glam::{UVec2, UVec3, Vec3Swizzles};

/// 1 + gradient z.
#[inline]
#[must_use]
pub fn sky_radiance(gradient: Real, z: Real) -> Real {
    real_add(real_uint(1, 0), real_multiply(gradient, z))
}

/// The sky by uniform directions: 2 pi cos t L.
#[inline]
#[must_use]
pub fn sky_uniform(gradient: Real, u: UVec2) -> Real {
    let z = real(uniform_hemisphere(u).z);
    let weight = real_multiply(z, real_uint(3_373_259_426, -29));
    real_multiply(weight, sky_radiance(gradient, z))
}

/// The sky by cosine-weighted directions: pi L.
#[inline]
#[must_use]
pub fn sky_cosine(gradient: Real, u: UVec2) -> Real {
    let z = real(cosine_hemisphere(u).z);
    real_multiply(real_uint(3_373_259_426, -30), sky_radiance(gradient, z))
}

/// Whether a direction is in the triangle, by the exact planes of its sides.
#[inline]
#[must_use]
pub fn lambert_inside(t: SphericalTriangle, d: Real3) -> bool {
    let outside = u32::from(real3_dot(t.ab_normal, d).negative)
        | u32::from(real3_dot(t.bc_normal, d).negative)
        | u32::from(real3_dot(t.ca_normal, d).negative);
    outside == 0
}

/// The triangle by uniform directions: 2 pi cos t inside.
#[inline]
#[must_use]
pub fn lambert_uniform(t: SphericalTriangle, u: UVec2) -> Real {
    let d = real3(uniform_hemisphere(u));
    let mut weight = real_multiply(d.z, real_uint(3_373_259_426, -29));
    if !lambert_inside(t, d) {
        weight = real_zero();
    }
    weight
}

/// The triangle by cosine-weighted directions: pi inside.
#[inline]
#[must_use]
pub fn lambert_cosine(t: SphericalTriangle, u: UVec2) -> Real {
    let mut weight = real_uint(3_373_259_426, -30);
    if !lambert_inside(t, real3(cosine_hemisphere(u))) {
        weight = real_zero();
    }
    weight
}

/// The triangle by its own directions: cos t times its solid angle.
#[inline]
#[must_use]
pub fn lambert_light(t: SphericalTriangle, u: UVec2) -> Real {
    let z = real(spherical_triangle(t, u).z);
    real_multiply(z, real_multiply(t.area, real_uint(3_373_259_426, -28)))
}

/// A cosine-weighted direction for half of all u.z and one of the triangle for the others,
/// with the balance heuristic: cos t over the mean of both pdfs inside.
#[inline]
#[must_use]
pub fn lambert_mis(t: SphericalTriangle, u: UVec3) -> Real {
    let mut d = real3(cosine_hemisphere(u.xy()));
    let mut inside = lambert_inside(t, d);
    let other = spherical_triangle(t, u.xy());
    if u.z >= 0x8000_0000 {
        d = real3(other);
        inside = true;
    }
    // 1/pi and 1/(4 pi) to 32 bits.
    let cosine = real_multiply(d.z, real_uint(2_734_261_102, -33));
    let light = real_divide(real_uint(2_734_261_102, -35), t.area);
    let both = real_add(cosine, light);
    let mut weight = real_divide(real_shift(d.z, 1), both);
    if !inside {
        weight = real_zero();
    }
    weight
}
