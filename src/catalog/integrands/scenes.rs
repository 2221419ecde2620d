//! Skies, a polygonal light and a rough mirror: problems of rendering without tables.

use super::quadrature::tanh_sinh;
use super::{Coefficients, Integrand, MIS, Parameter, Setting, within};
use crate::catalog::Words;
use crate::interface::integrand;
use crate::judge::spherical_triangle::solid_angle;
use crate::reference::ggx_lobe::ggx_prepare;
use crate::reference::real::real;
use crate::reference::spherical_triangle::spherical_triangle_prepare;
use glam::{Vec2, Vec3};
use std::f64::consts::{PI, TAU};

type Checked = core::result::Result<Coefficients, usize>;

/// What these integrands have in common.
pub(super) const BASE: Integrand = Integrand {
    name: "",
    id: 0,
    dimensions: (2, 2),
    default_dimensions: 2,
    parameters: &[],
    estimators: &[],
    needs_map: false,
    prepare: |_| Err(0),
    truth: |_| 0.0,
    error: 2e-7,
    picture: None,
    finite_variance: true,
    examples: &[],
    summary: "",
    formula: "",
    source: "",
};

const POLYGON: &[&str] = &["uniform", "cosine", "light", MIS];

const FURNACE: &[&str] = &["uniform", "cosine", "visible-normals"];

/// The integrands of this group.
pub(super) const INTEGRANDS: &[Integrand] = &[
    Integrand {
        name: "cosine-irradiance",
        id: integrand::SKY_UNIFORM,
        parameters: &[Parameter {
            name: "gradient",
            size: 1,
            default: Some(&[2.0]),
            domain: "it must be from 0 to 1000",
            summary: "how much the sky brightens towards the zenith: 2 is the CIE's overcast sky",
        }],
        estimators: &["uniform", "cosine"],
        prepare: |s| {
            let gradient = real(within(s.values, 0, 0.0, 1000.0)? as f32);
            let mut words = Vec::new();
            gradient.put(&mut words);
            let most = [TAU, PI].get(s.estimator).copied().unwrap_or(TAU);
            Ok(prepared(words, most * (1.0 + s.values[0])))
        },
        truth: |s| PI + TAU / 3.0 * f64::from(s.values[0] as f32),
        examples: &[(&[2.0], 2), (&[0.0], 2), (&[1000.0], 2)],
        summary: "light of a sky on a level surface",
        formula: "integral of (1 + gradient z) z over the directions of the hemisphere, \
                  uniform or cosine-weighted",
        source: "Moon and Spencer 1942",
        ..BASE
    },
    Integrand {
        name: "polygon-irradiance",
        id: integrand::POLYGON_UNIFORM,
        parameters: &[
            Parameter {
                name: "elevation",
                size: 1,
                default: Some(&[0.9]),
                domain: "it must be from 0.01 to 1.57",
                summary: "angle of the light's middle above the surface, in radians",
            },
            Parameter {
                name: "radius",
                size: 1,
                default: Some(&[0.5]),
                domain: "it must be from 0.01 to 1.5, and at most the elevation",
                summary: "angle from there to the light's three corners, in radians",
            },
        ],
        estimators: POLYGON,
        prepare: polygon,
        truth: |s| lambert(corners(s.values)),
        examples: &[
            (&[0.9, 0.5], 2),
            (&[1.57, 1.5], 2),
            (&[0.3, 0.3], 2),
            (&[0.6, 0.1], 2),
        ],
        summary: "light of an equilateral spherical triangle on a level surface",
        formula: "integral of z over the directions of the light; uniform and cosine: directions \
                  of the hemisphere, light: of the triangle, mis: half of each of the last two",
        source: "Lambert 1760; Arvo 1995",
        ..BASE
    },
    Integrand {
        name: "ggx-furnace",
        id: integrand::FURNACE_UNIFORM,
        parameters: &[
            Parameter {
                name: "alpha",
                size: 1,
                default: Some(&[0.3]),
                domain: "it must be from 0.1 to 1",
                summary: "roughness",
            },
            Parameter {
                name: "cosine",
                size: 1,
                default: Some(&[0.5]),
                domain: "it must be from 0.05 to 1",
                summary: "cosine of the angle from which the surface is seen",
            },
        ],
        estimators: FURNACE,
        prepare: furnace,
        truth: |s| albedo(s.values),
        // A direction is off by 2^-24, a half vector as long as the cosine by that over it, and
        // D falls by two thirds of its peak in an angle alpha.
        error: 8e-6,
        examples: &[
            (&[0.3, 0.5], 2),
            (&[1.0, 1.0], 2),
            (&[1.0, 0.05], 2),
            (&[0.1, 0.05], 2),
            (&[0.1, 1.0], 2),
        ],
        summary: "what a GGX surface reflects of a white sky: the white furnace",
        formula: "integral of D(h) G2 / (4 cos t) over the directions of the hemisphere, uniform, \
                  cosine-weighted, or reflected at visible normals",
        source: "Heitz 2014 and 2018",
        ..BASE
    },
];

/// Coefficients of the words that a kernel reads after the head.
pub(super) fn prepared(mut words: Vec<u32>, peak: f64) -> Coefficients {
    words.resize(words.len().next_multiple_of(4), 0);
    let (columns, _) = words.as_chunks();
    // What rounded floats may add to a weight.
    let peak = peak * (1.0 + 1.0 / (1 << 20) as f64);
    Coefficients::real([0; 4], columns.to_vec(), peak)
}

/// The corners of the light, by their angles around its middle.
fn corners(values: &[f64]) -> [Vec3; 3] {
    let (up, along) = values[0].sin_cos();
    let (out, near) = values[1].sin_cos();
    [0.0, 1.0, 2.0].map(|k| {
        let (side, rise) = (0.3 + TAU / 3.0 * k).sin_cos();
        let corner = [
            near * along - out * rise * up,
            out * side,
            near * up + out * rise * along,
        ];
        Vec3::from(corner.map(|x| x as f32))
    })
}

fn polygon(s: &Setting) -> Checked {
    let elevation = within(s.values, 0, 0.01, 1.57)?;
    within(s.values, 1, 0.01, elevation.min(1.5))?;
    let [a, b, c] = corners(s.values);
    let mut words = Vec::new();
    spherical_triangle_prepare(a, b, c).put(&mut words);
    let [a, b, c] = [a, b, c].map(|v| v.to_array().map(f64::from));
    let light = solid_angle(a, b, c);
    let peak = match POLYGON.get(s.estimator) {
        Some(&"uniform") => TAU,
        Some(&"cosine") => PI,
        Some(&"light") => light,
        // It grows with the cosine.
        _ => 2.0 / (PI.recip() + light.recip()),
    };
    Ok(prepared(words, peak))
}

/// Half the sum over the sides of angle times height of the side's unit normal.
fn lambert(corners: [Vec3; 3]) -> f64 {
    let [a, b, c] = corners.map(|v| v.as_dvec3());
    let side = |u: glam::DVec3, v: glam::DVec3| {
        let across = u.cross(v);
        let sine = across.length();
        sine.atan2(u.dot(v)) * across.z / sine
    };
    0.5 * (side(a, b) + side(b, c) + side(c, a)).abs()
}

/// The roughness, and the direction from which the surface is seen.
pub(super) fn seen(values: &[f64]) -> (f32, Vec3) {
    let cosine = values[1];
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    (values[0] as f32, Vec3::new(sine as f32, 0.0, cosine as f32))
}

fn furnace(s: &Setting) -> Checked {
    let alpha = within(s.values, 0, 0.1, 1.0)?;
    let cosine = within(s.values, 1, 0.05, 1.0)?;
    let (rough, wo) = seen(s.values);
    let mut words = Vec::new();
    ggx_prepare(Vec2::splat(rough), wo).put(&mut words);
    // pi D is at most 1/alpha^2, and |S w| at least alpha and w.z.
    let peak = match FURNACE.get(s.estimator) {
        Some(&"uniform") => 0.5 / (cosine * alpha * alpha),
        Some(&"cosine") => 0.5 / (cosine * alpha * alpha * alpha),
        _ => 1.0,
    };
    Ok(prepared(words, peak))
}

/// Over the slopes of the visible microfacets, of which a share s is flatter than
/// r = alpha sqrt(s / (1 - s)): the integral of G2 (wo h) / (cos t h.z) over s and their
/// azimuth. Those that reflect above the horizon have a cosine of the azimuth above
/// cos t (r^2 - 1) / (2 r sin t): all below r = (1 - sin t) / cos t, none above
/// (1 + sin t) / cos t, and between those ends the integrand is analytic.
fn albedo(values: &[f64]) -> f64 {
    let (rough, wo) = seen(values);
    let alpha = f64::from(rough);
    let wo = wo.as_dvec3().normalize();
    let (sine, cosine) = (wo.x, wo.z);
    let stretch = |z: f64| (alpha * alpha * (1.0 - z * z) + z * z).sqrt();
    let around = |s: f64| {
        let r = alpha * (s / (1.0 - s)).sqrt();
        let least = cosine * (r * r - 1.0) / (2.0 * r * sine);
        let most = if least > -1.0 {
            least.min(1.0).acos()
        } else {
            PI
        };
        let at = |azimuth: f64| {
            let facing = cosine + r * sine * azimuth.cos();
            let z = 2.0 * facing / (1.0 + r * r) - cosine;
            facing * 2.0 * z.max(0.0) / (z * stretch(cosine) + cosine * stretch(z))
        };
        tanh_sinh(at, 0.0, most) / PI
    };
    let share = |r: f64| r * r / (alpha * alpha + r * r);
    let (all, some) = (share((1.0 - sine) / cosine), share((1.0 + sine) / cosine));
    tanh_sinh(around, 0.0, all) + tanh_sinh(around, all, some)
}
