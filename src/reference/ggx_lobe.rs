//! A GGX lobe seen from one direction: what its visible normals and its reflection have
//! in common whatever they are sampled by.
//!
//! Source: Heitz 2018, Sampling the GGX distribution of visible normals, JCGT 7(4); Dupuy
//! and Benyoub 2023, Sampling visible GGX normals with spherical caps, CGF 42(8). With V
//! = S wo / |S wo| and n the normal of the unit sphere, S stretching x and y by alpha: h
//! = S n / |S n|, wo.h = |S wo| (V.n) / |S n|, D(h) = |S n|^4 / (pi alpha_x alpha_y
//! |n|^4), and G1 / wo.z = 2 / (wo.z + |S wo|). Domain: alpha of any size; its sign does
//! not count, and what is below 2^-60 counts as that: a mirror, to the precision of
//! floats. wo of any length; above the horizon, on it, and below it, where the normals
//! that Smith's surface shows downwards are few but not none (Heitz et al. 2016). wo = 0
//! counts as +z; from straight below nothing is visible: the pdf is 0 and the sample -wo.
//! Infinities and NaN count as large numbers. Range: unit vectors to 2^-23; pdf from 0 to
//! the largest float. Pdf: with respect to solid angle of wi, over the sphere: reflected
//! directions may lie below the horizon. A rounded direction belongs to a normal up to
//! 2^-24 / alpha away in units of the lobe, where the pdf may differ by four times that;
//! hence samples carry the pdf of the exact direction. Errors: samples, see the map. The
//! pdf of a direction, taken as exact: 2^-29 (4 + 4 / alpha) of it; weights 0.6 ULP. Tier
//! I.
//! Mirror: `shaders/corput/ggx_lobe.glsl`.

use crate::reference::ggx::{ggx_alpha, ggx_density, ggx_stretched};
use crate::reference::real::{
    Real, real_add, real_divide, real_float, real_less, real_multiply, real_shift, real_sqrt,
    real_square, real_uint, real_zero,
};
use crate::reference::real_vector::{
    Real3, real3, real3_add, real3_dot, real3_length, real3_normalize, real3_scale, real3_subtract,
};
use crate::reference::scattered::{Scattered, scattered};
use glam::{Vec2, Vec3};

/// A lobe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ggx {
    /// |alpha.x|.
    pub alpha_x: Real,
    /// |alpha.y|.
    pub alpha_y: Real,
    /// The unit direction from which it is seen.
    pub wo: Real3,
    /// The same stretched, and normalised.
    pub view: Real3,
    /// The length of the stretched wo.
    pub stretch: Real,
    /// 1 - view.z.
    pub view_below: Real,
    /// 1 + b, where the cap of reflections on the unit sphere is z > -b: of all visible
    /// normals b = view.z.
    pub cap_above: Real,
    /// 1 - b.
    pub cap_below: Real,
    /// view.z - b.
    pub excess: Real,
}

/// The lobe of all visible normals.
#[inline]
#[must_use]
pub fn ggx_prepare(alpha: Vec2, wo: Vec3) -> Ggx {
    let alpha_x = ggx_alpha(alpha.x);
    let alpha_y = ggx_alpha(alpha.y);
    let mut o = real3_normalize(real3(wo));
    if o.x.m == 0 && o.y.m == 0 && o.z.m == 0 {
        o.z = real_uint(1, 0);
    }
    let stretched = ggx_stretched(alpha_x, alpha_y, o);
    let stretch = real3_length(stretched);
    // stretch + |z|, and stretch - |z| without cancellation.
    let wide = real_add(
        stretch,
        Real {
            m: o.z.m,
            e: o.z.e,
            negative: false,
        },
    );
    let flat_square = real_add(real_square(stretched.x), real_square(stretched.y));
    let narrow = real_divide(flat_square, wide);
    let mut above = real_divide(wide, stretch);
    let mut below = real_divide(narrow, stretch);
    if o.z.negative {
        above = real_divide(narrow, stretch);
        below = real_divide(wide, stretch);
    }
    let view = Real3 {
        x: real_divide(stretched.x, stretch),
        y: real_divide(stretched.y, stretch),
        z: real_divide(stretched.z, stretch),
    };
    Ggx {
        alpha_x,
        alpha_y,
        wo: o,
        view,
        stretch,
        view_below: below,
        cap_above: above,
        cap_below: below,
        excess: real_zero(),
    }
}

/// Twice the projected area of the visible normals, wo.z + |S wo|, or of those of the cap.
#[inline]
#[must_use]
pub fn ggx_area(g: Ggx) -> Real {
    real_multiply(g.stretch, g.cap_above)
}

/// a over that area; 0 where nothing is visible.
#[inline]
#[must_use]
pub fn ggx_over_area(g: Ggx, a: Real) -> Real {
    let mut quotient = real_divide(a, ggx_area(g));
    if g.cap_above.m == 0 {
        quotient = real_zero();
    }
    quotient
}

/// D(h) for the normal n of the unit sphere, of squared length n_square, where S n has the
/// squared length s_square.
#[inline]
#[must_use]
pub fn ggx_density_of(g: Ggx, s_square: Real, n_square: Real) -> Real {
    let ratio = real_divide(s_square, n_square);
    let area = real_multiply(g.alpha_x, g.alpha_y);
    // 1 / pi.
    real_divide(
        real_multiply(
            real_square(ratio),
            Real {
                m: 2_734_261_102,
                e: -33,
                negative: false,
            },
        ),
        area,
    )
}

/// wo reflected at s = S n for the normal n of the unit sphere, with V.n = cosine.
#[inline]
#[must_use]
pub fn ggx_reflected(g: Ggx, s: Real3, s_square: Real, cosine: Real) -> Real3 {
    // 2 (wo.h) h - wo.
    let scale = real_shift(real_divide(real_multiply(g.stretch, cosine), s_square), 1);
    real3_subtract(real3_scale(s, scale), g.wo)
}

/// The pdf D / (2 area) of that direction, for the normal n of squared length n_square.
#[inline]
#[must_use]
pub fn ggx_reflected_pdf(g: Ggx, s_square: Real, n_square: Real) -> Real {
    real_shift(ggx_over_area(g, ggx_density_of(g, s_square, n_square)), -1)
}

/// The microfacet normal for the normal n of the unit sphere, and its pdf 2 (wo.h) D / area.
#[inline]
#[must_use]
pub fn ggx_normal(g: Ggx, n: Real3, n_square: Real, cosine: Real) -> Scattered {
    let s = ggx_stretched(g.alpha_x, g.alpha_y, n);
    let s_square = real3_dot(s, s);
    let inverse = real_divide(real_uint(1, 0), real_sqrt(s_square));
    let wo_h = real_multiply(real_multiply(g.stretch, cosine), inverse);
    let pdf = ggx_over_area(
        g,
        real_multiply(real_shift(wo_h, 1), ggx_density_of(g, s_square, n_square)),
    );
    scattered(real3_scale(s, inverse), pdf)
}

/// V + V', where V' is V reflected at the normal of the unit sphere whose facet reflects wo
/// to wi; h is wo + wi.
#[inline]
#[must_use]
pub fn ggx_sphere_sum(g: Ggx, h: Real3) -> Real3 {
    let area = real_multiply(g.alpha_x, g.alpha_y);
    let shrunk = Real3 {
        x: real_multiply(h.x, g.alpha_y),
        y: real_multiply(h.y, g.alpha_x),
        z: real_multiply(h.z, area),
    };
    let scale = real_divide(
        real_multiply(real3_dot(h, h), area),
        real_multiply(real3_dot(shrunk, shrunk), g.stretch),
    );
    real3_scale(shrunk, scale)
}

/// wo + wi, a multiple of the normal between them. The length of a rounded wi, 2^-25 off, would
/// turn that of nearly opposite directions.
#[inline]
#[must_use]
pub fn ggx_half(g: Ggx, wi: Vec3) -> Real3 {
    real3_add(real3_normalize(real3(wi)), g.wo)
}

/// The pdf D(h) / (2 area) of a reflected direction; 0 outside the cap.
#[inline]
#[must_use]
pub fn ggx_pdf(g: Ggx, wi: Vec3) -> f32 {
    let h = ggx_half(g, wi);
    // Nothing is outside above the horizon, whatever rounding says.
    if real_less(h.z, g.wo.z) && real_less(ggx_sphere_sum(g, h).z, g.excess) {
        return 0.0;
    }
    let pdf = ggx_over_area(g, ggx_density(g.alpha_x, g.alpha_y, h));
    real_float(real_shift(pdf, -1))
}

/// The weight G2 cos D / (4 cos cos' pdf) of a reflected direction, without Fresnel's term:
/// for all visible normals G2 / G1, at most 1. 0 where wo or wi lies below the horizon.
#[inline]
#[must_use]
pub fn ggx_weight_of(g: Ggx, i: Real3) -> Real {
    let stretch = real3_length(ggx_stretched(g.alpha_x, g.alpha_y, i));
    let sum = real_add(
        real_multiply(i.z, g.stretch),
        real_multiply(g.wo.z, stretch),
    );
    let mut weight = real_divide(real_multiply(i.z, ggx_area(g)), sum);
    if (u32::from(g.wo.z.negative) | u32::from(i.z.negative)) != 0 {
        weight = real_zero();
    }
    weight
}

/// The same of a rounded direction.
#[inline]
#[must_use]
pub fn ggx_weight(g: Ggx, wi: Vec3) -> f32 {
    real_float(ggx_weight_of(g, real3(wi)))
}
