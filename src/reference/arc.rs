//! Arcs between directions, without the differences that cancel in short and long ones.
//!
//! Source: the half-angle formulas; for unit vectors u, v with the unit normal n of u x v,
//! u + v = (v - u) x n / tan(half the angle). Domain: vectors of any length, exact floats.
//! Range: cosines and sines of half angles within 2^-28 of themselves. Tier I.
//! Mirror: `shaders/corput/arc.glsl`.

use crate::reference::real::{
    Real, real_add, real_divide, real_less, real_multiply, real_negate, real_shift, real_sqrt,
};
use crate::reference::real_vector::{
    Real3, real3_add, real3_cross, real3_dot, real3_length, real3_scale, real3_subtract,
};

/// Half the angle between two vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// Its cosine.
    pub cosine: Real,
    /// Its sine.
    pub sine: Real,
}

/// A vector with the other sign if so told.
#[inline]
#[must_use]
pub fn real3_signed(v: Real3, negative: bool) -> Real3 {
    if !negative {
        return v;
    }
    Real3 {
        x: real_negate(v.x),
        y: real_negate(v.y),
        z: real_negate(v.z),
    }
}

/// v x + w y.
#[inline]
#[must_use]
pub fn real3_combine(v: Real3, x: Real, w: Real3, y: Real) -> Real3 {
    real3_add(real3_scale(v, x), real3_scale(w, y))
}

/// The arc between two vectors of any length with this vector product.
#[inline]
#[must_use]
pub fn arc(a: Real3, b: Real3, normal: Real3) -> Arc {
    let product = real_multiply(real3_length(a), real3_length(b));
    let cosine = real3_dot(a, b);
    // The sum that does not cancel, and the other one by the vector product.
    let large = real_add(
        product,
        Real {
            m: cosine.m,
            e: cosine.e,
            negative: false,
        },
    );
    let small = real_divide(real3_dot(normal, normal), large);
    let twice = real_shift(product, 1);
    let far = real_sqrt(real_divide(large, twice));
    let near = real_sqrt(real_divide(small, twice));
    if cosine.negative {
        return Arc {
            cosine: near,
            sine: far,
        };
    }
    Arc {
        cosine: far,
        sine: near,
    }
}

/// u + v of unit vectors, each component within 2^-28 of the length of the sum, given their arc
/// and the unit normal of u x v.
#[inline]
#[must_use]
pub fn arc_sum(u: Real3, v: Real3, arc: Arc, normal: Real3) -> Real3 {
    if !real_less(arc.cosine, arc.sine) {
        return real3_add(u, v);
    }
    let across = real3_cross(real3_subtract(v, u), normal);
    real3_scale(across, real_divide(arc.cosine, arc.sine))
}
