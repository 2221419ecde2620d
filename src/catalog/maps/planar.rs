//! Uniform points of plane figures.

use super::{Group, Map, NATIVE_SINE, Parameter, none};
use crate::catalog::Tier;
use crate::interface::{MAP_PARAMETERS, map};
use crate::reference::triangle::triangle_area;
use glam::vec2;

/// What these maps have in common.
const BASE: Map = Map {
    name: "",
    group: Group::Planar,
    id: 0,
    dimensions: 2,
    coordinates: 2,
    parameters: &[],
    prepare: none,
    examples: &[&[]],
    measure: "area",
    pdf: "1 / area",
    ulp: 0.9,
    floor: 0.0,
    pdf_ulp: 0.6,
    native: 2.0 * NATIVE_SINE,
    native_pdf: 1e-5,
    tier: Tier::Integer,
    summary: "",
    source: "",
};

/// The maps of this group.
pub(super) const MAPS: &[Map] = &[
    Map {
        name: "triangle",
        id: map::TRIANGLE,
        parameters: &[vertex("a"), vertex("b"), vertex("c")],
        prepare: triangle,
        examples: &[
            &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0],
            &[0.25, 0.5, 0.75, 0.25, 0.125, 0.875],
            &[0.0, 0.0, 1e-6, 0.0, 0.0, 1e-6],
            &[1.0, 1.0, 1.001, 1.0, 1.0, 1.01],
            &[-0.5, -0.5, 0.5, -0.5, 0.0, 0.5],
        ],
        floor: 0.0625,
        native_pdf: 1e-4,
        summary: "the triangle of three points of the plane",
        source: "Heitz 2019, with integer barycentric coordinates",
        ..BASE
    },
    Map {
        name: "regular-polygon",
        id: map::REGULAR_POLYGON,
        parameters: &[Parameter {
            name: "sides",
            size: 1,
            default: None,
            domain: "it must be a whole number from 3 to 65536",
            summary: "the number of sides",
        }],
        prepare: sides,
        examples: &[&[3.0], &[5.0], &[6.0], &[1000.0], &[65536.0]],
        floor: 0.0625,
        pdf: "1 / (n sin(pi/n) cos(pi/n))",
        // Of three sides: 2^-11 in the sine of pi/3 is 1.7 times as much in its cosine, and
        // 4.6 times as much of the area; a rotation adds two errors to the coordinates.
        native: 4.0 * NATIVE_SINE,
        native_pdf: 5.0 * NATIVE_SINE,
        summary: "the regular polygon of circumradius 1",
        source: "triangles from the centre",
        ..BASE
    },
    Map {
        name: "annulus",
        id: map::ANNULUS,
        parameters: &[Parameter {
            name: "inner",
            size: 1,
            default: None,
            domain: "it must be at least 0 and below 1 - 2^-24",
            summary: "the inner radius; the outer one is 1",
        }],
        prepare: inner,
        examples: &[&[0.5], &[0.0], &[1e-6], &[0.999], &[0.9999]],
        pdf: "1 / (pi (1 - inner^2))",
        summary: "the ring between an inner radius and 1",
        source: "inversion of the radial CDF",
        ..BASE
    },
];

/// A vertex of a triangle.
const fn vertex(name: &'static str) -> Parameter {
    Parameter {
        name,
        size: 2,
        default: None,
        domain: "a, b and c must be points within 1e9, not on a line",
        summary: "a vertex",
    }
}

fn triangle(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let mut words = [0.0; MAP_PARAMETERS];
    for (i, value) in values.iter().enumerate().take(6) {
        if !(-1e9..=1e9).contains(value) {
            return Err(i / 2);
        }
        words[i] = *value as f32;
    }
    let [a, b, c] = [0, 2, 4].map(|i| vec2(words[i], words[i + 1]));
    let area = crate::reference::real::real_float(triangle_area(a, b, c));
    if area.abs() < 1e-30 {
        return Err(2);
    }
    Ok(words)
}

fn sides(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let &[sides] = values else { return Err(0) };
    if !(3.0..=65_536.0).contains(&sides) || sides.fract() != 0.0 {
        return Err(0);
    }
    let mut words = [0.0; MAP_PARAMETERS];
    // The kernel takes the number itself, whose bits are those of a small float.
    words[0] = f32::from_bits(sides as u32);
    Ok(words)
}

fn inner(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let &[inner] = values else { return Err(0) };
    if !(0.0..1.0).contains(&inner) || inner as f32 >= 1.0 {
        return Err(0);
    }
    let mut words = [0.0; MAP_PARAMETERS];
    words[0] = inner as f32;
    Ok(words)
}
