//! Logarithms, exponentials and the normal distribution: what a device must give, and how
//! far each is from the truth.

use crate::judge::{self, ulp_error};
use crate::reference::exponential::{exp, exp2, real_gaussian, real_power, real_power_complement};
use crate::reference::logarithm::{log, log2, negative_log, real_log, real_negative_log};
use crate::reference::normal_quantile::{
    inverse_erf, normal_fraction, normal_quantile, real_normal_density, real_normal_masses,
    real_normal_quantile,
};
use crate::reference::real::{Real, real, real_float, real_uint};

fn words(a: Real) -> [u32; 2] {
    [a.m, ((a.e as u32) << 1) | u32::from(a.negative)]
}

fn moderate(word: u32) -> f32 {
    f32::from_bits((word & 0x807f_ffff) | ((103 + ((word >> 23) & 31)) << 23))
}

/// Base and exponent of the power.
fn powered(a: [u32; 4]) -> [Real; 2] {
    [
        real_uint(a[0], -32),
        real(f32::from_bits(a[1] & 0x7fff_ffff)),
    ]
}

/// `evaluate_elementary.comp`, line by line; `None` for a name that it does not have.
pub fn reference(name: &str, a: [u32; 4]) -> Option<[u32; 4]> {
    let x = f32::from_bits(a[0]);
    let y = real(moderate(a[1]));
    Some(match name {
        "negative_log" => {
            let [m, e] = words(real_negative_log(a[0]));
            [negative_log(a[0]).to_bits(), m, e, 0]
        }
        "log" => {
            let [m, e] = words(real_log(real(x)));
            [log(x).to_bits(), log2(x).to_bits(), m, e]
        }
        "exp" => [
            exp2(x),
            exp2(moderate(a[1])),
            exp(moderate(a[1])),
            real_float(real_gaussian(y)),
        ]
        .map(f32::to_bits),
        "power" => {
            let [p, q] = powered(a);
            let [m, e] = words(real_power(p, q));
            let [n, f] = words(real_power_complement(p, q));
            [m, e, n, f]
        }
        "normal_quantile" => [
            normal_quantile(a[0]).to_bits(),
            inverse_erf(a[0]).to_bits(),
            normal_fraction(real_normal_quantile(a[0])),
            0,
        ],
        "normal_tail" => {
            let [m, e] = words(real_normal_masses(y).tail);
            let density = real_float(real_normal_density(y));
            [m, e, density.to_bits(), normal_fraction(real(x))]
        }
        _ => return None,
    })
}

fn value([m, word]: [u32; 2]) -> f64 {
    let magnitude = f64::from(m) * f64::powi(2.0, (word as i32) >> 1);
    if word & 1 == 0 { magnitude } else { -magnitude }
}

/// What a float result must be near to: no infinities, nothing below 2^-126.
fn saturated(truth: f64) -> f64 {
    if truth < f64::from(f32::MIN_POSITIVE) {
        0.0
    } else {
        truth.min(f64::from(f32::MAX))
    }
}

/// The worst error of the results, in the row's unit; `None` for a name that is not here.
pub fn error(name: &str, a: [u32; 4], got: [u32; 4]) -> Option<f64> {
    let float = |i: usize| f32::from_bits(got[i]);
    let wide = f64::from(moderate(a[1]));
    Some(match name {
        "negative_log" => ulp_error(float(0), judge::negative_log(a[0])),
        "log" => {
            let x = f32::from_bits(a[0]);
            if !x.is_finite() {
                return Some(0.0);
            }
            if x < f32::MIN_POSITIVE {
                let lowest = float(0) == f32::MIN && float(1) == f32::MIN;
                return Some(if lowest { 0.0 } else { f64::INFINITY });
            }
            let x = f64::from(x);
            worse(
                ulp_error(float(0), judge::log(x)),
                ulp_error(float(1), judge::log2(x)),
            )
        }
        "exp" => {
            let truth = [wide.exp2(), wide.exp(), (-0.5 * wide * wide).exp()];
            let each = truth.into_iter().enumerate();
            each.fold(0.0, |worst, (i, truth)| {
                worse(worst, ulp_error(float(i + 1), saturated(truth)))
            })
        }
        "power" => {
            let [p, q] = powered(a).map(|x| value(words(x)));
            let exponent = q * judge::log2(p);
            if p == 0.0 || exponent < -900.0 {
                return Some(0.0);
            }
            let bound = f64::powf(2.0, -29.5) + exponent.abs() * f64::powf(2.0, -29.7);
            let power = (value([got[0], got[1]]) / exponent.exp2() - 1.0).abs() / bound;
            let truth = -(exponent * std::f64::consts::LN_2).exp_m1();
            let complement = (value([got[2], got[3]]) / truth - 1.0).abs() * f64::powi(2.0, 28);
            // Exactly 0 for a power of 1, which the division cannot judge.
            worse(power, if truth == 0.0 { 0.0 } else { complement })
        }
        "normal_quantile" => {
            let truth = judge::normal_quantile(a[0]);
            let erf = truth * std::f64::consts::FRAC_1_SQRT_2;
            worse(ulp_error(float(0), truth), ulp_error(float(1), erf))
        }
        "normal_tail" => {
            let density = ulp_error(float(2), saturated(judge::normal_density(wide)));
            // Beyond 7 the tail is below the fractions.
            let tail = value([got[0], got[1]]) / judge::normal_tail(wide.abs()) - 1.0;
            let tail = tail.abs() * f64::powi(2.0, 26);
            worse(density, if wide.abs() < 7.0 { tail } else { 0.0 })
        }
        _ => return None,
    })
}

/// The larger, or the NaN.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
