//! Logarithmic axes, and what is straight on them.

use crate::plot::numbers::power;

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

    /// As `place`, but at the nearer end for what lies beyond.
    pub fn place_within(&self, value: f64) -> f64 {
        self.place_log(value.log10().clamp(self.low, self.high))
    }

    /// Whether a value lies on it.
    pub fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value.log10())
    }

    /// Pixels and labels of powers of the base, at least `apart` pixels from each other.
    pub fn ticks(&self, apart: f64) -> Vec<(f64, String)> {
        let tick = |exponent: i64| {
            let place = self.place_log(exponent as f64 * self.base.log10());
            (place, power(self.base as u32, exponent))
        };
        self.exponents(apart).into_iter().map(tick).collect()
    }

    /// The exponents of these powers.
    pub fn exponents(&self, apart: f64) -> Vec<i64> {
        let step = self.base.log10();
        let pixels = (self.pixels[1] - self.pixels[0]).abs() * step / (self.high - self.low);
        let every = (apart / pixels).ceil().max(1.0);
        let first = (self.low / step / every - 1e-9).ceil() as i64;
        let last = (self.high / step / every + 1e-9).floor() as i64;
        let exponent = |i: i64| (i as f64 * every) as i64;
        (first..=last).map(exponent).collect()
    }
}

/// The power law through a point, from there to where it leaves the axes.
pub fn guide(from: (f64, f64), exponent: f64, x: &Axis, y: &Axis) -> Option<[(f64, f64); 2]> {
    let (start, level) = (from.0.log10(), from.1.log10());
    let right = x.high;
    let mut run = right - start;
    let room = if exponent < 0.0 {
        y.low - level
    } else {
        y.high - level
    };
    if exponent != 0.0 {
        run = run.min(room / exponent);
    }
    let end = (start + run, level + exponent * run);
    (run > 0.0 && run.is_finite()).then(|| {
        [
            (x.place(from.0), y.place(from.1)),
            (x.place_log(end.0), y.place_log(end.1)),
        ]
    })
}
