//! Free flight through a homogeneous medium in the native profile, with pdf and inverse,
//! by the device's own log and exp.
//!
//! Source: PBRT 4th ed., A.4.2; the logarithm's series where u is small. Domain: sigma
//! from 1e-30 to 1e30, below it counts as that; a fraction u of 2^32. Pdf: with respect
//! to length: sigma e^(-sigma t), 0 for t < 0. Errors: Vulkan allows log 3 ULP and exp 3 +
//! 2 |x| ULP.
//! Mirror: `shaders/corput/native/free_flight.glsl`.

use crate::reference::native::disk::{native_fraction, native_unit};
use crate::reference::native::hemisphere::native_complement;

/// A length and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeFreeFlight {
    /// The length.
    pub t: f32,
    /// Its density.
    pub pdf: f32,
}

/// x, and at least 1e-30: what is divided by.
#[inline]
#[must_use]
pub fn native_positive(x: f32) -> f32 {
    if x > 1e-30 { x } else { 1e-30 }
}

/// -ln(1 - u), u a fraction of 2^32. Next to 1 Vulkan allows log an absolute error, so that
/// small u go by the series.
#[inline]
#[must_use]
pub fn native_negative_log(u: u32) -> f32 {
    if u < 0x1000_0000 {
        let x = native_unit(u);
        return x
            * (1.0 + x * (0.5 + x * (0.333_333_34 + x * (0.25 + x * (0.2 + x * 0.166_666_67)))));
    }
    -(native_complement(u)).ln()
}

/// The length that light flies through the medium of sigma.
#[inline]
#[must_use]
pub fn native_exponential(sigma: f32, u: u32) -> NativeFreeFlight {
    let rate = native_positive(sigma);
    let t = native_negative_log(u) / rate;
    NativeFreeFlight {
        t,
        pdf: rate * native_complement(u),
    }
}

/// sigma e^(-sigma t); 0 for t < 0.
#[inline]
#[must_use]
pub fn native_exponential_pdf(sigma: f32, t: f32) -> f32 {
    let rate = native_positive(sigma);
    if t >= 0.0 {
        rate * (-(rate * t)).exp()
    } else {
        0.0
    }
}

/// The fraction that gives this length.
#[inline]
#[must_use]
pub fn native_exponential_invert(sigma: f32, t: f32) -> u32 {
    native_fraction(1.0 - (-(native_positive(sigma) * t)).exp())
}
