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
        records(bytes, scale).collect()
    })
}

/// All of them together.
pub(super) fn total(results: &mut Buffer, invocations: u64, scale: i32) -> Result<Estimate> {
    results.read(0, RECORD * invocations, |bytes| {
        records(bytes, scale).try_fold(Estimate::new(scale), Estimate::merged)
    })?
}

fn records(bytes: &[u8], scale: i32) -> impl Iterator<Item = Estimate> {
    bytes.chunks_exact(RECORD as usize).map(move |record| {
        let [a, b, c, d, e, f, g, h, i, j, count, _]: [u32; 12] =
            bytemuck::pod_read_unaligned(record);
        Estimate::from_words(count, scale, [a, b, c, d], [e, f, g, h, i, j])
    })
}

/// Points of the next dispatch, after one of these took so long.
pub(super) fn next_chunk(points: u64, timing: &Timing, most: u64) -> u64 {
    let spent = timing.device_ns.unwrap_or(timing.host_ns).max(1.0);
    let ideal = points as f64 * (TARGET_NS / spent).min(GROWTH);
    (ideal as u64).clamp(1 << 10, most)
}
