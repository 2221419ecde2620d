//! Problems of rendering in `f64`, sample by sample.

use super::spherical_triangle::{solid_angle, spherical_triangle};
use super::{Ggx, cosine_hemisphere, uniform_hemisphere};
use super::{highlight, optics};
use std::f64::consts::{PI, TAU};

type Vector = [f64; 3];

/// The least and the greatest that an estimator of the integrand of this name may give for
/// these fractions: a direction near an edge may count as on its other side. NaN for names
/// that are none.
///
/// # Panics
/// For fewer parameters than the integrand has.
#[must_use]
pub fn scene(name: &str, estimator: &str, values: &[f64], u: [u32; 3]) -> [f64; 2] {
    let uniform = uniform_hemisphere([u[0], u[1]]);
    let cosine = cosine_hemisphere([u[0], u[1]]);
    match (name, estimator) {
        ("cosine-irradiance", _) => {
            let light = |z: f64| 1.0 + f64::from(values[0] as f32) * z;
            let value = match estimator {
                "uniform" => TAU * uniform[2] * light(uniform[2]),
                "cosine" => PI * light(cosine[2]),
                _ => f64::NAN,
            };
            [value; 2]
        }
        ("polygon-irradiance", _) => {
            let corners = corners(values);
            let [a, b, c] = corners;
            let area = solid_angle(a, b, c);
            let drawn = || spherical_triangle(corners, [u[0], u[1]])[2];
            let mixed = |z: f64| z / (0.5 * (z / PI + area.recip()));
            match estimator {
                "uniform" => cut(corners, uniform, TAU * uniform[2]),
                "cosine" => cut(corners, cosine, PI),
                "light" => [area * drawn(); 2],
                "mis" if u[2] < 1 << 31 => cut(corners, cosine, mixed(cosine[2])),
                "mis" => [mixed(drawn()); 2],
                _ => [f64::NAN; 2],
            }
        }
        ("ggx-furnace", _) => {
            let sine = (1.0 - values[1] * values[1]).sqrt();
            let wo = [sine as f32, 0.0, values[1] as f32];
            let lobe = Ggx::new([values[0] as f32; 2], wo);
            // D G2 / (4 cos) is the weight by visible normals times their pdf.
            let reflected = |wi: Vector| lobe.weight(wi) * lobe.pdf(wi);
            let value = match estimator {
                "uniform" => TAU * reflected(uniform),
                "cosine" if cosine[2] > 0.0 => PI * reflected(cosine) / cosine[2],
                "cosine" => PI * reflected(above(cosine)) / GRAZING,
                "visible-normals" => {
                    let [x, y, z, _] = lobe.vndf([u[0], u[1]]);
                    lobe.weight([x, y, z])
                }
                _ => f64::NAN,
            };
            [value; 2]
        }
        ("ggx-lobe", _) => highlight::sample(estimator, values, u),
        _ => optics::optics(name, estimator, values, u),
    }
}

/// A cosine that stands for 0, where only the limit of a quotient is a number.
const GRAZING: f64 = 1e-12;

fn above([x, y, _]: Vector) -> Vector {
    [x, y, GRAZING]
}

/// The corners of the light: the middle at an elevation over the x axis, and around it a
/// radius away the angles 0.3, 0.3 + 2 pi / 3, 0.3 + 4 pi / 3, from the way up towards +y.
fn corners(values: &[f64]) -> [Vector; 3] {
    let (sin_e, cos_e) = values[0].sin_cos();
    let (sin_r, cos_r) = values[1].sin_cos();
    [0, 1, 2].map(|k| {
        let (sin_a, cos_a) = (0.3 + TAU / 3.0 * f64::from(k)).sin_cos();
        let corner = [
            cos_r * cos_e - sin_r * cos_a * sin_e,
            sin_r * sin_a,
            cos_r * sin_e + sin_r * cos_a * cos_e,
        ];
        // The light is what its floats are.
        corner.map(|x| f64::from(x as f32))
    })
}

/// A value within the triangle, and 0 beyond: both near a side.
fn cut([a, b, c]: [Vector; 3], d: Vector, value: f64) -> [f64; 2] {
    let volume = triple(a, b, c);
    // By Cramer's rule d is a sum of the corners, with these weights times the volume.
    let height = |u: Vector, v: Vector| {
        let across = cross(u, v);
        let length = across.iter().map(|x| x * x).sum::<f64>().sqrt();
        triple(u, v, d) * volume.signum() / length
    };
    let least = height(a, b).min(height(b, c)).min(height(c, a));
    // Directions are floats.
    let near = 1.0 / f64::from(1 << 21);
    match least {
        inside if inside > near => [value; 2],
        outside if outside < -near => [0.0; 2],
        _ => [0.0, value],
    }
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn triple(a: Vector, b: Vector, c: Vector) -> f64 {
    cross(a, b).iter().zip(c).map(|(x, y)| x * y).sum()
}
