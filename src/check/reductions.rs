//! The kernel that sums floats: data that ruin sums in floats, in groups of all sizes and split
//! in several ways, have the bits of the CPU twin and of one long integer.

use super::inputs::mix;
use super::rows::{Row, words128};
use crate::Result;
use crate::bulk::reduce;
use crate::estimate::FloatSum;
use crate::judge::float_sum;
use crate::kernels::{Reducer, Split, largest_group};
use crate::vulkan::Device;
use std::sync::Arc;

/// Terms to sum.
#[derive(Clone, Copy, Debug)]
pub struct Reduction {
    /// What they are.
    pub name: &'static str,
    count: usize,
    term: fn(u32) -> f32,
}

/// Neither a power of two nor a multiple of a run.
const COUNT: usize = 20_011;

/// Every set of terms.
pub const REDUCTIONS: &[Reduction] = &[
    Reduction {
        name: "benign",
        count: COUNT,
        term: |i| (mix(i) >> 8) as f32 / 16_777_216.0,
    },
    // 1e30 + 1 - 1e30 + 1 ...: the sum is that of what floats lose.
    Reduction {
        name: "alternating 1e30",
        count: COUNT,
        term: |i| match i % 4 {
            0 => 1e30,
            2 => -1e30,
            _ => 1.0,
        },
    },
    Reduction {
        name: "denormals",
        count: COUNT,
        term: |i| f32::from_bits(mix(i) & 0x807f_ffff),
    },
    Reduction {
        name: "one huge among many tiny",
        count: COUNT,
        term: |i| match i {
            9_973 => f32::MAX,
            i => f32::from_bits(1 + i % 7),
        },
    },
    // Every bit of a significand, so that each place of a tally fills.
    Reduction {
        name: "equal terms",
        count: 1 << 20,
        term: |_| -1.999_999_9,
    },
    // Of every exponent and sign, the infinite among them.
    Reduction {
        name: "any bits",
        count: COUNT,
        term: |i| f32::from_bits(mix(i)),
    },
];

/// Invocations of a group that are tried, besides the most that the device runs. Every device has
/// six of them: Vulkan guarantees 128.
const GROUPS: [u32; 8] = [1, 7, 32, 64, 96, 128, 256, 512];

impl Reduction {
    /// The terms.
    #[must_use]
    pub fn terms(&self) -> Vec<f32> {
        (0..self.count as u32).map(self.term).collect()
    }

    /// Ways to split them: in one dispatch, and in several that end in the middle of a run.
    #[must_use]
    pub fn splits(&self) -> [Split; 3] {
        [
            (1 << 20, 256),
            (self.count / 3 + 1, 64),
            (self.count / 20 + 7, 1_000),
        ]
        .map(|(dispatch, run)| Split { dispatch, run })
    }
}

/// The row of a set of terms, in groups of all sizes that the device runs.
pub fn check(device: &Arc<Device>, reduction: &Reduction) -> Result<Row> {
    let largest = largest_group(device);
    let (runs, beyond): (Vec<u32>, Vec<u32>) = GROUPS.into_iter().partition(|g| *g <= largest);
    let mut sums = Vec::new();
    let whole = Some(largest).filter(|largest| !runs.contains(largest));
    for group in runs.into_iter().chain(whole) {
        sums.push(Reducer::with_group(device, group)?);
    }
    let mut row = compare_reduction(reduction, &mut |terms, split| {
        sums.iter().map(|one| one.reduce_in(terms, split)).collect()
    })?;
    if row.witness.is_empty() && !beyond.is_empty() {
        row.witness = format!("not in groups of {beyond:?}: this device runs {largest}");
    }
    Ok(row)
}

/// Sums of these terms, split like that.
pub type FloatSums<'a> = &'a mut dyn FnMut(&[f32], Split) -> Result<Vec<FloatSum>>;

/// Compares sums of the caller's with the twin's and with a long integer.
///
/// # Errors
/// Those of `sums`.
pub fn compare_reduction(reduction: &Reduction, sums: FloatSums) -> Result<Row> {
    let terms = reduction.terms();
    let twin = reduce(&terms)?;
    let finite: Vec<f32> = terms.iter().copied().filter(|x| x.is_finite()).collect();
    let truth = float_sum(&finite);
    let mut row = Row::exact(&format!("reduction {}", reduction.name), "reduce");
    for split in reduction.splits() {
        for (group, got) in sums(&terms, split)?.into_iter().enumerate() {
            // Of one group: how many a device runs must not show.
            let hashed = got.windows().iter().filter(|_| group == 0);
            hashed.for_each(|window| row.hash(&words128(window.sum() as u128)));
            let equal = got == twin && Some(got.words()) == truth;
            row.count(equal, || {
                format!(
                    "{split:?}: {:016x?}, not {:016x?} and {truth:016x?}",
                    got.words(),
                    twin.words()
                )
            });
        }
    }
    Ok(row.judged())
}
