//! Points of a triangle in the plane in the native profile, uniformly, with pdf and inverse.
//!
//! Source: Heitz 2019, A low-distortion map between triangle and square. Domain: three vertices
//! up to 1e18 apart, two fractions of 2^32; a degenerate triangle: points of it, with pdf 0.
//! Pdf: with respect to area, 1 over it inside, edges widened by 2^-18 of coordinates.
//! Mirror: `shaders/corput/native/triangle.glsl`.

use crate::reference::native::disk::{native_fraction, native_unit};
use glam::{UVec2, Vec2, uvec2};

/// Twice the area of a, b, c; negative if they turn clockwise.
#[must_use]
pub fn native_triangle_area(a: Vec2, b: Vec2, c: Vec2) -> f32 {
    let x = b - a;
    let y = c - a;
    x.x * y.y - x.y * y.x
}

/// Uniform point of the triangle.
#[must_use]
pub fn native_triangle(a: Vec2, b: Vec2, c: Vec2, u: UVec2) -> Vec2 {
    let x = native_unit(u.x);
    let y = native_unit(u.y);
    if y > x {
        return 0.5 * x * a + (y - 0.5 * x) * b + (1.0 - y) * c;
    }
    (x - 0.5 * y) * a + 0.5 * y * b + (1.0 - x) * c
}

/// Whether p is on the inner side of ab, or beyond it by its rounding.
#[must_use]
pub fn native_triangle_side(a: Vec2, b: Vec2, p: Vec2, sign: f32) -> bool {
    let side = (b - a).abs();
    let size = side.x.max(side.y);
    let slack = 3.8146973e-6 * size * (size + p.x.abs().max(p.y.abs()));
    sign * native_triangle_area(a, b, p) >= -slack
}

/// 1 over the area inside, else 0.
#[must_use]
pub fn native_triangle_pdf(a: Vec2, b: Vec2, c: Vec2, p: Vec2) -> f32 {
    let area = native_triangle_area(a, b, c);
    let sign = if area < 0.0 { -1.0 } else { 1.0 };
    let inside = area.abs() > 1e-37
        && native_triangle_side(a, b, p, sign)
        && native_triangle_side(b, c, p, sign)
        && native_triangle_side(c, a, p, sign);
    if inside { 2.0 / area.abs() } else { 0.0 }
}

/// The fractions that give this point.
#[must_use]
pub fn native_triangle_invert(a: Vec2, b: Vec2, c: Vec2, p: Vec2) -> UVec2 {
    let area = native_triangle_area(a, b, c);
    let flat_one = area.abs() <= 1e-37;
    if flat_one {
        return UVec2::ZERO;
    }
    let x = (native_triangle_area(p, b, c) / area).max(0.0);
    let y = (native_triangle_area(p, c, a) / area).max(0.0);
    if y > x {
        return uvec2(native_fraction(2.0 * x), native_fraction(x + y));
    }
    uvec2(native_fraction(x + y), native_fraction(2.0 * y))
}
