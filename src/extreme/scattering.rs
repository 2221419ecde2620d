//! Scattering: microfacets, Henyey and Greenstein's phase function, and frames.

use super::case::{Case, Measure, Reading, Source, Subject, Truth};
use super::elementary::unit;
use super::truth::{Scattering, scattering};
use crate::Result;
use crate::catalog::{Map, Mapping};
use crate::reference::frame::frame;
use crate::reference::ggx::{ggx_distribution, ggx_g1};
use glam::{Vec2, Vec3, vec3};
use std::f32::consts::{PI, TAU};

/// What an error may be: of a distribution, pdf or masking relative to itself, of x and y
/// relative to the distance from the pole where that is a lobe's width.
const BOUND: f64 = 1e-6;

/// (alpha^2 - 1) cos^2 + 1, with the normal normalised first.
fn naive_distribution(alpha: f32, h: Vec3) -> f32 {
    let cosine = h.normalize().z;
    let a = alpha * alpha;
    let d = (a - 1.0) * cosine * cosine + 1.0;
    a / (PI * d * d)
}

fn list(d: Vec3, pdf: f32) -> [f64; 4] {
    [d.x, d.y, d.z, pdf].map(f64::from)
}

/// The cap as published, in floats.
fn naive_cap(alpha: f32, wo: Vec3, [u, v]: [f32; 2]) -> [f64; 4] {
    let wo = wo.normalize();
    let view = vec3(alpha * wo.x, alpha * wo.y, wo.z).normalize();
    let z = (1.0 - u) * (1.0 + view.z) - view.z;
    let radius = (1.0 - z * z).max(0.0).sqrt();
    let phi = TAU * v;
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
fn naive_phase(rest: f32, [u, v]: [f32; 2]) -> [f64; 4] {
    let g = 1.0 - rest;
    let ratio = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
    let z = (1.0 + g * g - ratio * ratio) / (2.0 * g);
    let pdf = (1.0 - g * g) / (4.0 * PI * (1.0 + g * g - 2.0 * g * z).powf(1.5));
    let radius = (1.0 - z * z).sqrt();
    let phi = TAU * v;
    list(vec3(radius * phi.cos(), radius * phi.sin(), z), pdf)
}

fn sample(map: &str, values: &[f64], u: [u32; 2]) -> Result<Subject> {
    let mapping = Box::new(Mapping::with_values(Map::from_name(map)?, values)?);
    Ok(Subject::Map { mapping, u })
}

pub(super) fn lobes() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for row in scattering()? {
        cases.extend(lobe(row)?);
    }
    Ok(cases)
}

fn lobe(row: Scattering) -> Result<Option<Case>> {
    // The last two of a sample are its fractions of 2^32.
    let words = match row.what {
        "cap" | "phase" => 2,
        _ => 0,
    };
    let (floats, words) = row.inputs.split_at(row.inputs.len().saturating_sub(words));
    let mut numbers: Vec<String> = floats.iter().map(|x| (*x as f32).to_string()).collect();
    numbers.extend(words.iter().map(|x| (*x as u32).to_string()));
    let input = format!("{} {}", row.what, numbers.join(", "));
    let vector = |x: f64, y: f64, z: f64| vec3(x as f32, y as f32, z as f32);
    let host = |naive: f32, ours: f32| {
        let error = |got: f32| Measure::Relative.error(&[got.into()], &row.truth);
        let errors = [error(naive), error(ours)];
        Case::host(
            row.number,
            input.clone(),
            errors,
            Source::Multiprecision,
            BOUND,
        )
    };
    let of = |naive: [f64; 4], scale: f64, subject: Subject| {
        Case::of(
            row.number,
            input.clone(),
            &naive,
            Reading {
                first: 0,
                measure: Measure::Scattered { scale },
            },
            Truth {
                values: row.truth.clone(),
                source: Source::Multiprecision,
            },
            BOUND,
            subject,
        )
    };
    Ok(match (row.what, &row.inputs[..]) {
        ("distribution", &[alpha, x, y, z]) => {
            let (alpha, h) = (alpha as f32, vector(x, y, z));
            let ours = ggx_distribution(Vec2::splat(alpha), h);
            Some(host(naive_distribution(alpha, h), ours))
        }
        ("masking", &[alpha, x, y, z]) => {
            let (alpha, w) = (alpha as f32, vector(x, y, z));
            let ours = ggx_g1(Vec2::splat(alpha), w);
            Some(host(naive_masking(alpha, w), ours))
        }
        ("cap", &[alpha, x, y, z, u, v]) => {
            let u = [u as u32, v as u32];
            let subject = sample("ggx-vndf-cap", &[alpha, 0.0, x, y, z], u)?;
            let naive = naive_cap(alpha as f32, vector(x, y, z), u.map(unit));
            Some(of(naive, 1.0, subject))
        }
        ("phase", &[rest, u, v]) => {
            let u = [u as u32, v as u32];
            let subject = sample("henyey-greenstein", &[1.0 - rest], u)?;
            // A narrow lobe is as wide as its directions are away from the pole.
            let radius = row.truth.iter().take(2).map(|x| x * x).sum::<f64>().sqrt();
            Some(of(
                naive_phase(rest as f32, u.map(unit)),
                radius.max(1e-12),
                subject,
            ))
        }
        _ => None,
    })
}

/// How far two vectors are from unit length and from a right angle.
fn defect(t: Vec3, b: Vec3) -> f64 {
    let (t, b) = (t.as_dvec3(), b.as_dvec3());
    let parts = [t.length() - 1.0, b.length() - 1.0, t.dot(b)].map(f64::abs);
    let worse = |a: f64, b: f64| if b.is_nan() || b > a { b } else { a };
    parts.into_iter().fold(0.0, worse)
}

/// Frisvad's frame divides by 1 + z; Duff's does not where z nears -1.
pub(super) fn frames() -> Vec<Case> {
    let case = |radius: f32| {
        let n = vec3(0.6 * radius, 0.8 * radius, -(1.0 - radius * radius).sqrt());
        let a = 1.0 / (1.0 + n.z);
        let b = -n.x * n.y * a;
        let naive = defect(
            vec3(1.0 - n.x * n.x * a, b, -n.x),
            vec3(b, 1.0 - n.y * n.y * a, -n.y),
        );
        let f = frame(n);
        let errors = [naive, defect(f.tangent, f.bitangent)];
        let input = format!("frame around {n:?}, defect");
        Case::host(29, input, errors, Source::ClosedForm, BOUND)
    };
    [1e-3, 1e-4, 1e-5].map(case).into()
}
