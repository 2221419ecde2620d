//! Integrands of one to three dimensions, for estimators: x^2, an offset fraction,
//! 1/sqrt(x), the disk's step, checkerboards, Ishigami's function.
//!
//! Source: Ishigami and Homma 1990; the others by their formulas. Domain: x a fraction u of
//! 2^32, x = u 2^-32; in 1/sqrt(x) the middle of its cell. Range: x^2, offsets and steps are
//! exact; reals within 2^-28 of the integrand's peak. Tier I.
//! Mirror: `shaders/corput/integrand.glsl`.

use crate::reference::elementary::sincos_scaled;
use crate::reference::fixed::{addc, mul64, mulhi};
use crate::reference::real::{
    Real, real_add, real_divide, real_multiply, real_negate, real_scaled, real_sqrt, real_square,
    real_uint, real_wide,
};
use crate::reference::sum::Term;
use glam::{UVec2, UVec3, uvec2};

/// x^2 in units of 2^-64.
#[inline]
#[must_use]
pub fn x_squared(u: u32) -> Term {
    Term {
        m: mul64(u, u),
        negative: false,
    }
}

/// offset + x in units of 2^-32.
#[inline]
#[must_use]
pub fn offset_fraction(u: u32, offset: u32) -> Term {
    Term {
        m: uvec2(u, offset),
        negative: false,
    }
}

/// 1 or 0 in units of 1.
#[inline]
#[must_use]
pub fn indicator(inside: bool) -> Term {
    Term {
        m: uvec2(u32::from(inside), 0),
        negative: false,
    }
}

/// 1/sqrt(x), for x = (u + 1/2) 2^-32.
#[inline]
#[must_use]
pub fn inverse_root(u: u32) -> Real {
    let x = real_wide(uvec2((u << 1) | 1, u >> 31), -33);
    real_divide(real_uint(1, 0), real_sqrt(x))
}

/// Whether x^2 + y^2 < 1.
#[inline]
#[must_use]
pub fn disk_step(u: UVec2) -> bool {
    let xx = mul64(u.x, u.x);
    let yy = mul64(u.y, u.y);
    let low = addc(xx.x, yy.x);
    let carried = addc(xx.y, low.y);
    (carried.y | addc(carried.x, yy.y).y) == 0
}

/// The number of x's cell among so many, of which the parities of all axes together make
/// the colour.
#[inline]
#[must_use]
pub fn checkerboard_cell(u: u32, cells: u32) -> u32 {
    mulhi(u, cells)
}

/// sin(2 pi u) of a fraction of 2^32.
#[inline]
#[must_use]
pub fn turns_sine(u: u32) -> Real {
    let angle = sincos_scaled(u);
    real_scaled(angle.sine, angle.sine_negative)
}

/// `sin t_1 + a sin^2 t_2 + b t_3^4 sin t_1`, for `t = pi (2 x - 1)` and `b_pi = b pi^4`.
#[inline]
#[must_use]
pub fn ishigami(u: UVec3, a: Real, b_pi: Real) -> Real {
    // sin(t) = -sin(t + pi).
    let first = real_negate(turns_sine(u.x));
    let second = turns_sine(u.y);
    let above = u32::from(u.z >= 0x8000_0000);
    let distance = (u.z.wrapping_sub(0x8000_0000) & 0u32.wrapping_sub(above))
        | (0x8000_0000u32.wrapping_sub(u.z) & above.wrapping_sub(1));
    let square = real_square(real_uint(distance, -31));
    let factor = real_add(real_uint(1, 0), real_multiply(b_pi, real_square(square)));
    real_add(
        real_multiply(first, factor),
        real_multiply(a, real_square(second)),
    )
}
