//! Directions of the hemisphere around +z by a power of their cosine, with pdf and
//! inverse: cos^n lobes, of which the uniform hemisphere is n = 0 and the cosine-weighted
//! one n = 1.
//!
//! Source: PBRT 3rd ed., 14.1.1, z = (1 - u)^(1/(n + 1)), by logarithms: with w = ln(1 -
//! u) / (n + 1), z = e^w, radius = sqrt(-(e^w - 1) (1 + e^w)), where the common 1 - z^2
//! has no digits of a narrow lobe. Domain: n >= 0, any float; two fractions of 2^32. n <
//! 0 counts as 0, infinities and NaN as numbers of at least 2^128; the pdf is then at
//! most the largest float. Range: unit vectors to 2^-23, z >= 2^-32. Pdf: with respect to
//! solid angle: (n + 1)/(2 pi) z^n, 0 below the horizon; ln z by x^2 + y^2 where z is
//! near 1. It is then well conditioned: that of a sample's rounded direction is within 20
//! ULP of the exact direction's. That of a sample is (n + 1)/(2 pi) (1 - u)^(n/(n + 1)).
//! Errors: coordinates 0.6 ULP, the pdf of a sample 0.7 ULP. The inverse of a sample is
//! within 2^-23 of it, angles modulo one turn; on the axis the angle is lost. Tier I.
//! Mirror: `shaders/corput/cosine_power.glsl`.

use crate::reference::elementary::atan2;
use crate::reference::exponential::{real_exp2, real_exp2m1};
use crate::reference::free_flight::real_positive;
use crate::reference::logarithm::{log_polynomial, real_log2};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_fraction, real_less, real_max,
    real_multiply, real_negate, real_sqrt, real_square, real_uint, real_zero,
};
use crate::reference::real_angle::{real_complement, real_fraction_of};
use crate::reference::real_vector::real3;
use crate::reference::scattered::{Scattered, real3_around, scattered};
use glam::{UVec2, Vec3, uvec2};

/// n and n + 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CosinePower {
    /// The exponent.
    pub n: Real,
    /// One more.
    pub next: Real,
}

/// By n.
#[inline]
#[must_use]
pub fn cosine_power_prepare(n: f32) -> CosinePower {
    let power = real_positive(n);
    CosinePower {
        n: power,
        next: real_add(power, real_uint(1, 0)),
    }
}

/// (n + 1)/(2 pi) 2^(n w).
#[inline]
#[must_use]
pub fn cosine_power_density(lobe: CosinePower, w: Real) -> Real {
    let power = real_exp2(real_multiply(lobe.n, w));
    let over_tau = Real {
        m: 2_734_261_102,
        e: -34,
        negative: false,
    };
    real_multiply(real_multiply(lobe.next, over_tau), power)
}

/// log2 z of a unit vector, to full relative precision also next to the pole; that of the
/// horizon for what is below it.
#[inline]
#[must_use]
pub fn cosine_power_log2(direction: Vec3) -> Real {
    let d = real3(direction);
    let z = real_max(d.z, real_zero());
    let square = real_add(real_square(d.x), real_square(d.y));
    let versine = real_divide(square, real_add(z, real_uint(1, 0)));
    if real_less(versine, real_uint(1, -2)) {
        // ln(1 - v) = -v P(-v); 3098164009 = 2^31 / ln 2.
        let p = log_polynomial(real_fraction(versine), true);
        let rest = real_multiply(versine, real_uint(p, -31));
        let over_ln2 = Real {
            m: 3_098_164_009,
            e: -31,
            negative: false,
        };
        return real_negate(real_multiply(rest, over_ln2));
    }
    real_log2(z)
}

/// Direction and pdf.
#[inline]
#[must_use]
pub fn cosine_power(lobe: CosinePower, u: UVec2) -> Scattered {
    let w = real_divide(real_log2(real_complement(u.x)), lobe.next);
    let z = real_exp2(w);
    let versine = real_negate(real_exp2m1(w));
    let above = real_add(z, real_uint(1, 0));
    let radius = real_sqrt(real_multiply(versine, above));
    scattered(real3_around(radius, u.y, z), cosine_power_density(lobe, w))
}

/// The pdf of a direction.
#[inline]
#[must_use]
pub fn cosine_power_pdf(lobe: CosinePower, direction: Vec3) -> f32 {
    if real(direction.z).negative {
        return 0.0;
    }
    real_float(cosine_power_density(lobe, cosine_power_log2(direction)))
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn cosine_power_invert(lobe: CosinePower, direction: Vec3) -> UVec2 {
    let w = real_multiply(lobe.next, cosine_power_log2(direction));
    let above = real_exp2(w);
    let below = real_negate(real_exp2m1(w));
    uvec2(
        real_fraction_of(below, above),
        atan2(direction.y, direction.x),
    )
}
