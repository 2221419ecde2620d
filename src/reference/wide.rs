//! Reals with a significand of 64 bits, for sums of products that cancel: determinants,
//! vector products.
//!
//! Source: Kahan 2004, On the cost of floating-point computation without extra-precise
//! arithmetic. Domain: as `real`. Range: a product of reals is exact; a sum is within 2^-62
//! of its larger operand. Tier I.
//! Mirror: `shaders/corput/wide.glsl`.

use crate::reference::bits::find_msb;
use crate::reference::fixed::{add64, mul64, shl64, shr64, sub64};
use crate::reference::real::{Real, real_negate, real_zero};
use crate::reference::real_vector::Real3;
use glam::{UVec2, uvec2};

/// (negative ? -1 : 1) * m * 2^e: bit 63 of m is set, or all of it is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide {
    /// The significand.
    pub m: UVec2,
    /// The exponent; 0 for 0.
    pub e: i32,
    /// The sign; false for 0.
    pub negative: bool,
}

/// (negative ? -1 : 1) * m * 2^e, for any m.
#[inline]
#[must_use]
pub fn wide(m: UVec2, e: i32, negative: bool) -> Wide {
    let mut rest = m;
    let mut exponent = e;
    if rest.y == 0 {
        rest = uvec2(0, rest.x);
        exponent -= 32;
    }
    if rest.y == 0 {
        return Wide {
            m: UVec2::ZERO,
            e: 0,
            negative: false,
        };
    }
    let shift = 31 - find_msb(rest.y);
    Wide {
        m: shl64(rest, shift),
        e: exponent - shift as i32,
        negative,
    }
}

/// a * b, exactly.
#[inline]
#[must_use]
pub fn wide_product(a: Real, b: Real) -> Wide {
    wide(mul64(a.m, b.m), a.e + b.e, a.negative != b.negative)
}

/// a * b.
#[inline]
#[must_use]
pub fn wide_multiply(a: Wide, b: Real) -> Wide {
    let low = mul64(a.m.x, b.m);
    let product = add64(mul64(a.m.y, b.m), uvec2(low.y, 0));
    wide(product, a.e + b.e + 32, a.negative != b.negative)
}

/// Whether |a| < |b|.
#[inline]
#[must_use]
pub fn wide_smaller(a: Wide, b: Wide) -> bool {
    if a.m.y == 0 || b.m.y == 0 {
        return b.m.y != 0;
    }
    if a.e != b.e {
        return a.e < b.e;
    }
    a.m.y < b.m.y || (a.m.y == b.m.y && a.m.x < b.m.x)
}

/// a + b.
#[inline]
#[must_use]
pub fn wide_add(a: Wide, b: Wide) -> Wide {
    let mut large = a;
    let mut small = b;
    if wide_smaller(a, b) {
        large = b;
        small = a;
    }
    if small.m.y == 0 {
        return large;
    }
    let shifted = shr64(small.m, ((large.e - small.e).min(63)) as u32);
    if large.negative != small.negative {
        return wide(sub64(large.m, shifted), large.e, large.negative);
    }
    let mut sum = add64(large.m, shifted);
    if sum.y < large.m.y || (sum.y == large.m.y && sum.x < large.m.x) {
        sum = shr64(sum, 1);
        return Wide {
            m: uvec2(sum.x, sum.y | 0x8000_0000),
            e: large.e + 1,
            negative: large.negative,
        };
    }
    Wide {
        m: sum,
        e: large.e,
        negative: large.negative,
    }
}

/// a * d - b * c.
#[inline]
#[must_use]
pub fn wide_determinant(a: Real, b: Real, c: Real, d: Real) -> Wide {
    wide_add(wide_product(a, d), wide_product(real_negate(b), c))
}

/// a cut to 32 significant bits.
#[inline]
#[must_use]
pub fn wide_real(a: Wide) -> Real {
    if a.m.y == 0 {
        return real_zero();
    }
    Real {
        m: a.m.y,
        e: a.e + 32,
        negative: a.negative,
    }
}

/// The vector product of v and w, each component within 2^-31 of itself where the products
/// cancel by 31 bits at most.
#[inline]
#[must_use]
pub fn wide_cross(v: Real3, w: Real3) -> Real3 {
    Real3 {
        x: wide_real(wide_determinant(v.y, v.z, w.y, w.z)),
        y: wide_real(wide_determinant(v.z, v.x, w.z, w.x)),
        z: wide_real(wide_determinant(v.x, v.y, w.x, w.y)),
    }
}

/// The scalar product of u with the vector product of v and w.
#[inline]
#[must_use]
pub fn wide_triple(u: Real3, v: Real3, w: Real3) -> Real {
    let x = wide_multiply(wide_determinant(v.y, v.z, w.y, w.z), u.x);
    let y = wide_multiply(wide_determinant(v.z, v.x, w.z, w.x), u.y);
    let z = wide_multiply(wide_determinant(v.x, v.y, w.x, w.y), u.z);
    wide_real(wide_add(wide_add(x, y), z))
}
