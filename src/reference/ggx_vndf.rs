//! The visible normals of a GGX lobe, and reflection at them, with pdf and inverse.
//!
//! Source: Heitz 2018, Sampling the GGX distribution of visible normals, JCGT 7(4): with
//! V = (sin e, cos), t1 = sqrt(u) cos phi, A = sqrt(1 - t1^2), s = (1 + V.z) / 2 and t2 =
//! A - s (A - sqrt(u) sin phi), the normal is t1 T1 + t2 T2 + w V, w = sqrt(A^2 - t2^2).
//! By q = s (A - sqrt(u) sin phi), w = sqrt(q (2 A - q)); and (A - sqrt(u) sin phi)(A +
//! sqrt(u) sin phi) = 1 - u, so that neither cancels; nor does the height t2 sin + w cos
//! of the normal, see ggx_vndf_height. Domain: two fractions of 2^32: u.x radius,
//! u.y angle on the projected area. Lobes as ggx_lobe.glsl, of all visible normals. A V
//! of +z or -z has T1 = +x. Range: unit vectors to 2^-23; reflected directions may lie
//! below the horizon. Pdf: with respect to solid angle: of normals 2 (wo.h) D / (wo.z +
//! |S wo|), of directions a fourth of that over wo.h. Errors: a coordinate half a ULP and
//! 2^-26, the pdf 0.9 ULP, also at the edges, and both 2^-32 k, k the largest of alpha_x,
//! alpha_y and 1 over the least. The inverse agrees with the sample to 2^-20 +
//! 2^-21 / (alpha |wo + wi|), and leads back to the same direction; where rounding took
//! the normal below the horizon, to the edge. Tier I.
//! Mirror: `shaders/corput/ggx_vndf.glsl`.

use crate::reference::ggx::{ggx_density, ggx_stretched};
use crate::reference::ggx_lobe::{
    Ggx, ggx_half, ggx_normal, ggx_over_area, ggx_pdf, ggx_reflected, ggx_reflected_pdf,
};
use crate::reference::real::{
    Real, real_add, real_divide, real_float, real_multiply, real_negate, real_shift, real_sqrt,
    real_square, real_subtract, real_uint, real_zero,
};
use crate::reference::real_angle::{real_complement, real_fraction_of, real_turns};
use crate::reference::real_vector::{Real3, real3, real3_dot, real3_length, real3_normalize};
use crate::reference::scattered::{Scattered, real3_around, scattered};
use glam::{UVec2, Vec3, uvec2};

/// A visible normal of the unit sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GgxVisible {
    /// The normal n.
    pub normal: Real3,
    /// V.n.
    pub cosine: Real,
}

/// The sine of V to +z, and the unit vector of its horizontal part: (-y, x) is T1.
#[inline]
#[must_use]
pub fn ggx_vndf_axis(g: Ggx) -> Real3 {
    let sine = real_sqrt(real_add(real_square(g.view.x), real_square(g.view.y)));
    let mut axis = Real3 {
        x: real_divide(g.view.x, sine),
        y: real_divide(g.view.y, sine),
        z: sine,
    };
    if sine.m == 0 {
        axis.y = real_negate(real_uint(1, 0));
    }
    axis
}

/// t2 sin + w cos, given rise = t2 + A cos: where the terms differ in sign, the difference of
/// their squares is rise (t2 - A cos).
#[inline]
#[must_use]
pub fn ggx_vndf_height(sine: Real, cosine: Real, t2: Real, w: Real, a: Real, rise: Real) -> Real {
    let mut first = real_multiply(t2, sine);
    let mut second = real_multiply(w, cosine);
    let plain = u32::from(first.negative == second.negative)
        | u32::from(first.m == 0)
        | u32::from(second.m == 0);
    let other = real_subtract(t2, real_multiply(a, cosine));
    let product = real_multiply(
        rise,
        Real {
            m: other.m,
            e: other.e,
            negative: false,
        },
    );
    if plain == 0 {
        first.negative = false;
        second.negative = false;
    }
    let sum = real_add(first, second);
    let mut height = real_divide(product, sum);
    if plain != 0 {
        height = sum;
    }
    height
}

/// The visible normal of the unit sphere.
#[inline]
#[must_use]
pub fn ggx_vndf_visible(g: Ggx, u: UVec2) -> GgxVisible {
    let radius_square = real_uint(u.x, -32);
    let rest = real_complement(u.x);
    let disk = real3_around(real_sqrt(radius_square), u.y, real_zero());
    let a = real_sqrt(real_add(rest, real_square(disk.y)));
    // A - y and A + y.
    let far = real_add(
        a,
        Real {
            m: disk.y.m,
            e: disk.y.e,
            negative: false,
        },
    );
    let near = real_divide(rest, far);
    let mut less = near;
    let mut more = far;
    if disk.y.negative {
        less = far;
        more = near;
    }
    let s = real_shift(g.cap_above, -1);
    let q = real_multiply(s, less);
    let rise = real_multiply(s, more);
    let t2 = real_subtract(a, q);
    // sqrt(q (A + t2)).
    let w = real_sqrt(real_multiply(
        q,
        real_add(real_multiply(real_shift(g.cap_below, -1), less), more),
    ));
    let axis = ggx_vndf_axis(g);
    let along = real_subtract(real_multiply(w, axis.z), real_multiply(t2, g.view.z));
    let height = ggx_vndf_height(axis.z, g.view.z, t2, w, a, rise);
    let normal = Real3 {
        x: real_subtract(real_multiply(along, axis.x), real_multiply(disk.x, axis.y)),
        y: real_add(real_multiply(along, axis.y), real_multiply(disk.x, axis.x)),
        z: height,
    };
    GgxVisible { normal, cosine: w }
}

/// Direction and pdf.
#[inline]
#[must_use]
pub fn ggx_vndf(g: Ggx, u: UVec2) -> Scattered {
    let v = ggx_vndf_visible(g, u);
    let s = ggx_stretched(g.alpha_x, g.alpha_y, v.normal);
    let s_square = real3_dot(s, s);
    scattered(
        ggx_reflected(g, s, s_square, v.cosine),
        ggx_reflected_pdf(g, s_square, real_uint(1, 0)),
    )
}

/// The pdf of a direction.
#[inline]
#[must_use]
pub fn ggx_vndf_pdf(g: Ggx, wi: Vec3) -> f32 {
    ggx_pdf(g, wi)
}

/// Normal and pdf.
#[inline]
#[must_use]
pub fn ggx_vndf_normal(g: Ggx, u: UVec2) -> Scattered {
    let v = ggx_vndf_visible(g, u);
    ggx_normal(g, v.normal, real_uint(1, 0), v.cosine)
}

/// The pdf of a normal.
#[inline]
#[must_use]
pub fn ggx_vndf_normal_pdf(g: Ggx, normal: Vec3) -> f32 {
    let h = real3_normalize(real3(normal));
    let wo_h = real3_dot(g.wo, h);
    if wo_h.negative {
        return 0.0;
    }
    real_float(ggx_over_area(
        g,
        real_multiply(real_shift(wo_h, 1), ggx_density(g.alpha_x, g.alpha_y, h)),
    ))
}

/// t2 + A cos; where the terms differ in sign, by the difference of the squares of t2 sin and
/// w cos, which is as exact as the sine.
#[inline]
#[must_use]
pub fn ggx_vndf_rise(sine: Real, cosine: Real, t2: Real, w: Real, a: Real) -> Real {
    let near = real_multiply(a, cosine);
    if near.negative == t2.negative {
        return real_add(t2, near);
    }
    let mut first = real_multiply(t2, sine);
    let mut second = real_multiply(w, cosine);
    let height = real_add(first, second);
    first.negative = false;
    second.negative = false;
    let mut other = real_subtract(t2, near);
    other.negative = false;
    real_divide(real_multiply(height, real_add(first, second)), other)
}

/// The fractions that give the normal h, of any length, with wo.h.
#[inline]
#[must_use]
pub fn ggx_vndf_fractions(g: Ggx, h: Real3, wo_h: Real) -> UVec2 {
    let area = real_multiply(g.alpha_x, g.alpha_y);
    let shrunk = Real3 {
        x: real_multiply(h.x, g.alpha_y),
        y: real_multiply(h.y, g.alpha_x),
        z: real_multiply(h.z, area),
    };
    let length = real3_length(shrunk);
    let n = Real3 {
        x: real_divide(shrunk.x, length),
        y: real_divide(shrunk.y, length),
        z: real_divide(shrunk.z, length),
    };
    let axis = ggx_vndf_axis(g);
    let along = real_add(real_multiply(n.x, axis.x), real_multiply(n.y, axis.y));
    let t1 = real_subtract(real_multiply(n.y, axis.x), real_multiply(n.x, axis.y));
    let t2 = real_subtract(real_multiply(n.z, axis.z), real_multiply(along, g.view.z));
    let w = real_divide(real_multiply(wo_h, area), real_multiply(g.stretch, length));
    let t2_square = real_square(t2);
    let w_square = real_square(w);
    let a = real_sqrt(real_add(t2_square, w_square));
    // A - t2, from w^2 where it would cancel.
    let mut q = real_subtract(a, t2);
    if !t2.negative {
        q = real_divide(w_square, real_add(a, t2));
    }
    // A - y and A + y, whose product is 1 - u.
    let s = real_shift(g.cap_above, -1);
    let less = real_divide(q, s);
    let more = real_divide(ggx_vndf_rise(axis.z, g.view.z, t2, w, a), s);
    let y = real_subtract(a, less);
    let square = real_add(real_square(t1), real_square(y));
    uvec2(
        real_fraction_of(square, real_multiply(less, more)),
        real_turns(y, t1),
    )
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn ggx_vndf_invert(g: Ggx, wi: Vec3) -> UVec2 {
    let h = ggx_half(g, wi);
    ggx_vndf_fractions(g, h, real_shift(real3_dot(h, h), -1))
}

/// The fractions that give this normal.
#[inline]
#[must_use]
pub fn ggx_vndf_normal_invert(g: Ggx, normal: Vec3) -> UVec2 {
    let h = real3(normal);
    ggx_vndf_fractions(g, h, real3_dot(g.wo, h))
}
