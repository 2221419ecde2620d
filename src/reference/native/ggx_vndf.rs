//! The visible normals of a GGX lobe, and reflection at them, in the native profile, with
//! pdf and inverse.
//!
//! Source: Heitz 2018, as ggx_vndf.glsl. Domain: two fractions of 2^32: u.x radius, u.y
//! angle on the projected area. Lobes as ggx_lobe.glsl, of all visible normals. Range:
//! unit vectors to the device's precision. Pdf: with respect to solid angle. Errors: as
//! ggx_lobe.glsl.
//! Mirror: `shaders/corput/native/ggx_vndf.glsl`.

use crate::reference::native::disk::{native_density, native_fraction, native_turns, native_unit};
use crate::reference::native::ggx::native_ggx_distribution;
use crate::reference::native::ggx_lobe::{
    NativeGgx, native_ggx_area, native_ggx_half, native_ggx_normal, native_ggx_pdf,
    native_ggx_reflected,
};
use crate::reference::native::hemisphere::native_complement;
use crate::reference::native::scattered::{
    NativeScattered, native_around, native_fraction_of, native_quotient,
};
use glam::{UVec2, Vec3, uvec2, vec2, vec3};

/// A visible normal of the unit sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeGgxVisible {
    /// The normal n.
    pub normal: Vec3,
    /// V.n.
    pub cosine: f32,
}

/// The sine of V to +z, and the unit vector of its horizontal part: (-y, x) is T1.
#[must_use]
pub fn native_ggx_vndf_axis(g: NativeGgx) -> Vec3 {
    let sine = (g.view.x * g.view.x + g.view.y * g.view.y).sqrt();
    if sine <= 0.0 {
        return vec3(0.0, -1.0, 0.0);
    }
    vec3(g.view.x / sine, g.view.y / sine, sine)
}

/// t2 sin + w cos, given rise = t2 + A cos.
#[must_use]
pub fn native_ggx_vndf_height(sine: f32, cosine: f32, t2: f32, w: f32, a: f32, rise: f32) -> f32 {
    let first = t2 * sine;
    let second = w * cosine;
    if first * second >= 0.0 {
        return first + second;
    }
    rise * (t2 - a * cosine).abs() / (first.abs() + second.abs())
}

/// The visible normal of the unit sphere.
#[must_use]
pub fn native_ggx_vndf_visible(g: NativeGgx, u: UVec2) -> NativeGgxVisible {
    let rest = native_complement(u.x);
    let disk = native_around(native_unit(u.x).sqrt(), u.y, 0.0);
    let a = (rest + disk.y * disk.y).sqrt();
    // A - y and A + y.
    let far = a + disk.y.abs();
    let mut less = rest / far;
    let mut more = far;
    if disk.y < 0.0 {
        less = far;
        more = rest / far;
    }
    let s = 0.5 * g.cap_above;
    let q = s * less;
    let t2 = a - q;
    // sqrt(q (A + t2)).
    let w = (q * (0.5 * g.cap_below * less + more)).sqrt();
    let axis = native_ggx_vndf_axis(g);
    let along = w * axis.z - t2 * g.view.z;
    let height = native_ggx_vndf_height(axis.z, g.view.z, t2, w, a, s * more);
    let normal = vec3(
        along * axis.x - disk.x * axis.y,
        along * axis.y + disk.x * axis.x,
        height,
    );
    NativeGgxVisible { normal, cosine: w }
}

/// Direction and pdf.
#[must_use]
pub fn native_ggx_vndf(g: NativeGgx, u: UVec2) -> NativeScattered {
    let v = native_ggx_vndf_visible(g, u);
    native_ggx_reflected(g, v.normal, 1.0, v.cosine)
}

/// The pdf of a direction.
#[must_use]
pub fn native_ggx_vndf_pdf(g: NativeGgx, wi: Vec3) -> f32 {
    native_ggx_pdf(g, wi)
}

/// Normal and pdf.
#[must_use]
pub fn native_ggx_vndf_normal(g: NativeGgx, u: UVec2) -> NativeScattered {
    let v = native_ggx_vndf_visible(g, u);
    native_ggx_normal(g, v.normal, 1.0, v.cosine)
}

/// The pdf of a normal.
#[must_use]
pub fn native_ggx_vndf_normal_pdf(g: NativeGgx, normal: Vec3) -> f32 {
    let wo_h = g.wo.dot(normal);
    if wo_h <= 0.0 {
        return 0.0;
    }
    native_density(native_quotient(
        2.0 * wo_h * native_ggx_distribution(g.alpha, normal),
        native_ggx_area(g),
    ))
}

/// t2 + A cos; where the terms differ in sign, by the difference of the squares of t2 sin and
/// w cos, which is as exact as the sine.
#[must_use]
pub fn native_ggx_vndf_rise(sine: f32, cosine: f32, t2: f32, w: f32, a: f32) -> f32 {
    let near = a * cosine;
    if near * t2 >= 0.0 {
        return t2 + near;
    }
    let first = t2 * sine;
    let second = w * cosine;
    (first + second) * (first.abs() + second.abs()) / (t2 - near).abs()
}

/// The fractions that give the normal h, of any length, with wo.h.
#[must_use]
pub fn native_ggx_vndf_fractions(g: NativeGgx, h: Vec3, wo_h: f32) -> UVec2 {
    let shrunk = vec3(h.x / g.alpha.x, h.y / g.alpha.y, h.z);
    let inverse = native_quotient(1.0, (shrunk.dot(shrunk)).sqrt());
    let n = shrunk * inverse;
    let axis = native_ggx_vndf_axis(g);
    let along = n.x * axis.x + n.y * axis.y;
    let t1 = n.y * axis.x - n.x * axis.y;
    let t2 = n.z * axis.z - along * g.view.z;
    let w = wo_h * inverse / g.stretch;
    let a = (t2 * t2 + w * w).sqrt();
    // A - t2, from w^2 where it would cancel.
    let mut q = a - t2;
    if t2 > 0.0 {
        q = w * w / (a + t2);
    }
    // A - y and A + y, whose product is 1 - u.
    let less = native_quotient(2.0 * q, g.cap_above);
    let rise = native_ggx_vndf_rise(axis.z, g.view.z, t2, w, a);
    let more = native_quotient(2.0 * rise, g.cap_above);
    let y = a - less;
    uvec2(
        native_fraction_of(t1 * t1 + y * y, less * more),
        native_fraction(native_turns(vec2(t1, y))),
    )
}

/// The fractions that give this direction.
#[must_use]
pub fn native_ggx_vndf_invert(g: NativeGgx, wi: Vec3) -> UVec2 {
    let h = native_ggx_half(g, wi);
    native_ggx_vndf_fractions(g, h, 0.5 * h.dot(h))
}

/// The fractions that give this normal.
#[must_use]
pub fn native_ggx_vndf_normal_invert(g: NativeGgx, normal: Vec3) -> UVec2 {
    native_ggx_vndf_fractions(g, normal, g.wo.dot(normal))
}
