//! Distributions over directions in `f64`, by angles rather than by the products that the
//! shaders form.

use super::functions::sin_cos;
use super::negative_log;
use std::f64::consts::{PI, TAU};

/// A fraction of 2^32.
fn unit(u: u32) -> f64 {
    f64::from(u) / 4_294_967_296.0
}

/// Uniform direction of the sphere: the polar angle is 2 asin(sqrt(u)).
#[must_use]
pub fn uniform_sphere(u: [u32; 2]) -> [f64; 3] {
    cone(2.0, u)
}

/// Uniform direction of the cone with 1 - cos(theta_max) = h, by its polar angle, which is
/// 2 asin(sqrt(u h / 2)).
#[must_use]
pub fn cone(h: f32, u: [u32; 2]) -> [f64; 3] {
    around(f64::from(h), u)
}

/// The same for h in `f64`.
pub(super) fn around(h: f64, u: [u32; 2]) -> [f64; 3] {
    let theta = 2.0 * (unit(u[0]) * h / 2.0).sqrt().asin();
    let (s, c) = sin_cos(u[1]);
    // One rounding, as z is small where the product is near 1.
    let z = (-unit(u[0])).mul_add(h, 1.0);
    [theta.sin() * c, theta.sin() * s, z]
}

/// 1/(2 pi h) where the angle to +z is at most theta_max.
#[must_use]
pub fn cone_pdf(h: f32, direction: [f64; 3]) -> f64 {
    let theta = direction[0].hypot(direction[1]).atan2(direction[2]);
    let widest = 2.0 * (f64::from(h) / 2.0).sqrt().asin();
    if theta <= widest {
        1.0 / (TAU * f64::from(h))
    } else {
        0.0
    }
}

/// The solid angle of the cone.
#[must_use]
pub fn cone_solid_angle(h: f32) -> f64 {
    4.0 * PI * (f64::from(h) / 2.0)
}

/// Direction of a cos^n lobe and its pdf, by the polar angle 2 asin(sqrt((1 - z)/2)).
#[must_use]
pub fn cosine_power(n: f64, u: [u32; 2]) -> [f64; 4] {
    let w = -negative_log(u[0]) / (n + 1.0);
    let theta = 2.0 * (-0.5 * w.exp_m1()).sqrt().asin();
    let (s, c) = sin_cos(u[1]);
    let pdf = (n + 1.0) / TAU * (n * w).exp();
    [theta.sin() * c, theta.sin() * s, w.exp(), pdf]
}
