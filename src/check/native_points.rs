//! Kernels of the native profile that make samples of a map: judged, not compared.

use super::maps::{examples, truth};
use super::points::{Case, Maker, case, points, starts};
use super::rows::Row;
use crate::Result;
use crate::catalog::{Profile, Request, maps};
use crate::judge;
use crate::vulkan::Device;
use std::sync::Arc;

/// Maps with their pdf in the native profile, in the kernel of their points.
///
/// # Errors
/// None that these requests could cause.
pub fn native_cases() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for map in maps().filter(|map| map.group.fused()) {
        let Some(mapping) = examples(map)?.into_iter().next() else {
            continue;
        };
        cases.push(case(
            format!("native halton {} pdf", map.name),
            "fused",
            |o| {
                o.map = Some(mapping.clone());
                o.with_pdf = true;
                o.profile = Profile::Native;
            },
        )?);
    }
    Ok(cases)
}

/// Runs a case of the native profile, which the judge holds to `bound`.
pub fn check_native(device: &Arc<Device>, case: &Case, bound: f64) -> Result<Row> {
    let request = &case.request;
    let mut maker = Maker::new(device, case)?;
    let points = points(request);
    let width = request.words_per_point() as usize;
    let kernel = format!("{}_native", case.kernel);
    let mut row = Row::native(&case.name, &kernel, bound, "absolute");
    for start in starts(request.count, points) {
        let got = maker.words(start, points)?;
        row.hash(&got);
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
    let truth = request
        .map
        .as_ref()
        .and_then(|mapping| truth(mapping, [u[0], u[1], 0]));
    words
        .iter()
        .zip(truth.unwrap_or([f64::NAN; 4]))
        .map(|(&word, t)| (f64::from(f32::from_bits(word)) - t).abs())
        .fold(0.0, |a: f64, b| if a.is_nan() || a > b { a } else { b })
}
