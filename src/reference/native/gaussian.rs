//! Normal distributions of mean 0 in the native profile: one coordinate or two by
//! quantiles, and two by the polar method, with pdf and inverse.
//!
//! Source: Box and Muller 1958 for the polar method, with 1 - u in the logarithm. Domain:
//! sigma from 1e-30 on, below it counts as that; fractions of 2^32. Pdf: with respect to
//! length or area; that of a sample by its fractions. Errors: Vulkan allows sin and cos
//! an absolute error of 2^-11, log 3 ULP.
//! Mirror: `shaders/corput/native/gaussian.glsl`.

use crate::reference::native::disk::{native_density, native_fraction, native_turns, native_unit};
use crate::reference::native::free_flight::{native_negative_log, native_positive};
use crate::reference::native::hemisphere::native_complement;
use crate::reference::native::normal_quantile::{
    native_normal_density, native_normal_fraction, native_normal_quantile,
};
use glam::{UVec2, Vec2, uvec2, vec2};

/// A coordinate and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeGaussian {
    /// The coordinate.
    pub x: f32,
    /// Its density.
    pub pdf: f32,
}

/// A point and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeGaussianPair {
    /// The point.
    pub p: Vec2,
    /// Its density.
    pub pdf: f32,
}

/// One coordinate.
#[inline]
#[must_use]
pub fn native_gaussian(sigma: f32, u: u32) -> NativeGaussian {
    let s = native_positive(sigma);
    let z = native_normal_quantile(u);
    NativeGaussian {
        x: z * s,
        pdf: native_normal_density(z) / s,
    }
}

/// The pdf of one coordinate.
#[inline]
#[must_use]
pub fn native_gaussian_pdf(sigma: f32, x: f32) -> f32 {
    let s = native_positive(sigma);
    native_normal_density(x / s) / s
}

/// The fraction that gives this coordinate.
#[inline]
#[must_use]
pub fn native_gaussian_invert(sigma: f32, x: f32) -> u32 {
    native_normal_fraction(x / native_positive(sigma))
}

/// Two coordinates by quantiles.
#[inline]
#[must_use]
pub fn native_normal_pair(sigma: f32, u: UVec2) -> NativeGaussianPair {
    let x = native_gaussian(sigma, u.x);
    let y = native_gaussian(sigma, u.y);
    NativeGaussianPair {
        p: vec2(x.x, y.x),
        pdf: native_density(x.pdf * y.pdf),
    }
}

/// The pdf of two coordinates, whichever way they were made.
#[inline]
#[must_use]
pub fn native_normal_pair_pdf(sigma: f32, p: Vec2) -> f32 {
    native_density(native_gaussian_pdf(sigma, p.x) * native_gaussian_pdf(sigma, p.y))
}

/// The fractions whose quantiles give this point.
#[inline]
#[must_use]
pub fn native_normal_pair_invert(sigma: f32, p: Vec2) -> UVec2 {
    uvec2(
        native_gaussian_invert(sigma, p.x),
        native_gaussian_invert(sigma, p.y),
    )
}

/// Two coordinates by the polar method: radius sqrt(-2 ln(1 - u.x)), angle 2 pi u.y.
#[inline]
#[must_use]
pub fn native_box_muller(sigma: f32, u: UVec2) -> NativeGaussianPair {
    let s = native_positive(sigma);
    let radius = s * (2.0 * native_negative_log(u.x)).sqrt();
    let phi = std::f32::consts::TAU * native_unit(u.y);
    let pdf = native_density(0.159_154_94 * native_complement(u.x) / s / s);
    NativeGaussianPair {
        p: vec2(radius * phi.cos(), radius * phi.sin()),
        pdf,
    }
}

/// The fractions from which the polar method gives this point.
#[inline]
#[must_use]
pub fn native_box_muller_invert(sigma: f32, p: Vec2) -> UVec2 {
    let s = native_positive(sigma);
    let x = p.x / s;
    let y = p.y / s;
    uvec2(
        native_fraction(1.0 - (-0.5 * (x * x + y * y)).exp()),
        native_fraction(native_turns(p)),
    )
}
