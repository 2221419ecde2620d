//! Scattering distributions: phase functions and microsurfaces.

use super::{Group, Map, Parameter, none};
use crate::catalog::Tier;
use crate::interface::{MAP_PARAMETERS, map};

const ALPHA: Parameter = Parameter {
    name: "alpha",
    size: 1,
    default: None,
    domain: "it must be from 1e-7 to 1e4",
    summary: "roughness, along x if alpha_y is given",
};

const ALPHA_Y: Parameter = Parameter {
    name: "alpha_y",
    size: 1,
    default: Some(&[0.0]),
    domain: "it must be from 1e-7 to 1e4, or 0 for that of alpha",
    summary: "roughness along y; 0: as along x",
};

const WO: Parameter = Parameter {
    name: "wo",
    size: 3,
    default: Some(&[0.0, 0.0, 1.0]),
    domain: "it must be a finite direction other than 0, with z >= 0",
    summary: "the direction from which the surface is seen, of any length",
};

/// What these maps have in common.
const BASE: Map = Map {
    name: "",
    group: Group::Ggx,
    id: 0,
    dimensions: 2,
    coordinates: 3,
    parameters: &[ALPHA, ALPHA_Y, WO],
    prepare: microsurface,
    examples: LOBES,
    measure: "solid angle",
    pdf: "D(h) / (2 (wo.z + |S wo|)), S stretching by alpha",
    ulp: 0.6,
    // A reflected direction is a multiple of a normal less wo.
    floor: 1.0,
    pdf_ulp: 0.9,
    // A normal of the unit sphere is right to 2^-20, and shrinking by alpha turns it.
    native: 0.02,
    native_pdf: 0.02,
    tier: Tier::Integer,
    summary: "",
    source: "",
};

/// alpha, alpha_y, wo: rough and smooth, isotropic and not, seen from above to grazing.
const LOBES: &[&[f64]] = &[
    &[0.3, 0.0, 0.8, 0.0, 0.6],
    &[1.0, 0.0, 0.0, 0.0, 1.0],
    &[0.1, 0.5, -0.48, 0.6, 0.64],
    &[1e-2, 0.0, 1.0, 0.0, 1e-3],
    &[1e-3, 0.0, 0.8, 0.0, 0.6],
    &[1e-4, 0.0, 0.0, 0.0, 1.0],
    &[1e-4, 0.0, -0.48, 0.6, 0.64],
    &[0.3, 0.0, 1.0, 0.0, 0.0],
];

/// The maps of this group.
pub(super) const MAPS: &[Map] = &[
    Map {
        name: "henyey-greenstein",
        group: Group::Phase,
        id: map::HENYEY_GREENSTEIN,
        parameters: &[Parameter {
            name: "g",
            size: 1,
            default: None,
            domain: "it must lie between -1 and 1, 1e-15 from either",
            summary: "the mean cosine: above 0 scatters forward, to +z",
        }],
        prepare: phase,
        examples: &[
            &[0.5],
            &[0.0],
            &[1e-6],
            &[-0.9],
            &[0.999],
            &[0.999_999],
            &[-0.999_999],
        ],
        pdf: "(1 - g^2) / (4 pi (1 + g^2 - 2 g z)^1.5)",
        ulp: 1.0,
        // z is right to 2^-29 where it passes 0; x and y are right to 0.53 ULP.
        floor: 1.0 / 64.0,
        native: 4e-6,
        native_pdf: 2e-5,
        summary: "phase function; +z is the direction of propagation",
        source: "Henyey and Greenstein 1941, as sums of positive terms",
        ..BASE
    },
    Map {
        name: "ggx-vndf",
        id: map::GGX_VNDF,
        summary: "reflection at the visible normals of GGX",
        source: "Heitz 2018",
        ..BASE
    },
    Map {
        name: "ggx-vndf-normal",
        id: map::GGX_VNDF_NORMAL,
        pdf: "2 (wo.h) D(h) / (wo.z + |S wo|)",
        summary: "the visible normals of GGX",
        source: "Heitz 2018",
        ..BASE
    },
    Map {
        name: "ggx-vndf-cap",
        group: Group::GgxCap,
        id: map::GGX_VNDF_CAP,
        // 0.9, and 2^-30 k of its header, a tenth of a ULP of lobes as narrow as the examples'.
        pdf_ulp: 1.0,
        summary: "reflection at the visible normals of GGX, by spherical caps",
        source: "Dupuy and Benyoub 2023",
        ..BASE
    },
    Map {
        name: "ggx-vndf-bounded",
        group: Group::GgxCap,
        id: map::GGX_VNDF_BOUNDED,
        pdf_ulp: 1.0,
        pdf: "D(h) / (2 (k wo.z + |S wo|))",
        summary: "the same without most of what would lie below the horizon",
        source: "Eto and Tokuyoshi 2023",
        ..BASE
    },
    Map {
        name: "beckmann-normal",
        group: Group::Beckmann,
        id: map::BECKMANN_NORMAL,
        parameters: &[ALPHA, ALPHA_Y],
        examples: &[
            &[0.3, 0.0],
            &[1.0, 0.0],
            &[0.1, 0.5],
            &[1e-3, 0.0],
            &[1e-4, 0.0],
        ],
        pdf: "D(h) h.z",
        floor: 0.0,
        native: 4e-6,
        native_pdf: 4e-5,
        summary: "the normals of Beckmann",
        source: "Walter et al. 2007",
        ..BASE
    },
    Map {
        name: "beckmann",
        group: Group::Beckmann,
        id: map::BECKMANN,
        examples: &[
            &[0.1, 0.0, 0.8, 0.0, 0.6],
            &[1.0, 0.0, 0.0, 0.0, 1.0],
            &[0.05, 0.1, -0.48, 0.6, 0.64],
            &[1e-3, 0.0, 0.8, 0.0, 0.6],
            &[1e-4, 0.0, 0.0, 0.0, 1.0],
        ],
        pdf: "D(h) h.z / (4 |wo.h|)",
        native: 1e-5,
        native_pdf: 1e-4,
        summary: "reflection at the normals of Beckmann",
        source: "Walter et al. 2007",
        ..BASE
    },
];

/// 1 - |g|, rounded to float from what `f64` has of it, and whether g < 0.
fn phase(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let &[g] = values else { return Err(0) };
    let rest = 1.0 - g.abs();
    if !(1e-15..=1.0).contains(&rest) {
        return Err(0);
    }
    let mut words = [0.0; MAP_PARAMETERS];
    words[0] = rest as f32;
    words[1] = f32::from(u8::from(g < 0.0));
    Ok(words)
}

/// alpha, twice, and the unit direction.
fn microsurface(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    const ROUGHNESS: std::ops::RangeInclusive<f64> = 1e-7..=1e4;
    let mut words = none(values)?;
    let (&[alpha, alpha_y], wo) = values.split_first_chunk().ok_or(0usize)?;
    if !ROUGHNESS.contains(&alpha) {
        return Err(0);
    }
    if alpha_y != 0.0 && !ROUGHNESS.contains(&alpha_y) {
        return Err(1);
    }
    words[0] = alpha as f32;
    words[1] = if alpha_y == 0.0 { alpha } else { alpha_y } as f32;
    if let &[x, y, z] = wo {
        // By the largest first: the square of a long vector is not a number.
        let largest = x.abs().max(y.abs()).max(z.abs());
        let length = [x, y, z].map(|v| (v / largest).powi(2)).iter().sum::<f64>();
        let unit = [x, y, z].map(|v| v / largest / length.sqrt());
        if !(unit.iter().all(|v| v.is_finite()) && z >= 0.0) {
            return Err(2);
        }
        for (word, v) in words[2..].iter_mut().zip(unit) {
            *word = v as f32;
        }
    }
    Ok(words)
}
