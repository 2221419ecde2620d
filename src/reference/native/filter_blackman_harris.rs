//! Offsets from a pixel's centre by the 4-term window of Blackman and Harris in the
//! native profile, with pdf and inverse.
//!
//! Source: as filter_blackman_harris.glsl, in float. Domain: radius from 1e-30 on, below
//! it counts as that; two fractions. Pdf: with respect to area; that of a sample by its
//! fractions. Errors: 2^-20 of the radius, 2^-17 of the pdf of a sample.
//! Mirror: `shaders/corput/native/filter_blackman_harris.glsl`.

use crate::reference::native::disk::native_unit;
use crate::reference::native::filter::{
    NativeFilterSample, native_filter_fractions, native_filter_point, native_filter_share,
    native_filter_side,
};
use crate::reference::native::free_flight::native_positive;
use glam::{UVec2, Vec2};

/// A distance of at most half the radius, as a share of it: from the middle or the edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeBlackmanHarris {
    /// The distance.
    pub x: f32,
    /// Whether from the edge.
    pub edge: bool,
}

/// w / a0 in the middle, or at the edge.
#[inline]
#[must_use]
pub fn native_blackman_harris_end(edge: bool) -> f32 {
    if edge { 0.000167247387 } else { 2.78745645 }
}

/// |mass / x - end| / z.
#[inline]
#[must_use]
pub fn native_blackman_harris_integral(z: f32, edge: bool) -> f32 {
    if edge {
        let mut p = 6.16367906e-05 - z * 4.08140477e-06;
        p = 0.000567001291 - z * p;
        p = 0.00348306773 - z * p;
        p = 0.0116596044 - z * p;
        p = 0.000323287677 + z * p;
        p = 0.116827272 - z * p;
        return 0.0324287001 + z * p;
    }
    let mut p = 6.70962036e-05 - z * 4.25893813e-06;
    p = 0.000683878548 - z * p;
    p = 0.00533088297 - z * p;
    p = 0.0322542656 - z * p;
    p = 0.149917368 - z * p;
    p = 0.522520295 - z * p;
    1.32801775 - z * p
}

/// |density - end| / z.
#[inline]
#[must_use]
pub fn native_blackman_harris_slope(z: f32, edge: bool) -> f32 {
    if edge {
        let mut p = 8.75503756e-05 - z * 5.07803634e-06;
        p = 0.000950583257 - z * p;
        p = 0.00739008887 - z * p;
        p = 0.0383212992 - z * p;
        p = 0.104938009 - z * p;
        p = 0.00226286193 + z * p;
        p = 0.584136355 - z * p;
        return 0.0972861005 + z * p;
    }
    let mut p = 9.09175724e-05 - z * 5.17535955e-06;
    p = 0.00103297643 - z * p;
    p = 0.00890985411 - z * p;
    p = 0.0586474137 - z * p;
    p = 0.290289988 - z * p;
    p = 1.04942173 - z * p;
    p = 2.61260148 - z * p;
    3.98405324 - z * p
}

/// w / a0 there: the density of the distance.
#[inline]
#[must_use]
pub fn native_blackman_harris_density(at: NativeBlackmanHarris) -> f32 {
    let z = 4.0 * at.x * at.x;
    let rest = z * native_blackman_harris_slope(z, at.edge);
    native_blackman_harris_end(at.edge) + native_filter_side(rest, !at.edge)
}

/// The mass of the half between there and the middle or the edge.
#[inline]
#[must_use]
pub fn native_blackman_harris_mass(at: NativeBlackmanHarris) -> f32 {
    let z = 4.0 * at.x * at.x;
    let rest = z * native_blackman_harris_integral(z, at.edge);
    at.x * (native_blackman_harris_end(at.edge) + native_filter_side(rest, !at.edge))
}

/// Where this share of the half, a fraction of 2^32 other than 0, lies within.
#[inline]
#[must_use]
pub fn native_blackman_harris_quantile(share: u32) -> NativeBlackmanHarris {
    let edge = share > 3_993_430_636;
    let mass = native_unit(if edge {
        0u32.wrapping_sub(share)
    } else {
        share
    });
    let mut x = mass / native_blackman_harris_end(edge);
    if edge {
        x = x.min(mass.sqrt().sqrt()).min(0.5);
    }
    let mut at = NativeBlackmanHarris { x, edge };
    for _ in 0..5 {
        let excess = native_blackman_harris_mass(at) - mass;
        at.x -= excess / native_blackman_harris_density(at);
    }
    at
}

/// Where |x| lies, at most the radius.
#[inline]
#[must_use]
pub fn native_blackman_harris_locate(radius: f32, x: f32) -> NativeBlackmanHarris {
    let d = x.abs();
    let rest = (radius - d).max(0.0);
    if d < rest {
        return NativeBlackmanHarris {
            x: d / radius,
            edge: false,
        };
    }
    NativeBlackmanHarris {
        x: rest / radius,
        edge: true,
    }
}

/// The window around the centre.
#[inline]
#[must_use]
pub fn native_filter_blackman_harris(radius: f32, u: UVec2) -> NativeFilterSample {
    let r = native_positive(radius);
    let x = native_blackman_harris_quantile(native_filter_share(u.x));
    let y = native_blackman_harris_quantile(native_filter_share(u.y));
    let right = if x.edge { 1.0 - x.x } else { x.x };
    let up = if y.edge { 1.0 - y.x } else { y.x };
    let p = native_filter_point(r * right, r * up, u);
    let pdf = native_blackman_harris_density(x) / r * (native_blackman_harris_density(y) / r);
    NativeFilterSample { p, pdf: 0.25 * pdf }
}

/// w(x/r) w(y/r) / (2 a0 r)^2 within the square.
#[inline]
#[must_use]
pub fn native_filter_blackman_harris_pdf(radius: f32, p: Vec2) -> f32 {
    let r = native_positive(radius);
    if (p.x.abs()).max(p.y.abs()) > r {
        return 0.0;
    }
    let x = native_blackman_harris_density(native_blackman_harris_locate(r, p.x));
    let y = native_blackman_harris_density(native_blackman_harris_locate(r, p.y));
    0.25 * (x / r) * (y / r)
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn native_filter_blackman_harris_invert(radius: f32, p: Vec2) -> UVec2 {
    let r = native_positive(radius);
    let x = native_blackman_harris_locate(r, p.x);
    let y = native_blackman_harris_locate(r, p.y);
    let right = native_blackman_harris_mass(x);
    let up = native_blackman_harris_mass(y);
    native_filter_fractions(
        if x.edge { 1.0 - right } else { right },
        if y.edge { 1.0 - up } else { up },
        p,
    )
}
