//! Whether device time grows as the words that are made do.

use super::measure::{dispatched, median};
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
const ROUNDS: usize = 5;

/// The time of so many words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Words that are stored.
    pub words: u64,
    /// Median device seconds of all of them.
    pub median_s: f64,
}

impl Scale {
    /// Device time of a word in nanoseconds.
    #[must_use]
    pub fn word_ns(&self) -> f64 {
        self.median_s * 1e9 / self.words as f64
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
    let mut times = vec![Vec::new(); sizes.clone().count()];
    for _ in 0..ROUNDS {
        for (size, times) in sizes.clone().zip(&mut times) {
            times.push(dispatched(&mut generator, points(size), u64::MAX)?);
        }
    }
    let scale = |(size, times): (u32, &mut Vec<f64>)| Scale {
        words: 2 * points(size),
        median_s: median(times),
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
            "word_ns": scale.word_ns(),
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
        let scale = |words, median_s| Scale { words, median_s };
        let linear = [scale(1 << 25, 0.5), scale(1 << 26, 1.0)];
        assert_eq!(spread(&linear), 1.0);
        let grows = [
            scale(1 << 25, 0.5),
            scale(1 << 26, 1.5),
            scale(1 << 27, 2.0),
        ];
        assert_eq!(spread(&grows), 1.5);
    }
}
