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
//! ULP; pdf of a sample 0.6 ULP, the Gaussian's 2.5 ULP. Tier I.
//! Mirror: `shaders/corput/filter.glsl`.

use crate::reference::free_flight::real_positive;
use crate::reference::gaussian::gaussian_area_pdf;
use crate::reference::normal_quantile::{real_normal_density, real_normal_masses, real_quantile};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_fraction, real_less, real_max, real_min,
    real_multiply, real_shift, real_sqrt, real_subtract, real_uint, real_zero,
};
use glam::{UVec2, Vec2};

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
    let mut p = Vec2::ZERO;
    for i in 0..2 {
        let x = real_multiply(r, real_uint(filter_share(u[i]), -32));
        p[i] = filter_offset(x, r, u[i]);
    }
    FilterSample {
        p,
        pdf: gaussian_area_pdf(real_uint(1, -2), r),
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
    gaussian_area_pdf(real_uint(1, -2), r)
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn filter_box_invert(radius: f32, p: Vec2) -> UVec2 {
    let r = real_positive(radius);
    let mut u = UVec2::ZERO;
    for i in 0..2 {
        u[i] = filter_fraction(real_divide(filter_distance(p[i]), r), p[i]);
    }
    u
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
    let mut density = real_uint(1, 0);
    let mut p = Vec2::ZERO;
    for i in 0..2 {
        let share = filter_share(u[i]);
        let height = tent_height(share);
        density = real_multiply(density, height);
        p[i] = filter_offset(real_multiply(r, tent_distance(share, height)), r, u[i]);
    }
    FilterSample {
        p,
        pdf: gaussian_area_pdf(density, r),
    }
}

/// (1 - |x|/r) (1 - |y|/r) / r^2.
#[inline]
#[must_use]
pub fn filter_tent_pdf(radius: f32, p: Vec2) -> f32 {
    let r = real_positive(radius);
    let mut density = real_uint(1, 0);
    for i in 0..2 {
        let mut rest = real_subtract(r, filter_distance(p[i]));
        rest = real_max(rest, real_zero());
        density = real_multiply(density, real_divide(rest, r));
    }
    gaussian_area_pdf(density, r)
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn filter_tent_invert(radius: f32, p: Vec2) -> UVec2 {
    let r = real_positive(radius);
    let mut u = UVec2::ZERO;
    for i in 0..2 {
        u[i] = filter_fraction(tent_share(r, p[i]), p[i]);
    }
    u
}

/// The Gaussian of this deviation up to this radius.
#[inline]
#[must_use]
pub fn filter_gaussian_prepare(radius: f32, sigma: f32) -> FilterGaussian {
    let r = real_positive(radius);
    let s = real_positive(sigma);
    let edge = real_divide(r, s);
    let masses = real_normal_masses(edge);
    FilterGaussian {
        radius: r,
        sigma: s,
        mass: masses.mass,
        tail: masses.tail,
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
    let mut density = real_uint(1, 0);
    let mut p = Vec2::ZERO;
    for i in 0..2 {
        let z = filter_gaussian_quantile(f, u[i]);
        density = real_multiply(density, filter_gaussian_density(f, z));
        p[i] = filter_offset(real_multiply(z, f.sigma), f.radius, u[i]);
    }
    FilterSample {
        p,
        pdf: real_float(density),
    }
}

/// The truncated density.
#[inline]
#[must_use]
pub fn filter_gaussian_pdf(f: FilterGaussian, p: Vec2) -> f32 {
    let mut density = real_uint(1, 0);
    for i in 0..2 {
        let x = filter_distance(p[i]);
        if real_less(f.radius, x) {
            return 0.0;
        }
        let z = real_divide(x, f.sigma);
        density = real_multiply(density, filter_gaussian_density(f, z));
    }
    real_float(density)
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn filter_gaussian_invert(f: FilterGaussian, p: Vec2) -> UVec2 {
    let mut u = UVec2::ZERO;
    for i in 0..2 {
        let z = real_divide(filter_distance(p[i]), f.sigma);
        let mass = real_normal_masses(z).mass;
        u[i] = filter_fraction(real_divide(mass, f.mass), p[i]);
    }
    u
}
