//! Offsets from a pixel's centre by the magnitude of the filter of Mitchell and Netravali
//! in the native profile, with pdf, inverse and signed weight.
//!
//! Source: as filter_mitchell.glsl, in float. Domain: radius from 1e-30 on, below it
//! counts as that; B and C from 0 to 1; two fractions. A host may set tail and lobe,
//! which prepare knows to 2^-22 of themselves: samples next to the change of sign go with
//! the root of that. Pdf: with respect to area, of |f|; that of a sample by its
//! fractions. Errors: 2^-20 of the radius, 2^-16 of the pdf of a sample, for the shares
//! that it has.
//! Mirror: `shaders/corput/native/filter_mitchell.glsl`.

use crate::reference::native::disk::{native_fraction, native_unit};
use crate::reference::native::filter::{
    NativeFilterSample, native_filter_fractions, native_filter_point, native_filter_share,
    native_filter_side,
};
use crate::reference::native::free_flight::native_positive;
use glam::{UVec2, Vec2, Vec4, vec4};

/// The filter of a radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeFilterMitchell {
    /// The radius.
    pub radius: f32,
    /// B.
    pub b: f32,
    /// C.
    pub c: f32,
    /// B + 6 C.
    pub sum: f32,
    /// The change of sign, from the edge.
    pub zero: f32,
    /// The integral of 6 |f| over one side.
    pub total: f32,
    /// What share of it lies beyond 1/2.
    pub inner: u32,
    /// Beyond 1.
    pub tail: u32,
    /// Beyond the change of sign.
    pub lobe: u32,
}

/// A distance z within a part: 0 from the centre, 1 from 1 inwards, 2 from the change of sign
/// inwards, 3 from there outwards, 4 from the edge. The integral of 6 |f| up to it is terms.x
/// z + terms.y z^2 + terms.z z^3 + terms.w z^4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeMitchell {
    /// The part.
    pub part: u32,
    /// The distance.
    pub z: f32,
    /// The coefficients.
    pub terms: Vec4,
}

/// a / b; 1, which no distance exceeds, for b = if 0.
#[inline]
#[must_use]
pub fn native_mitchell_ratio(a: f32, b: f32) -> f32 {
    if b > 1e-30 { a / b } else { 1.0 }
}

/// A distance within a part.
#[inline]
#[must_use]
pub fn native_mitchell(f: NativeFilterMitchell, part: u32, z: f32) -> NativeMitchell {
    let bent = 3.0 - 2.25 * f.b - 1.5 * f.c;
    let mut terms = vec4(6.0 - 2.0 * f.b, 0.0, 4.0 * f.b + 2.0 * f.c - 6.0, bent);
    if part == 1 {
        terms = vec4(
            f.b,
            1.5 * f.b + 3.0 * f.c,
            6.0 - 5.0 * f.b - 4.0 * f.c,
            -bent,
        );
    }
    if part == 2 {
        terms = vec4(0.0, 3.0 * f.c * f.zero, 4.0 * f.c, 0.25 * f.sum);
    }
    if part == 3 {
        terms = vec4(0.0, 3.0 * f.c * f.zero, -4.0 * f.c, 0.25 * f.sum);
    }
    if part == 4 {
        terms = vec4(0.0, 0.0, 2.0 * f.c, -0.25 * f.sum);
    }
    NativeMitchell { part, z, terms }
}

/// The integral of 6 |f| over the part up to z.
#[inline]
#[must_use]
pub fn native_mitchell_mass(at: NativeMitchell) -> f32 {
    at.z * (at.terms.x + at.z * (at.terms.y + at.z * (at.terms.z + at.z * at.terms.w)))
}

/// 6 |f| there.
#[inline]
#[must_use]
pub fn native_mitchell_density(at: NativeMitchell) -> f32 {
    let p = 3.0 * at.terms.z + at.z * (4.0 * at.terms.w);
    (at.terms.x + at.z * (2.0 * at.terms.y + at.z * p)).max(0.0)
}

/// A share of the total as an even fraction of 2^32: samples have odd ones.
#[inline]
#[must_use]
pub fn native_mitchell_share(mass: f32, total: f32) -> u32 {
    native_fraction(0.5 * mass / total) << 1
}

/// The filter of this radius, B and C.
#[inline]
#[must_use]
pub fn native_filter_mitchell_prepare(radius: f32, b: f32, c: f32) -> NativeFilterMitchell {
    let first = b.clamp(0.0, 1.0);
    let second = c.clamp(0.0, 1.0);
    let sum = first + 6.0 * second;
    let zero = native_mitchell_ratio(6.0 * second, sum);
    let lobe = 0.5 * second * zero * zero * zero;
    let total = 3.0 + 2.0 * lobe;
    let r = native_positive(radius);
    let mut f = NativeFilterMitchell {
        radius: r,
        b: first,
        c: second,
        sum,
        zero,
        total,
        inner: 0,
        tail: 0,
        lobe: 0,
    };
    let outer = native_mitchell_mass(native_mitchell(f, 2, native_mitchell_ratio(first, sum)));
    let core = native_mitchell_mass(native_mitchell(f, 0, 0.5));
    f.inner = native_mitchell_share(total - core, total);
    f.tail = native_mitchell_share(outer + lobe, total);
    f.lobe = native_mitchell_share(lobe, total);
    f
}

/// A distance at least that of this mass in the part, and at most twice it; or, of part 0, at
/// most that.
#[inline]
#[must_use]
pub fn native_mitchell_start(at: NativeMitchell, mass: f32) -> f32 {
    let scaled = if at.part == 3 { 1.625 * mass } else { mass };
    let linear = native_mitchell_ratio(mass, at.terms.x);
    let mut z = linear.min(native_mitchell_ratio(scaled, at.terms.y).sqrt());
    if at.part == 1 || at.part == 4 {
        let cubic = if at.part == 1 { 3.0 } else { 0.5 * at.terms.z };
        z = z.min(native_mitchell_ratio(mass, cubic).powf(0.33333334));
    }
    if at.part == 2 {
        z = z.min(native_mitchell_ratio(mass, at.terms.w).sqrt().sqrt());
    }
    z
}

/// Where this share of one side, an odd fraction of 2^32, lies within.
#[inline]
#[must_use]
pub fn native_mitchell_quantile(f: NativeFilterMitchell, share: u32) -> NativeMitchell {
    let rest = 0u32.wrapping_sub(share);
    let mut part = 0;
    let mut left = share;
    if rest < f.inner {
        part = 1;
        left = rest.wrapping_sub(f.tail);
    }
    if rest < f.tail {
        part = 2;
        left = rest - f.lobe;
    }
    if rest < f.lobe {
        part = 3;
        left = f.lobe - rest;
    }
    // 16/27 of the lobe are beyond its peak.
    if rest < (f.lobe as f32 * 0.5925926) as u32 {
        part = 4;
        left = rest;
    }
    let mass = f.total * native_unit(left);
    let mut at = native_mitchell(f, part, 0.0);
    at.z = native_mitchell_start(at, mass);
    for _ in 0..5 {
        let excess = native_mitchell_mass(at) - mass;
        at.z = (at.z - excess / native_mitchell_density(at)).max(1e-12);
    }
    at
}

/// |x| over the radius.
#[inline]
#[must_use]
pub fn native_mitchell_distance(f: NativeFilterMitchell, at: NativeMitchell) -> f32 {
    if at.part == 0 {
        return 0.5 * at.z;
    }
    if at.part == 1 {
        return 0.5 * (1.0 - at.z);
    }
    let mut y = at.z;
    if at.part == 2 {
        y = f.zero + at.z;
    }
    if at.part == 3 {
        y = f.zero - at.z;
    }
    (1.0 - 0.5 * y).min(1.0)
}

/// Where |x| lies, at most the radius.
#[inline]
#[must_use]
pub fn native_mitchell_locate(f: NativeFilterMitchell, x: f32) -> NativeMitchell {
    let d = 2.0 * x.abs();
    let y = (2.0 * f.radius - d).max(0.0) / f.radius;
    let mut part = 4;
    let mut z = y;
    if y > 0.6666667 * f.zero {
        part = 3;
        z = f.zero - y;
    }
    if y > f.zero {
        part = 2;
        z = y - f.zero;
    }
    if d < f.radius {
        part = 1;
        z = (f.radius - d) / f.radius;
    }
    if 2.0 * d < f.radius {
        part = 0;
        z = d / f.radius;
    }
    native_mitchell(f, part, z)
}

/// The magnitude of the filter around the centre.
#[inline]
#[must_use]
pub fn native_filter_mitchell(f: NativeFilterMitchell, u: UVec2) -> NativeFilterSample {
    let x = native_mitchell_quantile(f, native_filter_share(u.x));
    let y = native_mitchell_quantile(f, native_filter_share(u.y));
    let right = f.radius * native_mitchell_distance(f, x);
    let up = f.radius * native_mitchell_distance(f, y);
    let mut pdf = native_mitchell_density(x) / (f.total * f.radius);
    pdf *= native_mitchell_density(y) / (f.total * f.radius);
    NativeFilterSample {
        p: native_filter_point(right, up, u),
        pdf,
    }
}

/// |f(2 x / r) f(2 y / r)| over its integral, within the square.
#[inline]
#[must_use]
pub fn native_filter_mitchell_pdf(f: NativeFilterMitchell, p: Vec2) -> f32 {
    if (p.x.abs()).max(p.y.abs()) > f.radius {
        return 0.0;
    }
    let x = native_mitchell_density(native_mitchell_locate(f, p.x));
    let y = native_mitchell_density(native_mitchell_locate(f, p.y));
    x / (f.total * f.radius) * (y / (f.total * f.radius))
}

/// The filter, of integral 1, over the pdf: the integral of its magnitude, with its sign; 0
/// beyond the radius.
#[inline]
#[must_use]
pub fn native_filter_mitchell_weight(f: NativeFilterMitchell, p: Vec2) -> f32 {
    if (p.x.abs()).max(p.y.abs()) > f.radius {
        return 0.0;
    }
    let x = native_mitchell_locate(f, p.x).part;
    let y = native_mitchell_locate(f, p.y).part;
    let magnitude = f.total / 3.0;
    native_filter_side(magnitude * magnitude, (x > 2) != (y > 2))
}

/// The fraction of one side within |x|.
#[inline]
#[must_use]
pub fn native_mitchell_within(f: NativeFilterMitchell, x: f32) -> f32 {
    let at = native_mitchell_locate(f, x);
    let share = native_mitchell_mass(at) / f.total;
    if at.part == 0 {
        return share;
    }
    if at.part == 1 {
        return 1.0 - native_unit(f.tail) - share;
    }
    if at.part == 2 {
        return 1.0 - native_unit(f.lobe) - share;
    }
    if at.part == 3 {
        return 1.0 - native_unit(f.lobe) + share;
    }
    1.0 - share
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn native_filter_mitchell_invert(f: NativeFilterMitchell, p: Vec2) -> UVec2 {
    native_filter_fractions(
        native_mitchell_within(f, p.x),
        native_mitchell_within(f, p.y),
        p,
    )
}
