//! Truths with a bound of their own error, and what a float is against one.

use crate::judge;

/// The exact value of a result lies within `relative` of `value`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Truth {
    /// Near the exact value.
    pub value: f64,
    /// How near, relative to it: 0 where rounding `value` to 24 bits rounds the exact value.
    pub relative: f64,
}

/// Whether a result is the float nearest to the exact value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// It is.
    Correct,
    /// It is not.
    Other,
    /// The truth lies too near to the middle between two floats to say.
    Undecided,
}

impl Rounding {
    /// Of a result whose exact value lies within `away` of `value`.
    #[must_use]
    pub fn of(got: f32, value: f64, away: f64) -> Self {
        let (low, high) = (nearest(value - away), nearest(value + away));
        match got {
            got if got != low && got != high => Self::Other,
            _ if low == high => Self::Correct,
            _ => Self::Undecided,
        }
    }
}

/// Of one function of `f64`, from a good library, and few operations around it.
const LIBRARY: f64 = 1.0 / (1u64 << 50) as f64;

/// Of the normal quantile: the approximation of Wichura 1988 is good to 1e-16, and evaluated in
/// `f64` to 16 units.
const QUANTILE: f64 = 1.0 / (1u64 << 47) as f64;

/// The truths of a function's four words; `None` where a word is no float, or nothing is asked.
pub type Truths = fn([u32; 4]) -> [Option<Truth>; 4];

/// Those of a function of the catalogue by its name.
#[must_use]
pub fn truths(name: &str) -> Option<Truths> {
    Some(match name {
        "unit" => unit,
        "cos_sin" => cos_sin,
        "sqrt" => sqrt,
        "divide" => |a| quotient(a, |x, y| x / y),
        "multiply" => |a| quotient(a, |x, y| x * y),
        "negative_log" => |a| [near(judge::negative_log(a[0]), LIBRARY), None, None, None],
        "log" => log,
        "exp" => exp,
        "normal_quantile" => normal_quantile,
        "normal_tail" => |a| {
            let density = judge::normal_density(f64::from(moderate(a[1])));
            [None, None, near(density, LIBRARY), None]
        },
        "hemisphere_pdf" => hemisphere_pdf,
        _ => return None,
    })
}

impl Truth {
    /// What a float is against it: its error in ULP of the exact value, and its rounding.
    /// Results saturate at the largest float, and are 0 below the least normal one.
    #[must_use]
    pub fn judge(&self, got: f32) -> (f64, Rounding) {
        let away = match self.value.is_finite() {
            true => self.value.abs() * self.relative,
            false => 0.0,
        };
        let rounding = Rounding::of(got, self.value, away);
        let near = nearest(self.value);
        let saturated =
            near == 0.0 || near.abs() == f32::MAX && self.value.abs() > near.abs().into();
        let truth = if saturated {
            f64::from(near)
        } else {
            self.value
        };
        let error = (f64::from(got) - truth).abs() / ulp(truth);
        // A NaN must not pass unseen.
        (if error.is_nan() { f64::INFINITY } else { error }, rounding)
    }
}

/// A unit of the last place of the float that is not above |x|.
fn ulp(x: f64) -> f64 {
    let bits = x.abs().max(f64::from(f32::MIN_POSITIVE)).to_bits();
    f64::from_bits((bits & (0x7ff << 52)) - (23 << 52))
}

/// The nearest float of 24 bits: the largest beyond it, 0 below 2^-126.
fn nearest(x: f64) -> f32 {
    const UP: f64 = (1u64 << 63) as f64;
    let least = f64::from(f32::MIN_POSITIVE);
    // Where there are no 24 bits, rounded as if there were.
    let rounded = match x.abs() < least {
        true => f64::from((x * UP) as f32) / UP,
        false => x,
    };
    match rounded.abs() < least {
        true => 0.0,
        false => (rounded as f32).clamp(f32::MIN, f32::MAX),
    }
}

fn near(value: f64, relative: f64) -> Option<Truth> {
    (!value.is_nan()).then_some(Truth { value, relative })
}

/// Denormals as zeros: so the functions take them. `None` of infinities and NaN, about which
/// the twin alone speaks.
fn float(word: u32) -> Option<f64> {
    let x = f32::from_bits(word);
    if x.is_subnormal() {
        return Some(0.0);
    }
    x.is_finite().then_some(x.into())
}

/// A float between 2^-24 and 2^8 in magnitude, as `evaluate_elementary.comp` makes it.
fn moderate(word: u32) -> f32 {
    f32::from_bits((word & 0x807f_ffff) | ((103 + ((word >> 23) & 31)) << 23))
}

fn unit(a: [u32; 4]) -> [Option<Truth>; 4] {
    let up = (f64::from(a[0]) / 256.0).ceil().min(16_777_215.0);
    let [floor, ceil] = [f64::from(a[0] >> 8), up].map(|x| near(x / 16_777_216.0, 0.0));
    [floor, ceil, None, None]
}

fn cos_sin(a: [u32; 4]) -> [Option<Truth>; 4] {
    let (sin, cos) = judge::sin_cos(a[0]);
    [near(cos, LIBRARY), near(sin, LIBRARY), None, None]
}

/// A root in `f64` rounds to that of `f32`: 53 bits are more than twice 24 and two.
fn sqrt(a: [u32; 4]) -> [Option<Truth>; 4] {
    let x = float(a[0]).filter(|x| *x >= 0.0);
    [x.and_then(|x| near(x.sqrt(), 0.0)), None, None, None]
}

/// So does a quotient, and a product is exact.
fn quotient(a: [u32; 4], of: impl Fn(f64, f64) -> f64) -> [Option<Truth>; 4] {
    let value = float(a[0]).zip(float(a[1])).map(|(x, y)| of(x, y));
    let finite = value.filter(|value| value.abs() <= f64::from(f32::MAX));
    [finite.and_then(|x| near(x, 0.0)), None, None, None]
}

fn log(a: [u32; 4]) -> [Option<Truth>; 4] {
    let Some(x) = float(a[0]) else {
        return [None; 4];
    };
    if x <= 0.0 {
        let lowest = near(f64::from(f32::MIN), 0.0);
        return [lowest, lowest, None, None];
    }
    let [log, log2] = [judge::log(x), judge::log2(x)].map(|x| near(x, LIBRARY));
    [log, log2, None, None]
}

fn exp(a: [u32; 4]) -> [Option<Truth>; 4] {
    let y = f64::from(moderate(a[1]));
    [
        float(a[0]).and_then(|x| near(x.exp2(), LIBRARY)),
        near(y.exp2(), LIBRARY),
        near(y.exp(), LIBRARY),
        near((-0.5 * y * y).exp(), LIBRARY),
    ]
}

fn normal_quantile(a: [u32; 4]) -> [Option<Truth>; 4] {
    let z = judge::normal_quantile(a[0]);
    let erf = z * std::f64::consts::FRAC_1_SQRT_2;
    [near(z, QUANTILE), near(erf, QUANTILE), None, None]
}

/// Of z below 2^-124 nothing is left, and of what is no direction.
fn hemisphere_pdf(a: [u32; 4]) -> [Option<Truth>; 4] {
    let z = f64::from(f32::from_bits(a[0]));
    let over_pi = std::f64::consts::FRAC_1_PI;
    let direction = z.is_finite() && z >= f64::powi(2.0, -124);
    let cosine = if direction { z * over_pi } else { 0.0 };
    let uniform = if z >= 0.0 { 0.5 * over_pi } else { 0.0 };
    [near(cosine, LIBRARY), near(uniform, LIBRARY), None, None]
}

#[cfg(test)]
mod tests {
    use super::{Rounding, Truth, nearest};

    #[test]
    fn a_float_is_the_nearest_or_not_or_no_one_knows() {
        let third = Truth {
            value: 1.0 / 3.0,
            relative: 1e-15,
        };
        let (error, rounding) = third.judge(1.0 / 3.0);
        assert!(error < 0.5 && rounding == Rounding::Correct, "{error}");
        let (error, rounding) = third.judge((1.0f32 / 3.0).next_down());
        assert!((0.5..1.0).contains(&error) && rounding == Rounding::Other);
        assert_eq!(third.judge(f32::NAN), (f64::INFINITY, Rounding::Other));
        // The middle between two floats.
        let middle = Truth {
            value: 1.0 + f64::powi(2.0, -24),
            relative: 1e-15,
        };
        for got in [1.0, 1.0f32.next_up()] {
            assert_eq!(middle.judge(got), (0.5, Rounding::Undecided));
        }
        assert_eq!(middle.judge(1.0f32.next_down()).1, Rounding::Other);
    }

    #[test]
    fn results_saturate_and_have_no_denormals() {
        let least = f64::from(f32::MIN_POSITIVE);
        let below = |place| nearest(least * (1.0 - f64::powi(2.0, place)));
        assert_eq!([below(-26), below(-24)], [f32::MIN_POSITIVE, 0.0]);
        let huge = Truth {
            value: f64::INFINITY,
            relative: 1e-15,
        };
        assert_eq!(huge.judge(f32::MAX).1, Rounding::Correct);
        let tiny = Truth {
            value: 1e-40,
            relative: 1e-15,
        };
        assert_eq!(tiny.judge(0.0), (0.0, Rounding::Correct));
        assert!(tiny.judge(f32::MIN_POSITIVE).0 > 1e6);
    }
}
