//! Directions of a spherical triangle in the native profile, uniformly, with solid angle, pdf
//! and inverse.
//!
//! Source: the sums of `spherical_triangle`, which never cancel: Arvo 1995 and Peters 2021; Van
//! Oosterom and Strackee 1983. Domain: three vertices seen from the origin, of any order, of
//! lengths from 1e-6 to 1e6; two fractions of 2^32; where they span no solid angle, +z with
//! pdf 0. Pdf: with respect to solid angle, 1 over it inside, edges widened by 2^-12 of the
//! longest side.
//! Mirror: `shaders/corput/native/spherical_triangle.glsl`.

use crate::reference::native::disk::{native_fraction, native_unit};
use crate::reference::native::hemisphere::native_complement;
use glam::{UVec2, Vec2, Vec3, uvec2, vec2, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeSphericalTriangle {
    /// The first vertex, as a unit vector.
    pub a: Vec3,
    /// The second.
    pub b: Vec3,
    /// The third.
    pub c: Vec3,
    /// Cosines of half the sides ab, bc, ca.
    pub cosines: Vec3,
    /// Their sines.
    pub sines: Vec3,
    /// Half the solid angle, in radians.
    pub area: f32,
    /// What it lacks of pi.
    pub rest: f32,
    /// The unit normal of ab, inwards.
    pub ab_normal: Vec3,
    /// That of bc.
    pub bc_normal: Vec3,
    /// That of ca.
    pub ca_normal: Vec3,
    /// The unit tangent at b towards a.
    pub tangent: Vec3,
    /// The sine of the angle between b and ca.
    pub height: f32,
}

/// x / |x|; 0 for 0.
#[must_use]
pub fn native_direction(v: Vec3) -> Vec3 {
    let square = v.dot(v);
    if square > 0.0 {
        v / square.sqrt()
    } else {
        Vec3::ZERO
    }
}

/// The sine, with its digits where the angle is small; 0 to pi.
#[must_use]
pub fn native_sine(angle: f32) -> f32 {
    let square = angle * angle;
    if angle < 0.25 {
        return angle
            * (1.0 - square * (0.16666667 - square * (0.0083333333 - square * 0.00019841270)));
    }
    angle.sin()
}

/// Cosine and sine of half the angle between two vectors with this vector product.
#[must_use]
pub fn native_arc(a: Vec3, b: Vec3, across: Vec3) -> Vec2 {
    let product = (a.dot(a) * b.dot(b)).sqrt();
    let cosine = a.dot(b);
    let large = product + cosine.abs();
    let known = large > 0.0;
    if !known {
        return Vec2::ZERO;
    }
    let far = (large / (2.0 * product)).sqrt();
    let near = (across.dot(across) / (large * 2.0 * product)).sqrt();
    if cosine < 0.0 {
        vec2(near, far)
    } else {
        vec2(far, near)
    }
}

/// The triangle with vertices a, b, c, given a x b, b x c, c x a and the triple product.
#[must_use]
pub fn native_spherical_triangle_of(
    a: Vec3,
    b: Vec3,
    c: Vec3,
    ab_across: Vec3,
    bc_across: Vec3,
    ca_across: Vec3,
    volume: f32,
) -> NativeSphericalTriangle {
    let b_length = (b.dot(b)).sqrt();
    let lengths = (a.dot(a)).sqrt() * b_length * (c.dot(c)).sqrt();
    let ab = native_arc(a, b, ab_across);
    let bc = native_arc(b, c, bc_across);
    let ca = native_arc(c, a, ca_across);
    let side = if volume < 0.0 { -1.0 } else { 1.0 };
    let sine = volume.abs();
    let ua = native_direction(a);
    let ub = native_direction(b);
    let uc = native_direction(c);
    let cosine = (1.0 + ua.dot(ub) + ub.dot(uc) + uc.dot(ua)) * lengths;
    // Vertices on each other or opposite have no side between them.
    let seen = sine > 0.0 && (ab.x * ab.y).min((bc.x * bc.y).min(ca.x * ca.y)) > 0.0;
    let area = if seen { sine.atan2(cosine) } else { 0.0 };
    let rest = if seen { sine.atan2(-cosine) } else { 0.0 };
    let ab_normal = native_direction(ab_across);
    let height = sine / (b_length * (ca_across.dot(ca_across)).sqrt()).max(1e-37);
    NativeSphericalTriangle {
        a: ua,
        b: ub,
        c: uc,
        cosines: vec3(ab.x, bc.x, ca.x),
        sines: vec3(ab.y, bc.y, ca.y),
        area,
        rest,
        ab_normal: side * ab_normal,
        bc_normal: side * native_direction(bc_across),
        ca_normal: side * native_direction(ca_across),
        tangent: ub.cross(ab_normal),
        height,
    }
}

/// a . (b x c) by the sides at the shortest of them.
#[must_use]
pub fn native_volume(a: Vec3, b: Vec3, c: Vec3) -> f32 {
    let x = a.dot(a);
    let y = b.dot(b);
    let z = c.dot(c);
    if x <= y.min(z) {
        return a.dot((b - a).cross(c - a));
    }
    if y <= z {
        return b.dot((c - b).cross(a - b));
    }
    c.dot((a - c).cross(b - c))
}

/// a x b by the sum or difference, whichever is short.
#[must_use]
pub fn native_across(a: Vec3, b: Vec3) -> Vec3 {
    if a.dot(b) < 0.0 {
        a.cross(a + b)
    } else {
        a.cross(b - a)
    }
}

/// The triangle with these vertices.
#[must_use]
pub fn native_spherical_triangle_prepare(a: Vec3, b: Vec3, c: Vec3) -> NativeSphericalTriangle {
    native_spherical_triangle_of(
        a,
        b,
        c,
        native_across(a, b),
        native_across(b, c),
        native_across(c, a),
        native_volume(a, b, c),
    )
}

/// The direction whose moving vertex parts half the solid angle into before and behind, a
/// fraction of the way from b.
#[must_use]
pub fn native_spherical_triangle_at(
    t: NativeSphericalTriangle,
    before: f32,
    behind: f32,
    u: u32,
) -> Vec3 {
    let before_sine = native_sine(before.min(t.rest + behind));
    let behind_sine = native_sine(behind.min(t.rest + before));
    let area_sine = native_sine(t.area.min(t.rest));
    let mut q = t.cosines.x * before_sine;
    let mut d = 2.0 * t.cosines.y * t.cosines.z * behind_sine;
    // The limit of a hemisphere.
    if before_sine + behind_sine == 0.0 {
        q = t.cosines.x;
        d = 2.0 * t.cosines.y * t.cosines.z;
    }
    let ca_square = t.cosines.z * t.cosines.z;
    // On one scale, so that their squares stay normal floats.
    let scale = 1.0 / (q + d).max(1e-37);
    q *= scale;
    d *= scale;
    let along = d + 2.0 * q * ca_square;
    let square = (d * d + 4.0 * q * (d + q) * ca_square).max(1e-37);
    let root = square.sqrt();
    let cosine = (2.0 * t.cosines.x * t.cosines.y * t.cosines.z * area_sine * scale / root)
        .clamp(1e-18, 1.0);
    let part = native_unit(u);
    let rest = native_complement(u);
    let cosine_square = cosine * cosine;
    let sine_square = 1.0 - cosine_square;
    let part_root = part.sqrt();
    let near = (rest + part * cosine_square).sqrt();
    if cosine_square < 0.5 && cosine_square * t.cosines.x < t.sines.x {
        let a_cosine = along / root;
        let y = a_cosine * before_sine;
        let x = a_cosine * before.cos() - t.cosines.x * cosine;
        let radius = 2.0 * near * (part * sine_square).sqrt() / (x * x + y * y).sqrt().max(1e-18);
        return native_direction(
            (1.0 - 2.0 * part * sine_square) * t.b + radius * (x * t.tangent + y * t.ab_normal),
        );
    }
    let weight_b = rest * (cosine * near + sine_square * part_root) / (near + cosine * part_root);
    let moving = part_root * near / square;
    native_direction(weight_b * t.b + moving * (d * (d + 2.0 * q) * t.a + 2.0 * q * along * t.c))
}

/// Uniform direction of the triangle.
#[must_use]
pub fn native_spherical_triangle(t: NativeSphericalTriangle, u: UVec2) -> Vec3 {
    let seen = t.area > 0.0;
    if !seen {
        return vec3(0.0, 0.0, 1.0);
    }
    native_spherical_triangle_at(
        t,
        t.area * native_unit(u.x),
        t.area * native_complement(u.x),
        u.y,
    )
}

/// The solid angle.
#[must_use]
pub fn native_spherical_triangle_solid_angle(t: NativeSphericalTriangle) -> f32 {
    2.0 * t.area
}

/// Whether a direction is in the triangle.
#[must_use]
pub fn native_spherical_triangle_inside(t: NativeSphericalTriangle, direction: Vec3) -> bool {
    let slack = -0.00024414062 * t.sines.x.max(t.sines.y.max(t.sines.z)) - 2.3841858e-7;
    t.area >= 1e-37
        && t.ab_normal.dot(direction) >= slack
        && t.bc_normal.dot(direction) >= slack
        && t.ca_normal.dot(direction) >= slack
}

/// 1 over the solid angle, the pdf of every sample; 0 where there is none.
#[must_use]
pub fn native_spherical_triangle_density(t: NativeSphericalTriangle) -> f32 {
    if t.area >= 1e-37 { 0.5 / t.area } else { 0.0 }
}

/// 1 over the solid angle inside, else 0.
#[must_use]
pub fn native_spherical_triangle_pdf(t: NativeSphericalTriangle, direction: Vec3) -> f32 {
    if native_spherical_triangle_inside(t, direction) {
        native_spherical_triangle_density(t)
    } else {
        0.0
    }
}

/// Half the solid angle before the moving vertex of a direction, and what u.y is.
#[must_use]
pub fn native_spherical_triangle_parts(t: NativeSphericalTriangle, direction: Vec3) -> Vec2 {
    let x = direction.dot(t.tangent);
    let y = direction.dot(t.ab_normal).max(0.0);
    let radius = (x * x + y * y).sqrt();
    let scale = 1.0 / radius.max(1e-18);
    let slope = (t.cosines.x * t.cosines.x - t.sines.x * t.sines.x)
        / (2.0 * t.cosines.x * t.sines.x).max(1e-18);
    let lean = t.ab_normal.dot(t.ca_normal) / t.height.max(1e-18);
    let cotangent = ((slope * x - lean * y) * scale).clamp(-1e18, 1e18);
    let root = (1.0 + cotangent * cotangent).sqrt() + cotangent.abs();
    let tangent = if cotangent < 0.0 { root } else { 1.0 / root };
    let product = tangent * t.sines.x / t.cosines.x.max(1e-18) * scale;
    let mut before = product * y;
    let turned = 1.0 + product * x;
    if before > 0.0 {
        before = before.atan2(turned);
    } else {
        before = if turned < 0.0 { t.area } else { 0.0 };
    }
    let cosine = direction.dot(t.b);
    let versine = if cosine < 0.5 {
        1.0 - cosine
    } else {
        radius * radius / (1.0 + cosine)
    };
    let whole = 2.0 * tangent / (1.0 + tangent * tangent) * tangent;
    vec2(before, versine / whole.max(1e-37))
}

/// The fractions that give this direction.
#[must_use]
pub fn native_spherical_triangle_invert(t: NativeSphericalTriangle, direction: Vec3) -> UVec2 {
    let seen = t.area > 0.0;
    if !seen {
        return UVec2::ZERO;
    }
    let parts = native_spherical_triangle_parts(t, direction);
    uvec2(native_fraction(parts.x / t.area), native_fraction(parts.y))
}
