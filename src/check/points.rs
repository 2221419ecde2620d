//! Kernels that make points: each against the reference, word for word.

use super::rows::{Row, Verdict};
use crate::Result;
use crate::bulk::Reference;
use crate::catalog::{Engine, MAPS, Options, Profile, Request, Sequence};
use crate::kernels::{Generator, Mapper};
use crate::vulkan::Device;
use std::sync::Arc;

/// A request and the kernel that is to run it.
pub struct Case {
    /// What the row is called.
    pub name: String,
    /// `generate`, `tile`, `fused` or `map`.
    pub kernel: &'static str,
    /// Requests over several ranges of indices.
    pub requests: Vec<Request>,
}

/// Points of a range.
const POINTS: u64 = 1 << 16;

/// Starts all over the index range.
const STARTS: [u64; 5] = [0, 1, (1 << 24) - 7, 3_486_784_401 - 40, (1 << 32) - POINTS];

fn case(name: String, kernel: &'static str, change: impl Fn(&mut Options)) -> Case {
    let requests = STARTS
        .iter()
        .filter_map(|&first| {
            let mut options = Options::new(Sequence::Halton, POINTS);
            options.first = first;
            change(&mut options);
            Request::new(&options).ok()
        })
        .collect();
    Case {
        name,
        kernel,
        requests,
    }
}

/// Every kernel with the columns, outputs and maps that it may have.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for kernel in ["generate", "tile"] {
        for fractions in [true, false] {
            let kind = if fractions { "u32" } else { "f32" };
            let columns =
                |name: &str, sequence, dimensions: Option<u64>, bases: Option<Vec<u64>>| {
                    case(format!("{name} {kind}"), kernel, move |o| {
                        o.sequence = sequence;
                        o.dimensions = dimensions;
                        o.bases.clone_from(&bases);
                        o.fractions = fractions;
                    })
                };
            cases.push(columns("vdc", Sequence::VanDerCorput, None, None));
            cases.push(columns(
                "vdc base 3",
                Sequence::VanDerCorput,
                None,
                Some(vec![3]),
            ));
            cases.push(columns("halton d=2", Sequence::Halton, Some(2), None));
            cases.push(columns("halton d=3", Sequence::Halton, Some(3), None));
            cases.push(columns("halton d=4", Sequence::Halton, Some(4), None));
            cases.push(columns(
                "halton 2,181,8161",
                Sequence::Halton,
                None,
                Some(vec![2, 179, 8161]),
            ));
            cases.push(columns(
                "hammersley d=2",
                Sequence::Hammersley,
                Some(2),
                None,
            ));
            cases.push(columns(
                "hammersley d=4",
                Sequence::Hammersley,
                Some(4),
                None,
            ));
            if kernel == "generate" {
                cases.push(columns("halton d=17", Sequence::Halton, Some(17), None));
            }
        }
    }
    cases.push(case("halton d=1024 f32".into(), "generate", |o| {
        o.dimensions = Some(1024);
        o.count = 64;
    }));
    for map in MAPS {
        for with_pdf in [false, true] {
            let pdf = if with_pdf { " pdf" } else { "" };
            for kernel in ["fused", "map"] {
                cases.push(case(
                    format!("halton {}{pdf}", map.name),
                    kernel,
                    move |o| {
                        o.map = Some(map);
                        o.with_pdf = with_pdf;
                    },
                ));
            }
        }
    }
    cases.push(case("hammersley cosine-hemisphere".into(), "fused", |o| {
        o.sequence = Sequence::Hammersley;
        o.map = MAPS.first();
    }));
    cases.push(case(
        "halton 5,8161 cosine-hemisphere".into(),
        "fused",
        |o| {
            o.bases = Some(vec![5, 8161]);
            o.map = MAPS.first();
        },
    ));
    cases
}

/// Runs a case.
pub fn check(device: &Arc<Device>, case: &Case) -> Result<Row> {
    compare_points(case, |request| words(device, case.kernel, request))
}

/// Compares the words that `make` gives for each request with the reference.
///
/// # Errors
/// Those of `make`.
pub fn compare_points(
    case: &Case,
    mut make: impl FnMut(&Request) -> Result<Vec<u32>>,
) -> Result<Row> {
    let mut row = Row {
        name: case.name.clone(),
        kernel: case.kernel.to_owned(),
        profile: "exact",
        tier: "I",
        compared: 0,
        mismatches: Some(0),
        worst: None,
        bound: None,
        unit: "",
        witness: String::new(),
        verdict: Verdict::Failed,
    };
    for request in &case.requests {
        let got = make(request)?;
        let width = request.words_per_point() as usize;
        let mut expected = vec![0; request.count as usize * width];
        Reference::new(request).fill(0, &mut expected);
        row.compared += request.count;
        let mut wrong = 0;
        for (i, (g, e)) in got.chunks(width).zip(expected.chunks(width)).enumerate() {
            if g != e {
                wrong += 1;
                if row.witness.is_empty() {
                    let n = request.first + i as u64;
                    row.witness = format!("point {n}: {g:08x?}, not {e:08x?}");
                }
            }
        }
        // Missing words are mismatches as well.
        wrong += (expected.len() - got.len().min(expected.len())) as u64;
        row.mismatches = row.mismatches.map(|count| count + wrong);
    }
    Ok(row.judged())
}

fn words(device: &Arc<Device>, kernel: &str, request: &Request) -> Result<Vec<u32>> {
    let collect = |engine: &mut dyn Engine| {
        let mut words = Vec::new();
        engine.make(0, request.count, &mut |part| {
            words.extend_from_slice(part);
            Ok(())
        })?;
        Ok(words)
    };
    match kernel {
        "generate" => collect(&mut Generator::general(device, request)?),
        "map" => mapped(device, request, collect),
        _ => collect(&mut Generator::new(device, request)?),
    }
}

/// The fractions of a request by one kernel, and its map over them by another.
fn mapped(
    device: &Arc<Device>,
    request: &Request,
    collect: impl Fn(&mut dyn Engine) -> Result<Vec<u32>>,
) -> Result<Vec<u32>> {
    let mut points = request.clone();
    points.map = None;
    points.with_pdf = false;
    points.output = crate::catalog::Output::Fractions;
    let fractions = collect(&mut Generator::new(device, &points)?)?;
    let pairs: Vec<[u32; 2]> = fractions.chunks_exact(2).map(|p| [p[0], p[1]]).collect();
    match request.map {
        Some(map) => Ok(Mapper::new(device, map, request.with_pdf, Profile::Exact)?
            .run(&pairs)?
            .0),
        None => Ok(fractions),
    }
}
