//! How fast a loop over a function is.

use super::subject::Kernel;
use crate::Result;
use crate::interface::REPEATS;
use crate::vulkan::{Access, Buffer, Device};
use std::sync::Arc;

/// Rounds; the median of them is reported. The loops take turns.
const ROUNDS: usize = 9;

/// Seconds that a dispatch is to take at least, so that its start does not count.
const LEAST: f64 = 0.02;

/// Invocations at most: 64 MiB of results.
const MOST: u32 = 1 << 22;

/// The speed of a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speed {
    /// Results of a dispatch.
    pub results: u64,
    /// Median seconds of a dispatch, by the device's clock where it has one.
    pub median_s: f64,
    /// Median absolute deviation of these seconds.
    pub deviation_s: f64,
    /// Whether the times are those of the device's clock, not of the host's.
    pub device_clock: bool,
}

impl Speed {
    /// Results per second.
    #[must_use]
    pub fn results_per_s(&self) -> f64 {
        self.results as f64 / self.median_s
    }

    /// The deviation as a share of the median.
    #[must_use]
    pub fn spread(&self) -> f64 {
        self.deviation_s / self.median_s
    }
}

/// A loop and as many invocations as take long enough.
struct Running<'a> {
    kernel: &'a Kernel,
    invocations: u32,
    seconds: Vec<f64>,
    device_clock: bool,
}

impl Running<'_> {
    fn time(&mut self, results: &Buffer) -> Result<f64> {
        let timing = self.kernel.repeat(results, self.invocations)?;
        self.device_clock = timing.device_ns.is_some();
        Ok(timing.device_ns.unwrap_or(timing.host_ns) * 1e-9)
    }

    fn speed(mut self) -> Speed {
        let median_s = median(&mut self.seconds);
        let mut away: Vec<f64> = self.seconds.iter().map(|s| (s - median_s).abs()).collect();
        Speed {
            results: u64::from(self.invocations) * u64::from(REPEATS),
            median_s,
            deviation_s: median(&mut away),
            device_clock: self.device_clock,
        }
    }
}

/// The speeds of loops, measured in turns.
///
/// # Errors
/// Those of the device.
pub(super) fn speeds<const N: usize>(
    device: &Arc<Device>,
    kernels: [&Kernel; N],
) -> Result<[Speed; N]> {
    let results = Buffer::new(device, 16 * u64::from(MOST), Access::DeviceOnly)?;
    let mut running = kernels.map(|kernel| Running {
        kernel,
        invocations: 1 << 10,
        seconds: Vec::new(),
        device_clock: false,
    });
    for one in &mut running {
        // The first dispatch compiles on some drivers.
        one.time(&results)?;
        // The faster of two, lest one that was held up ends the search.
        while one.invocations < MOST && one.time(&results)?.min(one.time(&results)?) < LEAST {
            one.invocations *= 2;
        }
    }
    for _ in 0..ROUNDS {
        for one in &mut running {
            let seconds = one.time(&results)?;
            one.seconds.push(seconds);
        }
    }
    Ok(running.map(Running::speed))
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
