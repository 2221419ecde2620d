//! Plane figures in `f64`: Heitz's map as written, polygons by their vertices.

use super::functions::sin_cos;
use std::f64::consts::PI;

type Point = [f64; 2];

/// A fraction of 2^32.
fn unit(u: u32) -> f64 {
    f64::from(u) / 4_294_967_296.0
}

/// Heitz 2019: the point, and one over the area.
#[must_use]
pub fn triangle([a, b, c]: [Point; 3], u: [u32; 2]) -> [f64; 3] {
    // The last two bits do not count.
    let [mut x, mut y] = u.map(|u| unit(u & !3));
    if y > x {
        x *= 0.5;
        y -= x;
    } else {
        y *= 0.5;
        x -= y;
    }
    let z = 1.0 - x - y;
    let mean = |i: usize| x * a[i] + y * b[i] + z * c[i];
    let (p, q) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let area = 0.5 * (p[0] * q[1] - p[1] * q[0]).abs();
    [mean(0), mean(1), 1.0 / area]
}

/// The point of a regular polygon between two vertices and the centre, and one over the area.
#[must_use]
pub fn regular_polygon(sides: u32, u: [u32; 2]) -> [f64; 3] {
    let n = f64::from(sides);
    let around = u64::from(u[0]) * u64::from(sides);
    let (side, along) = ((around >> 32) as f64, unit(around as u32));
    let vertex = |k: f64| {
        let (s, c) = (2.0 * PI * k / n).sin_cos();
        [c, s]
    };
    let (p, q) = (vertex(side), vertex(side + 1.0));
    let radius = unit(u[1]).sqrt();
    let between = |i: usize| radius * ((1.0 - along) * p[i] + along * q[i]);
    [between(0), between(1), 2.0 / (n * (2.0 * PI / n).sin())]
}

/// The point of an annulus, and one over the area.
#[must_use]
pub fn annulus(inner: f32, u: [u32; 2]) -> [f64; 3] {
    let inner = f64::from(inner);
    let width = (1.0 - inner) * (1.0 + inner);
    let radius = (inner * inner + unit(u[0]) * width).sqrt();
    let (s, c) = sin_cos(u[1]);
    [radius * c, radius * s, 1.0 / (PI * width)]
}
