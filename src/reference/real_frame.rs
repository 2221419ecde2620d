//! An orthonormal frame around a unit normal in reals, and changes to and from it.
//!
//! Source: Duff et al. 2017, Building an orthonormal basis, revisited, JCGT 6(1), without its
//! difference that cancels. Domain: unit vectors. Range: right-handed, orthonormal to 2^-28.
//! Tier I.
//! Mirror: `shaders/corput/real_frame.glsl`.

use crate::reference::real::{
    Real, real_add, real_divide, real_multiply, real_negate, real_square, real_uint,
};
use crate::reference::real_vector::{Real3, real3_add, real3_dot, real3_scale};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RealFrame {
    /// First axis.
    pub tangent: Real3,
    /// Second axis.
    pub bitangent: Real3,
    /// Third axis.
    pub normal: Real3,
}

/// a, or -a if so told.
#[inline]
#[must_use]
pub fn real_frame_sign(a: Real, negative: bool) -> Real {
    if negative {
        return real_negate(a);
    }
    a
}

/// The frame around a unit normal.
#[inline]
#[must_use]
pub fn real_frame(normal: Real3) -> RealFrame {
    let negative = normal.z.negative;
    let height = Real {
        m: normal.z.m,
        e: normal.z.e,
        negative: false,
    };
    let below = real_add(real_uint(1, 0), height);
    let x_square = real_square(normal.x);
    let y_square = real_square(normal.y);
    let both = real_add(height, real_square(height));
    let xy = real_negate(real_divide(real_multiply(normal.x, normal.y), below));
    RealFrame {
        tangent: Real3 {
            x: real_divide(real_add(both, y_square), below),
            y: xy,
            z: real_frame_sign(real_negate(normal.x), negative),
        },
        bitangent: Real3 {
            x: real_frame_sign(xy, negative),
            y: real_frame_sign(real_divide(real_add(both, x_square), below), negative),
            z: real_negate(normal.y),
        },
        normal,
    }
}

/// The vector with these coordinates in the frame.
#[inline]
#[must_use]
pub fn real_frame_to_world(f: RealFrame, local: Real3) -> Real3 {
    let side = real3_add(
        real3_scale(f.tangent, local.x),
        real3_scale(f.bitangent, local.y),
    );
    real3_add(side, real3_scale(f.normal, local.z))
}

/// Coordinates in the frame of this vector.
#[inline]
#[must_use]
pub fn real_frame_to_local(f: RealFrame, world: Real3) -> Real3 {
    Real3 {
        x: real3_dot(world, f.tangent),
        y: real3_dot(world, f.bitangent),
        z: real3_dot(world, f.normal),
    }
}
