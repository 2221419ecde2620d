//! The irradiance of a surface under an environment map.

use super::{Coefficients, Integrand, LightMap, MIS, Parameter, Setting, within};
use crate::interface::integrand;
use std::f64::consts::{PI, TAU};

const ESTIMATORS: &[&str] = &["uniform", "cosine", "environment", MIS];

/// The integrands of this group.
pub(super) const INTEGRANDS: &[Integrand] = &[Integrand {
    name: "irradiance",
    id: integrand::IRRADIANCE_UNIFORM,
    dimensions: (2, 2),
    default_dimensions: 2,
    parameters: &[Parameter {
        name: "axis",
        size: 1,
        default: Some(&[4.0]),
        domain: "it must be one of +x, -x, +y, -y, +z, -z",
        summary: "the direction that the surface faces",
    }],
    estimators: ESTIMATORS,
    needs_map: true,
    picture: None,
    finite_variance: true,
    prepare,
    truth: |s| {
        s.map
            .map_or(f64::NAN, |map| map.irradiance(s.values[0] as usize))
    },
    error: 2e-7,
    examples: &[
        (&[4.0], 2),
        (&[1.0], 2),
        (&[2.0], 2),
        (&[5.0], 2),
        (&[0.0], 2),
        (&[3.0], 2),
    ],
    summary: "light of an environment map on a surface, as luminance (Rec. 709)",
    formula: "integral of L(w) max(0, n w) over directions w; uniform and cosine: of the \
              hemisphere, environment: by the map's light, mis: half of each of the last two",
    source: "Veach and Guibas 1995; Pharr, Jakob and Humphreys, PBRT 4th ed., 12.5",
}];

/// The map's size and the axis. The peaks: L cos t / pdf is at most 2 pi L, pi L and
/// L / pdf; one of a mixture grows with cos t.
fn prepare(s: &Setting) -> core::result::Result<Coefficients, usize> {
    let axis = within(s.values, 0, 0.0, 5.0)?;
    let map: &LightMap = s.map.ok_or(0usize)?;
    if axis.fract() != 0.0 {
        return Err(0);
    }
    let peak = match ESTIMATORS.get(s.estimator) {
        Some(&"uniform") => map.largest(|light, _| TAU * light),
        Some(&"cosine") => map.largest(|light, _| PI * light),
        Some(&"environment") => map.largest(|light, density| light / density),
        _ => map.largest(|light, density| 2.0 * light / (PI.recip() + density)),
    };
    let [width, height] = map.size();
    Ok(Coefficients::real(
        [width, height, axis as u32, 0],
        Vec::new(),
        peak,
    ))
}
