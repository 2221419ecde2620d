//! Disk and hemisphere.

use super::{Group, Map, NATIVE_SINE, none};
use crate::catalog::Tier;
use crate::interface::map;

/// What these maps have in common.
const BASE: Map = Map {
    name: "",
    group: Group::Hemisphere,
    id: 0,
    dimensions: 2,
    coordinates: 3,
    parameters: &[],
    prepare: none,
    examples: &[&[]],
    measure: "solid angle",
    pdf: "z / pi",
    ulp: 1.6,
    floor: 0.0,
    // z is rounded, by 0.53 ULP, before it is divided by pi, which may double the ULP.
    pdf_ulp: 1.6,
    native: NATIVE_SINE,
    native_pdf: NATIVE_SINE,
    tier: Tier::Integer,
    summary: "",
    source: "",
};

/// The maps of this group.
pub(super) const MAPS: &[Map] = &[
    Map {
        name: "cosine-hemisphere",
        id: map::COSINE_HEMISPHERE,
        ulp: 0.6,
        summary: "cosine-weighted directions over the concentric disk",
        source: "Malley's method on Shirley and Chiu 1997",
        ..BASE
    },
    Map {
        name: "cosine-hemisphere-polar",
        id: map::COSINE_HEMISPHERE_POLAR,
        summary: "cosine-weighted directions over the polar disk",
        source: "Malley's method",
        ..BASE
    },
    Map {
        name: "uniform-hemisphere",
        id: map::UNIFORM_HEMISPHERE,
        pdf: "1 / (2 pi)",
        pdf_ulp: 0.5,
        summary: "uniform directions above the horizon",
        source: "Archimedes' projection",
        ..BASE
    },
    Map {
        name: "concentric-disk",
        id: map::CONCENTRIC_DISK,
        coordinates: 2,
        measure: "area",
        pdf: "1 / pi",
        pdf_ulp: 0.5,
        ulp: 0.6,
        summary: "the unit disk, squares to circles",
        source: "Shirley and Chiu 1997",
        ..BASE
    },
    Map {
        name: "polar-disk",
        id: map::POLAR_DISK,
        coordinates: 2,
        measure: "area",
        pdf: "1 / pi",
        pdf_ulp: 0.5,
        summary: "the unit disk, radius and angle",
        source: "inversion of the radial CDF",
        ..BASE
    },
];
