//! A GGX lobe seen from one direction in the native profile: what its visible normals and
//! its reflection have in common whatever they are sampled by.
//!
//! Source: as ggx_lobe.glsl. Domain: finite alpha; its sign does not count, and what is
//! below 1e-9 counts as that. wo of any length near 1, above, on or below the horizon;
//! (0, 0, 0) counts as +z. Range: unit vectors to the device's precision. Pdf: with
//! respect to solid angle of wi, over the sphere; never more than the largest float, 0 for
//! what is no direction. Errors: about 2^-20 of a normal of the
//! unit sphere, and 2^-20 / alpha of directions and, relative, of the pdf.
//! Mirror: `shaders/corput/native/ggx_lobe.glsl`.

use crate::reference::native::disk::native_density;
use crate::reference::native::ggx::{
    native_ggx_alpha, native_ggx_distribution, native_ggx_stretch,
};
use crate::reference::native::scattered::{NativeScattered, native_quotient};
use glam::{Vec2, Vec3, vec2, vec3};

/// A lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeGgx {
    /// |alpha|.
    pub alpha: Vec2,
    /// The unit direction from which it is seen.
    pub wo: Vec3,
    /// The same stretched, and normalised.
    pub view: Vec3,
    /// The length of the stretched wo.
    pub stretch: f32,
    /// 1 - view.z.
    pub view_below: f32,
    /// 1 + b, where the cap of reflections on the unit sphere is z > -b.
    pub cap_above: f32,
    /// 1 - b.
    pub cap_below: f32,
    /// view.z - b.
    pub excess: f32,
}

/// The lobe of all visible normals.
#[must_use]
pub fn native_ggx_prepare(alpha: Vec2, wo: Vec3) -> NativeGgx {
    let a = vec2(native_ggx_alpha(alpha.x), native_ggx_alpha(alpha.y));
    let mut o = vec3(0.0, 0.0, 1.0);
    let square = wo.dot(wo);
    if square > 0.0 {
        o = wo * (1.0 / square.sqrt());
    }
    let stretch = native_ggx_stretch(a, o);
    let wide = stretch + o.z.abs();
    let x = o.x * a.x;
    let y = o.y * a.y;
    let narrow = (x * x + y * y) / wide;
    let mut above = wide / stretch;
    let mut below = narrow / stretch;
    if o.z < 0.0 {
        above = narrow / stretch;
        below = wide / stretch;
    }
    let view = vec3(x / stretch, y / stretch, o.z / stretch);
    NativeGgx {
        alpha: a,
        wo: o,
        view,
        stretch,
        view_below: below,
        cap_above: above,
        cap_below: below,
        excess: 0.0,
    }
}

/// Twice the projected area of the visible normals, or of those of the cap.
#[must_use]
pub fn native_ggx_area(g: NativeGgx) -> f32 {
    g.stretch * g.cap_above
}

/// wo reflected at the normal n of the unit sphere, of squared length n_square, with
/// V.n = cosine, and the pdf D / (2 area).
#[must_use]
pub fn native_ggx_reflected(g: NativeGgx, n: Vec3, n_square: f32, cosine: f32) -> NativeScattered {
    let s = vec3(n.x * g.alpha.x, n.y * g.alpha.y, n.z);
    let s_square = s.dot(s);
    let scale = 2.0 * native_quotient(g.stretch * cosine, s_square);
    let ratio = native_quotient(s_square, n_square);
    let density = std::f32::consts::FRAC_1_PI * (ratio / g.alpha.x) * (ratio / g.alpha.y);
    NativeScattered {
        direction: s * scale - g.wo,
        pdf: native_density(native_quotient(density, 2.0 * native_ggx_area(g))),
    }
}

/// The microfacet normal for the normal n of the unit sphere, and its pdf 2 (wo.h) D / area.
#[must_use]
pub fn native_ggx_normal(g: NativeGgx, n: Vec3, n_square: f32, cosine: f32) -> NativeScattered {
    let s = vec3(n.x * g.alpha.x, n.y * g.alpha.y, n.z);
    let s_square = s.dot(s);
    let inverse = native_quotient(1.0, s_square.sqrt());
    let ratio = native_quotient(s_square, n_square);
    let density = std::f32::consts::FRAC_1_PI * (ratio / g.alpha.x) * (ratio / g.alpha.y);
    let wo_h = g.stretch * cosine * inverse;
    NativeScattered {
        direction: s * inverse,
        pdf: native_density(native_quotient(2.0 * wo_h * density, native_ggx_area(g))),
    }
}

/// V + V', where V' is V reflected at the normal of the unit sphere whose facet reflects wo
/// to wi; h is wo + wi.
#[must_use]
pub fn native_ggx_sphere_sum(g: NativeGgx, h: Vec3) -> Vec3 {
    let n = vec3(h.x / g.alpha.x, h.y / g.alpha.y, h.z);
    n * native_quotient(h.dot(h) / g.stretch, n.dot(n))
}

/// wo + wi, a multiple of the normal between them.
#[must_use]
pub fn native_ggx_half(g: NativeGgx, wi: Vec3) -> Vec3 {
    wi * native_quotient(1.0, (wi.dot(wi)).sqrt()) + g.wo
}

/// The pdf D(h) / (2 area) of a reflected direction; 0 outside the cap.
#[must_use]
pub fn native_ggx_pdf(g: NativeGgx, wi: Vec3) -> f32 {
    let h = native_ggx_half(g, wi);
    let n = native_ggx_sphere_sum(g, h);
    // Nothing is outside above the horizon, whatever rounding says.
    if wi.z < 0.0 && n.z < g.excess {
        return 0.0;
    }
    native_density(native_quotient(
        native_ggx_distribution(g.alpha, h),
        2.0 * native_ggx_area(g),
    ))
}

/// The weight G2 cos D / (4 cos cos' pdf) of a reflected direction, without Fresnel's term.
#[must_use]
pub fn native_ggx_weight(g: NativeGgx, wi: Vec3) -> f32 {
    if g.wo.z < 0.0 || wi.z <= 0.0 {
        return 0.0;
    }
    native_density(
        wi.z * native_ggx_area(g) / (wi.z * g.stretch + g.wo.z * native_ggx_stretch(g.alpha, wi)),
    )
}
