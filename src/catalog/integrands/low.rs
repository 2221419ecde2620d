//! Integrands of one to three dimensions, and checkerboards.

use super::quadrature::tanh_sinh;
use super::{Coefficients, Integrand, Parameter, real_words, within};
use crate::interface::integrand;
use std::f64::consts::{FRAC_PI_4, LN_10, PI};

/// What these integrands have in common.
const BASE: Integrand = Integrand {
    name: "",
    id: 0,
    dimensions: (1, 1),
    default_dimensions: 1,
    parameters: &[],
    estimators: &[],
    needs_map: false,
    prepare: |_| Ok(Coefficients::exact(0, 1.0)),
    truth: |_| 0.0,
    error: 0.0,
    picture: None,
    finite_variance: true,
    examples: &[(&[], 1)],
    summary: "",
    formula: "",
    source: "",
};

const PI_4: f64 = PI * PI * PI * PI;

/// The integrands of this group.
pub(super) const INTEGRANDS: &[Integrand] = &[
    Integrand {
        name: "x-squared",
        id: integrand::X_SQUARED,
        prepare: |_| Ok(Coefficients::exact(64, 1.0)),
        truth: |_| 1.0 / 3.0,
        summary: "the square, exact in 64 bits",
        formula: "x^2",
        source: "the plainest integral of all",
        ..BASE
    },
    Integrand {
        name: "offset",
        id: integrand::OFFSET,
        parameters: &[Parameter {
            name: "offset",
            size: 1,
            default: Some(&[1e6]),
            domain: "it must be a whole number from 0 to 4294967295",
            summary: "what is added to x",
        }],
        prepare: |s| {
            let offset = within(s.values, 0, 0.0, u32::MAX.into())?;
            if offset.fract() != 0.0 {
                return Err(0);
            }
            let coefficients = Coefficients::exact(32, offset + 1.0);
            Ok(Coefficients {
                head: [offset as u32, 0, 0, 0],
                ..coefficients
            })
        },
        truth: |s| s.values[0] + 0.5,
        examples: &[(&[1e6], 1), (&[0.0], 1), (&[4_294_967_295.0], 1)],
        summary: "a mean of millions of standard deviations, exact in 64 bits",
        formula: "offset + x",
        source: "Chan, Golub and LeVeque 1983: where variances in floats fail",
        ..BASE
    },
    Integrand {
        name: "inverse-root",
        id: integrand::INVERSE_ROOT,
        // At x = 2^-33 it is 2^16.5.
        prepare: |_| {
            Ok(Coefficients::real(
                [0; 4],
                Vec::new(),
                92_681.900_023_683_16,
            ))
        },
        truth: |_| 2.0,
        error: 4e-9,
        finite_variance: false,
        summary: "a pole at 0, and no variance; x in the middle of its cell of 2^-32",
        formula: "1 / sqrt(x); over all cells the mean is 2 - 9.23e-6",
        source: "Owen 2006, Halton sequences avoid the origin",
        ..BASE
    },
    Integrand {
        name: "disk-step",
        id: integrand::DISK_STEP,
        dimensions: (2, 2),
        default_dimensions: 2,
        truth: |_| FRAC_PI_4,
        examples: &[(&[], 2)],
        summary: "a quarter of the unit disk, exact",
        formula: "1 where x^2 + y^2 < 1, else 0",
        source: "the usual estimate of pi",
        ..BASE
    },
    Integrand {
        name: "checkerboard",
        id: integrand::CHECKERBOARD,
        dimensions: (1, 64),
        default_dimensions: 2,
        parameters: &[Parameter {
            name: "cells",
            size: 1,
            default: Some(&[7.0]),
            domain: "it must be a whole number from 1 to 65536",
            summary: "cells along each axis",
        }],
        prepare: |s| {
            let cells = within(s.values, 0, 1.0, 65536.0)?;
            if cells.fract() != 0.0 {
                return Err(0);
            }
            let coefficients = Coefficients::exact(0, 1.0);
            Ok(Coefficients {
                head: [cells as u32, 0, 0, 0],
                ..coefficients
            })
        },
        truth: |s| checkerboard(s.values, s.dimensions),
        examples: &[(&[7.0], 2), (&[1.0], 1), (&[65536.0], 2), (&[3.0], 64)],
        summary: "a checkerboard, also of many dimensions, exact",
        formula: "1 where the sum of floor(cells x_j) is even, else 0",
        source: "the eye's favourite test of aliasing",
        ..BASE
    },
    Integrand {
        name: "oscillation",
        id: integrand::OSCILLATORY,
        dimensions: (1, 64),
        parameters: &[Parameter {
            name: "frequency",
            size: 1,
            default: Some(&[1024.0]),
            domain: "it must be a whole number from 1 to 16777216",
            summary: "periods along each axis",
        }],
        prepare: |s| {
            let frequency = within(s.values, 0, 1.0, 16_777_216.0)?;
            if frequency.fract() != 0.0 {
                return Err(0);
            }
            // Whole turns alone: of frequency x the fraction is exact.
            let columns = vec![[0, frequency as u32, 0, 0]; s.dimensions as usize];
            Ok(Coefficients::real([0; 4], columns, 1.0))
        },
        error: 2.5e-7,
        examples: &[
            (&[1024.0], 1),
            (&[1.0], 3),
            (&[16_777_216.0], 2),
            (&[4095.0], 64),
        ],
        summary: "a wave: points as many as its periods, evenly spaced, see 1",
        formula: "cos(2 pi frequency (sum of x_j))",
        source: "Nyquist 1928, Shannon 1949",
        ..BASE
    },
    Integrand {
        name: "square-of-sum",
        id: integrand::SQUARE_OF_SUM,
        dimensions: (1, 64),
        default_dimensions: 2,
        prepare: |s| {
            let d = f64::from(s.dimensions);
            Ok(Coefficients::real([0; 4], Vec::new(), d * d))
        },
        truth: |s| {
            let d = f64::from(s.dimensions);
            d / 12.0 + d * d / 4.0
        },
        error: 3.1e-8,
        examples: &[(&[], 2), (&[], 1), (&[], 7), (&[], 64)],
        summary: "smooth, of which nets err by little",
        formula: "(sum of x_j)^2",
        source: "Owen 1997, Scrambled net variance for integrals of smooth functions",
        ..BASE
    },
    Integrand {
        name: "ishigami",
        id: integrand::ISHIGAMI,
        dimensions: (3, 3),
        default_dimensions: 3,
        parameters: &[
            Parameter {
                name: "a",
                size: 1,
                default: Some(&[7.0]),
                domain: NOT_NEGATIVE,
                summary: "weight of the second variable",
            },
            Parameter {
                name: "b",
                size: 1,
                default: Some(&[0.1]),
                domain: NOT_NEGATIVE,
                summary: "weight of the third",
            },
        ],
        prepare: |s| {
            let a = within(s.values, 0, 0.0, 1000.0)?;
            let b = within(s.values, 1, 0.0, 1000.0)?;
            let [[a_m, a_e], [b_m, b_e]] = [real_words(a), real_words(b * PI_4)];
            let head = [a_m, a_e, b_m, b_e];
            Ok(Coefficients::real(head, Vec::new(), 1.0 + a + b * PI_4))
        },
        truth: |s| s.values[0] / 2.0,
        error: 1e-8,
        examples: &[(&[7.0, 0.1], 3), (&[0.0, 0.0], 3), (&[1000.0, 1000.0], 3)],
        summary: "three variables that act together",
        formula: "sin t_1 + a sin^2 t_2 + b t_3^4 sin t_1, t = pi (2 x - 1)",
        source: "Ishigami and Homma 1990",
        ..BASE
    },
    Integrand {
        name: "dynamic-range",
        id: integrand::CONTINUOUS,
        parameters: &[DECADES],
        prepare: |s| {
            let [m, e] = real_words(within(s.values, 0, 0.1, 18.0)? * LN_10);
            Ok(Coefficients::real([0; 4], vec![[m, e, 0, 0]], 1.0))
        },
        truth: |s| {
            let rate = s.values[0] * LN_10;
            -(-rate).exp_m1() / rate
        },
        error: 4e-9,
        examples: &[(&[18.0], 1), (&[0.1], 1)],
        summary: "values over many decades, of which floats lose most",
        formula: "10^(-decades x)",
        source: "the range between sunlight and starlight is about as wide",
        ..BASE
    },
    Integrand {
        name: "keister",
        id: integrand::KEISTER,
        dimensions: (1, 20),
        default_dimensions: 8,
        prepare: |s| {
            let whole = PI.powf(0.5 * f64::from(s.dimensions));
            let [m, e] = real_words(whole);
            Ok(Coefficients::real([m, e, 0, 0], Vec::new(), whole))
        },
        truth: |s| keister(s.dimensions),
        // 20 sums cut by 2^-30, under a root of up to 20.
        error: 2e-7,
        examples: &[(&[], 1), (&[], 2), (&[], 8), (&[], 20)],
        summary: "an oscillation over normal variables",
        formula: "pi^(d/2) cos(sqrt(sum of z_j^2 / 2)), z_j the normal quantile of x_j",
        source: "Keister 1996",
        ..BASE
    },
];

/// Decades that the integrand falls.
const DECADES: Parameter = Parameter {
    name: "decades",
    size: 1,
    default: Some(&[18.0]),
    domain: "it must be from 0.1 to 18",
    summary: "powers of ten from x = 0 to 1",
};

const NOT_NEGATIVE: &str = "it must be from 0 to 1000";

/// pi^(d/2) times the mean of cos r, for r of density proportional to r^(d-1) e^(-r^2).
fn keister(dimensions: u32) -> f64 {
    let d = f64::from(dimensions);
    // Its largest value is 1: what is 7 from there is below 2^-64 of it.
    let middle = (0.5 * (d - 1.0)).sqrt();
    let density = |r: f64| {
        let log = if d > 1.0 {
            (d - 1.0) * (r / middle).ln()
        } else {
            0.0
        };
        (log - (r - middle) * (r + middle)).exp()
    };
    let pieces = (0..=(middle + 7.0) as u32).map(f64::from);
    let integral =
        |f: &dyn Fn(f64) -> f64| -> f64 { pieces.clone().map(|r| tanh_sinh(f, r, r + 1.0)).sum() };
    PI.powf(0.5 * d) * integral(&|r| r.cos() * density(r)) / integral(&density)
}

/// Of an odd number k of cells one more is even than odd in each row: (1 + k^-d) / 2.
fn checkerboard(values: &[f64], dimensions: u32) -> f64 {
    if values[0] % 2.0 == 0.0 {
        return 0.5;
    }
    0.5 + 0.5 * values[0].powi(-(dimensions as i32))
}
