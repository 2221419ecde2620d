//! An orthonormal frame around a unit normal, and changes to and from it.
//!
//! Source: Duff et al. 2017, JCGT 6(1); the sign of z is taken as an integer, the
//! division is exact. Domain: unit vectors; components below 2^-40 count as zero.
//! Range: right-handed, cross(tangent, bitangent) = normal, to 2^-21.
//! Tier F: float + - * rounded to nearest even, never contracted.
//! Mirror: `shaders/corput/frame.glsl`.

use crate::reference::elementary::divide;
use glam::{Vec3, vec3};

/// Tangent, bitangent, normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// First axis.
    pub tangent: Vec3,
    /// Second axis.
    pub bitangent: Vec3,
    /// Third axis: the normal, its components below 2^-40 set to zero.
    pub normal: Vec3,
}

/// x, or 0 where |x| < 2^-40.
#[inline]
#[must_use]
pub fn frame_flush(x: f32) -> f32 {
    if x.to_bits() & 0x7fff_ffff < 0x2b80_0000 {
        0.0
    } else {
        x
    }
}

/// -x by its sign bit.
#[inline]
#[must_use]
pub fn frame_negate(x: f32) -> f32 {
    f32::from_bits(x.to_bits() ^ 0x8000_0000)
}

/// The frame around a unit normal.
#[inline]
#[must_use]
pub fn frame(normal: Vec3) -> Frame {
    let x = frame_flush(normal.x);
    let y = frame_flush(normal.y);
    let z = frame_flush(normal.z);
    let sign = z.to_bits() & 0x8000_0000;
    let one = f32::from_bits(0x3f80_0000 | sign);
    let denominator = one + z;
    let a = frame_negate(divide(1.0, denominator));
    // The sign is put on by its bit, as a product with +-1 would.
    let signed_x = f32::from_bits(x.to_bits() ^ sign);
    let xx = signed_x * x;
    let yy = y * y;
    let xy = x * y;
    let xxa = xx * a;
    let yya = yy * a;
    let b = xy * a;
    let tangent_x = 1.0 + xxa;
    let bitangent_y = one + yya;
    Frame {
        tangent: vec3(
            tangent_x,
            f32::from_bits(b.to_bits() ^ sign),
            frame_negate(signed_x),
        ),
        bitangent: vec3(b, bitangent_y, frame_negate(y)),
        normal: vec3(x, y, z),
    }
}

/// x a + y b + z c, from the left, for components of unit vectors.
#[inline]
#[must_use]
pub fn frame_combine(v: Vec3, w: Vec3) -> f32 {
    let a = frame_flush(v.x) * frame_flush(w.x);
    let b = frame_flush(v.y) * frame_flush(w.y);
    let c = frame_flush(v.z) * frame_flush(w.z);
    let ab = a + b;
    ab + c
}

/// The vector with these coordinates in the frame.
#[inline]
#[must_use]
pub fn frame_to_world(f: Frame, local: Vec3) -> Vec3 {
    vec3(
        frame_combine(local, vec3(f.tangent.x, f.bitangent.x, f.normal.x)),
        frame_combine(local, vec3(f.tangent.y, f.bitangent.y, f.normal.y)),
        frame_combine(local, vec3(f.tangent.z, f.bitangent.z, f.normal.z)),
    )
}

/// Coordinates in the frame of this vector.
#[inline]
#[must_use]
pub fn frame_to_local(f: Frame, world: Vec3) -> Vec3 {
    vec3(
        frame_combine(world, f.tangent),
        frame_combine(world, f.bitangent),
        frame_combine(world, f.normal),
    )
}
