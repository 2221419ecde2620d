//! Elementary functions and sequences, from their definitions.

use std::f64::consts::TAU;

/// (sin, cos) of 2 pi u 2^-32, with the quarter turns taken off exactly.
#[must_use]
pub fn sin_cos(u: u32) -> (f64, f64) {
    let mut rest = i64::from(u);
    let mut quarter = 0;
    while rest > 1 << 29 {
        rest -= 1 << 30;
        quarter += 1;
    }
    let (s, c) = (rest as f64 / 4_294_967_296.0 * TAU).sin_cos();
    match quarter % 4 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// The angle of (x, y) as a fraction of a turn in [0, 1).
#[must_use]
pub fn atan2_turns(y: f32, x: f32) -> f64 {
    let turns = f64::from(y).atan2(f64::from(x)) / TAU;
    if turns < 0.0 { turns + 1.0 } else { turns }
}

/// The correctly rounded root: `f64` holds more than twice the bits of `f32` plus two,
/// so rounding twice does no harm.
#[must_use]
pub fn sqrt(x: f32) -> f32 {
    f64::from(x).sqrt() as f32
}

/// The quotient rounded to 24 bits; below 2^-126 it is zero.
#[must_use]
pub fn divide(x: f32, y: f32) -> f32 {
    round(f64::from(x) / f64::from(y))
}

/// The product rounded to 24 bits; below 2^-126 it is zero.
#[must_use]
pub fn multiply(x: f32, y: f32) -> f32 {
    round(f64::from(x) * f64::from(y))
}

/// Rounds as if the exponent were unbounded below, then drops what is below 2^-126.
fn round(x: f64) -> f32 {
    let up = f64::powi(2.0, 100);
    if x.abs() < f64::from(f32::MIN_POSITIVE) {
        let rounded = f64::from((x * up) as f32) / up;
        if rounded.abs() < f64::from(f32::MIN_POSITIVE) {
            return 0f32.copysign(x as f32);
        }
        return rounded as f32;
    }
    x as f32
}

/// ceil(2^32 phi_b(n)) as a rational: reversed digits over b^m, in 128 bits.
#[must_use]
pub fn radical_inverse(n: u32, base: u32) -> u64 {
    let (mut reversed, mut scale, mut rest) = (0u128, 1u128, n);
    while rest != 0 {
        reversed = reversed * u128::from(base) + u128::from(rest % base);
        scale *= u128::from(base);
        rest /= base;
    }
    (reversed << 32).div_ceil(scale) as u64
}

/// Radical inverses of consecutive indices: the same rationals, over one denominator, by an
/// odometer of digits. A step takes a few additions.
#[derive(Clone, Debug)]
pub struct RadicalInverses {
    base: u32,
    /// The lowest first, with what each is worth when mirrored.
    digits: Vec<(u32, u64)>,
    reversed: u64,
    scale: u64,
}

impl RadicalInverses {
    /// From n on, in a base of 2 to 65535.
    #[must_use]
    pub fn new(n: u32, base: u32) -> Self {
        let (mut scale, mut length) = (1u64, 0);
        while scale < 1 << 32 {
            scale *= u64::from(base);
            length += 1;
        }
        let (mut rest, mut weight) = (n, scale);
        let digits = (0..length).map(|_| {
            weight /= u64::from(base);
            let digit = rest % base;
            rest /= base;
            (digit, weight)
        });
        let digits: Vec<(u32, u64)> = digits.collect();
        let reversed = digits.iter().map(|(d, w)| u64::from(*d) * w).sum();
        Self {
            base,
            digits,
            reversed,
            scale,
        }
    }

    /// Whether `got` is ceil(2^32 phi_b(n)).
    #[must_use]
    pub fn is(&self, got: u32) -> bool {
        let (truth, scale) = (u128::from(self.reversed) << 32, u128::from(self.scale));
        let most = u128::from(got) * scale;
        truth <= most && most < truth + scale
    }

    /// To the next index; after the last, to 0.
    pub fn step(&mut self) {
        for (digit, weight) in &mut self.digits {
            if *digit + 1 < self.base {
                *digit += 1;
                self.reversed += *weight;
                return;
            }
            self.reversed -= u64::from(*digit) * *weight;
            *digit = 0;
        }
    }
}

/// ceil(2^32 k / count).
#[must_use]
pub fn hammersley(k: u32, count: u64) -> u64 {
    (u128::from(k) << 32).div_ceil(u128::from(count)) as u64
}

/// Direction numbers by the recurrence on the odd integers m_i, as the papers have it:
/// m_i = 2 a_1 m_{i-1} ^ 2^2 a_2 m_{i-2} ^ ... ^ 2^s m_{i-s} ^ m_{i-s}, v_i = m_i / 2^i.
#[must_use]
pub fn sobol_directions(polynomial: u32, initial: &[u32]) -> [u32; 32] {
    let degree = initial.len();
    let mut m: Vec<u64> = initial.iter().map(|&m| u64::from(m)).collect();
    for i in degree..32 {
        let mut next = m[i - degree];
        for k in 1..=degree {
            let coefficient = u64::from(polynomial >> (degree - k) & 1);
            next ^= coefficient * (m[i - k] << k);
        }
        m.push(next);
    }
    std::array::from_fn(|i| (u128::from(m[i]) << 32 >> (i + 1)) as u32)
}

#[cfg(test)]
mod tests {
    use super::{RadicalInverses, radical_inverse};

    #[test]
    fn the_odometer_has_the_rationals() {
        for base in [2, 3, 5, 8161, 65_521] {
            for first in [0, 65_000, 4_163_763_246, u32::MAX - 999] {
                let mut inverses = RadicalInverses::new(first, base);
                for n in first..=first.saturating_add(999) {
                    let truth = radical_inverse(n, base) as u32;
                    assert!(inverses.is(truth), "{n} in base {base}");
                    assert!(!inverses.is(truth.wrapping_add(1)));
                    assert!(!inverses.is(truth.wrapping_sub(1)));
                    inverses.step();
                }
            }
        }
    }
}
