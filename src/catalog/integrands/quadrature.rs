//! The double exponential rule (Takahasi and Mori 1974): analytic functions on an interval,
//! whatever happens at its ends.

use std::f64::consts::FRAC_PI_2;

/// Nodes for each unit of the transformed axis, and units to each side, beyond which a
/// weight is below 2^-53.
const STEPS: i32 = 16;
const REACH: i32 = 3;

/// The integral of f from a to b; f is not asked for its ends.
pub(super) fn tanh_sinh(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let half = 0.5 * (b - a);
    if half <= 0.0 {
        return 0.0;
    }
    let node = |k: i32| {
        let t = f64::from(k) / f64::from(STEPS);
        let s = FRAC_PI_2 * t.sinh();
        let weight = FRAC_PI_2 * t.cosh() / s.cosh().powi(2);
        // The distance to the nearer end, in units of half the interval, without cancellation.
        let end = (-s.abs()).exp() / s.cosh();
        let x = if s < 0.0 {
            a + half * end
        } else {
            b - half * end
        };
        match a < x && x < b {
            true => weight * f(x),
            false => 0.0,
        }
    };
    let sum: f64 = (-REACH * STEPS..=REACH * STEPS).map(node).sum();
    half * sum / f64::from(STEPS)
}
