//! Triangles and rectangles seen from the origin, by their solid angle.

use super::case::{Case, Measure, Reading, Source, Subject, Truth};
use super::truth::{Solid, solid};
use crate::Result;
use crate::catalog::{Map, Mapping};
use crate::reference::spherical_rectangle::{
    spherical_rectangle, spherical_rectangle_pdf, spherical_rectangle_prepare,
};
use glam::{Vec3, vec3};
use std::f32::consts::{PI, TAU};

/// The middle of the fractions.
const MIDDLE: [u32; 2] = [1 << 31; 2];

fn sample(map: &str, parameters: &[f64]) -> Result<Subject> {
    let mapping = Box::new(Mapping::with_values(Map::from_name(map)?, parameters)?);
    Ok(Subject::Map { mapping, u: MIDDLE })
}

/// Three vectors, from their coordinates.
fn vectors(t: &Solid) -> Option<[Vec3; 3]> {
    let p: Vec<f32> = t.parameters.iter().map(|&x| x as f32).collect();
    let &[a, b, c, d, e, f, g, h, i] = p.as_slice() else {
        return None;
    };
    Some([vec3(a, b, c), vec3(d, e, f), vec3(g, h, i)])
}

/// The solid angle is the reciprocal of the pdf of any sample.
fn solid_angle(map: &str, t: &Solid, naive: f32) -> Result<Case> {
    let p: Vec<f32> = t.parameters.iter().map(|&x| x as f32).collect();
    Ok(Case::of(
        t.number,
        format!("{map} {p:?}, solid angle"),
        &[naive.into()],
        Reading {
            first: 3,
            measure: Measure::Reciprocal,
        },
        Truth {
            values: vec![t.value],
            source: Source::Multiprecision,
        },
        1e-6,
        sample(map, &t.parameters)?,
    ))
}

/// Girard's theorem in floats, the common formula.
fn girard(corners: [Vec3; 3]) -> f32 {
    let [a, b, c] = corners.map(Vec3::normalize);
    let [x, y, z] = [a.cross(b), b.cross(c), c.cross(a)].map(Vec3::normalize);
    let angle = |v: Vec3, w: Vec3| (-v.dot(w)).clamp(-1.0, 1.0).acos();
    angle(x, y) + angle(y, z) + angle(z, x) - PI
}

/// The triple product of unit vectors in floats, the other common one.
fn triple(corners: [Vec3; 3]) -> f32 {
    let [a, b, c] = corners.map(Vec3::normalize);
    let sum = 1.0 + a.dot(b) + b.dot(c) + c.dot(a);
    2.0 * a.dot(b.cross(c)).abs().atan2(sum)
}

pub(super) fn triangles() -> Result<Vec<Case>> {
    let map = "spherical-triangle";
    let mut cases = Vec::new();
    for t in solid(map)?.iter().filter(|t| t.quantity == "area") {
        let corners = vectors(t).unwrap_or_default();
        let naive = match t.number {
            24 => triple(corners),
            _ => girard(corners),
        };
        cases.push(solid_angle(map, t, naive)?);
    }
    Ok(cases)
}

/// Girard's theorem in floats with the inner angles of Urena et al.
fn girard_of_four([o, x, y]: [Vec3; 3]) -> f32 {
    let [a, b, c, d] = [o, o + x, o + x + y, o + y];
    let normals = [[a, b], [b, c], [c, d], [d, a]].map(|[v, w]| v.cross(w).normalize());
    let [p, q, r, s] = normals;
    let angle = |v: Vec3, w: Vec3| (-v.dot(w)).acos();
    [angle(p, q), angle(q, r), angle(r, s), angle(s, p)]
        .iter()
        .sum::<f32>()
        - TAU
}

/// A coordinate of Urena, Fajardo and King 2013, steps 3 to 5, of a rectangle with corners
/// (x0, y0) and (x1, y1) at this height below 0, which should be between x0 and x1.
fn urena([x0, x1]: [f32; 2], [y0, y1]: [f32; 2], z: f32, u: f32) -> f32 {
    let height = |y: f32| y / (y * y + z * z).sqrt();
    let width = |x: f32| x / (x * x + z * z).sqrt();
    let [n0, n1, n2, n3] = [-height(y0), width(x1), height(y1), -width(x0)];
    let [g0, g1, g2, g3] = [-n0 * n1, -n1 * n2, -n2 * n3, -n3 * n0].map(f32::acos);
    let k = 2.0 * PI - g2 - g3;
    let a = u * (g0 + g1 - k) + k;
    let f = (a.cos() * n0 - n2) / a.sin();
    let c = f.signum() / (f * f + n0 * n0).sqrt();
    -(c * z) / (1.0 - c * c).max(0.0).sqrt()
}

pub(super) fn rectangles() -> Result<Vec<Case>> {
    let map = "spherical-rectangle";
    let mut cases = Vec::new();
    for t in &solid(map)? {
        let naive = girard_of_four(vectors(t).unwrap_or_default());
        cases.push(solid_angle(map, t, naive)?);
    }
    cases.push(flat());
    Ok(cases)
}

/// In a plane with the origin there is nothing to see: +z, with a pdf of 0. The map's host
/// refuses it.
fn flat() -> Case {
    let found = urena([1.0, 2.0], [1.0, 2.0], 0.0, 0.5);
    let naive = match (1.0..=2.0).contains(&found) {
        true => 0.0,
        false => f64::INFINITY,
    };
    let seen = spherical_rectangle_prepare(vec3(1.0, 1.0, 0.0), Vec3::X, Vec3::Y);
    let d = spherical_rectangle(seen, MIDDLE.into());
    let ours = (d - Vec3::Z).length() + spherical_rectangle_pdf(seen, d);
    Case::host(
        28,
        "spherical-rectangle in a plane with the origin: +z, pdf 0",
        [naive, ours.into()],
        Source::ClosedForm,
        0.0,
    )
}

#[cfg(test)]
mod tests {
    /// With a height it is right, so that its failure is that of the case.
    #[test]
    fn the_common_form_is_right_at_a_height() {
        let right = super::urena([1.0, 2.0], [1.0, 2.0], -1.0, 0.5);
        assert!((1.0..2.0).contains(&right), "{right}");
    }
}
