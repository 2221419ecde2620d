//! Reflection and refraction at a microfacet in the native profile, with Jacobians.
//!
//! Source: Walter et al. 2007, as reflect.glsl. Domain: unit vectors: w points away from
//! the surface, h to either side. eta is the index of refraction beyond the surface over
//! that on the side of w. Beyond total internal reflection, for eta <= 0 and NaN direction
//! and Jacobian are 0. Range: unit vectors to the device's precision; the largest float
//! stands for an infinite Jacobian. Errors: about 2^-20.
//! Mirror: `shaders/corput/native/reflect.glsl`.

use crate::reference::native::disk::native_density;
use glam::{Vec3, vec3};

/// A direction beyond a microfacet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeBent {
    /// The unit vector; 0 where there is none.
    pub direction: Vec3,
    /// Solid angle of normals per solid angle of directions.
    pub jacobian: f32,
}

/// w reflected at h, and the Jacobian 1 / (4 |w.h|).
#[must_use]
pub fn native_reflect(w: Vec3, h: Vec3) -> NativeBent {
    let cosine = w.dot(h);
    NativeBent {
        direction: h * (2.0 * cosine) - w,
        jacobian: native_density(0.25 / cosine.abs()),
    }
}

/// w refracted at h, and the Jacobian eta^2 |t.h| / (|w.h| - eta |t.h|)^2.
#[must_use]
pub fn native_refract(w: Vec3, h: Vec3, eta: f32) -> NativeBent {
    let cosine = (w.dot(h)).abs();
    let mut n = h;
    if w.dot(h) < 0.0 {
        n = h * -1.0;
    }
    let across = vec3(
        w.y * n.z - w.z * n.y,
        w.z * n.x - w.x * n.z,
        w.x * n.y - w.y * n.x,
    );
    let rest = eta * eta - across.dot(across);
    let bends = eta > 0.0 && rest > 0.0;
    if !bends {
        return NativeBent {
            direction: vec3(0.0, 0.0, 0.0),
            jacobian: 0.0,
        };
    }
    let beyond = rest.sqrt();
    let along = (1.0 - eta) * (1.0 + eta) / (cosine + beyond);
    let direction = (n * along - w) * (1.0 / eta);
    NativeBent {
        direction,
        jacobian: native_density(beyond * eta / (along * along)),
    }
}
