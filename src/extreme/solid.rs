//! The sphere, cones, powers of the cosine and lights.

use super::case::{Case, Measure, Reading, Source, Subject, Truth};
use super::elementary::unit;
use super::truth::{Solid, solid};
use crate::Result;
use crate::catalog::{Map, Mapping};
use glam::{Vec3, vec3};
use std::f32::consts::{FRAC_1_PI, PI, TAU};

fn sample(map: &str, parameters: &[f64], u: [u32; 2]) -> Result<Subject> {
    let mapping = Box::new(Mapping::with_values(Map::from_name(map)?, parameters)?);
    Ok(Subject::Map { mapping, u })
}

fn truth(values: &[f64]) -> Truth {
    Truth {
        values: values.to_vec(),
        source: Source::Multiprecision,
    }
}

/// The word of x, z or the pdf of a direction.
fn reading(quantity: &str) -> Reading {
    Reading {
        first: match quantity {
            "x" => 0,
            "z" => 2,
            _ => 3,
        },
        measure: Measure::Relative,
    }
}

/// The reference's direction.
fn direction(subject: &Subject) -> Vec3 {
    let [x, y, z] = subject.floats();
    vec3(x, y, z)
}

/// A map whose truth has a number a line.
fn each(
    map: &'static str,
    naive: impl Fn(&Solid, Vec3) -> f32,
    name: impl Fn(&Solid) -> String,
    bound: impl Fn(&Solid) -> f64,
) -> Result<Vec<Case>> {
    let case = |t: Solid| {
        let subject = sample(map, &t.parameters, t.u)?;
        let input = format!("{map}{}, u = {} 2^-32, {}", name(&t), t.u[0], t.quantity);
        Ok(Case::of(
            t.number,
            input,
            &[naive(&t, direction(&subject)).into()],
            reading(t.quantity),
            truth(&[t.value]),
            bound(&t),
            subject,
        ))
    };
    solid(map)?.into_iter().map(case).collect()
}

fn first(t: &Solid) -> f64 {
    t.parameters.first().copied().unwrap_or(0.0)
}

pub(super) fn spheres() -> Result<Vec<Case>> {
    let naive = |t: &Solid, _: Vec3| {
        let z = 1.0 - 2.0 * unit(t.u[0]);
        if t.quantity == "x" {
            (1.0 - z * z).max(0.0).sqrt()
        } else {
            z
        }
    };
    let bound = |_: &Solid| 4.0 * f64::powi(2.0, -24);
    each("uniform-sphere", naive, |_| String::new(), bound)
}

pub(super) fn cones() -> Result<Vec<Case>> {
    let naive = |t: &Solid, _: Vec3| {
        let cosine = (first(t) as f32).cos();
        if t.quantity == "x" {
            let z = 1.0 - unit(t.u[0]) * (1.0 - cosine);
            (1.0 - z * z).max(0.0).sqrt()
        } else {
            0.5 * FRAC_1_PI / (1.0 - cosine)
        }
    };
    let name = |t: &Solid| format!(", theta_max = {}", first(t));
    each("cone", naive, name, |_| 1e-6)
}

pub(super) fn cosine_powers() -> Result<Vec<Case>> {
    let naive = |t: &Solid, d: Vec3| {
        let n = first(t) as f32;
        if t.quantity == "x" {
            let z = (1.0 - unit(t.u[0])).powf(1.0 / (n + 1.0));
            (1.0 - z * z).max(0.0).sqrt()
        } else {
            0.5 * FRAC_1_PI * (n + 1.0) * d.z.powf(n)
        }
    };
    let name = |t: &Solid| format!(", n = {}", first(t) as f32);
    let bound = |t: &Solid| if t.quantity == "x" { 1e-7 } else { 1e-6 };
    each("cosine-power-hemisphere", naive, name, bound)
}

/// Frisvad's frame in floats, which the common form of the map uses.
fn frisvad(n: Vec3, local: Vec3) -> Vec3 {
    let a = 1.0 / (1.0 + n.z);
    let b = -n.x * n.y * a;
    let tangent = vec3(1.0 - n.x * n.x * a, b, -n.x);
    let bitangent = vec3(b, 1.0 - n.y * n.y * a, -n.y);
    tangent * local.x + bitangent * local.y + n * local.z
}

/// PBRT's cone in floats: the direction towards a sphere, and its pdf.
fn naive_sphere(center: Vec3, r: f32, u: [u32; 2]) -> (Vec3, f32) {
    let square = r * r / center.length_squared();
    let widest = (1.0 - square).max(0.0).sqrt();
    let cosine = 1.0 - unit(u[0]) * (1.0 - widest);
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (s, c) = (TAU * unit(u[1])).sin_cos();
    let pdf = 0.5 * FRAC_1_PI / (1.0 - widest);
    let local = vec3(sine * c, sine * s, cosine);
    (frisvad(center.normalize(), local), pdf)
}

/// The pdf of a rounded direction to a disk, by the grazing angle.
fn naive_disk(center: Vec3, normal: Vec3, radius: f32, d: Vec3) -> f32 {
    let normal = normal.normalize();
    let distance = center.dot(normal) / d.dot(normal);
    distance * distance / (PI * radius * radius * d.dot(normal).abs())
}

pub(super) fn lights() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for map in ["sphere-light", "disk-light"] {
        // A pdf and three coordinates that follow each other.
        for four in solid(map)?.chunks_exact(4) {
            let [pdf, x, y, z] = four else { continue };
            let subject = sample(map, &pdf.parameters, pdf.u)?;
            let p: Vec<f32> = pdf.parameters.iter().map(|&x| x as f32).collect();
            let input = format!("{map} {p:?}, u = [{}, {}]", pdf.u[0], pdf.u[1]);
            let mut pdf_of = |naive: f32, subject: Subject| {
                cases.push(Case::of(
                    pdf.number,
                    format!("{input}, pdf"),
                    &[naive.into()],
                    reading(pdf.quantity),
                    truth(&[pdf.value]),
                    1e-6,
                    subject,
                ));
            };
            match p[..] {
                [a, b, c, r] => {
                    let (d, naive) = naive_sphere(vec3(a, b, c), r, pdf.u);
                    pdf_of(naive, subject.clone());
                    cases.push(Case::of(
                        pdf.number,
                        format!("{input}, direction"),
                        &d.to_array().map(f64::from),
                        Reading {
                            first: 0,
                            measure: Measure::Distance,
                        },
                        truth(&[x.value, y.value, z.value]),
                        1e-7,
                        subject,
                    ));
                }
                [a, b, c, i, j, k, r] => {
                    let d = direction(&subject);
                    pdf_of(naive_disk(vec3(a, b, c), vec3(i, j, k), r, d), subject);
                }
                _ => {}
            }
        }
    }
    Ok(cases)
}
