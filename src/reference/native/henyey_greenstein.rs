//! Directions around +z by the phase function of Henyey and Greenstein in the native
//! profile, with pdf and inverse. +z is the direction of propagation.
//!
//! Source: as henyey_greenstein.glsl: sums of positive terms. Domain: two fractions of
//! 2^32; z grows with u.x. g in (-1, 1): what is beyond counts as 1 - 2^-24 of its sign.
//! Or 1 - |g|: from 2^-60 to 1. Range: unit vectors to the device's precision. Pdf: with
//! respect to solid angle. Errors: x, y, z and the pdf about 2^-20 of themselves, or of
//! 1.
//! Mirror: `shaders/corput/native/henyey_greenstein.glsl`.

use crate::reference::native::disk::{native_density, native_fraction, native_turns, native_unit};
use crate::reference::native::hemisphere::native_complement;
use crate::reference::native::scattered::{NativeScattered, native_around, native_fraction_of};
use glam::{UVec2, Vec3, uvec2};

/// The asymmetry of a phase function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeHenyeyGreenstein {
    /// |g|.
    pub g: f32,
    /// 1 - |g|.
    pub rest: f32,
    /// Whether g < 0.
    pub backward: bool,
}

/// By g.
#[must_use]
pub fn native_henyey_greenstein_prepare(g: f32) -> NativeHenyeyGreenstein {
    let magnitude = (g.abs()).min(0.99999994);
    NativeHenyeyGreenstein {
        g: magnitude,
        rest: 1.0 - magnitude,
        backward: g < 0.0,
    }
}

/// By rest = 1 - |g|, which says more than g where g is near 1 or -1.
#[must_use]
pub fn native_henyey_greenstein_complement(rest: f32, backward: bool) -> NativeHenyeyGreenstein {
    let clamped = rest.clamp(8.673617379884035e-19, 1.0);
    NativeHenyeyGreenstein {
        g: 1.0 - clamped,
        rest: clamped,
        backward,
    }
}

/// Direction and pdf.
#[must_use]
pub fn native_henyey_greenstein(h: NativeHenyeyGreenstein, u: UVec2) -> NativeScattered {
    let mut a = native_unit(u.x);
    let mut b = native_complement(u.x);
    if h.backward {
        a = native_complement(u.x);
        b = native_unit(u.x);
    }
    let sum = 1.0 + h.g;
    let bent = h.g * a;
    let near = b * (1.0 + bent);
    let far = a * (h.rest + bent);
    let d = h.rest + 2.0 * bent;
    // Quotients before squares, which could leave the floats.
    let low = h.rest / d;
    let high = sum / d;
    let below = 2.0 * low * low * near;
    let above = 2.0 * high * high * far;
    let mut z = 1.0 - below;
    if above < below {
        z = above - 1.0;
    }
    if h.backward {
        z = -z;
    }
    let radius = 2.0 * low * high * (near * far).sqrt();
    let scale = d / (h.rest * sum);
    NativeScattered {
        direction: native_around(radius, u.y, z),
        pdf: 0.07957747 * scale * (scale * d),
    }
}

/// The pdf of a direction.
#[must_use]
pub fn native_henyey_greenstein_pdf(h: NativeHenyeyGreenstein, direction: Vec3) -> f32 {
    let mut z = direction.z;
    if h.backward {
        z = -z;
    }
    let mut below = 1.0 - z;
    if z > 0.0 {
        below = (direction.x * direction.x + direction.y * direction.y) / (1.0 + z);
    }
    let root = (h.rest * h.rest + 2.0 * h.g * below).sqrt();
    native_density(0.07957747 * (h.rest / root) * (1.0 + h.g) / (root * root))
}

/// The fractions that give this direction.
#[must_use]
pub fn native_henyey_greenstein_invert(h: NativeHenyeyGreenstein, direction: Vec3) -> UVec2 {
    let square = direction.x * direction.x + direction.y * direction.y;
    let wide = 1.0 + direction.z.abs();
    let same = h.backward == (direction.z < 0.0);
    let mut below = wide;
    let mut above = square / wide;
    if same {
        below = square / wide;
        above = wide;
    }
    let sum = 1.0 + h.g;
    let root = (h.rest * h.rest + 2.0 * h.g * below).sqrt();
    let a = h.rest / root * (above / (sum + root));
    let b = sum / root * (below / (h.rest + root));
    let phi = native_fraction(native_turns(direction.truncate()));
    if h.backward {
        return uvec2(native_fraction_of(b, a), phi);
    }
    uvec2(native_fraction_of(a, b), phi)
}
