//! Logarithmic axes.

use crate::plot::numbers::superscript;

/// A logarithmic axis: a range of log10 on a range of pixels.
pub struct Axis {
    pub low: f64,
    pub high: f64,
    pixels: [f64; 2],
    base: f64,
}

impl Axis {
    /// Covers the values; `whole` extends the range to whole powers of the base.
    pub fn new(
        values: impl Iterator<Item = f64>,
        base: f64,
        pixels: [f64; 2],
        whole: bool,
    ) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values.map(f64::log10) {
            (low, high) = (low.min(value), high.max(value));
        }
        let step = base.log10();
        if whole {
            (low, high) = ((low / step).floor() * step, (high / step).ceil() * step);
        }
        if high - low < step {
            (low, high) = (low - step / 2.0, high + step / 2.0);
        }
        // A little air, so that no marker lies on the frame.
        let air = if whole { 0.0 } else { 0.02 * (high - low) };
        Self {
            low: low - air,
            high: high + air,
            pixels,
            base,
        }
    }

    pub fn place_log(&self, log: f64) -> f64 {
        let part = (log - self.low) / (self.high - self.low);
        self.pixels[0] + part * (self.pixels[1] - self.pixels[0])
    }

    pub fn place(&self, value: f64) -> f64 {
        self.place_log(value.log10())
    }

    /// Pixels and labels of powers of the base, at least `apart` pixels from each other.
    pub fn ticks(&self, apart: f64) -> Vec<(f64, String)> {
        let step = self.base.log10();
        let pixels = (self.pixels[1] - self.pixels[0]).abs() * step / (self.high - self.low);
        let every = (apart / pixels).ceil().max(1.0);
        let first = (self.low / step / every - 1e-9).ceil() as i64;
        let last = (self.high / step / every + 1e-9).floor() as i64;
        (first..=last)
            .map(|i| {
                let exponent = i as f64 * every;
                let label = format!("{}{}", self.base, superscript(exponent as i64));
                (self.place_log(exponent * step), label)
            })
            .collect()
    }
}
