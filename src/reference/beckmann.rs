//! The normals of a Beckmann microsurface, all of them by D cos, and reflection at them,
//! with pdf and inverse. Visible normals need ggx_vndf.glsl.
//!
//! Source: Beckmann and Spizzichino 1963; Walter et al. 2007, Microfacet models for
//! refraction through rough surfaces, eq. 25, 28, 29; in slopes: a normal is (alpha_x r
//! cos phi, alpha_y r sin phi, 1) / length with r^2 = -ln(1 - u). Domain: alpha of any
//! size; its sign does not count, and what is below 2^-60 counts as that. wo of any
//! length, on either side; wo = 0 has the pdf 2^128 and the sample 0. Two fractions of
//! 2^32: u.x radius, u.y angle around +z. Range: unit vectors to 2^-23; reflected
//! directions may lie below the horizon. No normal lies beyond r = 4.71, for 1 - u is at
//! least 2^-32. Pdf: with respect to solid angle: D cos of normals, D cos / (4 |wo.h|) of
//! directions, which is infinite where wo is perpendicular to the normal: the largest
//! float. Errors: normals and their pdf 0.6 ULP; directions half a ULP and 2^-26, the pdf
//! of a sample 0.6 ULP or 2^-30 / |wo.h|. The pdf of a normal 2^-23 of it, and of a
//! direction 2^-24 / alpha, see ggx_lobe.glsl. The inverse agrees with a normal to 2^-20,
//! with a direction to 2^-20 + 2^-22 / alpha. Tier I.
//! Mirror: `shaders/corput/beckmann.glsl`.

use crate::reference::exponential::{real_exp, real_exp2m1};
use crate::reference::ggx::{ggx_alpha, ggx_stretched};
use crate::reference::logarithm::real_negative_log;
use crate::reference::real::{
    Real, real_add, real_divide, real_float, real_multiply, real_negate, real_shift, real_sqrt,
    real_square, real_uint,
};
use crate::reference::real_angle::{real_complement, real_fraction_of, real_turns};
use crate::reference::real_vector::{
    Real3, real3, real3_add, real3_dot, real3_length, real3_normalize, real3_scale, real3_subtract,
};
use crate::reference::scattered::{Scattered, real3_around, scattered};
use glam::{UVec2, Vec2, Vec3, uvec2};

/// (slopes, 1), not normalised.
#[inline]
#[must_use]
pub fn beckmann_slopes(alpha: Vec2, u: UVec2) -> Real3 {
    let radius = real_sqrt(real_negative_log(u.x));
    let around = real3_around(radius, u.y, real_uint(1, 0));
    ggx_stretched(ggx_alpha(alpha.x), ggx_alpha(alpha.y), around)
}

/// D cos at the slopes, where e^-r^2 is rest.
#[inline]
#[must_use]
pub fn beckmann_density(alpha: Vec2, slopes: Real3, rest: Real) -> Real {
    let square = real3_dot(slopes, slopes);
    let area = real_multiply(ggx_alpha(alpha.x), ggx_alpha(alpha.y));
    let cube = real_multiply(square, real_sqrt(square));
    // 1 / pi.
    let scaled = real_multiply(
        rest,
        Real {
            m: 2_734_261_102,
            e: -33,
            negative: false,
        },
    );
    real_divide(real_multiply(cube, scaled), area)
}

/// The slopes of the normal h, which need not be normalised.
#[inline]
#[must_use]
pub fn beckmann_slopes_of(h: Real3) -> Real3 {
    Real3 {
        x: real_divide(h.x, h.z),
        y: real_divide(h.y, h.z),
        z: real_uint(1, 0),
    }
}

/// r^2 for the slopes.
#[inline]
#[must_use]
pub fn beckmann_square(alpha: Vec2, slopes: Real3) -> Real {
    let x = real_divide(slopes.x, ggx_alpha(alpha.x));
    let y = real_divide(slopes.y, ggx_alpha(alpha.y));
    real_add(real_square(x), real_square(y))
}

/// e^-r^2 for the slopes.
#[inline]
#[must_use]
pub fn beckmann_rest(alpha: Vec2, slopes: Real3) -> Real {
    real_exp(real_negate(beckmann_square(alpha, slopes)))
}

/// The fractions that give these slopes.
#[inline]
#[must_use]
pub fn beckmann_fractions(alpha: Vec2, slopes: Real3) -> UVec2 {
    let square = beckmann_square(alpha, slopes);
    // 1 - 2^-s with s = r^2 / ln 2.
    let s = real_multiply(
        square,
        Real {
            m: 3_098_164_009,
            e: -31,
            negative: false,
        },
    );
    let radius = real_negate(real_exp2m1(real_negate(s)));
    uvec2(
        real_fraction_of(radius, real_exp(real_negate(square))),
        real_turns(
            real_multiply(slopes.y, ggx_alpha(alpha.x)),
            real_multiply(slopes.x, ggx_alpha(alpha.y)),
        ),
    )
}

/// Normal and pdf.
#[inline]
#[must_use]
pub fn beckmann_normal(alpha: Vec2, u: UVec2) -> Scattered {
    let slopes = beckmann_slopes(alpha, u);
    scattered(
        real3_normalize(slopes),
        beckmann_density(alpha, slopes, real_complement(u.x)),
    )
}

/// The pdf of a normal: 0 for normal.z <= 0.
#[inline]
#[must_use]
pub fn beckmann_normal_pdf(alpha: Vec2, normal: Vec3) -> f32 {
    let h = real3(normal);
    if h.z.negative || h.z.m == 0 {
        return 0.0;
    }
    let slopes = beckmann_slopes_of(h);
    real_float(beckmann_density(
        alpha,
        slopes,
        beckmann_rest(alpha, slopes),
    ))
}

/// The fractions that give this normal.
#[inline]
#[must_use]
pub fn beckmann_normal_invert(alpha: Vec2, normal: Vec3) -> UVec2 {
    beckmann_fractions(alpha, beckmann_slopes_of(real3(normal)))
}

/// Direction and pdf.
#[inline]
#[must_use]
pub fn beckmann(alpha: Vec2, wo: Vec3, u: UVec2) -> Scattered {
    let o = real3_normalize(real3(wo));
    let slopes = beckmann_slopes(alpha, u);
    let square = real3_dot(slopes, slopes);
    let cosine = real3_dot(o, slopes);
    // 2 (wo.h) h - wo.
    let scale = real_shift(real_divide(cosine, square), 1);
    let wo_h = real_divide(
        Real {
            m: cosine.m,
            e: cosine.e,
            negative: false,
        },
        real_sqrt(square),
    );
    let pdf = real_divide(
        beckmann_density(alpha, slopes, real_complement(u.x)),
        real_shift(wo_h, 2),
    );
    scattered(real3_subtract(real3_scale(slopes, scale), o), pdf)
}

/// The pdf of a direction.
#[inline]
#[must_use]
pub fn beckmann_pdf(alpha: Vec2, wo: Vec3, wi: Vec3) -> f32 {
    let o = real3_normalize(real3(wo));
    let h = real3_add(real3_normalize(real3(wi)), o);
    if h.z.m == 0 {
        return 0.0;
    }
    let slopes = beckmann_slopes_of(h);
    // |wo.h| is half the length of the sum.
    real_float(real_divide(
        beckmann_density(alpha, slopes, beckmann_rest(alpha, slopes)),
        real_shift(real3_length(h), 1),
    ))
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn beckmann_invert(alpha: Vec2, wo: Vec3, wi: Vec3) -> UVec2 {
    let o = real3_normalize(real3(wo));
    let h = real3_add(real3_normalize(real3(wi)), o);
    beckmann_fractions(alpha, beckmann_slopes_of(h))
}
