//! Distances of fractions of 2^32, in the interval or on the circle, and sums of their
//! squares as 96-bit integers (x low, z high).
//!
//! Source: schoolbook arithmetic. Domain: any `u32`; sums of up to 2^32 squares.
//! Range: exact.
//! Mirror: `shaders/corput/distance.glsl`.

use crate::reference::fixed::{addc, mul64};
use glam::{UVec3, uvec3};

/// |x - y|.
#[inline]
#[must_use]
pub fn apart(x: u32, y: u32) -> u32 {
    if x > y { x - y } else { y - x }
}

/// The way from x to y around the circle, the shorter of the two.
#[inline]
#[must_use]
pub fn apart_toroidal(x: u32, y: u32) -> u32 {
    x.wrapping_sub(y).min(y.wrapping_sub(x))
}

/// `sum + d^2`.
#[inline]
#[must_use]
pub fn add_square(sum: UVec3, d: u32) -> UVec3 {
    let square = mul64(d, d);
    let low = addc(sum.x, square.x);
    let middle = addc(sum.y, square.y);
    let carried = addc(middle.x, low.y);
    uvec3(
        low.x,
        carried.x,
        sum.z.wrapping_add(middle.y).wrapping_add(carried.y),
    )
}

/// `a < b`.
#[inline]
#[must_use]
pub fn less96(a: UVec3, b: UVec3) -> bool {
    if a.z != b.z {
        return a.z < b.z;
    }
    if a.y != b.y {
        return a.y < b.y;
    }
    a.x < b.x
}
