//! Fractions near 1, logarithms, angles, powers and radical inverses.

use super::case::{Case, Measure, Reading, Source, Subject, Truth, ULP};
use crate::judge;
use crate::reference::exponential::{power, real_exp, real_power};
use crate::reference::real::{real, real_divide, real_float, real_multiply, real_uint};
use crate::reference::real_angle::angle;
use std::f32::consts::{LOG2_E, TAU};

const fn read(first: usize, measure: Measure) -> Reading {
    Reading { first, measure }
}

fn closed(values: &[f64]) -> Truth {
    Truth {
        values: values.to_vec(),
        source: Source::ClosedForm,
    }
}

fn exact(value: f64) -> Truth {
    Truth {
        values: vec![value],
        source: Source::Integers,
    }
}

/// A fraction of 2^32 by the common conversion.
pub(super) fn unit(u: u32) -> f32 {
    u as f32 * 2f32.powi(-32)
}

/// Indices, fractions and grids: integers, of which nothing may be lost.
pub(super) fn integers() -> Vec<Case> {
    let mut cases = Vec::new();
    for (k, count) in [
        (0u32, 1u64),
        (999_999, 1_000_003),
        (u32::MAX - 1, (1 << 32) - 1),
        (u32::MAX, 1 << 32),
    ] {
        let truth = judge::hammersley(k, count) as f64 / 4_294_967_296.0;
        cases.push(Case::of(
            2,
            format!("ceil(2^32 k / N), k = {k}, N = {count}"),
            &[(k as f32 / count as f32).into()],
            read(0, Measure::Fraction),
            exact(truth),
            0.0,
            Subject::Function {
                name: "hammersley",
                call: [k, count as u32, 0, 0],
            },
        ));
    }
    for u in [0xffff_ff80u32, u32::MAX, 0x0100_0001] {
        cases.push(Case::of(
            3,
            format!("float below 1 of u = {u} 2^-32"),
            &[unit(u).into()],
            read(0, Measure::Relative),
            exact(f64::from(u >> 8) / 16_777_216.0),
            0.0,
            Subject::Function {
                name: "unit",
                call: [u, 0, 0, 0],
            },
        ));
    }
    for (n, base) in [(u32::MAX, 3u32), (u32::MAX, 8161), (1_000_003, 7)] {
        let truth = judge::radical_inverse(n, base) as f64 / 4_294_967_296.0;
        cases.push(Case::of(
            4,
            format!("radical inverse of {n} in base {base}"),
            &[float_inverse(n, base).into()],
            read(0, Measure::Fraction),
            exact(truth),
            0.0,
            Subject::Function {
                name: "radical_inverse",
                call: [n, base, 0, 0],
            },
        ));
    }
    cases
}

/// Digits one after the other onto powers of 1 / base, in floats.
fn float_inverse(mut n: u32, base: u32) -> f32 {
    let inverse = 1.0 / base as f32;
    let (mut sum, mut scale) = (0.0, inverse);
    while n != 0 {
        sum += (n % base) as f32 * scale;
        scale *= inverse;
        n /= base;
    }
    sum
}

pub(super) fn logarithms() -> Vec<Case> {
    let inputs = [
        (12, 1u32),
        (12, 256),
        (12, 1 << 16),
        (12, 1 << 31),
        (13, u32::MAX),
        (13, !255),
    ];
    let case = |(number, u): (u32, u32)| {
        let truth = -(-f64::from(u) / 4_294_967_296.0).ln_1p();
        Case::of(
            number,
            format!("-ln(1 - u), u = {u} 2^-32"),
            &[(-(1.0 - unit(u)).ln()).into()],
            read(0, Measure::Relative),
            closed(&[truth]),
            ULP,
            Subject::Function {
                name: "negative_log",
                call: [u, 0, 0, 0],
            },
        )
    };
    inputs.map(case).into()
}

pub(super) fn angles() -> Vec<Case> {
    let turns = [
        1u32,
        0x4000_0001,
        0x3fff_ff00,
        0x8000_0001,
        0xc000_0100,
        u32::MAX,
    ];
    let turn = |u: u32| {
        let (s, c) = judge::sin_cos(u);
        let (sine, cosine) = (TAU * unit(u)).sin_cos();
        Case::of(
            14,
            format!("sin and cos(2 pi u), u = {u} 2^-32"),
            &[cosine.into(), sine.into()],
            read(0, Measure::Relative),
            closed(&[c, s]),
            ULP,
            Subject::Function {
                name: "cos_sin",
                call: [u, 0, 0, 0],
            },
        )
    };
    let between = |theta: f32| {
        let (x, z) = (theta.sin(), theta.cos());
        let truth = f64::from(x).atan2(f64::from(z));
        let turns = f64::from(real_float(angle(real(x), real(z))));
        let relative = |got: f64| Measure::Relative.error(&[got], &[truth]);
        let errors = [
            relative(z.acos().into()),
            relative(turns * std::f64::consts::TAU),
        ];
        let input = format!("angle of {theta:e} between unit vectors");
        Case::host(15, input, errors, Source::ClosedForm, ULP)
    };
    let mut cases: Vec<Case> = turns.map(turn).into();
    cases.extend([1e-2, 1e-3, 1e-4, 1e-6].map(between));
    cases
}

/// The word of which the kernel of `exp` makes this float, if there is one.
fn moderate(x: f32) -> Option<u32> {
    let exponent = (x.to_bits() >> 23) & 0xff;
    let field = exponent.checked_sub(103).filter(|&field| field < 32)?;
    Some((x.to_bits() & 0x807f_ffff) | (field << 23))
}

/// Geometric means of prices e^x, as of options on an average: the product leaves the range of
/// floats long before the mean does.
pub(super) fn geometric_means() -> Vec<Case> {
    let case = |(first, last, count): (f32, f32, u32)| {
        let step = (last - first) / (count - 1) as f32;
        let logs = move || (0..count).map(move |k| first + step * k as f32);
        let mean = logs().map(f64::from).sum::<f64>() / f64::from(count);
        let relative = |got: f32| Measure::Relative.error(&[got.into()], &[mean.exp()]);
        let naive = logs()
            .map(f32::exp)
            .product::<f32>()
            .powf(1.0 / count as f32);
        let one = real_uint(1, 0);
        let product = logs().fold(one, |product, x| real_multiply(product, real_exp(real(x))));
        let ours = real_power(product, real_divide(one, real_uint(count, 0)));
        Case::host(
            54,
            format!("geometric mean of {count} prices from e^{first} to e^{last}"),
            [relative(naive), relative(real_float(ours))],
            Source::ClosedForm,
            ULP,
        )
    };
    [(0.5, 4.5, 64), (-12.0, -8.0, 12), (-80.0, 80.0, 252)]
        .map(case)
        .into()
}

pub(super) fn powers() -> Vec<Case> {
    let power = |(x, y): (f32, f32)| {
        let truth = f64::from(x).powf(f64::from(y));
        let relative = |got: f32| Measure::Relative.error(&[got.into()], &[truth]);
        let errors = [relative((y * x.log2()).exp2()), relative(power(x, y))];
        Case::host(
            16,
            format!("{x}^{y}"),
            errors,
            Source::ClosedForm,
            2.0 * ULP,
        )
    };
    let exponential = |x: f32| {
        let truth = f64::from(x).exp();
        let naive = (x * LOG2_E).exp2();
        let input = format!("e^{x}");
        match moderate(x) {
            Some(word) => Case::of(
                16,
                input,
                &[naive.into()],
                read(2, Measure::Relative),
                closed(&[truth]),
                ULP,
                Subject::Function {
                    name: "exp",
                    call: [0, word, 0, 0],
                },
            ),
            None => {
                let relative = |got: f32| Measure::Relative.error(&[got.into()], &[truth]);
                let ours = crate::reference::exponential::exp(x);
                let errors = [relative(naive), relative(ours)];
                Case::host(16, input, errors, Source::ClosedForm, ULP)
            }
        }
    };
    let bases = [(0.999_999, 1e6), (0.5, 100.0), (0.999, 5e4), (1e-3, 12.0)];
    let mut cases: Vec<Case> = bases.map(power).into();
    cases.extend([80.0, -80.0, -1e-7, 1e-20].map(exponential));
    cases
}
