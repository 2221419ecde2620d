//! Integrands as people write them, in float throughout.

use crate::judge::normal_quantile;
use std::f32::consts::{PI, TAU};

pub(super) fn inverse_root(x: f32) -> f32 {
    1.0 / x.sqrt()
}

pub(super) fn peak(x: f32, centre: f32, sigma: f32) -> f32 {
    let z = (x - centre) / sigma;
    (-0.5 * z * z).exp()
}

pub(super) fn cells(x: f32, cells: u32) -> f32 {
    let cell = (x * cells as f32) as u32;
    f32::from(cell.is_multiple_of(2))
}

pub(super) fn wave(x: f32, frequency: f32) -> f32 {
    (TAU * frequency * x).cos()
}

/// The quantile of a fraction of 2^32, of which 0 has none.
fn quantile(x: f32) -> f32 {
    match x {
        0.0 => f32::NEG_INFINITY,
        x => normal_quantile((f64::from(x) * 4_294_967_296.0) as u32) as f32,
    }
}

pub(super) fn keister(x: &[f32]) -> f32 {
    let squares: f32 = x.iter().map(|&x| quantile(x).powi(2)).sum();
    PI.powf(0.5 * x.len() as f32) * (0.5 * squares).sqrt().cos()
}

/// The mean of Ishigami's function with a = 7, b = 0.1, and its variance as the mean of squares
/// less the square of the mean.
pub(super) fn ishigami<E>(
    mean: impl Fn(&dyn Fn(&[f32]) -> f32) -> Result<f64, E>,
) -> Result<[f64; 2], E> {
    let f = |x: &[f32]| {
        let [x, y, z] = [0, 1, 2].map(|j| PI * (2.0 * x.get(j).copied().unwrap_or(0.0) - 1.0));
        x.sin() + 7.0 * y.sin().powi(2) + 0.1 * z.powi(4) * x.sin()
    };
    let first = mean(&f)?;
    let second = mean(&|x| f(x).powi(2))?;
    Ok([first, second - first * first])
}

pub(super) fn sobol_g(x: &[f32], growth: f32) -> f32 {
    let factor = |(j, x): (usize, &f32)| {
        let a = growth * j as f32;
        ((4.0 * x - 2.0).abs() + a) / (1.0 + a)
    };
    x.iter().enumerate().map(factor).product()
}

/// The product of 1 + (x_j - 1/2) / j^2, whose x repeat.
pub(super) fn product(x: &[f32], dimensions: usize) -> f32 {
    let factor = |(j, x): (usize, &f32)| 1.0 + (x - 0.5) / ((j + 1) * (j + 1)) as f32;
    x.iter()
        .cycle()
        .take(dimensions)
        .enumerate()
        .map(factor)
        .product()
}

/// c_j and w_j of Genz's families.
pub(super) struct Factors(Vec<[f32; 2]>);

impl Factors {
    pub(super) fn new(difficulty: f32, dimensions: u32) -> Self {
        let d = dimensions as f32;
        let pair = |j: u32| {
            let golden = (j + 1).wrapping_mul(0x9e37_79b9);
            let c = difficulty * (2 * j + 1) as f32 / (d * d);
            [c, golden as f32 / 4_294_967_296.0]
        };
        Self((0..dimensions).map(pair).collect())
    }

    /// A family at a point; NaN of a name that is none.
    pub(super) fn genz(&self, family: &str, x: &[f32]) -> f32 {
        let triples = || self.0.iter().zip(x).map(|(&[c, w], &x)| (c, w, x));
        let sum = |f: fn((f32, f32, f32)) -> f32| triples().map(f).sum::<f32>();
        let first = self.0.first().map_or(0.0, |&[_, w]| w);
        match family {
            "oscillatory" => (TAU * first + sum(|(c, _, x)| c * x)).cos(),
            "product-peak" => {
                let factor = |(c, w, x): (f32, f32, f32)| 1.0 / (1.0 / (c * c) + (x - w) * (x - w));
                triples().map(factor).product()
            }
            "corner-peak" => (1.0 + sum(|(c, _, x)| c * x)).powf(-(x.len() as f32 + 1.0)),
            "gaussian" => (-sum(|(c, w, x)| (c * (x - w)) * (c * (x - w)))).exp(),
            "continuous" => (-sum(|(c, w, x)| c * (x - w).abs())).exp(),
            "discontinuous" if triples().take(2).any(|(_, w, x)| x > w) => 0.0,
            "discontinuous" => sum(|(c, _, x)| c * x).exp(),
            _ => f32::NAN,
        }
    }
}
