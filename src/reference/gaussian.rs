//! Normal distributions of mean 0: one coordinate or two by quantiles, which keeps nets,
//! and two by the polar method, with pdf and inverse.
//!
//! Source: Box and Muller 1958 for the polar method, with 1 - u in the logarithm. Domain:
//! sigma > 0, fractions of 2^32; a quantile takes the midpoints (2 u + 1) / 2^33, so that
//! nothing is infinite. sigma <= 0 gives 0 with the largest float as its pdf; a NaN
//! counts as an infinity. Range: to 6.338 sigma by quantiles, to 6.661 sigma by the polar
//! method. Pdf: with respect to length or area, e^(-x^2 / (2 sigma^2)) / (sqrt(2 pi)
//! sigma) a coordinate. That of a sample is the one before its coordinates are rounded.
//! Errors: coordinates 0.57 ULP, polar ones 0.6 ULP; pdf of a sample 1.5 ULP a
//! coordinate, polar 0.6 ULP, of a value 1 ULP a coordinate within 6.7 sigma. An inverse
//! returns the fraction to 4 units where the float still tells: z^2 2^-24 of the tail.
//! Tier I.
//! Mirror: `shaders/corput/gaussian.glsl`.

use crate::reference::elementary::{atan2, sincos_scaled};
use crate::reference::free_flight::{exponential_fraction, real_positive};
use crate::reference::logarithm::real_negative_log;
use crate::reference::normal_quantile::{
    normal_fraction, real_normal_density, real_normal_quantile,
};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_multiply, real_scaled, real_shift,
    real_sqrt, real_square, real_uint, real_zero,
};
use crate::reference::real_angle::real_complement;
use glam::{UVec2, Vec2, uvec2, vec2};

/// A coordinate and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaussian {
    /// The coordinate.
    pub x: f32,
    /// Its density.
    pub pdf: f32,
}

/// A point and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaussianPair {
    /// The point.
    pub p: Vec2,
    /// Its density.
    pub pdf: f32,
}

/// density / sigma^2.
#[inline]
#[must_use]
pub fn gaussian_area_pdf(density: Real, sigma: Real) -> f32 {
    real_float(real_divide(density, real_square(sigma)))
}

/// One coordinate.
#[inline]
#[must_use]
pub fn gaussian(sigma: f32, u: u32) -> Gaussian {
    let s = real_positive(sigma);
    let z = real_normal_quantile(u);
    let pdf = real_divide(real_normal_density(z), s);
    Gaussian {
        x: real_float(real_multiply(z, s)),
        pdf: real_float(pdf),
    }
}

/// The pdf of one coordinate.
#[inline]
#[must_use]
pub fn gaussian_pdf(sigma: f32, x: f32) -> f32 {
    let s = real_positive(sigma);
    let z = real_divide(real(x), s);
    real_float(real_divide(real_normal_density(z), s))
}

/// The fraction that gives this coordinate.
#[inline]
#[must_use]
pub fn gaussian_invert(sigma: f32, x: f32) -> u32 {
    normal_fraction(real_divide(real(x), real_positive(sigma)))
}

/// Two coordinates by quantiles.
#[inline]
#[must_use]
pub fn normal_pair(sigma: f32, u: UVec2) -> GaussianPair {
    let s = real_positive(sigma);
    let mut density = real_uint(1, 0);
    let mut p = Vec2::ZERO;
    // One body for both coordinates: drivers inline whatever is called.
    for i in 0..2 {
        let z = real_normal_quantile(u[i]);
        density = real_multiply(density, real_normal_density(z));
        p[i] = real_float(real_multiply(z, s));
    }
    GaussianPair {
        p,
        pdf: gaussian_area_pdf(density, s),
    }
}

/// The pdf of two coordinates, whichever way they were made.
#[inline]
#[must_use]
pub fn normal_pair_pdf(sigma: f32, p: Vec2) -> f32 {
    let s = real_positive(sigma);
    let mut density = real_uint(1, 0);
    for i in 0..2 {
        let z = real_divide(real(p[i]), s);
        density = real_multiply(density, real_normal_density(z));
    }
    gaussian_area_pdf(density, s)
}

/// The fractions whose quantiles give this point.
#[inline]
#[must_use]
pub fn normal_pair_invert(sigma: f32, p: Vec2) -> UVec2 {
    let mut u = UVec2::ZERO;
    for i in 0..2 {
        u[i] = gaussian_invert(sigma, p[i]);
    }
    u
}

/// Two coordinates by the polar method: radius sqrt(-2 ln(1 - u.x)), angle 2 pi u.y.
#[inline]
#[must_use]
pub fn box_muller(sigma: f32, u: UVec2) -> GaussianPair {
    let s = real_positive(sigma);
    let mut radius = real_sqrt(real_shift(real_negative_log(u.x), 1));
    radius = real_multiply(radius, s);
    let phi = sincos_scaled(u.y);
    let x = real_multiply(radius, real_scaled(phi.cosine, phi.cosine_negative));
    let y = real_multiply(radius, real_scaled(phi.sine, phi.sine_negative));
    // 2_734_261_102 = 2^34 / (2 pi).
    let density = real_multiply(real_complement(u.x), real_uint(2_734_261_102, -34));
    GaussianPair {
        p: vec2(real_float(x), real_float(y)),
        pdf: gaussian_area_pdf(density, s),
    }
}

/// The fractions from which the polar method gives this point.
#[inline]
#[must_use]
pub fn box_muller_invert(sigma: f32, p: Vec2) -> UVec2 {
    let s = real_positive(sigma);
    let mut square = real_zero();
    for i in 0..2 {
        let z = real_divide(real(p[i]), s);
        square = real_add(square, real_square(z));
    }
    uvec2(
        exponential_fraction(real_shift(square, -1)),
        atan2(p.y, p.x),
    )
}
