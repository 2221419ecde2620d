//! Points of the annulus between an inner radius and 1 in the native profile, uniformly, with
//! pdf and inverse.
//!
//! Source: inversion of the radial CDF: r^2 = i^2 + u (1 - i) (1 + i). Domain: an inner radius i
//! from 0 to 1, others count as the nearest of them; two fractions of 2^32; i = 1: points of
//! the circle, with pdf 0. Pdf: with respect to area, 1 / (pi (1 - i) (1 + i)) inside, edges
//! widened by 2^-10.
//! Mirror: `shaders/corput/native/annulus.glsl`.

use crate::reference::native::disk::{native_fraction, native_turns, native_unit};
use glam::{UVec2, Vec2, uvec2, vec2};

/// The inner radius within its domain.
#[must_use]
pub fn native_annulus_inner(inner: f32) -> f32 {
    if inner > 0.0 { inner.min(1.0) } else { 0.0 }
}

/// Uniform point of the annulus: |p|^2 = i^2 + u.x (1 - i^2), at the angle 2 pi u.y.
#[must_use]
pub fn native_annulus(inner: f32, u: UVec2) -> Vec2 {
    let i = native_annulus_inner(inner);
    let radius = (i * i + native_unit(u.x) * ((1.0 - i) * (1.0 + i))).sqrt();
    let phi = std::f32::consts::TAU * native_unit(u.y);
    vec2(radius * phi.cos(), radius * phi.sin())
}

/// 1/(pi (1 - i^2)) inside, else 0.
#[must_use]
pub fn native_annulus_pdf(inner: f32, p: Vec2) -> f32 {
    let i = native_annulus_inner(inner);
    let width = (1.0 - i) * (1.0 + i);
    let square = p.x * p.x + p.y * p.y;
    let inside = width > 0.0 && square >= i * i * 0.9990234 && square <= 1.0009766;
    if inside {
        std::f32::consts::FRAC_1_PI / width
    } else {
        0.0
    }
}

/// The fractions that give this point.
#[must_use]
pub fn native_annulus_invert(inner: f32, p: Vec2) -> UVec2 {
    let i = native_annulus_inner(inner);
    let radius = (p.x * p.x + p.y * p.y).sqrt();
    let part = (radius - i) * (radius + i) / ((1.0 - i) * (1.0 + i)).max(1e-37);
    uvec2(native_fraction(part), native_fraction(native_turns(p)))
}
