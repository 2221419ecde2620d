//! Directions by the light of an environment map.

use super::{Group, Map, NATIVE_SINE, none};
use crate::catalog::Tier;
use crate::interface::map;

/// What these maps have in common.
const BASE: Map = Map {
    name: "",
    group: Group::Environment,
    id: 0,
    dimensions: 2,
    coordinates: 3,
    parameters: &[],
    prepare: none,
    examples: &[&[]],
    measure: "solid angle",
    pdf: "P(texel) / solid angle of the texel",
    // z keeps within the floats of its row, one away from the nearest at most.
    ulp: 0.8,
    floor: 1.0,
    pdf_ulp: 0.6,
    // z may be a float away besides.
    native: NATIVE_SINE,
    native_pdf: 1e-6,
    tier: Tier::Integer,
    summary: "",
    source: "",
};

/// The maps of this group.
pub(super) const MAPS: &[Map] = &[
    Map {
        name: "environment",
        id: map::ENVIRONMENT,
        summary: "the light of --env FILE: row, then column of a texel",
        source: "PBRT 4th ed., 12.5, on integer weights times exact solid angles",
        ..BASE
    },
    Map {
        name: "environment-alias",
        id: map::ENVIRONMENT_ALIAS,
        dimensions: 3,
        summary: "the light of --env FILE: a texel by one dimension, the place in it by two",
        source: "Walker 1977, Vose 1991, in integers",
        ..BASE
    },
];
