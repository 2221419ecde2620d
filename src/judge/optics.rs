//! A lens, a medium, a shadow and a pixel in `f64`, sample by sample.

use super::lights::sphere_light;
use super::line::{filter_box, filter_tent};
use super::spherical::uniform_sphere;
use super::{
    concentric_disk, cosine_hemisphere, henyey_greenstein, henyey_greenstein_pdf, polar_disk,
    uniform_hemisphere,
};
use std::f64::consts::{PI, TAU};

type Vector = [f64; 3];

/// Directions and points are floats: how far a test of a side may be off.
const NEAR: f64 = 1.0 / (1 << 21) as f64;

/// The least and the greatest that an estimator may give, as [`super::scene`] says.
pub(super) fn optics(name: &str, estimator: &str, values: &[f64], u: [u32; 3]) -> [f64; 2] {
    let pair = [u[0], u[1]];
    match name {
        "defocus-disk" => lens(estimator, values, pair),
        "henyey-greenstein" => scattering(estimator, values, u),
        "soft-shadow" => shadow(estimator, values, u),
        "pixel-edge" => pixel(estimator, values, pair),
        _ => [f64::NAN; 2],
    }
}

/// The value where all margins are positive, 0 where one is negative, both in between.
fn within(margins: &[f64], value: f64) -> [f64; 2] {
    let least = margins.iter().copied().fold(f64::INFINITY, f64::min);
    match least {
        inside if inside > NEAR => [value; 2],
        outside if outside < -NEAR => [0.0; 2],
        _ => [0.0, value],
    }
}

fn lens(estimator: &str, values: &[f64], u: [u32; 2]) -> [f64; 2] {
    let (sine, cosine) = values[0].sin_cos();
    let margin = |[x, y]: [f64; 2]| values[1] - x * cosine - y * sine;
    match estimator {
        "square" => {
            let p = u.map(|u| f64::from(u) / 2_147_483_648.0 - 1.0);
            let inside = 1.0 - p[0] * p[0] - p[1] * p[1];
            within(&[margin(p), inside], 4.0 / PI)
        }
        "polar" => within(&[margin(polar_disk(u))], 1.0),
        "concentric" => within(&[margin(concentric_disk(u))], 1.0),
        _ => [f64::NAN; 2],
    }
}

fn scattering(estimator: &str, values: &[f64], u: [u32; 3]) -> [f64; 2] {
    let [g, depth] = [values[0], values[1]].map(|x| x as f32);
    let (rest, backward) = (1.0 - g.abs(), g < 0.0);
    let along = f64::from(u[2]) / 4_294_967_296.0;
    let depth = f64::from(depth);
    match estimator {
        "uniform" => {
            let d = uniform_sphere([u[0], u[1]]);
            let phase = 4.0 * PI * henyey_greenstein_pdf(rest, backward, d);
            [depth * (-depth * along).exp() * phase * (1.0 + d[2]); 2]
        }
        "phase" => {
            let [_, _, z, _] = henyey_greenstein(rest, backward, [u[0], u[1]]);
            within(&[depth + (-along).ln_1p()], 1.0 + z)
        }
        _ => [f64::NAN; 2],
    }
}

fn shadow(estimator: &str, values: &[f64], [x, y, choice]: [u32; 3]) -> [f64; 2] {
    let u = [x, y];
    let (up, along) = values[0].sin_cos();
    let (side, ahead) = (values[2] * values[1]).sin_cos();
    // The scene is what its floats are.
    let float = |x: f64| f64::from(x as f32);
    let (centre, radius) = ([along, 0.0, up].map(float), float(values[1].sin()));
    let edge = [side * along, -ahead, side * up].map(float);
    let met = |d: Vector| [dot(d, centre) - values[1].cos(), dot(d, edge)];
    match estimator {
        "uniform" => {
            let d = uniform_hemisphere(u);
            within(&met(d), TAU * d[2])
        }
        "cosine" => within(&met(cosine_hemisphere(u)), PI),
        "light" => {
            let (d, pdf) = sphere_light(centre, radius, u);
            within(&[dot(d, edge)], d[2] / pdf)
        }
        "mis" => {
            let (drawn, pdf) = sphere_light(centre, radius, u);
            let mixed = |z: f64| z / (0.5 * (z / PI + pdf));
            if choice < 1 << 31 {
                let d = cosine_hemisphere(u);
                within(&met(d), mixed(d[2]))
            } else {
                within(&[dot(drawn, edge)], mixed(drawn[2]))
            }
        }
        _ => [f64::NAN; 2],
    }
}

fn pixel(estimator: &str, values: &[f64], u: [u32; 2]) -> [f64; 2] {
    let (sine, cosine) = values[0].sin_cos();
    let radius = values[2];
    // Floats of the normal and of the offset, in radii, are off by shares of their size.
    let size = 1.0 + values[1].abs() / radius;
    let margin = |x: f64, y: f64| ((values[1] - x * cosine - y * sine) / radius) / size;
    let of = |axis: fn(f64, u32) -> [f64; 2]| u.map(|u| axis(radius, u));
    match estimator {
        "uniform" => {
            let [[x, p], [y, q]] = of(filter_box);
            let tent = |x: f64| (1.0 - x.abs() / radius) / radius;
            within(&[margin(x, y)], tent(x) * tent(y) / (p * q))
        }
        "filter" => {
            let [[x, _], [y, _]] = of(filter_tent);
            within(&[margin(x, y)], 1.0)
        }
        _ => [f64::NAN; 2],
    }
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
