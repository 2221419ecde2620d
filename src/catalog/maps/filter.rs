//! Pixel filters whose cumulative distribution has no inverse in closed form.

use super::{Group, Map, Parameter};
use crate::catalog::Tier;
use crate::interface::{MAP_PARAMETERS, map};

const RADIUS: Parameter = Parameter {
    name: "radius",
    size: 1,
    default: None,
    domain: "it must be from 1e-6 to 1e6",
    summary: "half the side of its square, in pixels",
};

/// The maps of these groups.
pub(super) const MAPS: &[Map] = &[Map {
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
}];

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
