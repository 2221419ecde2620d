//! A direction with its pdf, and a direction from height, radius and angle.
//!
//! Source: cylindrical coordinates. Domain: any reals. range: no infinity or NaN. Errors:
//! each coordinate half a ULP more than its real's error. Tier I.
//! Mirror: `shaders/corput/scattered.glsl`.

use crate::reference::elementary::sincos_scaled;
use crate::reference::real::{Real, real_float, real_multiply, real_scaled};
use crate::reference::real_vector::{Real3, real3_floats};
use glam::Vec3;

/// A direction, and the density there with respect to solid angle: of the exact direction,
/// not of the rounded one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scattered {
    /// The unit vector.
    pub direction: Vec3,
    /// The density.
    pub pdf: f32,
}

/// Both rounded to float.
#[inline]
#[must_use]
pub fn scattered(direction: Real3, pdf: Real) -> Scattered {
    Scattered {
        direction: real3_floats(direction),
        pdf: real_float(pdf),
    }
}

/// (radius cos 2 pi phi, radius sin 2 pi phi, z), phi a fraction of 2^32.
#[inline]
#[must_use]
pub fn real3_around(radius: Real, phi: u32, z: Real) -> Real3 {
    let angle = sincos_scaled(phi);
    Real3 {
        x: real_multiply(radius, real_scaled(angle.cosine, angle.cosine_negative)),
        y: real_multiply(radius, real_scaled(angle.sine, angle.sine_negative)),
        z,
    }
}
