//! Lights seen from the origin in `f64`, by angles.

use super::maps::{concentric_disk, frame};
use super::spherical::around;
use std::f64::consts::PI;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

/// The vector with these coordinates in Duff's frame around a normal.
fn rotated(normal: Vector, local: Vector) -> Vector {
    let [tangent, bitangent] = frame(normal);
    [0, 1, 2].map(|i| local[0] * tangent[i] + local[1] * bitangent[i] + local[2] * normal[i])
}

/// The half angle under which a sphere is seen; pi from within.
fn half_angle(center: Vector, radius: f64) -> f64 {
    let distance = dot(center, center).sqrt();
    if distance == 0.0 || radius > distance {
        return PI;
    }
    // By the tangent: d^2 - r^2 from the floats that the arguments are, where the
    // distance would have been rounded.
    let rest = dot(center, center) - radius * radius;
    radius.atan2(rest.max(0.0).sqrt())
}

/// Uniform direction towards a sphere, and its pdf.
#[must_use]
pub fn sphere_light(center: Vector, radius: f64, u: [u32; 2]) -> ([f64; 3], f64) {
    let theta = half_angle(center, radius);
    let h = 2.0 * (0.5 * theta).sin().powi(2);
    let axis = if dot(center, center) == 0.0 {
        [0.0, 0.0, 1.0]
    } else {
        unit(center)
    };
    let pdf = if h > 0.0 { 0.5 / (PI * h) } else { 0.0 };
    (rotated(axis, around(h, u)), pdf)
}

/// Direction to a point of a disk, uniform in its area, and its pdf.
#[must_use]
pub fn disk_light(center: Vector, normal: Vector, radius: f64, u: [u32; 2]) -> ([f64; 3], f64) {
    let normal = unit(normal);
    let [x, y] = concentric_disk(u).map(|v| v * radius);
    let side = rotated(normal, [x, y, 0.0]);
    let point = [0, 1, 2].map(|i| center[i] + side[i]);
    let square = dot(point, point);
    let direction = unit(point);
    // Area seen under an angle: |n . d| dA / |p|^2, by n . p of the centre, as it is.
    let cosine = dot(normal, center).abs() / square.sqrt();
    (direction, square / (PI * radius * radius * cosine))
}
