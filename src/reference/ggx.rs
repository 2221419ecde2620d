//! The GGX (Trowbridge-Reitz) microsurface over the plane z = 0, anisotropic: its normals
//! and Smith's shadowing.
//!
//! Source: Walter et al. 2007, Microfacet models for refraction through rough surfaces;
//! Heitz 2014, Understanding the masking-shadowing function, JCGT 3(2), eq. 72, 85, 99.
//! The common (alpha^2 - 1) cos^2 + 1 cancels for small alpha, and tan^2 is infinite at
//! grazing angles; here nothing cancels and nothing divides by cos. Domain: alpha along x
//! and y, of any size; its sign does not count, and for D what is below 2^-60 counts as
//! that. Directions need not be normalised: each function is the same for all lengths.
//! Infinities and NaN count as large numbers. Range: 0 to the largest float. Errors: 0.6
//! ULP. Tier I.
//! Mirror: `shaders/corput/ggx.glsl`.

use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_max, real_multiply, real_shift,
    real_square, real_uint, real_zero,
};
use crate::reference::real_vector::{Real3, real3, real3_dot, real3_length};
use glam::{Vec2, Vec3};

/// (x alpha.x, y alpha.y, z): the direction where the surface is stretched to unit roughness.
#[inline]
#[must_use]
pub fn ggx_stretched(alpha_x: Real, alpha_y: Real, w: Real3) -> Real3 {
    Real3 {
        x: real_multiply(w.x, alpha_x),
        y: real_multiply(w.y, alpha_y),
        z: w.z,
    }
}

/// |alpha|, at least 2^-60.
#[inline]
#[must_use]
pub fn ggx_alpha(alpha: f32) -> Real {
    let a = real(alpha);
    real_max(
        Real {
            m: a.m,
            e: a.e,
            negative: false,
        },
        real_uint(1, -60),
    )
}

/// |stretched w|.
#[inline]
#[must_use]
pub fn ggx_stretch(alpha: Vec2, w: Vec3) -> Real {
    real3_length(ggx_stretched(real(alpha.x), real(alpha.y), real3(w)))
}

/// The density of normals D at h with respect to solid angle; 0 for h.z <= 0.
#[inline]
#[must_use]
pub fn ggx_density(alpha_x: Real, alpha_y: Real, h: Real3) -> Real {
    // alpha_x alpha_y / pi (|h|^2 / (alpha_x alpha_y |h'|^2))^2, with h' shrunk by alpha and
    // multiplied by alpha_x alpha_y so that nothing is divided by alpha.
    let area = real_multiply(alpha_x, alpha_y);
    let shrunk = Real3 {
        x: real_multiply(h.x, alpha_y),
        y: real_multiply(h.y, alpha_x),
        z: real_multiply(h.z, area),
    };
    let ratio = real_divide(
        real_multiply(area, real3_dot(h, h)),
        real3_dot(shrunk, shrunk),
    );
    // 1 / pi.
    let mut density = real_multiply(
        real_multiply(area, real_square(ratio)),
        Real {
            m: 2_734_261_102,
            e: -33,
            negative: false,
        },
    );
    if (u32::from(h.z.negative) | u32::from(h.z.m == 0)) != 0 {
        density = real_zero();
    }
    density
}

/// D at h.
#[inline]
#[must_use]
pub fn ggx_distribution(alpha: Vec2, h: Vec3) -> f32 {
    real_float(ggx_density(
        ggx_alpha(alpha.x),
        ggx_alpha(alpha.y),
        real3(h),
    ))
}

/// Smith's Lambda = (|stretched w| / w.z - 1) / 2; the largest float for w.z <= 0.
#[inline]
#[must_use]
pub fn ggx_lambda(alpha: Vec2, w: Vec3) -> f32 {
    let x = real_multiply(real(w.x), real(alpha.x));
    let y = real_multiply(real(w.y), real(alpha.y));
    let z = real(w.z);
    if z.negative || z.m == 0 {
        return f32::from_bits(0x7f7f_ffff);
    }
    let sum = real_add(z, ggx_stretch(alpha, w));
    let flat_square = real_add(real_square(x), real_square(y));
    real_float(real_divide(
        flat_square,
        real_shift(real_multiply(z, sum), 1),
    ))
}

/// Smith's masking G1 = 1 / (1 + Lambda) = 2 z / (z + |stretched w|): 0 for w.z <= 0.
#[inline]
#[must_use]
pub fn ggx_g1(alpha: Vec2, w: Vec3) -> f32 {
    let z = real(w.z);
    if z.negative || z.m == 0 {
        return 0.0;
    }
    real_float(real_divide(
        real_shift(z, 1),
        real_add(z, ggx_stretch(alpha, w)),
    ))
}

/// Smith's height-correlated masking and shadowing G2 = 1 / (1 + Lambda + Lambda) =
/// 2 z z' / (z' |stretched wo| + z |stretched wi|): 0 where wo.z or wi.z <= 0.
#[inline]
#[must_use]
pub fn ggx_g2(alpha: Vec2, wo: Vec3, wi: Vec3) -> f32 {
    let o = real(wo.z);
    let i = real(wi.z);
    if o.negative || o.m == 0 || i.negative || i.m == 0 {
        return 0.0;
    }
    let sum = real_add(
        real_multiply(i, ggx_stretch(alpha, wo)),
        real_multiply(o, ggx_stretch(alpha, wi)),
    );
    real_float(real_divide(real_shift(real_multiply(o, i), 1), sum))
}
