//! Rows of maps: samples with their pdf.

use super::Subject;
use super::compare::{Watch, compare};
use super::fractions::{Fractions, Input};
use super::judge::Judge;
use super::row::{Figures, Row};
use super::truth::Rounding;
use crate::bulk::map_sample;
use crate::catalog::{Map, Mapping, Profile};
use crate::check::{map_error, truth};
use crate::interface::task;
use crate::kernels::Mapper;
use crate::vulkan::Device;
use crate::{Error, Result};
use std::sync::Arc;

/// What the judges of maps are taken to be within, relative to the truth, and to the map's
/// floor below that: 2^8 closer than half a unit of a float. They work in `f64` at least, and
/// some cancel.
const TRUSTED: f64 = 1.0 / (1u64 << 32) as f64;

/// Inputs of a dispatch at most.
const DISPATCH: u64 = 1 << 22;

/// The mapper of a map's row.
///
/// # Errors
/// Those of the device.
pub fn mapper(device: &Arc<Device>, fractions: &Fractions) -> Result<Mapper> {
    let first = fractions.mappings().next();
    let first = first.ok_or_else(|| no_input(fractions.map(), 0))?;
    Mapper::new(device, first, true, Profile::Exact, task::SAMPLE)
}

/// The row of a map over these inputs, by [`mapper`] or by one of the caller's, of samples with
/// their pdf in the exact profile. Inputs other than all are named in the row, which then has no
/// published hash.
///
/// # Errors
/// Those of the device, and those of `watch`.
pub fn compare_map(mapper: &mut Mapper, fractions: &Fractions, watch: Watch) -> Result<Row> {
    let map = fractions.map();
    let mut row = Row::new(&Subject::Map(map));
    if !fractions.is_whole() {
        row.inputs = format!("{} critical inputs", fractions.count());
    }
    let mut source = |start: u64, count: u64| {
        let width = map.coordinates as usize + 1;
        let mut results = Vec::with_capacity(count as usize * width);
        let (mut at, end) = (start, start + count);
        while at < end {
            let (first, run) = fractions.at(at).ok_or_else(|| no_input(map, at))?;
            let stop = run.min(end).min(at + DISPATCH);
            mapper.set(first.mapping)?;
            results.extend(mapper.run(&words(fractions, at..stop))?.0);
            at = stop;
        }
        Ok(results)
    };
    let judge = OfMap { fractions };
    compare(row, fractions.count(), &mut source, &judge, watch)
}

/// The words that the kernel gets for inputs.
fn words(fractions: &Fractions, inputs: std::ops::Range<u64>) -> Vec<u32> {
    let dimensions = fractions.map().dimensions as usize;
    let inputs = inputs.filter_map(|i| fractions.at(i));
    inputs
        .flat_map(|(input, _)| input.u.into_iter().take(dimensions))
        .collect()
}

fn no_input(map: &Map, i: u64) -> Error {
    Error::Arguments {
        asked: format!("input {i} of {}", map.name),
        limit: "its row has fewer".into(),
        remedy: "ask for those before".into(),
    }
}

/// A map over its inputs.
struct OfMap<'a> {
    fractions: &'a Fractions,
}

impl Judge for OfMap<'_> {
    fn width(&self) -> usize {
        self.fractions.map().coordinates as usize + 1
    }

    fn figures(&self, start: u64, results: &[u32]) -> Figures {
        let mut figures = Figures::default();
        for (i, got) in (start..).zip(results.chunks_exact(self.width())) {
            let Some((Input { mapping, u, judged }, _)) = self.fractions.at(i) else {
                continue;
            };
            let expected = map_sample(mapping, Profile::Exact, u);
            figures.compared += 1;
            if !expected.starts_with(got) {
                figures.differs(i, || {
                    let label = self.fractions.label(mapping);
                    format!("{label}{u:08x?}: {got:08x?}, not {expected:08x?}")
                });
            }
            if let Some(truth) = judged.then(|| truth(mapping, u)).flatten() {
                figures.judged += 1;
                let (error, bound) = map_error(mapping.map(), got, &truth);
                figures.error(i, error / bound, || {
                    let label = self.fractions.label(mapping);
                    format!("{label}{u:08x?}: {error:.4} ULP, at most {bound}")
                });
                rounded(&mut figures, mapping, got, &truth);
            }
        }
        figures
    }
}

/// Whether each word is the float nearest to the truth.
fn rounded(figures: &mut Figures, mapping: &Mapping, got: &[u32], truth: &[f64; 4]) {
    let last = got.len().saturating_sub(1);
    for (place, (&word, &truth)) in got.iter().zip(truth).enumerate() {
        // The errors of a pdf are relative everywhere.
        let floor = if place == last {
            0.0
        } else {
            mapping.map().floor
        };
        let away = truth.abs().max(floor) * TRUSTED;
        figures.rounded(Rounding::of(f32::from_bits(word), truth, away));
    }
}
