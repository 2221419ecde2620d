//! The integrands in `f64`, from their formulas.

use super::normal_quantile;
use std::f64::consts::{PI, TAU};

const UNIT: f64 = 1.0 / 4_294_967_296.0;

/// The integrand of this name at a point of fractions of 2^32; NaN for a name that is none.
///
/// # Panics
/// For fewer parameters or dimensions than the integrand has.
#[must_use]
pub fn integrand(name: &str, values: &[f64], point: &[u32]) -> f64 {
    let x: Vec<f64> = point.iter().map(|&u| f64::from(u) * UNIT).collect();
    let d = x.len() as f64;
    // Genz's coefficients: x, c and w of each dimension.
    let genz = x.iter().enumerate().map(|(j, &x)| {
        let c = values[0] * (2.0 * j as f64 + 1.0) / (d * d);
        (x, c, golden(j))
    });
    match name {
        "x-squared" => x[0] * x[0],
        "offset" => values[0] + x[0],
        "inverse-root" => 1.0 / ((f64::from(point[0]) + 0.5) * UNIT).sqrt(),
        "square-of-sum" => x.iter().sum::<f64>().powi(2),
        "disk-step" => {
            let [a, b] = [u128::from(point[0]), u128::from(point[1])];
            f64::from(u8::from(a * a + b * b < 1 << 64))
        }
        "checkerboard" => {
            let cell = |u: &u32| (u128::from(*u) * values[0] as u128) >> 32;
            f64::from(u8::from(point.iter().map(cell).sum::<u128>() % 2 == 0))
        }
        "ishigami" => {
            let t = [0, 1, 2].map(|j| PI * (2.0 * x[j] - 1.0));
            let rest = values[1] * t[2].powi(4) * t[0].sin();
            t[0].sin() + values[0] * t[1].sin().powi(2) + rest
        }
        "oscillation" => {
            let turns = |u: &u32| u128::from(*u) * values[0] as u128;
            let fraction = point.iter().map(turns).sum::<u128>() % (1 << 32);
            (TAU * fraction as f64 * UNIT).cos()
        }
        "genz-oscillatory" => (TAU * golden(0) + genz.map(|(x, c, _)| c * x).sum::<f64>()).cos(),
        "genz-product-peak" => {
            let factor = |(x, c, w): (f64, f64, f64)| 1.0 / (c.powi(-2) + (x - w).powi(2));
            genz.map(factor).product()
        }
        "genz-corner-peak" => (1.0 + genz.map(|(x, c, _)| c * x).sum::<f64>()).powf(-(d + 1.0)),
        "genz-gaussian" => {
            let term = |(x, c, w): (f64, f64, f64)| (c * (x - w)).powi(2);
            (-genz.map(term).sum::<f64>()).exp()
        }
        "genz-continuous" => {
            let term = |(x, c, w): (f64, f64, f64)| c * (x - w).abs();
            (-genz.map(term).sum::<f64>()).exp()
        }
        "genz-discontinuous" => {
            if genz.clone().take(2).any(|(x, _, w)| x > w) {
                return 0.0;
            }
            genz.map(|(x, c, _)| c * x).sum::<f64>().exp()
        }
        "gaussian-peak" => {
            // The centre is a fraction of 2^32 as well.
            let centre = (values[1] / UNIT).round() * UNIT;
            let term = |x: &f64| ((x - centre) / values[0]).powi(2);
            (-0.5 * x.iter().map(term).sum::<f64>()).exp()
        }
        "dynamic-range" => 10f64.powf(-values[0] * x[0]),
        "keister" => {
            let squares = point.iter().map(|&u| normal_quantile(u).powi(2));
            PI.powf(0.5 * d) * (0.5 * squares.sum::<f64>()).sqrt().cos()
        }
        "sobol-g" => {
            let factor = |(j, x): (usize, &f64)| {
                let a = values[0] * j as f64;
                ((4.0 * x - 2.0).abs() + a) / (1.0 + a)
            };
            x.iter().enumerate().map(factor).product()
        }
        "product" => {
            let factor = |(j, x): (usize, &f64)| {
                1.0 + values[0] * (j as f64 + 1.0).powf(-values[1]) * (x - 0.5)
            };
            x.iter().enumerate().map(factor).product()
        }
        _ => f64::NAN,
    }
}

/// The least and greatest of a Gaussian peak by points of its normal distribution: its
/// integral over all of space for those in the cube, 0 beyond, both at its faces.
#[must_use]
pub fn normal_peak(sigma: f64, centre: f64, point: &[u32]) -> [f64; 2] {
    let centre = (centre / UNIT).round() * UNIT;
    let place = |&u: &u32| centre + sigma * normal_quantile(u);
    // How far inside, of the coordinate that is the least so.
    let depth = |x: f64| x.min(1.0 - x);
    let least = point.iter().map(place).map(depth).fold(1.0, f64::min);
    let whole = (sigma * TAU.sqrt()).powi(point.len() as i32);
    // Coordinates have 29 bits or more.
    let near = (1.0 + sigma) / f64::from(1 << 29);
    match least {
        inside if inside > near => [whole; 2],
        outside if outside < -near => [0.0; 2],
        _ => [0.0, whole],
    }
}

/// frac((j + 1) g), for g the golden ratio's fraction cut to 32 bits.
fn golden(j: usize) -> f64 {
    ((j as f64 + 1.0) * (2_654_435_769.0 * UNIT)).fract()
}
