//! Uniform directions of solid angles.

use super::{Group, Map, NATIVE_SINE, Parameter, none};
use crate::catalog::Tier;
use crate::interface::{MAP_PARAMETERS, map};
use crate::reference::spherical_rectangle::{
    spherical_rectangle_prepare, spherical_rectangle_solid_angle,
};
use crate::reference::spherical_triangle::{
    spherical_triangle_prepare, spherical_triangle_solid_angle,
};
use glam::{Vec3, vec3};
use std::f64::consts::PI;

/// What these maps have in common.
const BASE: Map = Map {
    name: "",
    group: Group::Spherical,
    id: 0,
    dimensions: 2,
    coordinates: 3,
    parameters: &[],
    prepare: none,
    examples: &[&[]],
    measure: "solid angle",
    pdf: "",
    ulp: 0.6,
    floor: 0.0,
    pdf_ulp: 0.51,
    native: NATIVE_SINE,
    native_pdf: 1e-5,
    tier: Tier::Integer,
    summary: "",
    source: "",
};

/// The maps of this group.
pub(super) const MAPS: &[Map] = &[
    Map {
        name: "uniform-sphere",
        id: map::UNIFORM_SPHERE,
        pdf: "1 / (4 pi)",
        ulp: 1.6,
        summary: "uniform directions",
        source: "Archimedes' projection; the radius as 2 sqrt(u (1 - u))",
        ..BASE
    },
    Map {
        name: "cone",
        id: map::CONE,
        parameters: &[Parameter {
            name: "theta_max",
            size: 1,
            default: None,
            domain: "it must be from 1.3e-15 to pi",
            summary: "half the opening angle, in radians",
        }],
        prepare: cone,
        examples: &[&[0.5], &[1e-4], &[1e-6], &[1e-3], &[3.0], &[PI], &[1e-12]],
        pdf: "1 / (2 pi h), h = 2 sin^2(theta_max/2)",
        ulp: 1.6,
        summary: "uniform directions of a cone around +z",
        source: "PBRT 4th ed., A.5.4, by versines",
        ..BASE
    },
    Map {
        name: "spherical-triangle",
        id: map::SPHERICAL_TRIANGLE,
        parameters: &[vertex("a"), vertex("b"), vertex("c")],
        prepare: triangle,
        examples: &[
            &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
            &[0.0, 0.0, 1.0, 1e-5, 0.0, 1.0, 0.0, 1e-5, 1.0],
            &[0.0, 0.0, 1.0, 0.0, 1e-3, 1.0, 1e-3, 0.0, 1.0],
            &[0.3, 0.4, 0.8, 0.31, 0.4, 0.8, 0.3, 0.41, 0.8],
            &[1.0, 0.0, 1e-2, -0.5, 0.866, 1e-2, -0.5, -0.866, 1e-2],
            &[1.0, 0.2, 0.1, 1.1, 0.3, -0.1, -1.0, 0.3, 0.2],
            &[-7.0, 1.0, 1.0, 1e-2, 2e-2, 4e-2, 90.0, -3.0, 80.0],
        ],
        ulp: 0.9,
        floor: 0.125,
        pdf: "1 / solid angle",
        pdf_ulp: 0.6,
        // The quotient of two sines, near a hemisphere's their difference.
        native: 0.02,
        native_pdf: 2e-3,
        summary: "uniform directions of a triangle seen from the origin",
        source: "Arvo 1995 and Peters 2021, in sums that do not cancel",
        ..BASE
    },
    Map {
        name: "spherical-rectangle",
        id: map::SPHERICAL_RECTANGLE,
        parameters: &[
            Parameter {
                name: "corner",
                size: 3,
                default: None,
                domain: RECTANGLE,
                summary: "one corner, seen from the origin",
            },
            Parameter {
                name: "x",
                size: 3,
                default: None,
                domain: RECTANGLE,
                summary: "the side from the corner to one neighbour",
            },
            Parameter {
                name: "y",
                size: 3,
                default: None,
                domain: RECTANGLE,
                summary: "the side from the corner to the other",
            },
        ],
        prepare: rectangle,
        examples: &[
            &[-0.5, -0.5, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
            &[0.0, 0.0, 1.0, 3e-3, 0.0, 0.0, 0.0, 3e-3, 0.0],
            &[0.0, 0.0, 1.0, 1e-5, 0.0, 0.0, 0.0, 1e-5, 0.0],
            &[-1.0, -1.0, 0.01, 2.0, 0.0, 0.0, 0.0, 3.0, 0.0],
            &[3.0, 1.0, 2.0, 0.5, 0.0, -0.5, 0.0, 7.0, 0.0],
        ],
        ulp: 0.9,
        floor: 0.125,
        pdf: "1 / solid angle",
        pdf_ulp: 0.6,
        native: 0.02,
        native_pdf: 2e-3,
        summary: "uniform directions of a rectangle seen from the origin",
        source: "two triangles that share a corner and the diagonal: Peters 2021",
        ..BASE
    },
    Map {
        name: "sphere-light",
        id: map::SPHERE_LIGHT,
        parameters: &[
            Parameter {
                name: "center",
                size: 3,
                default: None,
                domain: "it must be a point, the origin or from 1e-6 to 1e6 away",
                summary: "the centre, seen from the origin",
            },
            RADIUS,
        ],
        prepare: sphere,
        examples: &[
            &[1.0, 2.0, 3.0, 1.0],
            &[0.0, 0.0, 1.0, 1e-3],
            &[0.0, 0.0, -1e4, 1.0],
            &[3.0, 4.0, 12.0, 1e-2],
            &[0.0, 0.0, 1.0, 0.999_999_9],
            &[0.0, 3.0, 4.0, 5.0],
            &[0.1, 0.2, 0.3, 5.0],
        ],
        ulp: 0.7,
        floor: 0.03125,
        pdf: "1 / (2 pi h), h = 1 - cos of the half angle; 1 / (4 pi) from within",
        pdf_ulp: 0.6,
        native_pdf: 2e-3,
        summary: "uniform directions towards a sphere",
        source: "PBRT 4th ed., 6.2.4, by versines",
        ..BASE
    },
    Map {
        name: "disk-light",
        id: map::DISK_LIGHT,
        parameters: &[
            Parameter {
                name: "center",
                size: 3,
                default: None,
                domain: "it must be a point from 1e-6 to 1e6 away, from where the disk is not seen edge-on",
                summary: "the centre, seen from the origin",
            },
            Parameter {
                name: "normal",
                size: 3,
                default: None,
                domain: "it must be a vector of length 1e-6 to 1e6",
                summary: "the direction across the disk, either way",
            },
            RADIUS,
        ],
        prepare: disk,
        examples: &[
            &[0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 1.0],
            &[0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 1e-4],
            &[1.0, 2.0, 3.0, 1.0, 0.0, -0.3, 2.0],
            &[1.0, 0.0, 1e-2, 0.0, 0.0, 1.0, 0.5],
            &[-5.0, 1.0, 2.0, 3.0, 2.0, 1.0, 0.5],
        ],
        ulp: 3.0,
        floor: 0.25,
        pdf: "|p|^3 / (pi r^2 |n . p|)",
        pdf_ulp: 3.0,
        native: 4e-3,
        native_pdf: 5e-3,
        summary: "directions towards a disk, uniform in its area",
        source: "PBRT 4th ed., 6.3 and 12.2.3",
        ..BASE
    },
];

const RECTANGLE: &str = "corner, x and y must be vectors of length 1e-6 to 1e6, the sides \
    at right angles to 1e-5, not in a plane with the origin";

const RADIUS: Parameter = Parameter {
    name: "radius",
    size: 1,
    default: None,
    domain: "it must be from 1e-9 of the distance to 1e6",
    summary: "the radius",
};

/// A vertex of a triangle.
const fn vertex(name: &'static str) -> Parameter {
    Parameter {
        name,
        size: 3,
        default: None,
        domain: "a, b and c must be vectors of length 1e-6 to 1e6, not in a plane with the origin",
        summary: "a vertex, seen from the origin",
    }
}

/// The numbers as floats, if the vectors that begin at these places are of a length that
/// both profiles can square; or the first that is not.
fn vectors(values: &[f64], starts: &[usize]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let mut words = [0.0; MAP_PARAMETERS];
    for (word, value) in words.iter_mut().zip(values) {
        *word = *value as f32;
    }
    for (index, &start) in starts.iter().enumerate() {
        let length = (start..start + 3)
            .map(|i| f64::from(words[i]).powi(2))
            .sum::<f64>()
            .sqrt();
        if !(1e-6..=1e6).contains(&length) {
            return Err(index);
        }
    }
    Ok(words)
}

fn vector(words: &[f32; MAP_PARAMETERS], start: usize) -> Vec3 {
    vec3(words[start], words[start + 1], words[start + 2])
}

fn triangle(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let words = vectors(values, &[0, 3, 6])?;
    let made = spherical_triangle_prepare(vector(&words, 0), vector(&words, 3), vector(&words, 6));
    if spherical_triangle_solid_angle(made) < 1e-30 {
        return Err(2);
    }
    Ok(words)
}

fn rectangle(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let words = vectors(values, &[0, 3, 6])?;
    let [corner, x, y] = [0, 3, 6].map(|i| vector(&words, i));
    let made = spherical_rectangle_prepare(corner, x, y);
    let cosine = x.as_dvec3().normalize().dot(y.as_dvec3().normalize());
    if spherical_rectangle_solid_angle(made) < 1e-30 || cosine.abs() > 1e-5 {
        return Err(2);
    }
    Ok(words)
}

fn sphere(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let at_origin = values.iter().take(3).all(|&x| x == 0.0);
    let words = vectors(values, if at_origin { &[] } else { &[0] })?;
    let distance = f64::from(vector(&words, 0).length());
    if !(1e-9 * distance..=1e6).contains(&f64::from(words[3])) || words[3] < 1e-6 {
        return Err(1);
    }
    Ok(words)
}

fn disk(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let words = vectors(values, &[0, 3])?;
    let [center, normal] = [0, 3].map(|i| vector(&words, i).as_dvec3().normalize());
    if center.dot(normal).abs() < 1e-12 {
        return Err(0);
    }
    let distance = f64::from(vector(&words, 0).length());
    if !(1e-9 * distance..=1e6).contains(&f64::from(words[6])) {
        return Err(2);
    }
    Ok(words)
}

/// h = 2 sin^2(theta_max/2), rounded to float: the cone is that of the rounded h.
fn cone(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let &[theta] = values else { return Err(0) };
    let h = 2.0 * (0.5 * theta).sin().powi(2);
    if !(1.3e-15..=PI).contains(&theta) {
        return Err(0);
    }
    let mut words = [0.0; MAP_PARAMETERS];
    words[0] = (h as f32).min(2.0);
    Ok(words)
}
