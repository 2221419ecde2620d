//! A lens, a medium and a shadow: problems of rendering without tables.

use super::scenes::{BASE, prepared};
use super::{Coefficients, Integrand, MIS, Parameter, Setting, within};
use crate::catalog::Words;
use crate::interface::integrand;
use crate::reference::real::real;
use crate::reference::real_vector::real3;
use crate::reference::sphere_light::sphere_light_prepare;
use glam::Vec3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

type Checked = core::result::Result<Coefficients, usize>;

const SHADOW: &[&str] = &["uniform", "cosine", "light", MIS];

/// The integrands of this group.
pub(super) const INTEGRANDS: &[Integrand] = &[
    Integrand {
        name: "defocus-disk",
        id: integrand::LENS_SQUARE,
        parameters: &[
            Parameter {
                name: "angle",
                size: 1,
                default: Some(&[0.4]),
                domain: "it must be from 0 to 6.3",
                summary: "of the edge's normal to the x axis, in radians",
            },
            Parameter {
                name: "offset",
                size: 1,
                default: Some(&[0.3]),
                domain: "it must be from -0.99 to 0.99",
                summary: "distance of the edge from the middle, in radii",
            },
        ],
        estimators: &["square", "polar", "concentric"],
        prepare: lens,
        truth: |s| {
            let offset = edge(s.values).z.into();
            1.0 - segment(offset) / PI
        },
        examples: &[(&[0.4, 0.3], 2), (&[0.0, 0.0], 2), (&[6.3, -0.99], 2)],
        summary: "an edge in a circle of confusion",
        formula: "1 where x cos(angle) + y sin(angle) < offset, over the unit disk: by points \
                  of the square around it, by its polar map, by its concentric map",
        source: "Potmesil and Chakravarty 1981; Shirley and Chiu 1997",
        ..BASE
    },
    Integrand {
        name: "henyey-greenstein",
        id: integrand::SCATTERING_UNIFORM,
        dimensions: (3, 3),
        default_dimensions: 3,
        parameters: &[
            Parameter {
                name: "g",
                size: 1,
                default: Some(&[0.8]),
                domain: "it must be from -0.95 to 0.95",
                summary: "mean cosine of the phase function",
            },
            Parameter {
                name: "depth",
                size: 1,
                default: Some(&[2.0]),
                domain: "it must be from 0.01 to 20",
                summary: "optical thickness of the slab",
            },
        ],
        estimators: &["uniform", "phase"],
        prepare: scattering,
        truth: |s| {
            let [g, depth] = [s.values[0], s.values[1]].map(|x| f64::from(x as f32));
            (1.0 + g) * -(-depth).exp_m1()
        },
        // The pdf of a direction within 6 ULP.
        error: 8e-7,
        examples: &[
            (&[0.8, 2.0], 3),
            (&[0.0, 0.01], 3),
            (&[-0.95, 1.0], 3),
            (&[0.95, 20.0], 3),
        ],
        summary: "light that a slab scatters once into a ray",
        formula: "integral of e^-t p(w) (1 + z) over the slab and the sphere: uniform in both, \
                  or phase: by free flight and phase function",
        source: "Chandrasekhar 1950; Henyey and Greenstein 1941",
        ..BASE
    },
    Integrand {
        name: "soft-shadow",
        id: integrand::SHADOW_UNIFORM,
        parameters: &[
            Parameter {
                name: "elevation",
                size: 1,
                default: Some(&[0.8]),
                domain: "it must be from 0.05 to 1.57",
                summary: "angle of the light's centre above the surface, in radians",
            },
            Parameter {
                name: "radius",
                size: 1,
                default: Some(&[0.3]),
                domain: "it must be from 0.05 to 1.5, and at most the elevation",
                summary: "half the angle under which the light is seen, in radians",
            },
            Parameter {
                name: "edge",
                size: 1,
                default: Some(&[0.25]),
                domain: "it must be from -1.04 to 1.04",
                summary: "angle from the edge to the light's centre, in radii: 1 hides nothing, -1 all",
            },
        ],
        estimators: SHADOW,
        prepare: shadow,
        truth: half_shadow,
        picture: Some(penumbra),
        examples: &[
            (&[0.8, 0.3, 0.25], 2),
            (&[1.57, 1.5, -0.5], 2),
            (&[0.3, 0.3, 0.0], 2),
            (&[0.9, 0.2, 0.999], 2),
            (&[1.57, 1.5, 1.04], 2),
            (&[0.8, 0.05, -1.04], 2),
        ],
        summary: "light of a sphere behind an edge on a level surface",
        formula: "integral of z over the directions of the sphere on one side of a plane; \
                  uniform and cosine: directions of the hemisphere, light: of the sphere, mis: \
                  half of each of the last two",
        source: "Cook, Porter and Carpenter 1984; Veach and Guibas 1995",
        ..BASE
    },
];

/// The edge's normal, and its distance from the middle.
fn edge(values: &[f64]) -> Vec3 {
    let (sine, cosine) = values[0].sin_cos();
    Vec3::new(cosine as f32, sine as f32, values[1] as f32)
}

fn lens(s: &Setting) -> Checked {
    within(s.values, 0, 0.0, 6.3)?;
    within(s.values, 1, -0.99, 0.99)?;
    let mut words = Vec::new();
    real3(edge(s.values)).put(&mut words);
    Ok(prepared(
        words,
        if s.estimator == 0 { 4.0 / PI } else { 1.0 },
    ))
}

/// The area of the unit disk beyond a distance from its middle.
fn segment(offset: f64) -> f64 {
    offset.acos() - offset * ((1.0 - offset) * (1.0 + offset)).sqrt()
}

fn scattering(s: &Setting) -> Checked {
    let g = within(s.values, 0, -0.95, 0.95)?;
    let depth = within(s.values, 1, 0.01, 20.0)?;
    let mut words = Vec::new();
    real(depth as f32).put(&mut words);
    let lobe = (1.0 + g.abs()) / (1.0 - g.abs()).powi(2);
    let peak = if s.estimator == 0 {
        2.0 * depth * lobe
    } else {
        2.0
    };
    let made = prepared(words, peak);
    Ok(Coefficients {
        head: [(g as f32).to_bits(), 0, 0, 0],
        ..made
    })
}

/// The light's centre, its radius, and the normal of the edge's plane to the open side.
fn sphere(values: &[f64]) -> (Vec3, f32, Vec3) {
    let (up, along) = values[0].sin_cos();
    let (side, ahead) = (values[2] * values[1]).sin_cos();
    let normal = [side * along, -ahead, side * up];
    (
        Vec3::new(along as f32, 0.0, up as f32),
        values[1].sin() as f32,
        Vec3::from(normal.map(|x| x as f32)),
    )
}

fn shadow(s: &Setting) -> Checked {
    let elevation = within(s.values, 0, 0.05, 1.57)?;
    let radius = within(s.values, 1, 0.05, elevation.min(1.5))?;
    within(s.values, 2, -BESIDE, BESIDE)?;
    let (centre, size, normal) = sphere(s.values);
    let mut words = Vec::new();
    sphere_light_prepare(centre, size).put(&mut words);
    real3(normal).put(&mut words);
    let light = 2.0 * TAU * (0.5 * radius).sin().powi(2);
    let peak = match SHADOW.get(s.estimator) {
        Some(&"uniform") => TAU,
        Some(&"cosine") => PI,
        Some(&"light") => light,
        // It grows with the cosine.
        _ => 2.0 / (PI.recip() + light.recip()),
    };
    Ok(prepared(words, peak))
}

/// Where an edge is surely beside the light, and its plane less than a right angle from it.
const BESIDE: f64 = 1.04;

/// How far the edge stands behind the middle of the picture, in half heights.
const DISTANCE: f64 = 1.25;

/// A level surface seen from above, under a light that is far away behind its upper side. There
/// stands the edge, across the light's direction: from points further down, which are further
/// from it, the light leaves it over a wider way to the side.
fn penumbra(values: &[f64], [x, y]: [f64; 2], half: f64) -> Vec<f64> {
    let [elevation, radius, edge] = [values[0], values[1], values[2]];
    let away = DISTANCE * elevation.cos();
    let side = (edge * radius).tan() * away + x / half;
    let angle = side.atan2(away - y / half * elevation.cos());
    let edge = (angle / radius).clamp(-BESIDE, BESIDE);
    vec![elevation, radius, edge]
}

/// Half the integral of r x dr around the open part of the light, upwards: of the arc of its
/// rim from psi to pi - psi, measured from the way up, sin^2 (pi - 2 psi) sin(elevation); of
/// the edge, its angle as seen times the height of its plane's normal.
fn half_shadow(s: &Setting) -> f64 {
    let (centre, size, normal) = sphere(s.values);
    let [centre, normal] = [centre, normal].map(|v| v.as_dvec3().normalize());
    let sine = f64::from(size) / sphere(s.values).0.as_dvec3().length();
    let cosine = ((1.0 - sine) * (1.0 + sine)).sqrt();
    let edge = centre.dot(normal).clamp(-1.0, 1.0).asin();
    let reach = (edge.tan() * cosine / sine).clamp(-1.0, 1.0);
    let psi = -reach.asin();
    let half = (sine * psi.cos()).atan2(cosine * edge.cos() - sine * psi.sin() * edge.sin());
    let rim = sine * sine * 2.0 * (FRAC_PI_2 - psi) * centre.z;
    // Where nothing is open, rounding may leave less than 0.
    (0.5 * (rim + 2.0 * half * normal.z)).max(0.0)
}
