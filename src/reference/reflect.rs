//! Reflection and refraction at a microfacet, with their Jacobians: what turns the pdf of
//! a normal into that of a direction.
//!
//! Source: Walter et al. 2007, Microfacet models for refraction through rough surfaces,
//! eq. 13 to 17, 39, 40. With c = |w.h|, c' = |t.h|: c / eta - c' = (1 - eta^2) / (eta (c +
//! eta c')), and the Jacobian eta^2 c' / (c - eta c')^2 = c' (eta (c + eta c') / (1 -
//! eta^2))^2, neither of which cancels as eta nears 1; 1 - c^2 is |w x h|^2, which does
//! not cancel at normal incidence. Domain: w points away from the surface, h to either
//! side; both are normalised. eta is the index of refraction beyond the surface over that
//! on the side of w. Beyond total internal reflection, for eta <= 0 and for w or h = 0
//! nothing is refracted: direction and Jacobian are 0. Range: unit vectors to 2^-23; a
//! Jacobian from 0 to the largest float, which stands for infinity: reflection at h
//! perpendicular to w, refraction for eta = 1. Errors: directions 0.6 ULP, or 2^-28; the
//! Jacobian of reflection 0.6 ULP or 2^-29 / |w.h|, of refraction 2^-22 or 2^-26 (1 + |w
//! x h|^2 / (eta c')^2). Tier I.
//! Mirror: `shaders/corput/reflect.glsl`.

use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_multiply, real_negate, real_shift,
    real_sqrt, real_square, real_subtract, real_uint, real_zero,
};
use crate::reference::real_vector::{
    Real3, real3, real3_cross, real3_dot, real3_floats, real3_normalize, real3_scale,
    real3_subtract,
};
use glam::Vec3;

/// A direction beyond a microfacet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bent {
    /// The unit vector; 0 where there is none.
    pub direction: Vec3,
    /// Solid angle of normals per solid angle of directions.
    pub jacobian: f32,
}

/// w reflected at h, and the Jacobian 1 / (4 |w.h|).
#[inline]
#[must_use]
pub fn reflect(w: Vec3, h: Vec3) -> Bent {
    let o = real3_normalize(real3(w));
    let n = real3_normalize(real3(h));
    let cosine = real3_dot(o, n);
    let direction = real3_subtract(real3_scale(n, real_shift(cosine, 1)), o);
    let jacobian = real_divide(
        real_uint(1, -2),
        Real {
            m: cosine.m,
            e: cosine.e,
            negative: false,
        },
    );
    Bent {
        direction: real3_floats(direction),
        jacobian: real_float(jacobian),
    }
}

/// w refracted at h, and the Jacobian eta^2 |t.h| / (|w.h| - eta |t.h|)^2.
#[inline]
#[must_use]
pub fn refract(w: Vec3, h: Vec3, eta: f32) -> Bent {
    let o = real3_normalize(real3(w));
    let mut n = real3_normalize(real3(h));
    let index = real(eta);
    let mut cosine = real3_dot(o, n);
    if cosine.negative {
        cosine = real_negate(cosine);
        n = real3_subtract(
            Real3 {
                x: real_zero(),
                y: real_zero(),
                z: real_zero(),
            },
            n,
        );
    }
    let across = real3_cross(o, n);
    let sine_square = real3_dot(across, across);
    let rest = real_subtract(real_square(index), sine_square);
    if index.negative || rest.negative || rest.m == 0 || (cosine.m == 0 && sine_square.m == 0) {
        return Bent {
            direction: Vec3::ZERO,
            jacobian: 0.0,
        };
    }
    // eta c', and eta (c / eta - c').
    let beyond = real_sqrt(rest);
    let one = real_uint(1, 0);
    let sum = real_add(cosine, beyond);
    let step = real_multiply(real_subtract(one, index), real_add(one, index));
    let along = real_divide(step, sum);
    let bent = real3_subtract(real3_scale(n, along), o);
    let direction = Real3 {
        x: real_divide(bent.x, index),
        y: real_divide(bent.y, index),
        z: real_divide(bent.z, index),
    };
    // eta c' eta / (eta c' - c)^2.
    let jacobian = real_divide(real_multiply(beyond, index), real_square(along));
    Bent {
        direction: real3_floats(direction),
        jacobian: real_float(jacobian),
    }
}
