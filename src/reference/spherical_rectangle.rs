//! Directions of a rectangle seen from the origin, uniformly over its solid angle, with
//! solid angle, pdf and inverse.
//!
//! Source: two triangles that share the corner and the diagonal from it (Peters 2021, BRDF
//! importance sampling for polygonal lights, section 4), each as in `spherical_triangle`.
//! Domain: a corner, two sides from it; two fractions of 2^32; where the rectangle spans no
//! solid angle, +z with pdf 0. Range: unit vectors to 2^-23. Pdf: with respect to solid angle,
//! 1 over it inside. Errors: the solid angle 0.7 ULP; else as `spherical_triangle`. Tier I.
//! Mirror: `shaders/corput/spherical_rectangle.glsl`.

use crate::reference::arc::real3_signed;
use crate::reference::real::{
    Real, real_add, real_divide, real_float, real_less, real_min, real_multiply, real_negate,
    real_subtract, real_uint, real_zero,
};
use crate::reference::real_angle::{real_complement, real_fraction_nearest};
use crate::reference::real_vector::{real3, real3_add, real3_dot};
use crate::reference::spherical_triangle::{
    SphericalTriangle, spherical_triangle_at, spherical_triangle_inside, spherical_triangle_of,
    spherical_triangle_parts,
};
use crate::reference::wide::{wide_cross, wide_triple};
use glam::{UVec2, Vec3, uvec2, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphericalRectangle {
    /// The corner, its neighbour along x, the opposite corner.
    pub first: SphericalTriangle,
    /// The opposite corner, the corner, the neighbour along y.
    pub second: SphericalTriangle,
    /// Half the solid angle, in turns.
    pub area: Real,
}

/// The rectangle with this corner and these sides.
#[inline]
#[must_use]
pub fn spherical_rectangle_prepare(corner: Vec3, x: Vec3, y: Vec3) -> SphericalRectangle {
    let o = real3(corner);
    let ex = real3(x);
    let ey = real3(y);
    let a = real3_add(o, ex);
    let e = real3_add(o, ey);
    let c = real3_add(a, ey);
    // Products by the sides: those of the corners would have lost their digits.
    let volume = wide_triple(o, ex, ey);
    let diagonal = wide_cross(o, real3_add(ex, ey));
    let first = spherical_triangle_of(
        a,
        o,
        c,
        wide_cross(ex, o),
        diagonal,
        wide_cross(ey, a),
        real_negate(volume),
    );
    let second = spherical_triangle_of(
        c,
        o,
        e,
        real3_signed(diagonal, true),
        wide_cross(o, ey),
        wide_cross(e, ex),
        real_negate(volume),
    );
    SphericalRectangle {
        first,
        second,
        area: real_add(first.area, second.area),
    }
}

/// Uniform direction of the rectangle.
#[inline]
#[must_use]
pub fn spherical_rectangle(r: SphericalRectangle, u: UVec2) -> Vec3 {
    if r.area.m == 0 {
        return vec3(0.0, 0.0, 1.0);
    }
    let before = real_multiply(r.area, real_uint(u.x, -32));
    if real_less(before, r.first.area) {
        let behind = real_subtract(r.first.area, before);
        return spherical_triangle_at(r.first, before, behind, u.y);
    }
    // From the other end: the first half may be larger by far.
    let behind = real_min(real_multiply(r.area, real_complement(u.x)), r.second.area);
    spherical_triangle_at(r.second, real_subtract(r.second.area, behind), behind, u.y)
}

/// The solid angle.
#[inline]
#[must_use]
pub fn spherical_rectangle_solid_angle(r: SphericalRectangle) -> f32 {
    // 4 pi to 32 bits.
    real_float(real_multiply(r.area, real_uint(3_373_259_426, -28)))
}

/// 1 over the solid angle, the pdf of every sample; 0 where there is none.
#[inline]
#[must_use]
pub fn spherical_rectangle_density(r: SphericalRectangle) -> f32 {
    let mut density = real_zero();
    if r.area.m != 0 {
        // 1/(4 pi) to 32 bits.
        density = real_divide(real_uint(2_734_261_102, -35), r.area);
    }
    real_float(density)
}

/// 1 over the solid angle inside, else 0.
#[inline]
#[must_use]
pub fn spherical_rectangle_pdf(r: SphericalRectangle, direction: Vec3) -> f32 {
    let d = real3(direction);
    if !spherical_triangle_inside(r.first, d) && !spherical_triangle_inside(r.second, d) {
        return 0.0;
    }
    spherical_rectangle_density(r)
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn spherical_rectangle_invert(r: SphericalRectangle, direction: Vec3) -> UVec2 {
    if r.area.m == 0 {
        return UVec2::ZERO;
    }
    let d = real3(direction);
    let mut parts = spherical_triangle_parts(r.second, d);
    if real3_dot(d, r.second.ab_normal).negative {
        parts = spherical_triangle_parts(r.first, d);
        parts.cosine = real_min(parts.cosine, r.first.area);
    } else {
        parts.cosine = real_add(parts.cosine, r.first.area);
    }
    uvec2(
        real_fraction_nearest(real_divide(parts.cosine, r.area)),
        real_fraction_nearest(parts.sine),
    )
}
