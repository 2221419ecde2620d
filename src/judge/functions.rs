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

/// The correctly rounded quotient; results below 2^-126 are zero.
#[must_use]
pub fn divide(x: f32, y: f32) -> f32 {
    without_denormals((f64::from(x) / f64::from(y)) as f32)
}

/// The correctly rounded product; results below 2^-126 are zero.
#[must_use]
pub fn multiply(x: f32, y: f32) -> f32 {
    without_denormals((f64::from(x) * f64::from(y)) as f32)
}

fn without_denormals(x: f32) -> f32 {
    if x.is_subnormal() {
        0f32.copysign(x)
    } else {
        x
    }
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

/// ceil(2^32 k / count).
#[must_use]
pub fn hammersley(k: u32, count: u64) -> u64 {
    (u128::from(k) << 32).div_ceil(u128::from(count)) as u64
}
