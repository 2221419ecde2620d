//! The highlight of a spherical light on a GGX surface: a problem as stiff as its lobe is sharp
//! and its light is small.

use super::quadrature::tanh_sinh;
use super::scenes::{BASE, prepared, seen};
use super::{Coefficients, Integrand, MIS, Parameter, Setting, within};
use crate::catalog::Words;
use crate::interface::integrand;
use crate::reference::ggx_lobe::ggx_prepare;
use crate::reference::sphere_light::sphere_light_prepare;
use glam::{Vec2, Vec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const ESTIMATORS: &[&str] = &["uniform", "ggx", "light", MIS];

/// The integrands of this group.
pub(super) const INTEGRANDS: &[Integrand] = &[Integrand {
    name: "ggx-lobe",
    id: integrand::LOBE_UNIFORM,
    parameters: &[
        Parameter {
            name: "alpha",
            size: 1,
            default: Some(&[0.02]),
            domain: "it must be from 0.001 to 1",
            summary: "roughness",
        },
        Parameter {
            name: "cosine",
            size: 1,
            default: Some(&[0.6]),
            domain: "it must be from 0.1 to 1",
            summary: "cosine of the angle from which the surface is seen",
        },
        Parameter {
            name: "radius",
            size: 1,
            default: Some(&[0.1]),
            domain: "it must be from 0.001 to 1.5",
            summary: "half the angle under which the light is seen, in radians",
        },
        Parameter {
            name: "offset",
            size: 1,
            default: Some(&[0.5]),
            domain: "the whole light must be above the horizon, and the mean at least 2^-34 of \
                     the estimator's peak",
            summary: "angle from the mirror direction up to the light's centre, in radii",
        },
    ],
    estimators: ESTIMATORS,
    prepare,
    truth: |s| highlight(s.values),
    // Reals turn a half vector as long as twice the cosine by 2^-29 over that, and D falls by
    // two thirds of its peak in an angle alpha.
    error: 6e-6,
    examples: &[
        (&[0.02, 0.6, 0.1, 0.5], 2),
        (&[0.001, 0.9, 0.02, 0.99], 2),
        (&[0.001, 0.1, 0.002, 0.0], 2),
        (&[0.001, 0.5, 0.5, 1.0], 2),
        (&[0.3, 0.5, 0.001, -100.0], 2),
        (&[1.0, 0.1, 0.1, 0.0], 2),
        (&[0.1, 1.0, 0.2, 1.0], 2),
    ],
    summary: "highlight of a spherical light on a GGX surface",
    formula: "integral of D(h) G2 / (4 cos t) over the directions of the light; uniform: directions \
              of the hemisphere, ggx: reflected at visible normals, light: of the sphere, mis: half \
              of each of the last two",
    source: "Veach and Guibas 1995; Heitz 2018",
    ..BASE
}];

/// Angles in the plane of incidence, from the surface's normal: those of the view, and of the
/// light's centre, which is on the other side and counts there as negative; and half the angle
/// under which the light is seen.
struct Angles {
    view: f64,
    light: f64,
    half: f64,
}

/// The light's centre and its radius.
fn sphere(values: &[f64]) -> (Vec3, f32) {
    let (up, along) = (values[1].asin() + values[3] * values[2]).sin_cos();
    (
        Vec3::new(-along as f32, 0.0, up as f32),
        values[2].sin() as f32,
    )
}

/// Of the floats that the estimators take.
fn angles(values: &[f64]) -> Angles {
    let (_, view) = seen(values);
    let (centre, radius) = sphere(values);
    let angle = |v: Vec3| f64::from(v.x).atan2(v.z.into());
    Angles {
        view: angle(view),
        light: angle(centre),
        half: (f64::from(radius) / centre.as_dvec3().length()).asin(),
    }
}

fn prepare(s: &Setting) -> core::result::Result<Coefficients, usize> {
    let alpha = within(s.values, 0, 0.001, 1.0)?;
    let cosine = within(s.values, 1, 0.1, 1.0)?;
    let radius = within(s.values, 2, 0.001, 1.5)?;
    let low = radius - cosine.asin();
    let offset = within(
        s.values,
        3,
        low / radius,
        (low + PI - 2.0 * radius) / radius,
    )?;
    let (rough, wo) = seen(s.values);
    let (centre, size) = sphere(s.values);
    let mut words = Vec::new();
    ggx_prepare(Vec2::splat(rough), wo).put(&mut words);
    sphere_light_prepare(centre, size).put(&mut words);
    // A half vector turns half as far from the normal as its reflection from the mirror
    // direction, or farther; and rounding turns it a little back.
    let nearest = (0.5 * (offset.abs() - 1.0) * radius - 1e-6).max(0.0);
    let (sine, along) = nearest.sin_cos();
    let spread = (sine / alpha).powi(2) + along * along;
    let density = 1.0 / (PI * (alpha * spread).powi(2));
    // The pdf of a reflected direction; its weight is at most 1.
    let pdf = 0.5 * density / (cosine + stretch(alpha, cosine));
    let light = 2.0 * TAU * (0.5 * radius).sin().powi(2);
    let peak = match ESTIMATORS.get(s.estimator) {
        Some(&"uniform") => TAU * pdf,
        Some(&"ggx") => 1.0,
        Some(&"light") => light * pdf,
        _ => 2.0 / (1.0 + (light * pdf).recip()),
    };
    let made = prepared(words, peak);
    made.resolves(highlight(s.values)).then_some(made).ok_or(3)
}

/// The length of a unit vector at this cosine to the normal, stretched by alpha.
fn stretch(alpha: f64, z: f64) -> f64 {
    (alpha * alpha * (1.0 - z) * (1.0 + z) + z * z).sqrt()
}

/// The integral in polar coordinates of the half vector's slopes around the normal, r cos p and
/// r sin p: of the share s = r^2 / (alpha^2 + r^2) = tanh^2 t of the normals that are flatter
/// than r = alpha sinh t, of (wo h) G2 / (cos t h.z) ds dp / pi. On the ray of azimuth p the
/// reflection meets the light where C + 2 b x r - A r^2 > 0, x = cos p: with the angles v of
/// the view, l of the light's centre, d = v + l and e = v - l, half angle q of the light,
/// C = cos d - cos q, b = sin d, A = cos q + cos e - x^2 (cos e - cos d), and b^2 x^2 + A C =
/// sin^2 q - M sin^2 p, M = sin^2 d - (cos e - cos d) C. Neither ends of rays nor their
/// azimuths cancel, so that all digits are right however small light and lobe are.
fn highlight(values: &[f64]) -> f64 {
    let alpha = f64::from(values[0] as f32);
    let Angles { view, light, half } = angles(values);
    let (sine, cosine) = view.sin_cos();
    let (from_mirror, across) = (view + light, view - light);
    let inside = -2.0 * (0.5 * (from_mirror + half)).sin() * (0.5 * (from_mirror - half)).sin();
    let tilt = across.cos() - from_mirror.cos();
    let most = from_mirror.sin().powi(2) - tilt * inside;
    let rim = half.sin().powi(2);
    let stretched = stretch(alpha, cosine);
    let ray = |x: f64, from: f64, to: f64| {
        let at = |t: f64| {
            let r = alpha * t.sinh();
            let facing = cosine + r * sine * x;
            // A light that touches the horizon may be rounded below it.
            let z = (2.0 * facing / (1.0 + r * r) - cosine).max(0.0);
            let share = 2.0 * t.tanh() / t.cosh().powi(2);
            share * facing * z / (z * stretched + cosine * stretch(alpha, z))
        };
        tanh_sinh(at, (from / alpha).asinh(), (to / alpha).asinh())
    };
    let steepest = |x: f64| half.cos() + across.cos() - tilt * x * x;
    let sum = if inside > 0.0 {
        let at = |azimuth: f64| {
            let (y, x) = azimuth.sin_cos();
            let root = (rim - most * y * y).max(0.0).sqrt();
            let along = x * from_mirror.sin();
            let to = if along < 0.0 {
                inside / (root - along)
            } else {
                (root + along) / steepest(x)
            };
            ray(x, 0.0, to)
        };
        tanh_sinh(at, 0.0, FRAC_PI_2) + tanh_sinh(at, FRAC_PI_2, PI)
    } else {
        // Rays to either side of the one through the light's centre.
        let widest = (rim / most).sqrt().min(1.0).asin();
        let at = |azimuth: f64| {
            let x = azimuth.cos() * from_mirror.signum();
            let square = most * (widest - azimuth).sin() * (widest + azimuth).sin();
            let root = square.max(0.0).sqrt();
            let end = root + x * from_mirror.sin();
            ray(x, -inside / end, end / steepest(x))
        };
        tanh_sinh(at, 0.0, widest)
    };
    sum * 2.0 / PI
}
