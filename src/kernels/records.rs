//! What the kernels of estimates have in common: their records, and how much of a dispatch.

use crate::Result;
use crate::estimate::Estimate;
use crate::vulkan::{Buffer, Timing};

/// Points of the first dispatch: short on the slowest device.
pub(super) const FIRST: u64 = 1 << 14;

/// A dispatch should take about this long, and is made at most so many times longer at
/// once.
pub(super) const TARGET_NS: f64 = 1e8;
const GROWTH: f64 = 8.0;

/// Invocations that keep a GPU busy.
pub(super) const BUSY: u64 = 1 << 16;

/// Invocations that keep the cores of a CPU evenly busy.
pub(super) const BUSY_CPU: u64 = 1 << 10;

/// Bytes of an invocation's record.
pub(super) const RECORD: u64 = 48;

/// The sums of so many invocations, of terms in units of 2^-scale.
pub(super) fn read(results: &mut Buffer, invocations: u64, scale: i32) -> Result<Vec<Estimate>> {
    results.read(0, RECORD * invocations, |bytes| {
        let estimate = |[a, b, c, d, e, f, g, h, i, j, count, _]: [u32; WORDS]| {
            Estimate::from_words(count, scale, [a, b, c, d], [e, f, g, h, i, j])
        };
        records(bytes).map(estimate).collect()
    })
}

/// All of them together: of thousands, by sums of each word, which vectors make.
pub(super) fn total(results: &mut Buffer, invocations: u64, scale: i32) -> Result<Estimate> {
    let words = results.read(0, RECORD * invocations, |bytes| {
        let mut sums = [0u64; WORDS];
        for record in records(bytes) {
            for (sum, word) in sums.iter_mut().zip(record) {
                *sum += u64::from(word);
            }
        }
        sums
    })?;
    let [a, b, c, d, e, f, g, h, i, j, count, _] = words;
    let all = Estimate::from_word_sums(count, scale, [a, b, c, d], [e, f, g, h, i, j]);
    // A sum of too many terms is refused as a merge is.
    Estimate::new(scale).merged(all)
}

/// Words of a record, of which the last is none.
const WORDS: usize = RECORD as usize / 4;

fn records(bytes: &[u8]) -> impl Iterator<Item = [u32; WORDS]> {
    bytes
        .chunks_exact(RECORD as usize)
        .map(bytemuck::pod_read_unaligned)
}

/// Points of the next dispatch, after one of these took so long.
pub(super) fn next_chunk(points: u64, timing: &Timing, most: u64) -> u64 {
    let spent = timing.device_ns.unwrap_or(timing.host_ns).max(1.0);
    let ideal = points as f64 * (TARGET_NS / spent).min(GROWTH);
    (ideal as u64).clamp(1 << 10, most)
}
