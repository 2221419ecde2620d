//! Exponentials and powers of the exact profile against `f64`, with worst errors.

use corput::judge::{self, ulp_error};
use corput::reference::exponential::*;
use corput::reference::permute::permute_mix as mix;
use corput::reference::real::*;

fn value(a: Real) -> f64 {
    let magnitude = f64::from(a.m) * f64::powi(2.0, a.e);
    if a.negative { -magnitude } else { magnitude }
}

/// The larger, or the NaN.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

fn relative(got: Real, truth: f64) -> f64 {
    assert!(got.m >> 31 == 1 || got == real_zero(), "{got:?}");
    (value(got) / truth - 1.0).abs()
}

/// Floats of either sign with |x| < 128, small ones as often as large ones.
fn floats() -> impl Iterator<Item = f32> {
    (0..1u32 << 22).map(|i| {
        let exponent = 134 - mix(i) % 36;
        f32::from_bits((mix(!i) & 0x807f_ffff) | (exponent << 23)) / 2.0
    })
}

#[test]
fn exponentials_of_floats_are_within_0_52_ulp() {
    let (mut ulp, mut reals, mut exp2m1) = ([0.0f64; 3], 0.0f64, 0.0f64);
    for x in floats() {
        let wide = f64::from(x);
        let flush = |truth: f64| {
            if truth < f64::from(f32::MIN_POSITIVE) {
                0.0
            } else {
                truth
            }
        };
        let errors = [
            (exp2(x), flush(wide.exp2())),
            (exp(x), flush(wide.exp())),
            (
                real_float(real_gaussian(real(x))),
                flush((-0.5 * wide * wide).exp()),
            ),
        ];
        for (worst, (got, truth)) in ulp.iter_mut().zip(errors) {
            if truth < f64::from(f32::MAX) {
                *worst = worse(*worst, ulp_error(got, truth));
            } else {
                assert_eq!(got, f32::MAX, "{x}");
            }
        }
        let x = real(x);
        reals = worse(reals, relative(real_exp(x), value(x).exp()));
        reals = worse(reals, relative(real_exp2(x), value(x).exp2()));
        exp2m1 = worse(
            exp2m1,
            relative(real_exp2m1(x), (value(x) * std::f64::consts::LN_2).exp_m1()),
        );
    }
    println!(
        "{ulp:.4?} ULP, 2^{:.2}, 2^{:.2}",
        reals.log2(),
        exp2m1.log2()
    );
    assert!(ulp.iter().all(|&e| e < 0.52), "{ulp:?}");
    assert!(reals < f64::powf(2.0, -29.5), "2^{:.2}", reals.log2());
    assert!(exp2m1 < f64::powi(2.0, -29), "2^{:.2}", exp2m1.log2());
}

#[test]
fn powers_are_within_their_bounds() {
    let (mut power, mut complement) = (0.0f64, 0.0f64);
    for i in 0..1u32 << 20 {
        // (1 - u)^(1/(n + 1)): the cosine of a lobe's angle.
        let u = mix(i) >> (mix(i ^ 0x55) % 32);
        let n = f64::from(mix(!i) % 1_000_001) as f32;
        let x = real_uint(0u32.wrapping_sub(u.max(1)), -32);
        let one = real(1.0);
        let y = real_divide(one, real_add(real(n), one));
        let exponent = value(y) * judge::log2(value(x));
        let truth = exponent.exp2();
        let bound = f64::powf(2.0, -29.5) + exponent.abs() * f64::powf(2.0, -29.7);
        power = worse(power, relative(real_power(x, y), truth) / bound);
        let truth = -(exponent * std::f64::consts::LN_2).exp_m1();
        complement = worse(complement, relative(real_power_complement(x, y), truth));
        // Large powers.
        let y = real(n.max(1.0) / 1000.0);
        let exponent = value(y) * judge::log2(value(x));
        if exponent > -900.0 {
            let bound = f64::powf(2.0, -29.5) + exponent.abs() * f64::powf(2.0, -29.7);
            power = worse(power, relative(real_power(x, y), exponent.exp2()) / bound);
        }
    }
    println!("{power} {:.2}", complement.log2());
    assert!(power < 1.0, "{power}");
    assert!(
        complement < f64::powi(2.0, -28),
        "2^{:.2}",
        complement.log2()
    );
}

#[test]
fn every_argument_gives_a_finite_number() {
    for x in [f32::INFINITY, f32::MAX, 1e5, f32::from_bits(0x7fc0_0000)] {
        assert_eq!(exp2(x), f32::MAX, "{x}");
        assert_eq!(exp(x), f32::MAX, "{x}");
        assert_eq!(exp2(-x).to_bits(), 0, "{x}");
        assert_eq!(exp(-x).to_bits(), 0, "{x}");
    }
    for x in [0.0, -0.0, f32::from_bits(1), 1e-38, -1e-38, 1e-12, -1e-12] {
        assert_eq!(exp2(x), 1.0, "{x}");
        assert_eq!(exp(x), 1.0, "{x}");
    }
    assert_eq!(exp2(127.0), f32::powi(2.0, 127));
    assert_eq!(exp2(128.0), f32::MAX);
    assert_eq!(exp2(-126.0), f32::MIN_POSITIVE);
    assert_eq!(exp2(-127.0).to_bits(), 0);
    assert_eq!(power(0.0, 2.5).to_bits(), 0);
    assert_eq!(power(0.0, 0.0), 1.0);
    assert_eq!(power(1.0, 1e30), 1.0);
    assert_eq!(power(2.0, 10.0), 1024.0);
    assert_eq!(real_exp2m1(real(-1e30)), real_negate(real(1.0)));
    assert_eq!(real_gaussian(real(f32::MAX)), real_zero());
    for r in [0, 1, 0x7fff_ffff, 0xffff_fffe, 0xffff_ffff] {
        assert!(exp2_polynomial(r) >= 2_977_044_472);
    }
}

#[test]
fn a_square_rounded_to_float_breaks_the_bound_of_the_gaussian() {
    let worst = floats()
        .filter(|x| x.abs() < 12.0)
        .map(|x| ulp_error(exp(-0.5 * x * x), (-0.5 * f64::from(x).powi(2)).exp()))
        .fold(0.0, f64::max);
    assert!(worst > 2.0, "{worst}");
}
