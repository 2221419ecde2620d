//! Whether device time grows as the words that are made do.

use super::fill::Fills;
use super::measure::{deviation, dispatched, median};
use crate::Result;
use crate::catalog::{Options, Request, Sequence};
use crate::kernels::Generator;
use crate::vulkan::Device;
use serde_json::{Value, json};
use std::ops::RangeInclusive;
use std::sync::Arc;

/// The numbers of words that `corput bench --scaling` measures, as powers of two.
pub const SIZES: RangeInclusive<u32> = 25..=32;

/// Times a word may take, over the least.
pub const MOST: f64 = 1.1;

/// Rounds of all sizes; the median of them is reported.
const ROUNDS: usize = 9;

/// The time of so many words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Words that are stored.
    pub words: u64,
    /// Median device seconds of all of them.
    pub median_s: f64,
    /// Median absolute deviation of that time.
    pub deviation_s: f64,
    /// Median seconds of a fill of as many bytes on all cores of the host, in memory that is used
    /// again as the device's buffer is.
    pub fill_s: f64,
}

impl Scale {
    /// Device time of a word in nanoseconds.
    #[must_use]
    pub fn word_ns(&self) -> f64 {
        self.median_s * 1e9 / self.words as f64
    }

    /// Times the fill.
    #[must_use]
    pub fn fills(&self) -> f64 {
        self.median_s / self.fill_s
    }
}

/// Measures 2^k words of two-dimensional Sobol points for each k, all by the kernel of the most
/// and into one buffer, which longer runs fill again and again.
///
/// # Errors
/// Those of the device, and of sizes that no request has: 2 to 33.
pub fn scaling(device: &Arc<Device>, sizes: RangeInclusive<u32>) -> Result<Vec<Scale>> {
    let points = |size: u32| 1u64.checked_shl(size.saturating_sub(1)).unwrap_or(u64::MAX);
    let mut options = Options::new(Sequence::Sobol, points(*sizes.end()));
    options.dimensions = Some(2);
    let mut generator = Generator::new(device, &Request::new(&options)?)?;
    // The pages of the buffer are touched, and all is compiled.
    generator.dispatch(0, generator.limit().min(points(*sizes.end())))?;
    let mut memory = Fills::new();
    let mut times = vec![(Vec::new(), Vec::new()); sizes.clone().count()];
    for _ in 0..ROUNDS {
        for (size, (times, fills)) in sizes.clone().zip(&mut times) {
            fills.push(memory.seconds(8 * points(size)));
            times.push(dispatched(&mut generator, points(size), u64::MAX)?);
        }
    }
    let scale = |(size, (times, fills)): (u32, &mut (Vec<f64>, Vec<f64>))| Scale {
        words: 2 * points(size),
        median_s: median(times),
        deviation_s: deviation(times),
        fill_s: median(fills),
    };
    Ok(sizes.zip(&mut times).map(scale).collect())
}

/// How many times as long a word takes where it takes longest.
#[must_use]
pub fn spread(scales: &[Scale]) -> f64 {
    let times = || scales.iter().map(Scale::word_ns);
    let least = times().fold(f64::INFINITY, f64::min);
    times().fold(0.0, f64::max) / least
}

/// The measured sizes as JSON.
#[must_use]
pub fn scaling_json(machine: &super::Machine, scales: &[Scale]) -> Value {
    let scale = |scale: &Scale| {
        json!({
            "words": scale.words,
            "median_s": scale.median_s,
            "deviation_s": scale.deviation_s,
            "word_ns": scale.word_ns(),
            "fill_s": scale.fill_s,
            "times_fill": scale.fills(),
        })
    };
    json!({
        "schema": "corput-scaling/1",
        "version": env!("CARGO_PKG_VERSION"),
        "device": machine.device,
        "command": machine.command,
        "sizes": scales.iter().map(scale).collect::<Vec<_>>(),
        "spread": spread(scales),
        "spread_at_most": MOST,
        "goal_reached": spread(scales) <= MOST,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spread_is_that_of_times_per_word() {
        let scale = |words, median_s| Scale {
            words,
            median_s,
            deviation_s: 0.0,
            fill_s: 0.25,
        };
        let linear = [scale(1 << 25, 0.5), scale(1 << 26, 1.0)];
        assert_eq!(spread(&linear), 1.0);
        assert_eq!(linear[1].fills(), 4.0);
        let grows = [
            scale(1 << 25, 0.5),
            scale(1 << 26, 1.5),
            scale(1 << 27, 2.0),
        ];
        assert_eq!(spread(&grows), 1.5);
    }
}
