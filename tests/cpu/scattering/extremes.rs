//! The extreme cases of scattering: multi-precision truth, the common float formula, and the
//! reference, a line each.

use super::extreme::extreme;
use super::lobes::{Kind, Lobe};
use corput::glam::{Vec3, uvec2, vec2, vec3};
use corput::reference::frame::frame;
use corput::reference::ggx::{ggx_distribution, ggx_g1};
use std::f32::consts::{PI, TAU};

/// What an error may be: of a distribution, pdf or masking relative to itself, of x and y
/// relative to the distance from the pole where that is a lobe's width.
const THRESHOLD: f64 = 1e-6;

/// One row of the file: its number, what is computed, inputs and truth.
struct Case {
    row: u32,
    what: String,
    inputs: Vec<f64>,
    truth: Vec<f64>,
}

fn cases() -> Vec<Case> {
    let numbers = |text: &str| -> Vec<f64> {
        let parse = |word: &str| word.parse().expect("a number");
        text.split(' ').map(parse).collect()
    };
    include_str!("../../data/scattering_truth.csv")
        .lines()
        .map(|line| {
            let parts: Vec<&str> = line.split(',').collect();
            Case {
                row: parts[0].parse().expect("a row"),
                what: parts[1].to_owned(),
                inputs: numbers(parts[2]),
                truth: numbers(parts[3]),
            }
        })
        .collect()
}

/// The largest relative error; NaN is one without end.
fn relative(got: &[f64], truth: &[f64]) -> f64 {
    let mut worst = 0f64;
    for (g, t) in got.iter().zip(truth) {
        let error = ((g - t) / t).abs();
        worst = if error.is_nan() {
            f64::INFINITY
        } else {
            worst.max(error)
        };
    }
    worst
}

/// The worst error: of x and y relative to `scale`, of z, and of the pdf relative to itself.
fn scattered(got: &[f64], truth: &[f64], scale: f64) -> f64 {
    let away = (got[0] - truth[0]).hypot(got[1] - truth[1]) / scale;
    let error = away.max((got[2] - truth[2]).abs());
    let all = error.max(relative(&got[3..], &truth[3..]));
    if got.iter().any(|x| x.is_nan()) {
        f64::INFINITY
    } else {
        all
    }
}

fn list(d: Vec3, pdf: f32) -> Vec<f64> {
    [d.x, d.y, d.z, pdf].map(f64::from).to_vec()
}

/// (alpha^2 - 1) cos^2 + 1, with the normal normalised first.
fn naive_distribution(alpha: f32, h: Vec3) -> f32 {
    let cosine = h.normalize().z;
    let a = alpha * alpha;
    let d = (a - 1.0) * cosine * cosine + 1.0;
    a / (PI * d * d)
}

/// The cap as published, in floats.
fn naive_cap(alpha: f32, wo: Vec3, u: [f32; 2]) -> Vec<f64> {
    let wo = wo.normalize();
    let view = vec3(alpha * wo.x, alpha * wo.y, wo.z).normalize();
    let z = (1.0 - u[0]) * (1.0 + view.z) - view.z;
    let radius = (1.0 - z * z).max(0.0).sqrt();
    let phi = TAU * u[1];
    let n = vec3(radius * phi.cos(), radius * phi.sin(), z) + view;
    let h = vec3(alpha * n.x, alpha * n.y, n.z).normalize();
    let tan_square = (wo.x * wo.x + wo.y * wo.y) / (wo.z * wo.z);
    let g1 = 2.0 / (1.0 + (1.0 + alpha * alpha * tan_square).sqrt());
    let pdf = naive_distribution(alpha, h) * g1 / (4.0 * wo.z);
    list(2.0 * wo.dot(h) * h - wo, pdf)
}

/// G1 by tan^2, with Lambda = 0 where that is infinite, as PBRT has it.
fn naive_masking(alpha: f32, w: Vec3) -> f32 {
    let w = w.normalize();
    let tan_square = (w.x * w.x + w.y * w.y) / (w.z * w.z);
    if tan_square.is_infinite() {
        return 1.0;
    }
    1.0 / (1.0 + ((1.0 + alpha * alpha * tan_square).sqrt() - 1.0) / 2.0)
}

/// The published inversion, in floats.
fn naive_phase(rest: f32, u: [f32; 2]) -> Vec<f64> {
    let g = 1.0 - rest;
    let ratio = (1.0 - g * g) / (1.0 - g + 2.0 * g * u[0]);
    let z = (1.0 + g * g - ratio * ratio) / (2.0 * g);
    let pdf = (1.0 - g * g) / (4.0 * PI * (1.0 + g * g - 2.0 * g * z).powf(1.5));
    let radius = (1.0 - z * z).sqrt();
    let phi = TAU * u[1];
    list(vec3(radius * phi.cos(), radius * phi.sin(), z), pdf)
}

fn unit(u: f64) -> f32 {
    (u / 4_294_967_296.0) as f32
}

/// Errors of the common formula and of the reference.
fn errors(case: &Case) -> (f64, f64) {
    let (x, truth) = (&case.inputs, &case.truth[..]);
    let float = |i: usize| x[i] as f32;
    match case.what.as_str() {
        "distribution" => {
            let (alpha, h) = (float(0), vec3(float(1), float(2), float(3)));
            let ours = ggx_distribution(vec2(alpha, alpha), h);
            (
                relative(&[naive_distribution(alpha, h).into()], truth),
                relative(&[ours.into()], truth),
            )
        }
        "cap" => {
            let (alpha, wo) = (float(0), [float(1), float(2), float(3)]);
            let u = uvec2(x[4] as u32, x[5] as u32);
            let ours = Lobe::ggx(Kind::Cap, [alpha; 2], wo).sample(u);
            let naive = naive_cap(alpha, wo.into(), [unit(x[4]), unit(x[5])]);
            (
                scattered(&naive, truth, 1.0),
                scattered(&list(ours.direction, ours.pdf), truth, 1.0),
            )
        }
        "masking" => {
            let (alpha, w) = (float(0), vec3(float(1), float(2), float(3)));
            let ours = ggx_g1(vec2(alpha, alpha), w);
            (
                relative(&[naive_masking(alpha, w).into()], truth),
                relative(&[ours.into()], truth),
            )
        }
        _ => {
            let u = uvec2(x[1] as u32, x[2] as u32);
            let ours = Lobe::henyey_greenstein(float(0), false).sample(u);
            let naive = naive_phase(float(0), [unit(x[1]), unit(x[2])]);
            // A narrow lobe is as wide as its directions are away from the pole.
            let scale = truth[0].hypot(truth[1]).max(1e-12);
            (
                scattered(&naive, truth, scale),
                scattered(&list(ours.direction, ours.pdf), truth, scale),
            )
        }
    }
}

#[test]
fn extreme_rows_are_right_where_common_formulas_are_not() {
    let mut worst_naive = std::collections::BTreeMap::new();
    for case in cases() {
        let (naive, ours) = errors(&case);
        let numbers: Vec<String> = case
            .inputs
            .iter()
            .map(|x| (*x as f32).to_string())
            .collect();
        let input = format!("{} {}", case.what, numbers.join(", "));
        extreme(case.row, &input, naive, ours, THRESHOLD);
        let worst: &mut f64 = worst_naive.entry(case.row).or_default();
        *worst = worst.max(naive);
    }
    assert_eq!(worst_naive.len(), 5, "rows 30 to 34");
    for (row, naive) in worst_naive {
        assert!(
            naive > 100.0 * THRESHOLD,
            "row {row} is not extreme: {naive:e}"
        );
    }
}

/// Frisvad's frame divides by 1 + z; Duff's does not where z nears -1.
#[test]
fn extreme_frames_are_orthonormal() {
    let defect = |t: Vec3, b: Vec3| {
        let (t, b) = (t.as_dvec3(), b.as_dvec3());
        let parts = [t.length() - 1.0, b.length() - 1.0, t.dot(b)];
        let worst = parts.iter().fold(0f64, |worst, x| worst.max(x.abs()));
        if parts.iter().any(|x| x.is_nan()) {
            f64::INFINITY
        } else {
            worst
        }
    };
    let mut worst_naive = 0f64;
    for radius in [1e-3f32, 1e-4, 1e-5] {
        let n = vec3(0.6 * radius, 0.8 * radius, -(1.0 - radius * radius).sqrt());
        let a = 1.0 / (1.0 + n.z);
        let b = -n.x * n.y * a;
        let naive = defect(
            vec3(1.0 - n.x * n.x * a, b, -n.x),
            vec3(b, 1.0 - n.y * n.y * a, -n.y),
        );
        let f = frame(n);
        let ours = defect(f.tangent, f.bitangent);
        let input = format!("frame around {n:?}, defect");
        extreme(29, &input, naive, ours, THRESHOLD);
        worst_naive = worst_naive.max(naive);
    }
    assert!(worst_naive > 100.0 * THRESHOLD);
}
