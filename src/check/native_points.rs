//! Kernels of the native profile that make samples of a map: judged, not compared.

use super::points::{Case, Maker, case, points, starts};
use super::rows::{Row, Verdict};
use crate::Result;
use crate::catalog::{MAPS, Profile, Request};
use crate::interface::map;
use crate::judge;
use crate::vulkan::Device;
use std::sync::Arc;

/// Maps with their pdf in the native profile, by both kernels that have one.
///
/// # Errors
/// None that these requests could cause.
pub fn native_cases() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for map in MAPS {
        for kernel in ["fused", "map"] {
            cases.push(case(
                format!("native halton {} pdf", map.name),
                kernel,
                |o| {
                    o.map = Some(map);
                    o.with_pdf = true;
                    o.profile = Profile::Native;
                },
            )?);
        }
    }
    Ok(cases)
}

/// Runs a case of the native profile, which the judge holds to `bound`.
pub fn check_native(device: &Arc<Device>, case: &Case, bound: f64) -> Result<Row> {
    let request = &case.request;
    let mut maker = Maker::new(device, case)?;
    let points = points(request);
    let width = request.words_per_point() as usize;
    let mut row = Row {
        name: case.name.clone(),
        kernel: format!("{}_native", case.kernel),
        profile: "native",
        tier: "-",
        compared: 0,
        mismatches: None,
        worst: Some(0.0),
        bound: Some(bound),
        unit: "absolute",
        witness: String::new(),
        verdict: Verdict::Failed,
    };
    for start in starts(request.count, points) {
        let got = maker.words(start, points)?;
        row.compared += (got.len() / width) as u64;
        for (n, words) in (request.first + start..).zip(got.chunks_exact(width)) {
            let u = [2, 3].map(|base| judge::radical_inverse(n as u32, base) as u32);
            let error = native_error(request, u, words);
            if error.is_nan() || row.worst.is_some_and(|worst| error > worst) {
                row.worst = Some(error);
                row.witness = format!("point {n}: {words:08x?}");
            }
        }
    }
    Ok(row.judged())
}

/// The largest absolute error of coordinates and pdf.
fn native_error(request: &Request, u: [u32; 2], words: &[u32]) -> f64 {
    let over_pi = std::f64::consts::FRAC_1_PI;
    let planar = |p: [f64; 2]| vec![p[0], p[1], over_pi];
    let spatial = |d: [f64; 3], pdf: f64| vec![d[0], d[1], d[2], pdf];
    let lambert = |d: [f64; 3]| spatial(d, d[2] * over_pi);
    let truth = match request.map.map(|map| map.id) {
        Some(map::CONCENTRIC_DISK) => planar(judge::concentric_disk(u)),
        Some(map::POLAR_DISK) => planar(judge::polar_disk(u)),
        Some(map::UNIFORM_HEMISPHERE) => spatial(judge::uniform_hemisphere(u), 0.5 * over_pi),
        Some(map::COSINE_HEMISPHERE) => lambert(judge::cosine_hemisphere(u)),
        _ => lambert(judge::cosine_hemisphere_polar(u)),
    };
    words
        .iter()
        .zip(truth)
        .map(|(&word, t)| (f64::from(f32::from_bits(word)) - t).abs())
        .fold(0.0, |a: f64, b| if a.is_nan() || a > b { a } else { b })
}
