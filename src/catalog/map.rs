//! The maps from the unit square.

use super::Tier;
use crate::Result;
use crate::interface::map;

/// A map of two fractions to a sample of a distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Map {
    /// The name on the command line.
    pub name: &'static str,
    /// Value of the specialization constant `MAP`.
    pub id: u32,
    /// Coordinates of a sample: 2 of a disk, 3 of a direction.
    pub coordinates: u32,
    /// Measure that the pdf is taken with respect to.
    pub measure: &'static str,
    /// The density.
    pub pdf: &'static str,
    /// Worst error of a coordinate in the exact profile, in ULP.
    pub ulp: f64,
    /// Where its bits are promised.
    pub tier: Tier,
    /// What it is, in a line.
    pub summary: &'static str,
    /// The paper.
    pub source: &'static str,
}

impl Map {
    /// Fractions that it takes per sample.
    pub const DIMENSIONS: u32 = 2;

    /// The map with this name.
    ///
    /// # Errors
    /// [`crate::Error::UnknownName`], with the nearest name.
    pub fn from_name(name: &str) -> Result<&'static Self> {
        MAPS.iter()
            .find(|candidate| candidate.name == name)
            .ok_or_else(|| {
                let known: Vec<&str> = MAPS.iter().map(|m| m.name).collect();
                crate::Error::unknown_name("map", name, &known)
            })
    }
}

/// Every map.
pub const MAPS: &[Map] = &[
    Map {
        name: "cosine-hemisphere",
        id: map::COSINE_HEMISPHERE,
        coordinates: 3,
        measure: "solid angle",
        pdf: "z / pi",
        ulp: 0.6,
        tier: Tier::Integer,
        summary: "cosine-weighted directions over the concentric disk",
        source: "Malley's method on Shirley and Chiu 1997",
    },
    Map {
        name: "cosine-hemisphere-polar",
        id: map::COSINE_HEMISPHERE_POLAR,
        coordinates: 3,
        measure: "solid angle",
        pdf: "z / pi",
        ulp: 1.6,
        tier: Tier::Integer,
        summary: "cosine-weighted directions over the polar disk",
        source: "Malley's method",
    },
    Map {
        name: "uniform-hemisphere",
        id: map::UNIFORM_HEMISPHERE,
        coordinates: 3,
        measure: "solid angle",
        pdf: "1 / (2 pi)",
        ulp: 1.6,
        tier: Tier::Integer,
        summary: "uniform directions above the horizon",
        source: "Archimedes' projection",
    },
    Map {
        name: "concentric-disk",
        id: map::CONCENTRIC_DISK,
        coordinates: 2,
        measure: "area",
        pdf: "1 / pi",
        ulp: 0.6,
        tier: Tier::Integer,
        summary: "the unit disk, squares to circles",
        source: "Shirley and Chiu 1997",
    },
    Map {
        name: "polar-disk",
        id: map::POLAR_DISK,
        coordinates: 2,
        measure: "area",
        pdf: "1 / pi",
        ulp: 1.6,
        tier: Tier::Integer,
        summary: "the unit disk, radius and angle",
        source: "inversion of the radial CDF",
    },
];
