//! Rows of the maps: what each map kernel does with points in memory, for every map with
//! all its example parameters, in both profiles.

mod environment;
mod truth;

use super::inputs::mix;
use super::rows::Row;
use crate::bulk::{map_invert, map_pdf, map_sample};
use crate::catalog::{Group, Map, Mapping, Profile};
use crate::interface::task;
use crate::judge::{ulp_above, ulp_error};
use crate::kernels::Mapper;
use crate::vulkan::Device;
use crate::{Error, Result};
use std::sync::Arc;
pub use truth::truth;

/// Random fractions for each set of parameters, besides the critical ones.
const RANDOM: u32 = 1 << 12;

/// Fractions where maps have their singular points, and beside them.
const CRITICAL: [u32; 13] = [
    0,
    1,
    2,
    255,
    256,
    0x3fff_ffff,
    0x4000_0000,
    0x7fff_ffff,
    0x8000_0000,
    0x8000_0001,
    0xc000_0000,
    0xffff_ff00,
    u32::MAX,
];

/// Coordinates that no sample has, which must do no harm.
const STRANGE: [f32; 9] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1e-40,
    1e-20,
    f32::MAX,
    f32::INFINITY,
    f32::NAN,
];

/// Fractions to sample: all pairs of critical ones, and random ones.
#[must_use]
pub fn fractions() -> Vec<[u32; 3]> {
    let mut list = Vec::new();
    for x in CRITICAL {
        for y in CRITICAL {
            list.push([x, y, mix(x ^ y.rotate_left(7))]);
        }
    }
    list.extend((0..RANDOM).map(|i| [mix(3 * i), mix(3 * i + 1), mix(3 * i + 2)]));
    list
}

/// Coordinates to find the pdf and the fractions of: samples, and strange ones.
fn samples(mapping: &Mapping) -> Vec<[u32; 3]> {
    let mut list: Vec<[u32; 3]> = fractions()
        .into_iter()
        .map(|u| {
            let [x, y, z, _] = map_sample(mapping, Profile::Exact, u);
            match mapping.map().coordinates {
                1 => [x, 0, 0],
                2 => [x, y, 0],
                _ => [x, y, z],
            }
        })
        .collect();
    for x in STRANGE {
        for y in STRANGE {
            list.extend(STRANGE.map(|z| [x, y, z].map(f32::to_bits)));
        }
    }
    list
}

/// The parameter sets of a map.
///
/// # Errors
/// None, if the catalogue's examples are in their domains.
pub fn examples(map: &'static Map) -> Result<Vec<Mapping>> {
    if map.group == Group::Environment {
        return environment::examples(map);
    }
    map.examples
        .iter()
        .map(|values| Mapping::with_values(map, values))
        .collect()
}

/// What of a map is checked: each task in the exact profile, and samples in the native one.
pub fn tasks(map: &'static Map) -> Result<Vec<(Profile, u32)>> {
    let prepared = examples(map)?.first().is_some_and(Mapping::is_prepared);
    let exact = [task::SAMPLE, task::PDF, task::INVERT].into_iter();
    let exact = exact.chain(prepared.then_some(task::PREPARE));
    let exact = exact.map(|task| (Profile::Exact, task));
    Ok(exact.chain([(Profile::Native, task::SAMPLE)]).collect())
}

/// One of these.
pub fn check(device: &Arc<Device>, map: &'static Map, profile: Profile, task: u32) -> Result<Row> {
    let mappings = examples(map)?;
    let first = mappings.first().ok_or_else(|| Error::Arguments {
        asked: format!("a check of {}", map.name),
        limit: "it has no example".into(),
        remedy: "give it one in the catalogue".into(),
    })?;
    let mut mapper = Mapper::new(device, first, true, profile, task)?;
    match profile {
        Profile::Exact => compare_map(&mut mapper, map, &mappings, task),
        Profile::Native => judge_native(&mut mapper, map, &mappings),
    }
}

/// Compares a task of a map in the exact profile with the reference, and its samples with
/// the judge, for these parameter sets.
///
/// # Errors
/// Those of the device.
pub fn compare_map(
    mapper: &mut Mapper,
    map: &'static Map,
    mappings: &[Mapping],
    task: u32,
) -> Result<Row> {
    let suffix = ["", " pdf", " invert", " prepare"][task.min(3) as usize];
    let mut row = Row::exact(
        &format!("{}{suffix}", map.name),
        map.group.kernel(Profile::Exact),
    );
    for mapping in mappings {
        mapper.set(mapping)?;
        match task {
            task::SAMPLE => sampled(mapper, mapping, &mut row)?,
            task::PDF => inverse(mapper, mapping, &mut row, |s| {
                vec![map_pdf(mapping, Profile::Exact, s)]
            })?,
            task::PREPARE => prepared(mapper, mapping, &mut row)?,
            _ => inverse(mapper, mapping, &mut row, |s| {
                let [x, y, z] = map_invert(mapping, Profile::Exact, s);
                vec![x, y, z, 0]
            })?,
        }
    }
    Ok(row.judged())
}

/// What a device prepares, against what the host does.
fn prepared(mapper: &Mapper, mapping: &Mapping, row: &mut Row) -> Result<()> {
    for expected in mapping.tables() {
        let got = mapper.prepare(expected.len())?;
        row.hash(&got);
        row.count(&got == expected, || {
            format!("{:?}: {got:08x?}, not {expected:08x?}", mapping.values())
        });
    }
    Ok(())
}

/// The words that a kernel gets for these fractions.
fn inputs(map: &Map, list: &[[u32; 3]]) -> Vec<u32> {
    let taken = list.iter().flat_map(|u| &u[..map.dimensions as usize]);
    taken.copied().collect()
}

fn sampled(mapper: &Mapper, mapping: &Mapping, row: &mut Row) -> Result<()> {
    let map = mapping.map();
    let list = fractions();
    let (words, _) = mapper.run(&inputs(map, &list))?;
    row.hash(&words);
    let width = map.coordinates as usize + 1;
    for (u, got) in list.into_iter().zip(words.chunks_exact(width)) {
        let mut u = u;
        u[map.dimensions as usize..].fill(0);
        let expected = map_sample(mapping, Profile::Exact, u);
        row.count(got == &expected[..width], || {
            format!(
                "{:?} {u:08x?}: {got:08x?}, not {expected:08x?}",
                mapping.values()
            )
        });
        let Some(truth) = truth(mapping, u) else {
            continue;
        };
        let (error, bound) = map_error(map, got, &truth);
        row.bound = Some(1.0);
        row.unit = "of bound";
        let ratio = error / bound;
        if row
            .worst
            .is_none_or(|worst| ratio > worst || ratio.is_nan())
        {
            row.worst = Some(ratio);
            if row.mismatches == Some(0) {
                row.witness = format!("{:?} {u:08x?}: {error} ULP", mapping.values());
            }
        }
    }
    Ok(())
}

/// The error in ULP of the word that is worst by its bound, and that bound, of the words of a
/// sample with its pdf against [`truth`](crate::check::truth).
#[must_use]
pub fn map_error(map: &Map, got: &[u32], truth: &[f64; 4]) -> (f64, f64) {
    let last = got.len().saturating_sub(1);
    let mut worst = (0.0, 1.0);
    for (i, (&word, &t)) in got.iter().zip(truth).enumerate() {
        let x = f32::from_bits(word);
        let (error, bound) = if i == last {
            (ulp_error(x, t), map.pdf_ulp)
        } else {
            (ulp_above(x, t, map.floor), map.ulp)
        };
        if error / bound > worst.0 / worst.1 || error.is_nan() {
            worst = (error, bound);
        }
    }
    worst
}

fn inverse(
    mapper: &Mapper,
    mapping: &Mapping,
    row: &mut Row,
    reference: impl Fn([u32; 3]) -> Vec<u32>,
) -> Result<()> {
    let list = samples(mapping);
    let rows: Vec<u32> = list.iter().flat_map(|&[x, y, z]| [x, y, z, 0]).collect();
    let (words, _) = mapper.run(&rows)?;
    row.hash(&words);
    let width = words.len() / list.len();
    for (s, got) in list.into_iter().zip(words.chunks_exact(width)) {
        let expected = reference(s);
        row.count(got == expected, || {
            format!(
                "{:?} {s:08x?}: {got:08x?}, not {expected:08x?}",
                mapping.values()
            )
        });
    }
    Ok(())
}

fn norm(coordinates: &[f64]) -> f64 {
    coordinates.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Holds the samples of a map in the native profile to its bounds, for these parameter
/// sets.
///
/// # Errors
/// Those of the device.
pub fn judge_native(mapper: &mut Mapper, map: &'static Map, mappings: &[Mapping]) -> Result<Row> {
    let kernel = map.group.kernel(Profile::Native);
    let mut row = Row::native(&format!("native {}", map.name), kernel, 1.0, "of bound");
    let list = fractions();
    let width = map.coordinates as usize + 1;
    for mapping in mappings {
        mapper.set(mapping)?;
        let (words, _) = mapper.run(&inputs(map, &list))?;
        row.hash(&words);
        for (&u, got) in list.iter().zip(words.chunks_exact(width)) {
            let mut u = u;
            u[map.dimensions as usize..].fill(0);
            let Some(truth) = truth(mapping, u) else {
                continue;
            };
            row.compared += 1;
            let scale = norm(&truth[..width - 1]).max(1.0);
            let mut ratio = 0.0;
            for (i, (&word, &t)) in got.iter().zip(&truth).enumerate() {
                let away = (f64::from(f32::from_bits(word)) - t).abs();
                let part = if i + 1 == width {
                    // Of a pdf of 0 nothing is asked: a device may round either way there.
                    if t == 0.0 {
                        0.0
                    } else {
                        away / t / map.native_pdf
                    }
                } else {
                    away / (map.native * scale)
                };
                if part > ratio || part.is_nan() {
                    ratio = part;
                }
            }
            if row
                .worst
                .is_some_and(|worst| ratio > worst || ratio.is_nan())
            {
                row.worst = Some(ratio);
                row.witness = format!("{:?} {u:08x?}: {got:08x?}", mapping.values());
            }
        }
    }
    Ok(row.judged())
}
