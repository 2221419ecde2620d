//! Uniform directions of solid angles.

use super::{Group, Map, NATIVE_SINE, Parameter, none};
use crate::catalog::Tier;
use crate::interface::{MAP_PARAMETERS, map};
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
];

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
