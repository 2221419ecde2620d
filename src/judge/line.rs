//! Distributions of one coordinate, and of points that are made of such, in `f64`: a
//! coordinate and its density.

use super::functions::sin_cos;
use super::{negative_log, normal_density, normal_mass, normal_quantile, normal_tail};
use std::f64::consts::{PI, SQRT_2};

/// 1 - u.
fn complement(u: u32) -> f64 {
    1.0 - f64::from(u) / 4_294_967_296.0
}

/// The side of u's midpoint, and its share of that half, counted from the middle.
fn half(u: u32) -> (f64, f64) {
    let middle = (f64::from(u) + 0.5) / 2_147_483_648.0 - 1.0;
    (1f64.copysign(middle), middle.abs())
}

/// Free flight.
#[must_use]
pub fn exponential(sigma: f64, u: u32) -> [f64; 2] {
    [negative_log(u) / sigma, sigma * complement(u)]
}

/// Normal distribution.
#[must_use]
pub fn gaussian(sigma: f64, u: u32) -> [f64; 2] {
    let z = normal_quantile(u);
    [z * sigma, normal_density(z) / sigma]
}

/// Two normal distributions by the polar method.
#[must_use]
pub fn box_muller(sigma: f64, u: [u32; 2]) -> [f64; 3] {
    let radius = sigma * SQRT_2 * negative_log(u[0]).sqrt();
    let (s, c) = sin_cos(u[1]);
    let pdf = complement(u[0]) / (2.0 * PI * sigma * sigma);
    [radius * c, radius * s, pdf]
}

/// A box of this radius.
#[must_use]
pub fn filter_box(radius: f64, u: u32) -> [f64; 2] {
    let (side, share) = half(u);
    [side * share * radius, 0.5 / radius]
}

/// A tent of this radius, its distance by Newton's method on share = s (2 - s).
#[must_use]
pub fn filter_tent(radius: f64, u: u32) -> [f64; 2] {
    let (side, share) = half(u);
    // 1 - s = sqrt(1 - share), whose rest is exact.
    let height = (1.0 - share).sqrt();
    let mut s = 1.0 - height;
    for _ in 0..3 {
        s -= (s * (2.0 - s) - share) / (2.0 * (1.0 - s));
    }
    [side * s * radius, height / radius]
}

/// A Gaussian of deviation sigma up to this radius, its distance by bisection.
#[must_use]
pub fn filter_gaussian(radius: f64, sigma: f64, u: u32) -> [f64; 2] {
    let (side, share) = half(u);
    let edge = radius / sigma;
    let mass = normal_mass(edge);
    // Where little is left, what is beyond tells better than what is within.
    let beyond = normal_tail(edge) + mass * (1.0 - share);
    let below = |z: f64| {
        if share * mass < 0.45 {
            normal_mass(z) < share * mass
        } else {
            normal_tail(z) > beyond
        }
    };
    let (mut low, mut high) = (0.0, edge.min(10.0));
    while high - low > 1e-15 * high {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let z = 0.5 * (low + high);
    [side * z * sigma, normal_density(z) / (2.0 * sigma * mass)]
}

/// The 4-term window of Blackman and Harris, its distance from the middle or from the edge
/// by bisection of the integral of its cosines.
#[must_use]
pub fn filter_blackman_harris(radius: f64, u: u32) -> [f64; 2] {
    const A: [f64; 4] = [0.35875, 0.48829, 0.14128, 0.01168];
    let (side, share) = half(u);
    // Seen from the edge, the odd cosines change their sign.
    let edge = share > 0.9;
    let terms = |x: f64, f: &dyn Fn(f64, f64) -> f64| -> f64 {
        let signs = if edge { [-1.0, 1.0, -1.0] } else { [1.0; 3] };
        (1..4)
            .map(|k| signs[k - 1] * A[k] / A[0] * f(k as f64 * PI, x))
            .sum()
    };
    let mass = |x: f64| x + terms(x, &|k, x| (k * x).sin() / k);
    let target = if edge { 1.0 - share } else { share };
    let (mut low, mut high) = (0.0, 1.0);
    while high - low > 1e-16 * high {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if mass(middle) < target {
            low = middle;
        } else {
            high = middle;
        }
    }
    let x = 0.5 * (low + high);
    let distance = if edge { 1.0 - x } else { x };
    let density = 1.0 + terms(x, &|k, x| (k * x).cos());
    [side * distance * radius, density / (2.0 * radius)]
}
