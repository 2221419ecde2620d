//! Estimators of the share of a lens that sees one side of an edge in its circle of
//! confusion: 1 or 0 for each point of the unit disk.
//!
//! Source: Potmesil and Chakravarty 1981, SIGGRAPH; Shirley and Chiu 1997. Domain: fractions
//! of 2^32; the edge x nx + y ny = offset, given (nx, ny, offset). Range: 0 or 1, or of the
//! square 0 or 4/pi; a point within 2^-23 of the edge may count as on its other side. Tier I.
//! Mirror: `shaders/corput/defocus.glsl`.

use crate::reference::disk::{concentric_disk, polar_disk};
use crate::reference::real::{
    Real, real, real_add, real_less, real_multiply, real_square, real_subtract, real_uint,
    real_zero,
};
use crate::reference::real_vector::Real3;
use glam::UVec2;

/// 1 below the edge, else 0.
#[inline]
#[must_use]
pub fn defocus_side(edge: Real3, x: Real, y: Real) -> Real {
    let across = real_add(real_multiply(edge.x, x), real_multiply(edge.y, y));
    real_uint(u32::from(real_less(across, edge.z)), 0)
}

/// By points of the square around the disk: 4/pi where they are in both.
#[inline]
#[must_use]
pub fn defocus_square(edge: Real3, u: UVec2) -> Real {
    let one = real_uint(1, 0);
    let x = real_subtract(real_uint(u.x, -31), one);
    let y = real_subtract(real_uint(u.y, -31), one);
    let mut value = real_multiply(defocus_side(edge, x, y), real_uint(2_734_261_102, -31));
    if !real_less(real_add(real_square(x), real_square(y)), one) {
        value = real_zero();
    }
    value
}

/// By the polar map.
#[inline]
#[must_use]
pub fn defocus_polar(edge: Real3, u: UVec2) -> Real {
    let p = polar_disk(u);
    defocus_side(edge, real(p.x), real(p.y))
}

/// By the concentric map.
#[inline]
#[must_use]
pub fn defocus_concentric(edge: Real3, u: UVec2) -> Real {
    let p = concentric_disk(u);
    defocus_side(edge, real(p.x), real(p.y))
}
