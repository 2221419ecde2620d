//! The rows of an equirectangular map on the sphere.

use std::f64::consts::PI;

/// 1 - z of every row's upper edge, and last of the lower pole, 2, in units of 2^-62:
/// `height + 1` of them.
///
/// 1 - cos t = 2 sin^2(t/2), so that the caps around the poles are exact to 2^-52 of
/// themselves; both halves are each other's mirror image to the last bit. Only + - * / of
/// f64 are used, which every platform rounds alike.
pub fn caps(height: u32) -> Vec<u64> {
    let cap = |row: u32| -> u64 {
        let sine = sine(PI * f64::from(row) / (2.0 * f64::from(height)));
        (2.0 * sine * sine * (1u64 << 62) as f64) as u64
    };
    (0..=height)
        .map(|row| match (2 * row).cmp(&height) {
            std::cmp::Ordering::Less => cap(row),
            std::cmp::Ordering::Equal => 1 << 62,
            std::cmp::Ordering::Greater => (1 << 63) - cap(height - row),
        })
        .collect()
}

/// The z of a cap's edge, correctly rounded.
pub fn edge(cap: u64) -> f32 {
    ((1i64 << 62) - cap as i64) as f32 / (1u64 << 62) as f32
}

/// sin x for 0 <= x <= pi/4, by its series.
fn sine(x: f64) -> f64 {
    let square = x * x;
    let mut sum = 0.0;
    for k in (1..=10).rev().map(f64::from) {
        sum = (1.0 + sum) * -square / ((2.0 * k) * (2.0 * k + 1.0));
    }
    x + x * sum
}
