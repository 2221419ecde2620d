//! Free flight through a homogeneous medium: the exponential distribution, with pdf and
//! inverse.
//!
//! Source: PBRT 4th ed., A.4.2, t = -ln(1 - u) / sigma. Domain: sigma > 0, a fraction u
//! of 2^32. sigma <= 0 gives the largest float, or 0 for u = 0, with pdf 0; a NaN counts
//! as an infinity. Range: t from 0 to 22.2 / sigma, finite. Pdf: with respect to length:
//! sigma e^(-sigma t), 0 for t < 0. That of a sample is sigma (1 - u): t of 24 bits is
//! off by its own size, times sigma. Errors: t 0.51 ULP, pdf of a sample 0.51 ULP, pdf of
//! t 0.53 ULP. Tier I.
//! Mirror: `shaders/corput/free_flight.glsl`.

use crate::reference::exponential::{real_exp_wide, real_exp2m1};
use crate::reference::fixed::mul64;
use crate::reference::logarithm::real_negative_log;
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_fraction, real_max, real_multiply,
    real_negate, real_uint, real_zero,
};
use crate::reference::real_angle::real_complement;

/// A length and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeFlight {
    /// The length.
    pub t: f32,
    /// Its density.
    pub pdf: f32,
}

/// x, or 0 for x < 0.
#[inline]
#[must_use]
pub fn real_positive(x: f32) -> Real {
    real_max(real(x), real_zero())
}

/// 1 - e^(-x) as a fraction of 2^32, rounded to nearest, for x >= 0.
#[inline]
#[must_use]
pub fn exponential_fraction(x: Real) -> u32 {
    // 3_098_164_009 = 2^31 / ln 2.
    let power = real_multiply(x, real_uint(3_098_164_009, -31));
    let mass = real_negate(real_exp2m1(real_negate(power)));
    real_fraction(real_add(mass, real_uint(1, -33)))
}

/// The length that light flies through the medium of sigma.
#[inline]
#[must_use]
pub fn exponential(sigma: f32, u: u32) -> FreeFlight {
    let rate = real_positive(sigma);
    let t = real_divide(real_negative_log(u), rate);
    let pdf = real_multiply(rate, real_complement(u));
    FreeFlight {
        t: real_float(t),
        pdf: real_float(pdf),
    }
}

/// sigma e^(-sigma t); 0 for t < 0.
#[inline]
#[must_use]
pub fn exponential_pdf(sigma: f32, t: f32) -> f32 {
    let rate = real_positive(sigma);
    let x = real(t);
    if x.negative {
        return 0.0;
    }
    // The product is not rounded.
    let decay = real_exp_wide(mul64(rate.m, x.m), rate.e + x.e, true);
    real_float(real_multiply(rate, decay))
}

/// The fraction that gives this length.
#[inline]
#[must_use]
pub fn exponential_invert(sigma: f32, t: f32) -> u32 {
    exponential_fraction(real_multiply(real_positive(sigma), real_positive(t)))
}
