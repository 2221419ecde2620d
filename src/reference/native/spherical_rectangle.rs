//! Directions of a rectangle seen from the origin in the native profile, uniformly over its
//! solid angle, with solid angle, pdf and inverse.
//!
//! Source: two triangles that share the corner and the diagonal from it: Peters 2021. Domain:
//! a corner, two sides from it; two fractions of 2^32; where the rectangle spans no solid
//! angle, +z with pdf 0. Pdf: with respect to solid angle, 1 over it inside.
//! Mirror: `shaders/corput/native/spherical_rectangle.glsl`.

use crate::reference::native::disk::{native_fraction, native_unit};
use crate::reference::native::hemisphere::native_complement;
use crate::reference::native::spherical_triangle::{
    NativeSphericalTriangle, native_spherical_triangle_at, native_spherical_triangle_inside,
    native_spherical_triangle_of, native_spherical_triangle_parts,
};
use glam::{UVec2, Vec3, uvec2, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeSphericalRectangle {
    /// The corner, its neighbour along x, the opposite corner.
    pub first: NativeSphericalTriangle,
    /// The opposite corner, the corner, the neighbour along y.
    pub second: NativeSphericalTriangle,
    /// Half the solid angle, in radians.
    pub area: f32,
}

/// The rectangle with this corner and these sides.
#[must_use]
pub fn native_spherical_rectangle_prepare(
    corner: Vec3,
    x: Vec3,
    y: Vec3,
) -> NativeSphericalRectangle {
    let a = corner + x;
    let e = corner + y;
    let c = a + y;
    let volume = -corner.dot(x.cross(y));
    let diagonal = corner.cross(x + y);
    let first =
        native_spherical_triangle_of(a, corner, c, x.cross(corner), diagonal, y.cross(a), volume);
    let second =
        native_spherical_triangle_of(c, corner, e, -diagonal, corner.cross(y), e.cross(x), volume);
    NativeSphericalRectangle {
        first,
        second,
        area: first.area + second.area,
    }
}

/// Uniform direction of the rectangle.
#[must_use]
pub fn native_spherical_rectangle(r: NativeSphericalRectangle, u: UVec2) -> Vec3 {
    let seen = r.area > 0.0;
    if !seen {
        return vec3(0.0, 0.0, 1.0);
    }
    let before = r.area * native_unit(u.x);
    if before < r.first.area {
        return native_spherical_triangle_at(r.first, before, r.first.area - before, u.y);
    }
    let behind = (r.area * native_complement(u.x)).min(r.second.area);
    native_spherical_triangle_at(r.second, r.second.area - behind, behind, u.y)
}

/// The solid angle.
#[must_use]
pub fn native_spherical_rectangle_solid_angle(r: NativeSphericalRectangle) -> f32 {
    2.0 * r.area
}

/// 1 over the solid angle, the pdf of every sample; 0 where there is none.
#[must_use]
pub fn native_spherical_rectangle_density(r: NativeSphericalRectangle) -> f32 {
    if r.area >= 1e-37 { 0.5 / r.area } else { 0.0 }
}

/// 1 over the solid angle inside, else 0.
#[must_use]
pub fn native_spherical_rectangle_pdf(r: NativeSphericalRectangle, direction: Vec3) -> f32 {
    let inside = native_spherical_triangle_inside(r.first, direction)
        || native_spherical_triangle_inside(r.second, direction);
    if inside {
        native_spherical_rectangle_density(r)
    } else {
        0.0
    }
}

/// The fractions that give this direction.
#[must_use]
pub fn native_spherical_rectangle_invert(r: NativeSphericalRectangle, direction: Vec3) -> UVec2 {
    let seen = r.area > 0.0;
    if !seen {
        return UVec2::ZERO;
    }
    let mut parts = native_spherical_triangle_parts(r.second, direction);
    let mut before = parts.x + r.first.area;
    if direction.dot(r.second.ab_normal) < 0.0 {
        parts = native_spherical_triangle_parts(r.first, direction);
        before = parts.x.min(r.first.area);
    }
    uvec2(native_fraction(before / r.area), native_fraction(parts.y))
}
