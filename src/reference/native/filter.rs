//! Offsets from a pixel's centre by its reconstruction filter in the native profile: box,
//! tent, truncated Gaussian, with pdf and inverse.
//!
//! Source: Ernst, Stamminger and Greiner 2006; PBRT 4th ed., 8.8. Domain: radius and
//! sigma from 1e-30 on, below it they count as that; two fractions. Pdf: with respect to
//! area; that of a sample by its fractions. Errors: 2^-21 of the radius, within what
//! Vulkan allows division, sqrt, log and exp.
//! Mirror: `shaders/corput/native/filter.glsl`.

use crate::reference::native::disk::{native_fraction, native_unit};
use crate::reference::native::free_flight::native_positive;
use crate::reference::native::normal_quantile::{
    native_normal_density, native_normal_masses, native_quantile,
};
use glam::{UVec2, Vec2, uvec2, vec2};

/// An offset from the pixel's centre, and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeFilterSample {
    /// The point.
    pub p: Vec2,
    /// Its density.
    pub pdf: f32,
}

/// A truncated Gaussian: its edge and deviation, and the masses of the normal distribution
/// from 0 to the edge and beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeFilterGaussian {
    /// The edge.
    pub radius: f32,
    /// The deviation.
    pub sigma: f32,
    /// The masses within and beyond it, on one side.
    pub masses: Vec2,
}

/// The share of its half below u's midpoint, counted from the middle, as an odd fraction.
#[inline]
#[must_use]
pub fn native_filter_share(u: u32) -> u32 {
    let upper = if u < 0x8000_0000 { !u } else { u };
    (upper << 1) | 1
}

/// x or -x.
#[inline]
#[must_use]
pub fn native_filter_side(x: f32, negative: bool) -> f32 {
    if negative { -x } else { x }
}

/// The point with these distances from the axes.
#[inline]
#[must_use]
pub fn native_filter_point(x: f32, y: f32, u: UVec2) -> Vec2 {
    vec2(
        native_filter_side(x, u.x < 0x8000_0000),
        native_filter_side(y, u.y < 0x8000_0000),
    )
}

/// The fractions with these shares of their halves.
#[inline]
#[must_use]
pub fn native_filter_fractions(x: f32, y: f32, p: Vec2) -> UVec2 {
    let right = 0.5 * native_filter_side(x, p.x < 0.0);
    let up = 0.5 * native_filter_side(y, p.y < 0.0);
    uvec2(native_fraction(0.5 + right), native_fraction(0.5 + up))
}

/// A square around the centre.
#[inline]
#[must_use]
pub fn native_filter_box(radius: f32, u: UVec2) -> NativeFilterSample {
    let r = native_positive(radius);
    let x = r * native_unit(native_filter_share(u.x));
    let y = r * native_unit(native_filter_share(u.y));
    NativeFilterSample {
        p: native_filter_point(x, y, u),
        pdf: 0.25 / r / r,
    }
}

/// 1 / (4 r^2) within the square.
#[inline]
#[must_use]
pub fn native_filter_box_pdf(radius: f32, p: Vec2) -> f32 {
    let r = native_positive(radius);
    if (p.x.abs()).max(p.y.abs()) <= r {
        0.25 / r / r
    } else {
        0.0
    }
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn native_filter_box_invert(radius: f32, p: Vec2) -> UVec2 {
    let r = native_positive(radius);
    native_filter_fractions(p.x.abs() / r, p.y.abs() / r, p)
}

/// A pyramid around the centre.
#[inline]
#[must_use]
pub fn native_filter_tent(radius: f32, u: UVec2) -> NativeFilterSample {
    let r = native_positive(radius);
    let x_share = native_filter_share(u.x);
    let y_share = native_filter_share(u.y);
    let x_height = (native_unit(0u32.wrapping_sub(x_share))).sqrt();
    let y_height = (native_unit(0u32.wrapping_sub(y_share))).sqrt();
    // 1 - (1 - a).sqrt() = a / (1 + (1 - a).sqrt()).
    let x = r * (native_unit(x_share) / (1.0 + x_height));
    let y = r * (native_unit(y_share) / (1.0 + y_height));
    NativeFilterSample {
        p: native_filter_point(x, y, u),
        pdf: x_height / r * (y_height / r),
    }
}

/// (1 - |x|/r) (1 - |y|/r) / r^2.
#[inline]
#[must_use]
pub fn native_filter_tent_pdf(radius: f32, p: Vec2) -> f32 {
    let r = native_positive(radius);
    let x = (r - p.x.abs()).max(0.0) / r;
    let y = (r - p.y.abs()).max(0.0) / r;
    x / r * (y / r)
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn native_filter_tent_invert(radius: f32, p: Vec2) -> UVec2 {
    let r = native_positive(radius);
    let x = (p.x.abs() / r).min(1.0);
    let y = (p.y.abs() / r).min(1.0);
    native_filter_fractions(x * (2.0 - x), y * (2.0 - y), p)
}

/// The Gaussian of this deviation up to this radius.
#[inline]
#[must_use]
pub fn native_filter_gaussian_prepare(radius: f32, sigma: f32) -> NativeFilterGaussian {
    let r = native_positive(radius);
    let s = native_positive(sigma);
    NativeFilterGaussian {
        radius: r,
        sigma: s,
        masses: native_normal_masses(r / s),
    }
}

/// |x| / sigma for a sample's coordinate.
#[inline]
#[must_use]
pub fn native_filter_gaussian_quantile(f: NativeFilterGaussian, u: u32) -> f32 {
    let share = native_filter_share(u);
    let rest = f.masses.x * native_unit(0u32.wrapping_sub(share));
    native_quantile(f.masses.x * native_unit(share), f.masses.y + rest)
}

/// The pdf of a coordinate's share of sigma.
#[inline]
#[must_use]
pub fn native_filter_gaussian_density(f: NativeFilterGaussian, z: f32) -> f32 {
    native_normal_density(z) / (2.0 * f.sigma * f.masses.x)
}

/// A truncated Gaussian around the centre.
#[inline]
#[must_use]
pub fn native_filter_gaussian(f: NativeFilterGaussian, u: UVec2) -> NativeFilterSample {
    let x = native_filter_gaussian_quantile(f, u.x);
    let y = native_filter_gaussian_quantile(f, u.y);
    let pdf = native_filter_gaussian_density(f, x) * native_filter_gaussian_density(f, y);
    let p = native_filter_point((x * f.sigma).min(f.radius), (y * f.sigma).min(f.radius), u);
    NativeFilterSample { p, pdf }
}

/// The truncated density.
#[inline]
#[must_use]
pub fn native_filter_gaussian_pdf(f: NativeFilterGaussian, p: Vec2) -> f32 {
    if (p.x.abs()).max(p.y.abs()) > f.radius {
        return 0.0;
    }
    native_filter_gaussian_density(f, p.x / f.sigma)
        * native_filter_gaussian_density(f, p.y / f.sigma)
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn native_filter_gaussian_invert(f: NativeFilterGaussian, p: Vec2) -> UVec2 {
    let x = native_normal_masses(p.x / f.sigma).x / f.masses.x;
    let y = native_normal_masses(p.y / f.sigma).x / f.masses.x;
    native_filter_fractions(x, y, p)
}
