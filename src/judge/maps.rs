//! Maps in `f64`, by the formulas of the papers rather than those of the shaders.

use std::f64::consts::FRAC_PI_4;

use super::functions::sin_cos;

fn unit(u: u32) -> f64 {
    f64::from(u) / 4_294_967_296.0
}

/// Shirley and Chiu's map of u in [0, 1)^2 to the unit disk.
#[must_use]
pub fn concentric_disk(u: [u32; 2]) -> [f64; 2] {
    let a = 2.0 * unit(u[0]) - 1.0;
    let b = 2.0 * unit(u[1]) - 1.0;
    if a == 0.0 && b == 0.0 {
        return [0.0, 0.0];
    }
    // sin near a multiple of pi/2 and cos near its odd ones would lose digits: take the
    // angle from the nearer axis.
    if a.abs() >= b.abs() {
        let phi = FRAC_PI_4 * (b / a);
        [a * phi.cos(), a * phi.sin()]
    } else {
        let phi = FRAC_PI_4 * (a / b);
        [b * phi.sin(), b * phi.cos()]
    }
}

/// r = sqrt(u0), phi = 2 pi u1.
#[must_use]
pub fn polar_disk(u: [u32; 2]) -> [f64; 2] {
    let radius = unit(u[0]).sqrt();
    let (s, c) = sin_cos(u[1]);
    [radius * c, radius * s]
}

/// z = u0, phi = 2 pi u1.
#[must_use]
pub fn uniform_hemisphere(u: [u32; 2]) -> [f64; 3] {
    let z = unit(u[0]);
    let radius = ((1.0 - z) * (1.0 + z)).sqrt();
    let (s, c) = sin_cos(u[1]);
    [radius * c, radius * s, z]
}

/// The concentric disk lifted to the hemisphere.
#[must_use]
pub fn cosine_hemisphere(u: [u32; 2]) -> [f64; 3] {
    let [x, y] = concentric_disk(u);
    let radius = (2.0 * unit(u[0]) - 1.0)
        .abs()
        .max((2.0 * unit(u[1]) - 1.0).abs());
    [x, y, ((1.0 - radius) * (1.0 + radius)).sqrt()]
}

/// The polar disk lifted to the hemisphere: z = sqrt(1 - u0).
#[must_use]
pub fn cosine_hemisphere_polar(u: [u32; 2]) -> [f64; 3] {
    let [x, y] = polar_disk(u);
    [x, y, (1.0 - unit(u[0])).sqrt()]
}

/// Duff's frame in `f64`: tangent and bitangent of a normal.
#[must_use]
pub fn frame(n: [f64; 3]) -> [[f64; 3]; 2] {
    let sign = 1f64.copysign(n[2]);
    let a = -1.0 / (sign + n[2]);
    let b = n[0] * n[1] * a;
    [
        [1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]],
        [b, sign + n[1] * n[1] * a, -n[1]],
    ]
}
