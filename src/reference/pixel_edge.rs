//! Estimators of a pixel's value at an edge, seen through a tent filter: the filtered share of
//! one side of a straight line.
//!
//! Source: Ernst, Stamminger and Greiner 2006, Filter importance sampling; PBRT 4th ed., 8.8.
//! Domain: fractions of 2^32, which stand for midpoints of their parts; the edge x nx + y ny =
//! offset, given (nx, ny, offset), in units of the filter's radius. Range: by the filter 0 or
//! 1, uniform from 0 to 4, within 2^-29; a point within 2^-28 of the edge may count as on its
//! other side. Tier I.
//! Mirror: `shaders/corput/pixel_edge.glsl`.

use crate::reference::filter::{filter_share, tent_distance, tent_height};
use crate::reference::real::{
    Real, real_add, real_less, real_multiply, real_shift, real_uint, real_zero,
};
use crate::reference::real_vector::Real3;
use glam::UVec2;

/// A distance on the side of u.
#[inline]
#[must_use]
pub fn pixel_coordinate(d: Real, u: u32) -> Real {
    Real {
        m: d.m,
        e: d.e,
        negative: u < 0x8000_0000,
    }
}

/// A weight where a point is below the edge, else 0.
#[inline]
#[must_use]
pub fn pixel_side(edge: Real3, x: Real, y: Real, weight: Real) -> Real {
    let across = real_add(real_multiply(edge.x, x), real_multiply(edge.y, y));
    let mut value = weight;
    if !real_less(across, edge.z) {
        value = real_zero();
    }
    value
}

/// By points that are uniform in the filter's square: 4 (1 - |x|) (1 - |y|).
#[inline]
#[must_use]
pub fn pixel_uniform(edge: Real3, u: UVec2) -> Real {
    let a = filter_share(u.x);
    let b = filter_share(u.y);
    let x = pixel_coordinate(real_uint(a, -32), u.x);
    let y = pixel_coordinate(real_uint(b, -32), u.y);
    let rest = |share: u32| real_uint(0u32.wrapping_sub(share), -32);
    let height = real_multiply(rest(a), rest(b));
    pixel_side(edge, x, y, real_shift(height, 2))
}

/// By the filter: 1.
#[inline]
#[must_use]
pub fn pixel_filter(edge: Real3, u: UVec2) -> Real {
    let a = filter_share(u.x);
    let b = filter_share(u.y);
    let x = pixel_coordinate(tent_distance(a, tent_height(a)), u.x);
    let y = pixel_coordinate(tent_distance(b, tent_height(b)), u.y);
    pixel_side(edge, x, y, real_uint(1, 0))
}
