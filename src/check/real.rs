//! Reals: what a device must give, and how far each operation is from the truth.

use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_fraction, real_max, real_min,
    real_multiply, real_negate, real_shift, real_sqrt, real_square, real_subtract, real_uint,
};
use crate::reference::real_vector::{
    Real3, real3, real3_add, real3_cross, real3_floats, real3_normalize, real3_scale,
    real3_subtract,
};
use glam::vec3;

fn operand(m: u32, word: u32, base: i32) -> Real {
    let a = real_uint(m, base - (word & 63) as i32);
    if word & 64 == 0 { a } else { real_negate(a) }
}

fn operands(a: [u32; 4]) -> [Real; 2] {
    [operand(a[0], a[2], 0), operand(a[1], a[2] >> 8, 0)]
}

fn words(a: Real) -> [u32; 2] {
    [a.m, ((a.e as u32) << 1) | u32::from(a.negative)]
}

/// `evaluate_real.comp`, line by line; `None` for a name that it does not have.
pub fn reference(name: &str, a: [u32; 4]) -> Option<[u32; 4]> {
    let [p, q] = operands(a);
    let two = |x: Real, y: Real| {
        let ([a, b], [c, d]) = (words(x), words(y));
        [a, b, c, d]
    };
    Some(match name {
        "real_add" => two(real_add(p, q), real_subtract(p, q)),
        "real_multiply" => two(real_multiply(p, q), real_divide(p, q)),
        "real_sqrt" => two(real_sqrt(p), real_square(p)),
        "real_min" => two(real_min(p, q), real_max(p, q)),
        "real_float" => {
            let p = real_shift(p, (a[3] % 320) as i32 - 128);
            let [m, e] = words(real(f32::from_bits(a[3])));
            [real_float(p).to_bits(), real_fraction(p), m, e]
        }
        "real_vector" => {
            let float = |word: u32| f32::from_bits(word & 0xbfff_ffff);
            let v = real3(vec3(float(a[0]), float(a[1]), float(a[2])));
            let w = real3_cross(real3_add(v, Real3 { x: p, y: q, z: p }), v);
            let d = real3_floats(real3_normalize(real3_subtract(w, real3_scale(v, q))));
            [d.x.to_bits(), d.y.to_bits(), d.z.to_bits(), 0]
        }
        _ => return None,
    })
}

fn value([m, word]: [u32; 2]) -> f64 {
    let magnitude = f64::from(m) * f64::powi(2.0, (word as i32) >> 1);
    if word & 1 == 0 { magnitude } else { -magnitude }
}

/// The larger error of the two results, in units of 2^-30 of the truth.
pub fn error(name: &str, a: [u32; 4], got: [u32; 4]) -> Option<f64> {
    let [p, q] = operands(a).map(|x| value(words(x)));
    let truth = match name {
        "real_add" => [p + q, p - q],
        "real_multiply" if q == 0.0 && p != 0.0 => [0.0, f64::powi(2.0, 128).copysign(p)],
        "real_multiply" if q == 0.0 => [0.0, 0.0],
        "real_multiply" => [p * q, p / q],
        "real_sqrt" => [p.max(0.0).sqrt(), p * p],
        _ => return None,
    };
    let found = [value([got[0], got[1]]), value([got[2], got[3]])];
    let each = found.iter().zip(truth).map(|(&x, t)| {
        if x == t {
            0.0
        } else {
            (x / t - 1.0).abs() * f64::powi(2.0, 30)
        }
    });
    Some(each.fold(0.0, |a: f64, b| if a.is_nan() || a > b { a } else { b }))
}
