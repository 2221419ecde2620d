//! The normal distribution in `f64`.

#![expect(clippy::excessive_precision, reason = "coefficients as published")]

use std::f64::consts::PI;

// Wichura 1988, AS 241, PPND16: numerators and denominators of the centre, the near tail and
// the far one, lowest coefficient first.
#[rustfmt::skip]
const A: [f64; 8] = [3.3871328727963666080, 1.3314166789178437745e2, 1.9715909503065514427e3, 1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4, 3.3430575583588128105e4, 2.5090809287301226727e3];
#[rustfmt::skip]
const B: [f64; 8] = [1.0, 4.2313330701600911252e1, 6.8718700749205790830e2, 5.3941960214247511077e3, 2.1213794301586595867e4, 3.9307895800092710610e4, 2.8729085735721942674e4, 5.2264952788528545610e3];
#[rustfmt::skip]
const C: [f64; 8] = [1.42343711074968357734, 4.63033784615654529590, 5.76949722146069140550, 3.64784832476320460504, 1.27045825245236838258, 2.41780725177450611770e-1, 2.27238449892691845833e-2, 7.74545014278341407640e-4];
#[rustfmt::skip]
const D: [f64; 8] = [1.0, 2.05319162663775882187, 1.67638483018380384940, 6.89767334985100004550e-1, 1.48103976427480074590e-1, 1.51986665636164571966e-2, 5.47593808499534494600e-4, 1.05075007164441684324e-9];
#[rustfmt::skip]
const E: [f64; 8] = [6.65790464350110377720, 5.46378491116411436990, 1.78482653991729133580, 2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3, 2.71155556874348757815e-5, 2.01033439929228813265e-7];
#[rustfmt::skip]
const F: [f64; 8] = [1.0, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2, 7.86869131145613259100e-4, 1.84631831751005468180e-5, 1.42151175831644588870e-7, 2.04426310338993978564e-15];

fn polynomial(coefficients: [f64; 8], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// z such that the normal distribution has mass (2 u + 1) / 2^33 below it.
#[must_use]
pub fn normal_quantile(u: u32) -> f64 {
    // Both exact.
    let centre = (f64::from(u) - 2_147_483_647.5) / 4_294_967_296.0;
    let tail = 0.5 - centre.abs();
    if centre.abs() <= 0.425 {
        let r = 0.180_625 - centre * centre;
        return centre * polynomial(A, r) / polynomial(B, r);
    }
    let r = (-tail.ln()).sqrt();
    let z = if r <= 5.0 {
        polynomial(C, r - 1.6) / polynomial(D, r - 1.6)
    } else {
        polynomial(E, r - 5.0) / polynomial(F, r - 5.0)
    };
    z.copysign(centre)
}

/// The density at z.
#[must_use]
pub fn normal_density(z: f64) -> f64 {
    (-0.5 * z * z).exp() / (2.0 * PI).sqrt()
}

/// The mass of the normal distribution from 0 to z >= 0: the series of Abramowitz and Stegun
/// 26.2.11 near 0, Laplace's continued fraction 26.2.14 from 2 on.
#[must_use]
pub fn normal_mass(z: f64) -> f64 {
    if z < 2.0 {
        let mut term = z;
        let mut sum = 0.0;
        for k in 1..60 {
            sum += term;
            term *= z * z / f64::from(2 * k + 1);
        }
        return normal_density(z) * sum;
    }
    0.5 - normal_tail(z)
}

/// The mass of the normal distribution above z >= 0.
#[must_use]
pub fn normal_tail(z: f64) -> f64 {
    if z < 2.0 {
        return 0.5 - normal_mass(z);
    }
    let fraction = (1..200)
        .rev()
        .fold(0.0, |rest, k| f64::from(k) / (z + rest));
    normal_density(z) / (z + fraction)
}
