//! Numbers of twice the precision of `f64`: sums of two of them.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of about 106 bits (Dekker 1971, A floating-point technique for extending the
/// available precision): enough to evaluate formulas of papers that cancel as they stand.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Wide {
    high: f64,
    low: f64,
}

/// a + b without error, for |a| >= |b| or a = 0.
fn fast_sum(a: f64, b: f64) -> Wide {
    let high = a + b;
    Wide {
        high,
        low: b - (high - a),
    }
}

/// a + b without error (Knuth).
fn exact_sum(a: f64, b: f64) -> Wide {
    let high = a + b;
    let part = high - a;
    Wide {
        high,
        low: (a - (high - part)) + (b - part),
    }
}

impl From<f64> for Wide {
    fn from(value: f64) -> Self {
        Self {
            high: value,
            low: 0.0,
        }
    }
}

impl From<f32> for Wide {
    fn from(value: f32) -> Self {
        f64::from(value).into()
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = exact_sum(self.high, other.high);
        let low = exact_sum(self.low, other.low);
        let sum = fast_sum(high.high, high.low + low.high);
        fast_sum(sum.high, sum.low + low.low)
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let error = self.high.mul_add(other.high, -high);
        fast_sum(
            high,
            error + (self.high * other.low + self.low * other.high),
        )
    }
}

impl Div for Wide {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other * first.into();
        let second = rest.high / other.high;
        let rest = rest - other * second.into();
        fast_sum(first, second) + (rest.high / other.high).into()
    }
}

impl Wide {
    /// The root; 0 for a negative number.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return 0.0.into();
        }
        let root = self.high.sqrt();
        let rest = self - Self::from(root) * root.into();
        fast_sum(root, rest.high / (2.0 * root))
    }

    /// The nearest `f64`.
    #[must_use]
    pub fn value(self) -> f64 {
        self.high
    }

    /// Pi.
    #[must_use]
    pub fn pi() -> Self {
        Self {
            high: std::f64::consts::PI,
            low: 1.224_646_799_147_353_2e-16,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Wide;

    /// 1 - (1 - 2^-60) and (sqrt 2)^2 - 2, which `f64` does not hold.
    #[test]
    fn twice_the_precision_is_kept() {
        let tiny = f64::powi(2.0, -60);
        let one = Wide::from(1.0);
        assert_eq!((one - (one - tiny.into())).value(), tiny);
        let two = Wide::from(2.0);
        assert!((two.sqrt() * two.sqrt() - two).value().abs() < 1e-31);
        let third = one / Wide::from(3.0);
        assert!((third * Wide::from(3.0) - one).value().abs() < 1e-31);
    }
}
