//! Directions around an axis, for surfaces that face along one.
//!
//! Source: the definitions. Domain: axes 0 to 5: +x, -x, +y, -y, +z, -z; any vectors.
//! Range: exact, coordinates change places and signs. Tier I.
//! Mirror: `shaders/corput/axis.glsl`.

use crate::reference::real::{Real, real, real_zero};
use glam::{Vec3, Vec3Swizzles, vec3};

/// The direction with +z turned to the axis, exactly: coordinates change places, and for a
/// negative axis the signs of two, half a turn about an axis across.
#[inline]
#[must_use]
pub fn axis_turned(d: Vec3, axis: u32) -> Vec3 {
    let mut v = d;
    if axis < 4 {
        v = d.yzx();
    }
    if axis < 2 {
        v = d.zxy();
    }
    let first = u32::from(axis == 1);
    let second = u32::from(axis == 3);
    let third = u32::from(axis == 5);
    vec3(
        f32::from_bits(v.x.to_bits() ^ ((first | third) << 31)),
        f32::from_bits(v.y.to_bits() ^ ((first | second) << 31)),
        f32::from_bits(v.z.to_bits() ^ ((second | third) << 31)),
    )
}

/// The cosine of the angle to the axis, 0 for more than a right one.
#[inline]
#[must_use]
pub fn axis_cosine(d: Vec3, axis: u32) -> Real {
    let mut along = d.z;
    if axis < 4 {
        along = d.y;
    }
    if axis < 2 {
        along = d.x;
    }
    let mut cosine = real(f32::from_bits(along.to_bits() ^ (axis << 31)));
    if cosine.negative {
        cosine = real_zero();
    }
    cosine
}
