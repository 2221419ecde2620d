//! Vectors of three reals.
//!
//! Source: the definitions. Domain: as `real`. A sum that cancels is as exact as the
//! products in it: relative to the largest of them, 2^-29. Tier I.
//! Mirror: `shaders/corput/real_vector.glsl`.

use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_multiply, real_sqrt, real_subtract,
};
use glam::{Vec3, vec3};

/// A vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Real3 {
    /// Along +x.
    pub x: Real,
    /// Along +y.
    pub y: Real,
    /// Along +z.
    pub z: Real,
}

/// v, exactly.
#[inline]
#[must_use]
pub fn real3(v: Vec3) -> Real3 {
    Real3 {
        x: real(v.x),
        y: real(v.y),
        z: real(v.z),
    }
}

/// v + w.
#[inline]
#[must_use]
pub fn real3_add(v: Real3, w: Real3) -> Real3 {
    Real3 {
        x: real_add(v.x, w.x),
        y: real_add(v.y, w.y),
        z: real_add(v.z, w.z),
    }
}

/// v - w.
#[inline]
#[must_use]
pub fn real3_subtract(v: Real3, w: Real3) -> Real3 {
    Real3 {
        x: real_subtract(v.x, w.x),
        y: real_subtract(v.y, w.y),
        z: real_subtract(v.z, w.z),
    }
}

/// v * a.
#[inline]
#[must_use]
pub fn real3_scale(v: Real3, a: Real) -> Real3 {
    Real3 {
        x: real_multiply(v.x, a),
        y: real_multiply(v.y, a),
        z: real_multiply(v.z, a),
    }
}

/// The scalar product of v and w.
#[inline]
#[must_use]
pub fn real3_dot(v: Real3, w: Real3) -> Real {
    real_add(
        real_add(real_multiply(v.x, w.x), real_multiply(v.y, w.y)),
        real_multiply(v.z, w.z),
    )
}

/// The vector product of v and w.
#[inline]
#[must_use]
pub fn real3_cross(v: Real3, w: Real3) -> Real3 {
    Real3 {
        x: real_subtract(real_multiply(v.y, w.z), real_multiply(v.z, w.y)),
        y: real_subtract(real_multiply(v.z, w.x), real_multiply(v.x, w.z)),
        z: real_subtract(real_multiply(v.x, w.y), real_multiply(v.y, w.x)),
    }
}

/// |v|.
#[inline]
#[must_use]
pub fn real3_length(v: Real3) -> Real {
    real_sqrt(real3_dot(v, v))
}

/// v / |v|; 0 for v = 0.
#[inline]
#[must_use]
pub fn real3_normalize(v: Real3) -> Real3 {
    let length = real3_length(v);
    Real3 {
        x: real_divide(v.x, length),
        y: real_divide(v.y, length),
        z: real_divide(v.z, length),
    }
}

/// The nearest floats.
#[inline]
#[must_use]
pub fn real3_floats(v: Real3) -> Vec3 {
    vec3(real_float(v.x), real_float(v.y), real_float(v.z))
}
