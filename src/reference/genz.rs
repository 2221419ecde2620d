//! Genz's six families of integrands, Sobol's g and products of linear factors, dimension by
//! dimension: a term or factor for each, and what the sum or product of them all gives.
//!
//! Source: Genz 1984, Testing multidimensional integration routines; Saltelli and Sobol
//! 1995; Sobol and Asotsky 2003. Domain: x = u 2^-32; coefficients as reals above 0, places w
//! and phases as fractions of 2^32; dimensions to 64, of products of linear factors any
//! number. Range: each step within 2^-29 of its result, a linear factor within 2^-29.9; a
//! phase within 2^-32 of a turn a dimension. Tier I.
//! Mirror: `shaders/corput/genz.glsl`.

use crate::reference::exponential::real_power;
use crate::reference::fixed::mulhi;
use crate::reference::integrand::turns_sine;
use crate::reference::real::{
    Real, real_add, real_divide, real_multiply, real_negate, real_shift, real_square, real_uint,
};
use glam::UVec2;

/// Oscillatory: the phase with c x added, for c in turns, 32 bits of them a fraction.
#[inline]
#[must_use]
pub fn genz_phase(phase: u32, u: u32, c: UVec2) -> u32 {
    phase
        .wrapping_add(c.y.wrapping_mul(u))
        .wrapping_add(mulhi(c.x, u))
}

/// cos of a phase.
#[inline]
#[must_use]
pub fn genz_oscillation(phase: u32) -> Real {
    turns_sine(phase.wrapping_add(0x4000_0000))
}

/// |x - w|.
#[inline]
#[must_use]
pub fn genz_distance(u: u32, w: u32) -> Real {
    let mut d = u.wrapping_sub(w);
    if u < w {
        d = w - u;
    }
    real_uint(d, -32)
}

/// Product peak: product / (c^-2 + (x - w)^2), given c^-2.
#[inline]
#[must_use]
pub fn genz_peak(product: Real, u: u32, w: u32, width: Real) -> Real {
    let square = real_square(genz_distance(u, w));
    real_divide(product, real_add(width, square))
}

/// Corner peak and discontinuous: sum + c x.
#[inline]
#[must_use]
pub fn genz_linear(sum: Real, u: u32, c: Real) -> Real {
    real_add(sum, real_multiply(c, real_uint(u, -32)))
}

/// Corner peak: (1 + sum)^-(dimensions + 1).
#[inline]
#[must_use]
pub fn genz_corner(sum: Real, dimensions: u32) -> Real {
    let power = real_negate(real_uint(dimensions.wrapping_add(1), 0));
    real_power(real_add(sum, real_uint(1, 0)), power)
}

/// Gaussian: sum + (c (x - w))^2.
#[inline]
#[must_use]
pub fn genz_square(sum: Real, u: u32, w: u32, c: Real) -> Real {
    let distance = real_multiply(c, genz_distance(u, w));
    real_add(sum, real_square(distance))
}

/// Continuous: sum + c |x - w|.
#[inline]
#[must_use]
pub fn genz_kink(sum: Real, u: u32, w: u32, c: Real) -> Real {
    real_add(sum, real_multiply(c, genz_distance(u, w)))
}

/// Sobol's g: product (|4 x - 2| + a) / (1 + a), given a and 1 / (1 + a).
#[inline]
#[must_use]
pub fn sobol_g(product: Real, u: u32, a: Real, share: Real) -> Real {
    let factor = real_add(real_shift(genz_distance(u, 0x8000_0000), 2), a);
    real_multiply(product, real_multiply(factor, share))
}

/// Linear factors: product (1 + c (x - 1/2)), given 1 - c/2 and c.
#[inline]
#[must_use]
pub fn linear_factor(product: Real, u: u32, least: Real, c: Real) -> Real {
    real_multiply(product, genz_linear(least, u, c))
}
