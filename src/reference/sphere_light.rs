//! Directions from the origin towards a sphere, uniformly over its solid angle, with pdf
//! and inverse.
//!
//! Source: PBRT 4th ed., 6.2.4, by h = 1 - cos(theta_max) = r^2 / (d^2 + d sqrt(d^2 - r^2)).
//! Domain: a centre, a radius; two fractions of 2^32; the origin within the sphere: uniform
//! over all directions; r <= 0: the direction of the centre, with pdf 0. Range: unit vectors
//! to 2^-23. Pdf: with respect to solid angle, 1/(2 pi h) inside, 1/(4 pi) from within, the
//! edge widened by the rounding of a direction. Errors: 0.6 ULP, or 2^-30 for coordinates
//! below 2^-5, which a rotation leaves; pdf 0.6 ULP; the inverse agrees with the sample to
//! 2^-20, more where the rounding of a direction is more of the sphere's angle. Tier I.
//! Mirror: `shaders/corput/sphere_light.glsl`.

use crate::reference::cone::{cone_around, cone_around_invert, cone_density};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_less, real_max, real_multiply, real_negate,
    real_shift, real_sqrt, real_square, real_subtract, real_uint, real_zero,
};
use crate::reference::real_frame::{
    RealFrame, real_frame, real_frame_to_local, real_frame_to_world,
};
use crate::reference::real_vector::{
    Real3, real3, real3_dot, real3_floats, real3_length, real3_normalize,
};
use crate::reference::wide::{wide_add, wide_cross, wide_product, wide_real};
use glam::{UVec2, Vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereLight {
    /// Its normal points to the centre.
    pub frame: RealFrame,
    /// 1 - cos(theta_max).
    pub h: Real,
    /// sin(theta_max).
    pub sine: Real,
}

/// The sphere with this centre and radius.
#[inline]
#[must_use]
pub fn sphere_light_prepare(center: Vec3, radius: f32) -> SphereLight {
    let c = real3(center);
    let r = real_max(real(radius), real_zero());
    let mut axis = real3_normalize(c);
    let square = real3_dot(c, c);
    if square.m == 0 {
        axis.z = real_uint(1, 0);
    }
    let rest = wide_add(
        wide_add(wide_product(c.x, c.x), wide_product(c.y, c.y)),
        wide_add(wide_product(c.z, c.z), wide_product(real_negate(r), r)),
    );
    let mut h = real_uint(2, 0);
    let mut sine = real_uint(1, 0);
    if !rest.negative && square.m != 0 {
        let root = real_sqrt(real_multiply(square, wide_real(rest)));
        h = real_divide(real_square(r), real_add(square, root));
        sine = real_divide(r, real_sqrt(square));
    }
    SphereLight {
        frame: real_frame(axis),
        h,
        sine,
    }
}

/// Uniform direction towards the sphere.
#[inline]
#[must_use]
pub fn sphere_light(light: SphereLight, u: UVec2) -> Vec3 {
    real3_floats(real_frame_to_world(light.frame, cone_around(light.h, u)))
}

/// Whether a direction meets the sphere, or does so by its rounding.
#[inline]
#[must_use]
pub fn sphere_light_inside(light: SphereLight, d: Real3) -> bool {
    if !real_less(light.h, real_uint(2, 0)) {
        return true;
    }
    let n = light.frame.normal;
    let cosine = real3_dot(d, n);
    if real_less(real_uint(3, -2), light.sine) {
        // Near a right angle its sine says little.
        let edge = real_subtract(real_uint(1, 0), light.h);
        return !real_less(cosine, real_subtract(edge, real_uint(1, -22)));
    }
    // |d x n|, and what the rounding of d changes of it.
    let across = wide_cross(d, n);
    let size = Real3 {
        x: real_add(
            real_square(real_multiply(d.y, n.z)),
            real_square(real_multiply(d.z, n.y)),
        ),
        y: real_add(
            real_square(real_multiply(d.z, n.x)),
            real_square(real_multiply(d.x, n.z)),
        ),
        z: real_add(
            real_square(real_multiply(d.x, n.y)),
            real_square(real_multiply(d.y, n.x)),
        ),
    };
    let sum = real_add(real_add(size.x, size.y), size.z);
    let most = real_add(
        real_add(light.sine, real_shift(light.sine, -22)),
        real_shift(real_sqrt(sum), -22),
    );
    !cosine.negative && !real_less(most, real3_length(across))
}

/// 1/(2 pi h) towards the sphere, else 0.
#[inline]
#[must_use]
pub fn sphere_light_pdf(light: SphereLight, direction: Vec3) -> f32 {
    if !sphere_light_inside(light, real3(direction)) {
        return 0.0;
    }
    real_float(cone_density(light.h))
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn sphere_light_invert(light: SphereLight, direction: Vec3) -> UVec2 {
    cone_around_invert(light.h, real_frame_to_local(light.frame, real3(direction)))
}
