//! Offsets from a pixel's centre by its reconstruction filter: box, tent, truncated
//! Gaussian, as products of two coordinates, with pdf and inverse.
//!
//! Source: Ernst, Stamminger and Greiner 2006, Filter importance sampling; PBRT 4th ed.,
//! 8.8; the Gaussian by the quantile of its part between the edges. Domain: radius > 0,
//! sigma > 0, two fractions of 2^32, which stand for midpoints of their parts. radius <=
//! 0 gives the centre; sigma <= 0 likewise, with a pdf that the largest float bounds; a
//! NaN counts as an infinity. Range: coordinates from -radius to radius. Pdf: with
//! respect to area: 1 / (2 r), (1 - |x|/r) / r, and the normal density over the mass
//! between the edges, a coordinate; 0 beyond the radius. That of a sample is the one
//! before its coordinates are rounded. Errors: coordinates 0.54 ULP, the Gaussian's 0.6
//! ULP; pdf of a sample 0.6 ULP, of the Gaussian 1 ULP. Tier I.
//! Mirror: `shaders/corput/filter.glsl`.

use crate::reference::free_flight::real_positive;
use crate::reference::gaussian::gaussian_area_pdf;
use crate::reference::normal_quantile::{
    real_normal_density, real_normal_mass, real_normal_tail, real_quantile,
};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_fraction, real_less, real_max, real_min,
    real_multiply, real_shift, real_sqrt, real_square, real_subtract, real_uint, real_zero,
};
use glam::{UVec2, Vec2, uvec2, vec2};

/// An offset from the pixel's centre, and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilterSample {
    /// The point.
    pub p: Vec2,
    /// Its density.
    pub pdf: f32,
}

/// A truncated Gaussian: its edge and deviation, and the mass of the normal distribution
/// from 0 to the edge and beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilterGaussian {
    /// The edge.
    pub radius: Real,
    /// The deviation.
    pub sigma: Real,
    /// The mass within the edge, on one side.
    pub mass: Real,
    /// The mass beyond it.
    pub tail: Real,
}

/// The share of its half below u's midpoint, counted from the middle, as a fraction of
/// 2^32: an odd number.
#[inline]
#[must_use]
pub fn filter_share(u: u32) -> u32 {
    let upper = if u < 0x8000_0000 { !u } else { u };
    (upper << 1) | 1
}

/// The fraction with this share of the half on x's side.
#[inline]
#[must_use]
pub fn filter_fraction(share: Real, x: f32) -> u32 {
    let half_u = real_fraction(share) >> 1;
    if x.to_bits() > 0x8000_0000 {
        0x7fff_ffff - half_u
    } else {
        0x8000_0000 | half_u
    }
}

/// The float of this distance, at most the radius, on the side of u.
#[inline]
#[must_use]
pub fn filter_offset(d: Real, radius: Real, u: u32) -> f32 {
    let nearer = real_min(d, radius);
    real_float(Real {
        m: nearer.m,
        e: nearer.e,
        negative: nearer.m != 0 && u < 0x8000_0000,
    })
}

/// The point with these distances from the axes.
#[inline]
#[must_use]
pub fn filter_point(x: Real, y: Real, radius: Real, u: UVec2) -> Vec2 {
    vec2(filter_offset(x, radius, u.x), filter_offset(y, radius, u.y))
}

/// The fractions with these shares of their halves.
#[inline]
#[must_use]
pub fn filter_fractions(x: Real, y: Real, p: Vec2) -> UVec2 {
    uvec2(filter_fraction(x, p.x), filter_fraction(y, p.y))
}

/// |x|.
#[inline]
#[must_use]
pub fn filter_distance(x: f32) -> Real {
    real(f32::from_bits(x.to_bits() & 0x7fff_ffff))
}

/// A square around the centre.
#[inline]
#[must_use]
pub fn filter_box(radius: f32, u: UVec2) -> FilterSample {
    let r = real_positive(radius);
    let x = real_multiply(r, real_uint(filter_share(u.x), -32));
    let y = real_multiply(r, real_uint(filter_share(u.y), -32));
    let pdf = real_divide(real_uint(1, -2), real_square(r));
    FilterSample {
        p: filter_point(x, y, r, u),
        pdf: real_float(pdf),
    }
}

/// 1 / (4 r^2) within the square.
#[inline]
#[must_use]
pub fn filter_box_pdf(radius: f32, p: Vec2) -> f32 {
    let r = real_positive(radius);
    if real_less(r, real_max(filter_distance(p.x), filter_distance(p.y))) {
        return 0.0;
    }
    real_float(real_divide(real_uint(1, -2), real_square(r)))
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn filter_box_invert(radius: f32, p: Vec2) -> UVec2 {
    let r = real_positive(radius);
    let x = real_divide(filter_distance(p.x), r);
    let y = real_divide(filter_distance(p.y), r);
    filter_fractions(x, y, p)
}

/// 1 - |x|/r for a sample's coordinate: the root of what lies outside.
#[inline]
#[must_use]
pub fn tent_height(share: u32) -> Real {
    real_sqrt(real_uint(0u32.wrapping_sub(share), -32))
}

/// |x|/r for a sample's coordinate.
#[inline]
#[must_use]
pub fn tent_distance(share: u32, height: Real) -> Real {
    // 1 - (1 - a).sqrt() = a / (1 + (1 - a).sqrt()).
    real_divide(real_uint(share, -32), real_add(real_uint(1, 0), height))
}

/// The share of the half within |x|.
#[inline]
#[must_use]
pub fn tent_share(radius: Real, x: f32) -> Real {
    let d = real_min(real_divide(filter_distance(x), radius), real_uint(1, 0));
    real_multiply(d, real_subtract(real_uint(2, 0), d))
}

/// A pyramid around the centre.
#[inline]
#[must_use]
pub fn filter_tent(radius: f32, u: UVec2) -> FilterSample {
    let r = real_positive(radius);
    let share = uvec2(filter_share(u.x), filter_share(u.y));
    let x_height = tent_height(share.x);
    let y_height = tent_height(share.y);
    let x = real_multiply(r, tent_distance(share.x, x_height));
    let y = real_multiply(r, tent_distance(share.y, y_height));
    let pdf = gaussian_area_pdf(real_multiply(x_height, y_height), r);
    FilterSample {
        p: filter_point(x, y, r, u),
        pdf,
    }
}

/// (1 - |x|/r) (1 - |y|/r) / r^2.
#[inline]
#[must_use]
pub fn filter_tent_pdf(radius: f32, p: Vec2) -> f32 {
    let r = real_positive(radius);
    let x = real_max(real_subtract(r, filter_distance(p.x)), real_zero());
    let y = real_max(real_subtract(r, filter_distance(p.y)), real_zero());
    gaussian_area_pdf(real_multiply(real_divide(x, r), real_divide(y, r)), r)
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn filter_tent_invert(radius: f32, p: Vec2) -> UVec2 {
    let r = real_positive(radius);
    filter_fractions(tent_share(r, p.x), tent_share(r, p.y), p)
}

/// The Gaussian of this deviation up to this radius.
#[inline]
#[must_use]
pub fn filter_gaussian_prepare(radius: f32, sigma: f32) -> FilterGaussian {
    let r = real_positive(radius);
    let s = real_positive(sigma);
    let edge = real_divide(r, s);
    FilterGaussian {
        radius: r,
        sigma: s,
        mass: real_normal_mass(edge),
        tail: real_normal_tail(edge),
    }
}

/// |x| / sigma for a sample's coordinate.
#[inline]
#[must_use]
pub fn filter_gaussian_quantile(f: FilterGaussian, u: u32) -> Real {
    let share = filter_share(u);
    let mass = real_multiply(f.mass, real_uint(share, -32));
    let rest = real_multiply(f.mass, real_uint(0u32.wrapping_sub(share), -32));
    real_quantile(mass, real_add(f.tail, rest))
}

/// The pdf of a coordinate's share of sigma.
#[inline]
#[must_use]
pub fn filter_gaussian_density(f: FilterGaussian, z: Real) -> Real {
    let scale = real_multiply(f.sigma, real_shift(f.mass, 1));
    real_divide(real_normal_density(z), scale)
}

/// A truncated Gaussian around the centre.
#[inline]
#[must_use]
pub fn filter_gaussian(f: FilterGaussian, u: UVec2) -> FilterSample {
    let mut x = filter_gaussian_quantile(f, u.x);
    let mut y = filter_gaussian_quantile(f, u.y);
    let mut pdf = filter_gaussian_density(f, x);
    pdf = real_multiply(pdf, filter_gaussian_density(f, y));
    x = real_multiply(x, f.sigma);
    y = real_multiply(y, f.sigma);
    FilterSample {
        p: filter_point(x, y, f.radius, u),
        pdf: real_float(pdf),
    }
}

/// The truncated density.
#[inline]
#[must_use]
pub fn filter_gaussian_pdf(f: FilterGaussian, p: Vec2) -> f32 {
    let mut x = filter_distance(p.x);
    let mut y = filter_distance(p.y);
    if real_less(f.radius, real_max(x, y)) {
        return 0.0;
    }
    x = filter_gaussian_density(f, real_divide(x, f.sigma));
    y = filter_gaussian_density(f, real_divide(y, f.sigma));
    real_float(real_multiply(x, y))
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn filter_gaussian_invert(f: FilterGaussian, p: Vec2) -> UVec2 {
    let x = real_normal_mass(real_divide(filter_distance(p.x), f.sigma));
    let y = real_normal_mass(real_divide(filter_distance(p.y), f.sigma));
    filter_fractions(real_divide(x, f.mass), real_divide(y, f.mass), p)
}
