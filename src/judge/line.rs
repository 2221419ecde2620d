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

/// The filter of Mitchell and Netravali 1988, eq. 8.
#[must_use]
pub fn mitchell(b: f64, c: f64, t: f64) -> f64 {
    let x = t.abs();
    let sum = if x < 1.0 {
        (12.0 - 9.0 * b - 6.0 * c) * x.powi(3) + (12.0 * b + 6.0 * c - 18.0) * x * x + 6.0 - 2.0 * b
    } else if x < 2.0 {
        -(b + 6.0 * c) * x.powi(3) + (6.0 * b + 30.0 * c) * x * x - (12.0 * b + 48.0 * c) * x
            + 8.0 * b
            + 24.0 * c
    } else {
        0.0
    };
    sum / 6.0
}

/// The integral of |f| between two places of no change of sign, by the rule of Gauss and
/// Legendre, which is exact for cubics.
fn mitchell_mass(b: f64, c: f64, from: f64, to: f64) -> f64 {
    let (middle, reach) = (0.5 * (from + to), 0.5 * (to - from));
    let node = reach / 3f64.sqrt();
    let sum = mitchell(b, c, middle - node).abs() + mitchell(b, c, middle + node).abs();
    (sum * reach).abs()
}

/// The shares of one side beyond 1 and beyond the change of sign, and the integral of |f|
/// over one side.
#[must_use]
pub fn mitchell_shares(b: f64, c: f64) -> [f64; 3] {
    let zero = if c == 0.0 {
        2.0
    } else {
        2.0 - 6.0 * c / (b + 6.0 * c)
    };
    let (outer, lobe) = (
        mitchell_mass(b, c, 1.0, zero),
        mitchell_mass(b, c, zero, 2.0),
    );
    let total = mitchell_mass(b, c, 0.0, 1.0) + outer + lobe;
    [(outer + lobe) / total, lobe / total, total]
}

/// The magnitude of the filter of this radius, B and C, by bisection within its parts, which
/// begin at these shares of 2^32.
#[must_use]
pub fn filter_mitchell([radius, b, c]: [f64; 3], shares: [u32; 2], u: u32) -> [f64; 2] {
    let (side, share) = half(u);
    let rest = 1.0 - share;
    let [tail, lobe] = shares.map(|k| f64::from(k) / 4_294_967_296.0);
    let zero = if c == 0.0 {
        2.0
    } else {
        2.0 - 6.0 * c / (b + 6.0 * c)
    };
    let total = mitchell_shares(b, c)[2];
    // From where, to where, and what mass lies between.
    let (from, to, part) = if rest > 0.5 {
        (0.0, 1.0, share)
    } else if rest > tail {
        (1.0, 0.0, rest - tail)
    } else if rest > lobe {
        (zero, 1.0, rest - lobe)
    } else if rest > 0.5 * lobe {
        (zero, 2.0, lobe - rest)
    } else {
        (2.0, zero, rest)
    };
    let (mut low, mut high) = (0.0, f64::abs(to - from));
    let at = |z: f64| from + z * (to - from).signum();
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if mitchell_mass(b, c, from, at(middle)) < part * total {
            low = middle;
        } else {
            high = middle;
        }
    }
    let t = at(0.5 * (low + high));
    let density = mitchell(b, c, t).abs() / (total * radius);
    [side * t * 0.5 * radius, density]
}
