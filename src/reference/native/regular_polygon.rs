//! Points of a regular polygon of circumradius 1 with a vertex at (1, 0) in the native
//! profile, uniformly, with pdf and inverse.
//!
//! Source: the polygon's triangles from the centre in turn. Domain: 3 to 65,536 sides, others
//! count as the nearest of them; two fractions of 2^32. Pdf: with respect to area,
//! 1 / (n sin(pi/n) cos(pi/n)) inside, the edge widened by 2^-10.
//! Mirror: `shaders/corput/native/regular_polygon.glsl`.

use crate::reference::native::disk::{native_fraction, native_turns, native_unit};
use glam::{UVec2, Vec2, Vec3, uvec2, vec2, vec3};

/// The sine of pi/n, with its digits for many sides.
#[must_use]
pub fn native_regular_polygon_sine(sides: f32) -> f32 {
    let angle = std::f32::consts::PI / sides;
    let square = angle * angle;
    if sides < 13.0 {
        return angle.sin();
    }
    angle * (1.0 - square * (0.16666667 - square * (0.0083333333 - square * 0.00019841270)))
}

/// Sides within their domain.
#[must_use]
pub fn native_regular_polygon_sides(sides: u32) -> f32 {
    sides.clamp(3, 65_536) as f32
}

/// Uniform point of the polygon.
#[must_use]
pub fn native_regular_polygon(sides: u32, u: UVec2) -> Vec2 {
    let n = native_regular_polygon_sides(sides);
    let sine = native_regular_polygon_sine(n);
    let around = native_unit(u.x) * n;
    let side = around.floor().min(n - 1.0);
    let radius = (native_unit(u.y)).sqrt();
    let x = radius * (1.0 - sine * sine).sqrt();
    let y = radius * sine * (2.0 * (around - side) - 1.0);
    let turn = std::f32::consts::TAU * ((side + 0.5) / n);
    vec2(
        x * turn.cos() - y * turn.sin(),
        x * turn.sin() + y * turn.cos(),
    )
}

/// A point turned so that the middle of its side is on +x, and the side.
#[must_use]
pub fn native_regular_polygon_turned(n: f32, p: Vec2) -> Vec3 {
    let side = (native_turns(p) * n).floor().min(n - 1.0);
    let turn = std::f32::consts::TAU * ((side + 0.5) / n);
    vec3(
        p.x * turn.cos() + p.y * turn.sin(),
        p.y * turn.cos() - p.x * turn.sin(),
        side,
    )
}

/// 1 over the area inside, else 0.
#[must_use]
pub fn native_regular_polygon_pdf(sides: u32, p: Vec2) -> f32 {
    let n = native_regular_polygon_sides(sides);
    let sine = native_regular_polygon_sine(n);
    let cosine = (1.0 - sine * sine).sqrt();
    let local = native_regular_polygon_turned(n, p);
    if local.x <= cosine * 1.0009766 {
        1.0 / (n * sine * cosine)
    } else {
        0.0
    }
}

/// The fractions that give this point.
#[must_use]
pub fn native_regular_polygon_invert(sides: u32, p: Vec2) -> UVec2 {
    let n = native_regular_polygon_sides(sides);
    let sine = native_regular_polygon_sine(n);
    let local = native_regular_polygon_turned(n, p);
    let radius = local.x / (1.0 - sine * sine).sqrt();
    let along = 0.5 + 0.5 * (local.y / (radius * sine).max(1e-37)).clamp(-1.0, 1.0);
    uvec2(
        native_fraction((local.z + along) / n),
        native_fraction(radius * radius),
    )
}
