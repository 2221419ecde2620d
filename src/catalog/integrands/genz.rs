//! Genz's families, a Gaussian peak and Sobol's g: products and sums over dimensions.
//!
//! Genz draws c_j at random and scales their sum to a difficulty; here c_j grows with j,
//! (2 j + 1) difficulty / d^2, and w_j = frac((j + 1) (sqrt(5) - 1) / 2) to 32 bits, for j
//! from 0 on, so that results can be compared. The default difficulties are his for d = 10.

use super::{Coefficients, Integrand, Parameter, Setting, real_words, unit, within};
use crate::interface::integrand;
use crate::judge::normal_mass;
use std::f64::consts::{PI, SQRT_2, TAU};

type Checked = core::result::Result<Coefficients, usize>;

const fn difficulty(default: &'static [f64]) -> Parameter {
    Parameter {
        name: "difficulty",
        size: 1,
        default: Some(default),
        domain: "it must be from 0.001 to 100, and so small for its dimensions that the mean is \
                 at least 2^-34 of the peak",
        summary: "sum of c_j",
    }
}

/// What these integrands have in common.
pub(super) const BASE: Integrand = Integrand {
    name: "",
    id: 0,
    dimensions: (1, 64),
    default_dimensions: 8,
    parameters: &[],
    estimators: &[],
    needs_map: false,
    prepare: |_| Err(0),
    truth: |_| 0.0,
    error: 2.5e-7,
    picture: None,
    finite_variance: true,
    examples: &[
        (&[0.001], 1),
        (&[100.0], 1),
        (&[2.0], 2),
        (&[9.0], 8),
        (&[1.0], 64),
    ],
    summary: "",
    formula: "",
    source: "Genz 1984",
};

/// The integrands of this group.
pub(super) const INTEGRANDS: &[Integrand] = &[
    Integrand {
        name: "genz-oscillatory",
        id: integrand::OSCILLATORY,
        parameters: &[difficulty(&[9.0])],
        prepare: |s| oscillatory(s.values, s.dimensions),
        truth: |s| {
            let rates = || rates(s.values[0], s.dimensions);
            let sum: f64 = rates().sum();
            let factors = rates().map(|c| (0.5 * c).sin() / (0.5 * c));
            (TAU * unit(place(0)) + 0.5 * sum).cos() * factors.product::<f64>()
        },
        summary: "smooth, oscillating",
        formula: "cos(2 pi w_0 + sum of c_j x_j)",
        ..BASE
    },
    Integrand {
        name: "genz-product-peak",
        id: integrand::PRODUCT_PEAK,
        parameters: &[difficulty(&[7.25])],
        prepare: |s| {
            let (values, d) = (s.values, s.dimensions);
            let h = within(values, 0, 0.001, 100.0)?;
            let peak = rates(h, d).map(|c| c * c).product();
            dominant(
                peaked(values, d, |c| 1.0 / (c * c), peak),
                product_peak(values, d),
            )
        },
        truth: |s| product_peak(s.values, s.dimensions),
        summary: "smooth, a peak in each coordinate",
        formula: "product of 1 / (c_j^-2 + (x_j - w_j)^2)",
        ..BASE
    },
    Integrand {
        name: "genz-corner-peak",
        id: integrand::CORNER_PEAK,
        parameters: &[difficulty(&[1.85])],
        prepare: |s| {
            let (values, d) = (s.values, s.dimensions);
            dominant(peaked(values, d, |c| c, 1.0), corner_peak(values, d))
        },
        truth: |s| corner_peak(s.values, s.dimensions),
        examples: &[
            (&[0.001], 1),
            (&[100.0], 1),
            (&[2.0], 4),
            (&[1.85], 8),
            (&[0.5], 64),
        ],
        summary: "smooth, a peak in the corner",
        formula: "(1 + sum of c_j x_j)^-(d+1)",
        ..BASE
    },
    Integrand {
        name: "genz-gaussian",
        id: integrand::GAUSSIAN,
        parameters: &[difficulty(&[7.03])],
        prepare: |s| {
            let (values, d) = (s.values, s.dimensions);
            dominant(peaked(values, d, |c| c, 1.0), gaussian(values, d))
        },
        truth: |s| gaussian(s.values, s.dimensions),
        summary: "smooth, a Gaussian",
        formula: "exp(-sum of c_j^2 (x_j - w_j)^2)",
        ..BASE
    },
    Integrand {
        name: "genz-continuous",
        id: integrand::CONTINUOUS,
        parameters: &[difficulty(&[20.4])],
        prepare: |s| {
            let (values, d) = (s.values, s.dimensions);
            dominant(peaked(values, d, |c| c, 1.0), continuous(values, d))
        },
        truth: |s| continuous(s.values, s.dimensions),
        summary: "continuous, with kinks",
        formula: "exp(-sum of c_j |x_j - w_j|)",
        ..BASE
    },
    Integrand {
        name: "genz-discontinuous",
        id: integrand::DISCONTINUOUS,
        parameters: &[difficulty(&[4.3])],
        prepare: |s| discontinuous_words(s.values, s.dimensions),
        truth: |s| discontinuous(s.values, s.dimensions),
        error: 2.5e-6,
        examples: &[
            (&[0.001], 1),
            (&[20.0], 1),
            (&[2.0], 3),
            (&[4.3], 8),
            (&[4.3], 64),
        ],
        summary: "discontinuous in the first two coordinates",
        formula: "0 where x_0 > w_0 or x_1 > w_1, else exp(sum of c_j x_j)",
        ..BASE
    },
    Integrand {
        name: "gaussian-peak",
        id: integrand::PEAK_UNIFORM,
        default_dimensions: 1,
        parameters: &[
            Parameter {
                name: "sigma",
                size: 1,
                default: Some(&[1e-3]),
                domain: "it must be from 1e-6 to 1, and so large for its dimensions that the \
                         mean is at least 2^-34 of the peak",
                summary: "standard deviation",
            },
            Parameter {
                name: "centre",
                size: 1,
                default: Some(&[0.381_966_011_250_105]),
                domain: "it must be from 0 to 0.999",
                summary: "its place along each axis",
            },
        ],
        estimators: &["uniform", "normal"],
        prepare: peak,
        truth: |s| gaussian_peak(s.values, s.dimensions),
        examples: &[
            (&[1e-3, 0.4], 1),
            (&[1e-6, 0.381_966_011_250_105], 1),
            (&[1e-6, 0.0], 1),
            (&[1.0, 0.999], 3),
            (&[0.3, 0.5], 16),
            (&[0.2, 0.5], 3),
        ],
        summary: "nearly a delta; normal: by points of its normal distribution",
        formula: "exp(-sum of (x_j - centre)^2 / (2 sigma^2))",
        source: "the usual trap of uniform sampling",
        ..BASE
    },
    Integrand {
        name: "sobol-g",
        id: integrand::SOBOL_G,
        dimensions: (1, 1024),
        parameters: &[Parameter {
            name: "growth",
            size: 1,
            default: Some(&[1.0]),
            domain: "it must be from 0.25 to 1000",
            summary: "a_j = growth j, j from 0 on: small where all variables matter",
        }],
        prepare: |s| sobol_g(s.values, s.dimensions),
        truth: |_| 1.0,
        // 1024 steps of three cuts by 2^-30 each.
        error: 3e-6,
        examples: &[
            (&[1.0], 8),
            (&[0.25], 64),
            (&[1000.0], 3),
            (&[1.0], 1),
            (&[1.0], 1000),
        ],
        summary: "kinks in the middle, and variables of declining weight",
        formula: "product of (|4 x_j - 2| + a_j) / (1 + a_j)",
        source: "Saltelli and Sobol 1995",
        ..BASE
    },
];

/// c_j.
fn rates(difficulty: f64, dimensions: u32) -> impl Iterator<Item = f64> + Clone {
    let d = f64::from(dimensions);
    (0..dimensions).map(move |j| difficulty * (2.0 * f64::from(j) + 1.0) / (d * d))
}

/// w_j, a fraction of 2^32.
fn place(j: u32) -> u32 {
    // (sqrt(5) - 1) / 2 * 2^32.
    (j + 1).wrapping_mul(0x9e37_79b9)
}

/// c_j and w_j of every dimension.
fn pairs(values: &[f64], dimensions: u32) -> impl Iterator<Item = (f64, f64)> {
    rates(values[0], dimensions).zip((0..).map(|j| unit(place(j))))
}

/// A real of each c_j, and w_j.
fn peaked(values: &[f64], dimensions: u32, of: fn(f64) -> f64, peak: f64) -> Checked {
    let h = within(values, 0, 0.001, 100.0)?;
    let column = |(c, j)| {
        let [m, e] = real_words(of(c));
        [m, e, place(j), 0]
    };
    let columns = rates(h, dimensions).zip(0..).map(column).collect();
    Ok(Coefficients::real([0; 4], columns, peak))
}

/// Refuses what would lose its mean below the unit of its terms.
pub(super) fn dominant(made: Checked, truth: f64) -> Checked {
    made.and_then(|made| made.resolves(truth).then_some(made).ok_or(0))
}

fn oscillatory(values: &[f64], dimensions: u32) -> Checked {
    let h = within(values, 0, 0.001, 100.0)?;
    let column = |c: f64| {
        let turns = (c / TAU * 4_294_967_296.0).round() as u64;
        [turns as u32, (turns >> 32) as u32, 0, 0]
    };
    let columns = rates(h, dimensions).map(column).collect();
    Ok(Coefficients::real([place(0), 0, 0, 0], columns, 1.0))
}

fn product_peak(values: &[f64], dimensions: u32) -> f64 {
    let factor = |(c, w): (f64, f64)| c * ((c * (1.0 - w)).atan() + (c * w).atan());
    pairs(values, dimensions).map(factor).product()
}

/// With (1 + s)^-(d+1) = 1/d! * integral of t^d e^(-t (1 + s)) dt, the integral over x is
/// 1/d! * integral of e^-t * product of (1 - e^(-c_j t)) / c_j dt, which has no
/// cancellation; in y = ln t the trapezoidal rule errs by e^(-pi^2 / step).
fn corner_peak(values: &[f64], dimensions: u32) -> f64 {
    const STEPS: i32 = 16;
    let factorial: f64 = (1..=dimensions).map(|k| f64::from(k).ln()).sum();
    let rates = rates(values[0], dimensions);
    let term = |step: i32| {
        let y = f64::from(step) / f64::from(STEPS);
        let t = y.exp();
        let logs = rates.clone().map(|c| (-(-c * t).exp_m1() / c).ln());
        (y - t - factorial + logs.sum::<f64>()).exp()
    };
    // Below, t^(d+1) is under 2^-57; above, e^-t.
    (-40 * STEPS..8 * STEPS).map(term).sum::<f64>() / f64::from(STEPS)
}

/// sqrt(pi) / 2 * (erf b - erf -a) / c.
fn bell(c: f64, a: f64, b: f64) -> f64 {
    let half_erf = |x: f64| normal_mass(SQRT_2 * x);
    PI.sqrt() * (half_erf(a) + half_erf(b)) / c
}

fn gaussian(values: &[f64], dimensions: u32) -> f64 {
    let factor = |(c, w): (f64, f64)| bell(c, c * w, c * (1.0 - w));
    pairs(values, dimensions).map(factor).product()
}

fn continuous(values: &[f64], dimensions: u32) -> f64 {
    let factor = |(c, w): (f64, f64)| (-(-c * w).exp_m1() - (-c * (1.0 - w)).exp_m1()) / c;
    pairs(values, dimensions).map(factor).product()
}

fn discontinuous_words(values: &[f64], dimensions: u32) -> Checked {
    let h = within(values, 0, 0.001, 100.0)?;
    let limits = (0..dimensions).map(|j| if j < 2 { unit(place(j)) } else { 1.0 });
    let largest: f64 = rates(h, dimensions).zip(limits).map(|(c, w)| c * w).sum();
    let mut made = peaked(values, dimensions, |c| c, largest.exp())?;
    for column in made.columns.iter_mut().skip(2) {
        // Nothing is beyond this.
        column[2] = u32::MAX;
    }
    dominant(Ok(made), discontinuous(values, dimensions))
}

fn discontinuous(values: &[f64], dimensions: u32) -> f64 {
    let factor = |(j, (c, w)): (usize, (f64, f64))| (c * if j < 2 { w } else { 1.0 }).exp_m1() / c;
    pairs(values, dimensions).enumerate().map(factor).product()
}

/// The centre, a fraction of 2^32.
fn centre(values: &[f64]) -> u32 {
    (values[1] * 4_294_967_296.0).round() as u32
}

fn gaussian_peak(values: &[f64], dimensions: u32) -> f64 {
    let c = values[0].recip() / SQRT_2;
    let w = unit(centre(values));
    bell(c, c * w, c * (1.0 - w)).powi(dimensions as i32)
}

/// By uniform points 1 / (sqrt(2) sigma) for each dimension; by its own, sigma, and first
/// of all the integral over all of space, which each point in the cube counts for.
fn peak(s: &Setting) -> Checked {
    let (values, d) = (s.values, s.dimensions);
    let sigma = within(values, 0, 1e-6, 1.0)?;
    within(values, 1, 0.0, 0.999)?;
    let made = |head, width: f64, peak| {
        let [m, e] = real_words(width);
        let columns = vec![[m, e, centre(values), 0]; d as usize];
        Coefficients::real(head, columns, peak)
    };
    let truth = gaussian_peak(values, d);
    let whole = (sigma * TAU.sqrt()).powi(d as i32);
    let [m, e] = real_words(whole);
    let made = match s.estimator {
        0 => made([0; 4], sigma.recip() / SQRT_2, 1.0),
        // Its 32 bits may have been rounded upwards.
        _ => made([m, e, 0, 0], sigma, whole * (1.0 + 1e-9)),
    };
    dominant(Ok(made), truth)
}

fn sobol_g(values: &[f64], dimensions: u32) -> Checked {
    let growth = within(values, 0, 0.25, 1000.0)?;
    let weights = (0..dimensions).map(|j| growth * f64::from(j));
    let column = |a: f64| {
        let [[m, e], [share_m, share_e]] = [real_words(a), real_words(1.0 / (1.0 + a))];
        [m, e, share_m, share_e]
    };
    let peak = weights.clone().map(|a| (2.0 + a) / (1.0 + a)).product();
    Ok(Coefficients::real(
        [0; 4],
        weights.map(column).collect(),
        peak,
    ))
}
