//! Disks, the cosine-weighted hemisphere, and triangles of the plane.

use super::case::{Case, Measure, Reading, Source, Subject, Truth, ULP};
use super::elementary::unit;
use crate::catalog::{Map, Mapping};
use crate::reference::permute::permute_mix as mix;
use crate::reference::triangle::triangle_weights;
use crate::{Result, judge};
use glam::uvec2;
use std::f32::consts::FRAC_PI_4;

fn sample(map: &str, u: [u32; 2]) -> Result<Subject> {
    let mapping = Box::new(Mapping::with_values(Map::from_name(map)?, &[])?);
    Ok(Subject::Map { mapping, u })
}

pub(super) fn disks() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for u in [
        [u32::MAX, 1 << 31],
        [0, 1 << 31],
        [0xffff_ff00, 1 << 31],
        [1 << 31, 255],
    ] {
        let subject = sample("cosine-hemisphere", u)?;
        let [x, y]: [f32; 2] = subject.floats();
        let naive = (1.0 - x * x - y * y).max(0.0).sqrt();
        let [.., z] = judge::cosine_hemisphere(u);
        cases.push(Case::of(
            17,
            format!("cosine-hemisphere, u = {u:?} 2^-32, z"),
            &[naive.into()],
            Reading {
                first: 2,
                measure: Measure::Relative,
            },
            Truth {
                values: vec![z],
                source: Source::ClosedForm,
            },
            ULP,
            subject,
        ));
    }
    let (x, y) = (2.0 * unit(1 << 31) - 1.0, 2.0 * unit(1 << 31) - 1.0);
    let (s, c) = (FRAC_PI_4 * (y / x)).sin_cos();
    cases.push(Case::of(
        18,
        "concentric-disk, u = (1/2, 1/2)",
        &[(x * c).into(), (x * s).into()],
        Reading {
            first: 0,
            measure: Measure::Relative,
        },
        Truth {
            values: vec![0.0, 0.0],
            source: Source::ClosedForm,
        },
        0.0,
        sample("concentric-disk", [1 << 31, 1 << 31])?,
    ));
    Ok(cases)
}

/// Barycentric weights, which sum to 2^31.
pub(super) fn weights() -> Vec<Case> {
    let fractions = || (0..100_000u32).map(|i| [mix(2 * i), mix(2 * i + 1)]);
    let lost = |[x, y]: [u32; 2]| {
        let (root, y) = (unit(x).sqrt(), unit(y));
        let (b0, b1, b2) = (1.0 - root, root * (1.0 - y), root * y);
        f64::from((b0 + b1 + b2 - 1.0).abs())
    };
    let ours = |[x, y]: [u32; 2]| {
        let w = triangle_weights(uvec2(x, y));
        let sum = u64::from(w.x) + u64::from(w.y) + u64::from(w.z);
        sum.abs_diff(1 << 31) as f64 / 2_147_483_648.0
    };
    let sums = [
        fractions().map(lost).fold(0.0, f64::max),
        fractions().map(ours).fold(0.0, f64::max),
    ];
    // PBRT's map and repair in floats: b1 /= b1 + b2, b2 /= b1 + b2 uses the new b1.
    let (b1, b2) = (0.8f32, 0.4f32);
    let first = b1 / (b1 + b2);
    let second = b2 / (first + b2);
    let negative = (first + second - 1.0).max(0.0);
    // Weights of ours are unsigned, and none exceeds their sum.
    let more = |[x, y]: [u32; 2]| {
        let over = triangle_weights(uvec2(x, y)).max_element();
        f64::from(over.saturating_sub(1 << 31)) / 2_147_483_648.0
    };
    let beyond = fractions().map(more).fold(0.0, f64::max);
    vec![
        Case::host(
            22,
            "triangle, sum of weights less 1",
            sums,
            Source::Integers,
            0.0,
        ),
        Case::host(
            26,
            "triangle, b1 + b2 = 1.2, negative weight",
            [negative.into(), beyond],
            Source::Integers,
            0.0,
        ),
    ]
}
