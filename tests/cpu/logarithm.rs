//! Logarithms of the exact profile against the judge, with worst errors.

use corput::judge::{self, ulp_error};
use corput::reference::logarithm::*;
use corput::reference::permute::permute_mix as mix;
use corput::reference::real::*;

/// What a result in reals may be off by, of itself.
const PROMISE: f64 = 1.0 / 759_250_124.0;

fn value(a: Real) -> f64 {
    let magnitude = f64::from(a.m) * f64::powi(2.0, a.e);
    if a.negative { -magnitude } else { magnitude }
}

/// The larger, or the NaN.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// |got / truth - 1|; 0 for two zeros.
fn relative(got: Real, truth: f64) -> f64 {
    if got == real_zero() && truth == 0.0 {
        return 0.0;
    }
    (value(got) / truth - 1.0).abs()
}

/// Fractions all over, and those next to 0, 1 and every power of two.
fn fractions() -> impl Iterator<Item = u32> {
    let near = (0..32u32).flat_map(|bit| {
        (0..64u32).flat_map(move |i| {
            let u = (1u32 << bit).wrapping_add(i.wrapping_sub(32));
            [u, 0u32.wrapping_sub(u)]
        })
    });
    (0..1u32 << 22).map(|i| i.wrapping_mul(1025)).chain(near)
}

/// Positive normal floats: of every exponent, and all of those next to 1.
fn floats() -> impl Iterator<Item = f32> {
    let all = (0..1u32 << 22).map(|i| f32::from_bits(0x0080_0000 + (mix(i) % 0x7f00_0000)));
    let near = (0..1u32 << 20).map(|i| f32::from_bits(0x3f80_0000 - (1 << 19) + i));
    all.chain(near)
}

#[test]
fn the_log_of_any_fraction_is_within_0_52_ulp() {
    let (mut ulp, mut real) = (0.0, 0.0);
    for u in fractions() {
        let truth = judge::negative_log(u);
        ulp = worse(ulp, ulp_error(negative_log(u), truth));
        real = worse(real, relative(real_negative_log(u), truth));
    }
    println!("{ulp:.4} ULP, 2^{:.2}", real.log2());
    assert!(ulp < 0.52, "{ulp}");
    assert!(real < PROMISE, "2^{:.2}", real.log2());
    assert_eq!(negative_log(0).to_bits(), 0);
    assert_eq!(negative_log(u32::MAX), 22.180_71);
}

#[test]
fn logs_of_floats_are_within_0_52_ulp() {
    let mut worst = [0.0f64; 4];
    for x in floats() {
        let wide = f64::from(x);
        let errors = [
            ulp_error(log(x), judge::log(wide)),
            ulp_error(log2(x), judge::log2(wide)),
            relative(real_log(real(x)), judge::log(wide)),
            relative(real_log2(real(x)), judge::log2(wide)),
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worse(*worst, error);
        }
    }
    println!(
        "{worst:?} 2^{:.2} 2^{:.2}",
        worst[2].log2(),
        worst[3].log2()
    );
    assert!(worst[0] < 0.52 && worst[1] < 0.52, "{worst:?}");
    assert!(worst[2] < PROMISE && worst[3] < PROMISE, "{worst:?}");
}

#[test]
fn logs_of_reals_use_all_32_bits() {
    for i in 0..1u32 << 20 {
        let x = real_uint(mix(i) | 0x8000_0000, (mix(!i) % 2048) as i32 - 1024);
        let truth = judge::log2(f64::from(x.m) / f64::powi(2.0, 31)) + f64::from(x.e + 31);
        let error = (value(real_log2(x)) - truth).abs();
        assert!(error <= truth.abs() * PROMISE, "{x:?}");
        // One unit off is seen, where the logarithm is small.
        let next = real_uint(0x8000_0001 + i, -31);
        let truth = judge::log(value(next));
        assert!(relative(real_log(next), truth) < PROMISE, "{next:?}");
    }
}

#[test]
fn powers_of_two_have_exact_logs_and_degenerate_arguments_finite_ones() {
    for e in -126..128 {
        assert_eq!(log2(f32::from_bits(((e + 127) as u32) << 23)), e as f32);
    }
    assert_eq!(log(1.0).to_bits(), 0);
    for x in [0.0, -0.0, -1.0, f32::from_bits(1), f32::NEG_INFINITY] {
        assert_eq!(log(x), f32::MIN, "{x}");
        assert_eq!(log2(x), f32::MIN, "{x}");
    }
    assert_eq!(log2(f32::INFINITY), 128.0);
    assert!(log2(f32::from_bits(0x7fc0_0000)).is_finite());
    // Beyond the domain the exponent saturates; nothing overflows.
    for e in [1 << 20, 1 << 28, -(1 << 28)] {
        assert!(real_float(real_log(real_uint(3, e))).is_finite());
    }
}

#[test]
fn a_polynomial_with_one_term_less_breaks_the_bound() {
    // The series itself, as far as the polynomial goes: the bound tells them apart.
    let series = |f: f64| (0..13).fold(0.0, |sum, k| sum + (-f).powi(k) / f64::from(k + 1));
    let worst = (0..1000)
        .map(|i| 0.2929 * f64::from(i + 1) / -1000.0)
        .map(|f| (series(f) / (judge::log(1.0 + f) / f) - 1.0).abs())
        .fold(0.0, f64::max);
    assert!(worst > PROMISE, "{worst:e}");
}
