//! Directions around +z by the phase function of Henyey and Greenstein, with pdf and
//! inverse. +z is the direction of propagation: g > 0 scatters forward, to +z.
//!
//! Source: Henyey and Greenstein 1941, Diffuse radiation in the galaxy, ApJ 93. With q =
//! 1 - g, D = q + 2 g u: 1 - z = 2 q^2 (1 - u) (1 + g u) / D^2, 1 + z = 2 (1 + g)^2 u (q +
//! g u) / D^2, pdf = D^3 / (4 pi (1 - g^2)^2): sums of positive terms, where the common
//! form of z cancels as g^2 nears 1, or 0. Domain: two fractions of 2^32; z grows with
//! u.x. g in (-1, 1): what is beyond, and NaN, counts as 1 - 2^-24 of its sign. Nearer to
//! 1 or -1, give 1 - |g|: from 2^-63 to 1, what is beyond counts as the end. Range: unit
//! vectors to 2^-23. Pdf: with respect to solid angle: (1 - g^2) / (4 pi (q^2 + 2 g (1 -
//! z))^(3/2)), with 1 - z = (x^2 + y^2) / (1 + z) for z > 0. It is well conditioned: that
//! of a rounded direction is within 6 ULP of the exact direction's. Infinities and NaN
//! are no directions; their pdf is finite. Errors: x, y and the pdf of a sample 0.6 ULP,
//! z 0.6 ULP or 2^-29. The inverse of a sample is within 2^-22 of it, angles modulo one
//! turn; at the poles the angle is lost. Tier I.
//! Mirror: `shaders/corput/henyey_greenstein.glsl`.

use crate::reference::elementary::atan2;
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_less, real_max, real_min, real_multiply,
    real_negate, real_shift, real_sqrt, real_square, real_subtract, real_uint,
};
use crate::reference::real_angle::{real_complement, real_fraction_of};
use crate::reference::real_vector::real3;
use crate::reference::scattered::{Scattered, real3_around, scattered};
use glam::{UVec2, Vec3, uvec2};

/// The asymmetry of a phase function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HenyeyGreenstein {
    /// |g|.
    pub g: Real,
    /// 1 - |g|.
    pub rest: Real,
    /// Whether g < 0.
    pub backward: bool,
}

/// 1 - z and 1 + z of a unit vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Versines {
    /// 1 - z.
    pub below: Real,
    /// 1 + z.
    pub above: Real,
}

/// By g.
#[inline]
#[must_use]
pub fn henyey_greenstein_prepare(g: f32) -> HenyeyGreenstein {
    let given = real(g);
    let magnitude = real_min(
        Real {
            m: given.m,
            e: given.e,
            negative: false,
        },
        Real {
            m: 0xffff_ff00,
            e: -32,
            negative: false,
        },
    );
    HenyeyGreenstein {
        g: magnitude,
        rest: real_subtract(real_uint(1, 0), magnitude),
        backward: given.negative,
    }
}

/// By rest = 1 - |g|, which says more than g where g is near 1 or -1.
#[inline]
#[must_use]
pub fn henyey_greenstein_complement(rest: f32, backward: bool) -> HenyeyGreenstein {
    let one = real_uint(1, 0);
    let clamped = real_min(real_max(real(rest), real_uint(1, -63)), one);
    HenyeyGreenstein {
        g: real_subtract(one, clamped),
        rest: clamped,
        backward,
    }
}

/// Direction and pdf.
#[inline]
#[must_use]
pub fn henyey_greenstein(h: HenyeyGreenstein, u: UVec2) -> Scattered {
    let mut a = real_uint(u.x, -32);
    let mut b = real_complement(u.x);
    if h.backward {
        a = real_complement(u.x);
        b = real_uint(u.x, -32);
    }
    let one = real_uint(1, 0);
    let sum = real_add(one, h.g);
    let bent = real_multiply(h.g, a);
    let near = real_multiply(b, real_add(one, bent));
    let far = real_multiply(a, real_add(h.rest, bent));
    let d = real_add(h.rest, real_shift(bent, 1));
    let k = real_divide(real_uint(2, 0), real_square(d));
    let product = real_multiply(h.rest, sum);
    let below = real_multiply(real_multiply(k, real_square(h.rest)), near);
    let above = real_multiply(real_multiply(k, real_square(sum)), far);
    let mut z = real_subtract(one, below);
    if real_less(above, below) {
        z = real_subtract(above, one);
    }
    if h.backward {
        z = real_negate(z);
    }
    let radius = real_multiply(
        real_multiply(k, product),
        real_sqrt(real_multiply(near, far)),
    );
    let mut pdf = real_divide(real_multiply(d, real_square(d)), real_square(product));
    // 1 / (4 pi).
    pdf = real_multiply(
        pdf,
        Real {
            m: 2_734_261_102,
            e: -35,
            negative: false,
        },
    );
    scattered(real3_around(radius, u.y, z), pdf)
}

/// 1 - z and 1 + z of a direction, neither by a difference that cancels.
#[inline]
#[must_use]
pub fn henyey_greenstein_versines(direction: Vec3) -> Versines {
    let d = real3(direction);
    let one = real_uint(1, 0);
    let square = real_add(real_square(d.x), real_square(d.y));
    let above = real_add(
        one,
        Real {
            m: d.z.m,
            e: d.z.e,
            negative: false,
        },
    );
    let below = real_divide(square, above);
    if d.z.negative {
        return Versines {
            below: above,
            above: below,
        };
    }
    Versines { below, above }
}

/// The pdf of a direction.
#[inline]
#[must_use]
pub fn henyey_greenstein_pdf(h: HenyeyGreenstein, direction: Vec3) -> f32 {
    let v = henyey_greenstein_versines(direction);
    let mut below = v.below;
    if h.backward {
        below = v.above;
    }
    let square = real_add(
        real_square(h.rest),
        real_shift(real_multiply(h.g, below), 1),
    );
    let cube = real_multiply(square, real_sqrt(square));
    let product = real_multiply(h.rest, real_add(real_uint(1, 0), h.g));
    // 1 / (4 pi).
    let scaled = real_multiply(
        product,
        Real {
            m: 2_734_261_102,
            e: -35,
            negative: false,
        },
    );
    real_float(real_divide(scaled, cube))
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn henyey_greenstein_invert(h: HenyeyGreenstein, direction: Vec3) -> UVec2 {
    let v = henyey_greenstein_versines(direction);
    let mut below = v.below;
    let mut above = v.above;
    if h.backward {
        below = v.above;
        above = v.below;
    }
    let sum = real_add(real_uint(1, 0), h.g);
    let root = real_sqrt(real_add(
        real_square(h.rest),
        real_shift(real_multiply(h.g, below), 1),
    ));
    let a = real_divide(
        real_multiply(h.rest, above),
        real_multiply(root, real_add(sum, root)),
    );
    let b = real_divide(
        real_multiply(sum, below),
        real_multiply(root, real_add(h.rest, root)),
    );
    let phi = atan2(direction.y, direction.x);
    if h.backward {
        return uvec2(real_fraction_of(b, a), phi);
    }
    uvec2(real_fraction_of(a, b), phi)
}
