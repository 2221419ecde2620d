//! Powers of the cosine.

use super::{Group, Map, Parameter};
use crate::catalog::Tier;
use crate::interface::{MAP_PARAMETERS, map};

/// The maps of this group.
pub(super) const MAPS: &[Map] = &[Map {
    name: "cosine-power-hemisphere",
    group: Group::Lobe,
    id: map::COSINE_POWER_HEMISPHERE,
    dimensions: 2,
    coordinates: 3,
    parameters: &[Parameter {
        name: "exponent",
        size: 1,
        default: None,
        domain: "it must be from 0 to 1e9",
        summary: "the power n: 0 is uniform, 1 cosine-weighted",
    }],
    prepare: exponent,
    examples: &[
        &[1.0],
        &[0.0],
        &[0.3],
        &[20.0],
        &[1e-6],
        &[1e3],
        &[1e6],
        &[1e9],
    ],
    measure: "solid angle",
    pdf: "(n + 1) / (2 pi) z^n, 0 below the horizon",
    ulp: 0.6,
    floor: 0.0,
    // Half, and 2^-27 of an exponent of up to 32, whose digits before the point the mantissa
    // lacks: an eighth.
    pdf_ulp: 0.7,
    native: NATIVE_LOG,
    native_pdf: NATIVE_EXP,
    tier: Tier::Integer,
    summary: "directions around +z by a power of their cosine",
    source: "PBRT 3rd ed., 14.1.1, by logarithms without loss at the pole",
}];

/// log of a device may be off by 2^-21 where it is 2^-4: 2^-17 of the square of a radius.
const NATIVE_LOG: f64 = 1e-5;

/// exp of a device may be off by 3 + 2 |x| ULP, for an x of up to 22 that is off by 2^-21.
const NATIVE_EXP: f64 = 5e-5;

/// A number from 0 to 1e9.
fn exponent(values: &[f64]) -> Result<[f32; MAP_PARAMETERS], usize> {
    let &[n] = values else { return Err(0) };
    if !(0.0..=1e9).contains(&n) {
        return Err(0);
    }
    let mut words = [0.0; MAP_PARAMETERS];
    words[0] = n as f32;
    Ok(words)
}
