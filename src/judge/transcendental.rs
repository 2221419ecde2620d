//! Logarithms and exponentials in `f64`.

/// -ln(1 - u 2^-32).
#[must_use]
pub fn negative_log(u: u32) -> f64 {
    -(-f64::from(u) / 4_294_967_296.0).ln_1p()
}

/// ln x, without loss next to 1.
#[must_use]
pub fn log(x: f64) -> f64 {
    if (0.5..=2.0).contains(&x) {
        // x - 1 is exact.
        (x - 1.0).ln_1p()
    } else {
        x.ln()
    }
}

/// log2 x, without loss next to 1.
#[must_use]
pub fn log2(x: f64) -> f64 {
    if (0.5..=2.0).contains(&x) {
        (x - 1.0).ln_1p() / std::f64::consts::LN_2
    } else {
        x.log2()
    }
}
