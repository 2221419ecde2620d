//! Pixel filters whose cumulative distribution has no inverse in closed form.

use super::{Group, Map, Parameter, SWIFTSHADER};
use crate::catalog::Tier;
use crate::interface::{MAP_PARAMETERS, map};
use crate::reference::filter_mitchell::filter_mitchell_prepare;

const RADIUS: Parameter = Parameter {
    name: "radius",
    size: 1,
    default: None,
    domain: "it must be from 1e-6 to 1e6",
    summary: "half the side of its square, in pixels",
};

/// The maps of these groups.
pub(super) const MAPS: &[Map] = &[
    Map {
        name: "filter-blackman-harris",
        group: Group::WindowFilter,
        id: map::FILTER_BLACKMAN_HARRIS,
        dimensions: 2,
        coordinates: 2,
        parameters: &[RADIUS],
        prepare: window,
        examples: &[&[2.0], &[0.5], &[1e-6], &[1e6]],
        measure: "area",
        pdf: "w(x/r) w(y/r) / (0.7175 r)^2, w = 0.35875 + 0.48829 cos(pi t) + \
        0.14128 cos(2 pi t) + 0.01168 cos(3 pi t)",
        ulp: 0.6,
        floor: 0.0,
        pdf_ulp: 1.0,
        native: 1e-5,
        native_pdf: 1e-4,
        slow: &[],
        tier: Tier::Integer,
        summary: "offsets by the 4-term window of Blackman and Harris",
        source: "Harris 1978; the inverse of its integral by Newton's method",
    },
    Map {
        name: "filter-mitchell",
        group: Group::MitchellFilter,
        id: map::FILTER_MITCHELL,
        dimensions: 2,
        coordinates: 2,
        parameters: &[RADIUS, THIRD, Parameter { name: "c", ..THIRD }],
        prepare: mitchell,
        examples: &[
            &[2.0, 1.0 / 3.0, 1.0 / 3.0],
            &[2.0, 0.0, 0.5],
            &[0.5, 1.0, 0.0],
            &[1.0, 0.0, 0.0],
            &[1.0, 1.0, 1.0],
            &[1.0, 0.2, 1e-3],
            &[1.0, 1e-3, 0.9],
            &[1e6, 0.5, 0.25],
            &[1e-6, 0.25, 0.5],
        ],
        measure: "area",
        pdf: "|f(2 x/r) f(2 y/r)| over its integral; f / pdf is the weight",
        ulp: 0.6,
        floor: 0.0,
        pdf_ulp: 1.0,
        native: 1e-5,
        native_pdf: 1e-4,
        slow: SWIFTSHADER,
        tier: Tier::Integer,
        summary: "offsets by the magnitude of Mitchell and Netravali's filter, whose sign is the weight's",
        source: "Mitchell and Netravali 1988; weights as in PBRT 4th ed., 8.8.6",
    },
];

const THIRD: Parameter = Parameter {
    name: "b",
    size: 1,
    default: Some(&[1.0 / 3.0]),
    domain: "b and c must be from 0 to 1",
    summary: "a parameter of the filter, which blurs by b and rings by c",
};

/// A radius, or the number of the parameter that is none.
fn window(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let &[radius] = values else { return Err(0) };
    if !(1e-6..=1e6).contains(&radius) {
        return Err(0);
    }
    let mut words = [0.0; MAP_PARAMETERS];
    words[0] = radius as f32;
    Ok(words)
}

/// Radius, B and C, and the bits of the shares beyond 1 and beyond the change of sign.
fn mitchell(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let &[radius, b, c] = values else {
        return Err(0);
    };
    let mut words = window(&[radius])?;
    for (i, value) in [b, c].into_iter().enumerate() {
        if !(0.0..=1.0).contains(&value) {
            return Err(i + 1);
        }
        words[i + 1] = value as f32;
    }
    let filter = filter_mitchell_prepare(words[0], words[1], words[2]);
    // Below 2^30, hence finite.
    words[3] = f32::from_bits(filter.tail);
    words[4] = f32::from_bits(filter.lobe);
    Ok(words)
}
