//! Chi-square tests at a level that holds for all tests of a family together.

#![allow(dead_code, reason = "each test uses a part of it")]

/// The chance of any false alarm in a family.
const FAMILY: f64 = 0.01;

/// The normal deviate that one of `tests` independent ones exceeds with a chance of
/// [`FAMILY`] in all (Sidak): the tail by its asymptotic series, good to 1% from 2.5 on.
pub fn critical(tests: usize) -> f64 {
    let level = 1.0 - (1.0 - FAMILY).powf(1.0 / tests as f64);
    let tail = |z: f64| {
        let density = (-0.5 * z * z).exp() / std::f64::consts::TAU.sqrt();
        density / z * (1.0 - z.powi(-2) + 3.0 * z.powi(-4))
    };
    let (mut low, mut high) = (2.0, 10.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if tail(middle) > level {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// The normal deviate of Pearson's statistic of counts against their expectation (Wilson and
/// Hilferty 1931).
pub fn deviate(counts: &[u32], expected: f64) -> f64 {
    let chi_square: f64 = counts
        .iter()
        .map(|&count| (f64::from(count) - expected).powi(2) / expected)
        .sum();
    pearson(chi_square, (counts.len() - 1) as f64)
}

/// The normal deviate of Pearson's statistic with so many degrees of freedom.
pub fn pearson(chi_square: f64, freedom: f64) -> f64 {
    let spread = 2.0 / (9.0 * freedom);
    ((chi_square / freedom).cbrt() - (1.0 - spread)) / spread.sqrt()
}
