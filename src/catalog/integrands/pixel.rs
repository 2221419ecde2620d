//! An edge in a pixel, seen through its filter.

use super::scenes::{BASE, prepared};
use super::{Coefficients, Integrand, Parameter, Setting, within};
use crate::catalog::Words;
use crate::interface::integrand;
use crate::reference::real_vector::real3;
use glam::Vec3;

type Checked = core::result::Result<Coefficients, usize>;

/// The integrands of this group.
pub(super) const INTEGRANDS: &[Integrand] = &[Integrand {
    name: "pixel-edge",
    id: integrand::PIXEL_UNIFORM,
    parameters: &[
        Parameter {
            name: "angle",
            size: 1,
            default: Some(&[0.4]),
            domain: "it must be from 0 to 6.3",
            summary: "of the edge's normal to the x axis, in radians",
        },
        Parameter {
            name: "offset",
            size: 1,
            default: Some(&[0.3]),
            domain: "it must be from -65536 to 65536",
            summary: "distance of the edge from the pixel's centre, in pixels",
        },
        Parameter {
            name: "radius",
            size: 1,
            default: Some(&[1.0]),
            domain: "it must be from 0.25 to 16",
            summary: "of the filter, in pixels",
        },
    ],
    estimators: &["uniform", "filter"],
    prepare: pixel,
    truth: covered,
    picture: Some(|values, [x, y], _| {
        let (sine, cosine) = values[0].sin_cos();
        vec![values[0], values[1] - x * cosine - y * sine, values[2]]
    }),
    examples: &[
        (&[0.4, 0.3, 1.0], 2),
        (&[0.0, 0.0, 0.5], 2),
        (&[6.3, -1.2, 2.0], 2),
        (&[2.5, 65536.0, 16.0], 2),
    ],
    summary: "an edge in a pixel, through a tent filter",
    formula: "integral of (1 - |x|/r) (1 - |y|/r) / r^2 over the side x cos(angle) + y sin(angle) \
              < offset; uniform: points of the filter's square, filter: by the filter",
    source: "Ernst, Stamminger and Greiner 2006",
    ..BASE
}];

/// The edge's normal, and its distance from the middle in radii.
fn edge(values: &[f64]) -> Vec3 {
    let (sine, cosine) = values[0].sin_cos();
    Vec3::new(cosine as f32, sine as f32, (values[1] / values[2]) as f32)
}

fn pixel(s: &Setting) -> Checked {
    within(s.values, 0, 0.0, 6.3)?;
    within(s.values, 1, -65536.0, 65536.0)?;
    within(s.values, 2, 0.25, 16.0)?;
    let mut words = Vec::new();
    real3(edge(s.values)).put(&mut words);
    Ok(prepared(words, if s.estimator == 0 { 4.0 } else { 1.0 }))
}

/// Along the axis that the edge is closer to, the tent times the share of the other axis's
/// tent below the edge: a polynomial of degree 3 between the places where either bends, for
/// which two nodes of Gauss and Legendre are exact.
fn covered(s: &Setting) -> f64 {
    let edge = edge(s.values).as_dvec3();
    let (x, y) = (edge.x.abs(), edge.y.abs());
    let (along, across) = (x.min(y), x.max(y));
    let reach = |x: f64| (edge.z - x * along) / across;
    let below = |t: f64| match t.clamp(-1.0, 1.0) {
        t if t < 0.0 => 0.5 * (1.0 + t) * (1.0 + t),
        t => 1.0 - 0.5 * (1.0 - t) * (1.0 - t),
    };
    let mut bends = vec![-1.0, 0.0, 1.0];
    if along > 0.0 {
        let of = |t: f64| ((edge.z - t * across) / along).clamp(-1.0, 1.0);
        bends.extend([-1.0, 0.0, 1.0].map(of));
    }
    bends.sort_by(f64::total_cmp);
    let piece = |(from, to): (&f64, &f64)| {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let node = half / 3f64.sqrt();
        let at = |x: f64| (1.0 - x.abs()) * below(reach(x));
        half * (at(middle - node) + at(middle + node))
    };
    bends.iter().zip(bends.iter().skip(1)).map(piece).sum()
}
