//! Free flight, normal distributions and pixel filters.

use super::{Group, Map, NATIVE_SINE, Parameter, none};
use crate::catalog::Tier;
use crate::interface::{MAP_PARAMETERS, map};

/// What these maps have in common.
const BASE: Map = Map {
    name: "",
    group: Group::Line,
    id: 0,
    dimensions: 2,
    coordinates: 2,
    parameters: &[],
    prepare: none,
    examples: &[&[]],
    measure: "area",
    pdf: "",
    ulp: 0.54,
    floor: 0.0,
    pdf_ulp: 0.6,
    native: NATIVE_LOG,
    native_pdf: NATIVE_EXP,
    tier: Tier::Integer,
    summary: "",
    source: "",
};

/// A quantile is a real within 2^-28, whose product with the deviation is rounded twice.
const QUANTILE_ULP: f64 = 0.57;

/// log and division of a device may be off by 3 and 2.5 ULP, and so may our polynomials.
const NATIVE_LOG: f64 = 1e-5;

/// exp of a device may be off by 3 + 2 |x| ULP, for an x of up to 22 that is off itself.
const NATIVE_EXP: f64 = 1e-4;

/// Squares of these, times densities at the farthest samples, are floats.
const SCALE: &str = "it must be from 1e-6 to 1e6";

const SIGMA: Parameter = Parameter {
    name: "sigma",
    size: 1,
    default: Some(&[1.0]),
    domain: SCALE,
    summary: "standard deviation",
};

const RADIUS: Parameter = Parameter {
    name: "radius",
    size: 1,
    default: None,
    domain: SCALE,
    summary: "half the side of its square, in pixels",
};

const SCALES: &[&[f64]] = &[&[1.0], &[0.37], &[1e-6], &[1e6]];

/// The maps of this group.
pub(super) const MAPS: &[Map] = &[
    Map {
        name: "exponential",
        id: map::EXPONENTIAL,
        dimensions: 1,
        coordinates: 1,
        parameters: &[Parameter {
            name: "sigma",
            size: 1,
            default: Some(&[1.0]),
            domain: SCALE,
            summary: "attenuation per unit of length",
        }],
        prepare: scales,
        examples: SCALES,
        measure: "length",
        pdf: "sigma e^(-sigma t)",
        summary: "free flight through a homogeneous medium",
        source: "PBRT 4th ed., A.4.2",
        ..BASE
    },
    Map {
        name: "gaussian",
        id: map::GAUSSIAN,
        dimensions: 1,
        coordinates: 1,
        parameters: &[SIGMA],
        prepare: scales,
        examples: SCALES,
        measure: "length",
        pdf: "e^(-x^2 / (2 sigma^2)) / (sqrt(2 pi) sigma)",
        ulp: QUANTILE_ULP,
        pdf_ulp: 1.5,
        summary: "normal distribution of mean 0, by its quantile",
        source: "Giles 2010",
        ..BASE
    },
    Map {
        name: "normal-pair",
        group: Group::Normal,
        id: map::NORMAL_PAIR,
        parameters: &[SIGMA],
        prepare: scales,
        examples: SCALES,
        pdf: "e^(-(x^2 + y^2) / (2 sigma^2)) / (2 pi sigma^2)",
        ulp: QUANTILE_ULP,
        pdf_ulp: 2.5,
        summary: "two normal distributions by quantiles, which keeps nets",
        source: "Giles 2010",
        ..BASE
    },
    Map {
        name: "box-muller",
        group: Group::Normal,
        id: map::BOX_MULLER,
        parameters: &[SIGMA],
        prepare: scales,
        examples: SCALES,
        pdf: "e^(-(x^2 + y^2) / (2 sigma^2)) / (2 pi sigma^2)",
        ulp: 0.6,
        native: 2.0 * NATIVE_RADIUS * NATIVE_SINE,
        summary: "two normal distributions by radius and angle",
        source: "Box and Muller 1958",
        ..BASE
    },
    Map {
        name: "filter-box",
        group: Group::Filter,
        id: map::FILTER_BOX,
        parameters: &[RADIUS],
        prepare: scales,
        examples: &[&[0.5], &[1.5], &[1e-6], &[1e6]],
        pdf: "1 / (4 r^2)",
        summary: "offsets in a pixel's square",
        source: "PBRT 4th ed., 8.8.1",
        ..BASE
    },
    Map {
        name: "filter-tent",
        group: Group::Filter,
        id: map::FILTER_TENT,
        parameters: &[RADIUS],
        prepare: scales,
        examples: &[&[1.0], &[2.0], &[1e-6], &[1e6]],
        pdf: "(1 - |x|/r) (1 - |y|/r) / r^2",
        summary: "offsets by a tent",
        source: "PBRT 4th ed., 8.8.3",
        ..BASE
    },
    Map {
        name: "filter-gaussian",
        group: Group::GaussianFilter,
        id: map::FILTER_GAUSSIAN,
        parameters: &[
            RADIUS,
            Parameter {
                summary: "its deviation, in pixels",
                ..SIGMA
            },
        ],
        prepare: scales,
        examples: &[
            &[1.5, 0.5],
            &[0.5, 100.0],
            &[1.0, 1.0],
            &[1e3, 0.1],
            &[6.0, 1.0],
            &[1e-6, 1e-6],
        ],
        pdf: "the normal densities over erf(r / (sqrt(2) sigma)), within the radius",
        ulp: 0.6,
        pdf_ulp: 2.5,
        summary: "offsets by a Gaussian that ends at the radius",
        source: "PBRT 4th ed., 8.8.2, not lowered to 0 at its edge",
        ..BASE
    },
];

/// sqrt(2 * 32 ln 2) is the largest radius, a sine of which is off by its share.
const NATIVE_RADIUS: f64 = 6.7;

/// Numbers within the scale.
fn scales(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let mut words = [0.0; MAP_PARAMETERS];
    for (i, (word, &value)) in words.iter_mut().zip(values).enumerate() {
        if !(1e-6..=1e6).contains(&value) {
            return Err(i);
        }
        *word = value as f32;
    }
    Ok(words)
}
