//! The real numbers of the exact profile against `f64`, which holds each operand exactly.

use corput::glam::uvec2;
use corput::reference::permute::permute_mix as mix;
use corput::reference::real::*;

/// Each operation is promised to be within this of itself.
const PROMISE: f64 = 1.0 / (1u64 << 30) as f64;

fn value(a: Real) -> f64 {
    let magnitude = f64::from(a.m) * f64::powi(2.0, a.e);
    if a.negative { -magnitude } else { magnitude }
}

/// Significands at the ends and in between, with exponents near each other and far.
fn operands() -> Vec<Real> {
    let mut list = vec![real_zero()];
    for (i, m) in [
        0x8000_0000u32,
        0x8000_0001,
        0xffff_ffff,
        0xffff_fffe,
        0xb504_f333,
        0xb504_f334,
        0xaaaa_aaaa,
    ]
    .into_iter()
    .chain((0..60).map(mix))
    .enumerate()
    {
        for e in [-32, -31, -33, -30, -64, 0, 1, -47] {
            list.push(Real {
                m: m | 0x8000_0000,
                e: e + (i as i32 % 3),
                negative: mix(m ^ e as u32) & 1 == 1,
            });
        }
    }
    list
}

fn within(got: Real, truth: f64, what: &str) {
    assert!(got.m >> 31 == 1 || got == real_zero(), "{what}: {got:?}");
    let error = (value(got) - truth).abs();
    assert!(
        error <= PROMISE * truth.abs(),
        "{what}: {got:?} is {}, not {truth}",
        value(got)
    );
}

#[test]
fn every_operation_keeps_its_promise() {
    let list = operands();
    for &a in &list {
        within(real_negate(a), -value(a), "negate");
        within(real_shift(a, -5), value(a) / 32.0, "shift");
        within(real_sqrt(a), value(a).max(0.0).sqrt(), "sqrt");
        for &b in &list {
            let (x, y) = (value(a), value(b));
            within(real_add(a, b), x + y, "add");
            within(real_subtract(a, b), x - y, "subtract");
            within(real_multiply(a, b), x * y, "multiply");
            if b.m != 0 {
                within(real_divide(a, b), x / y, "divide");
            }
            assert_eq!(real_less(a, b), x < y, "{a:?} < {b:?}");
            assert_eq!(value(real_min(a, b)), x.min(y));
            assert_eq!(value(real_max(a, b)), x.max(y));
        }
    }
}

#[test]
fn division_and_root_keep_it_over_many_significands() {
    let worst = (0..1u32 << 22)
        .map(|i| {
            let (a, b) = (mix(i) | 0x8000_0000, mix(!i) | 0x8000_0000);
            let (a, b) = (real_uint(a, 0), real_uint(b, (i % 2) as i32));
            let divided = value(real_divide(a, b)) / (value(a) / value(b)) - 1.0;
            let rooted = value(real_sqrt(b)) / value(b).sqrt() - 1.0;
            divided.abs().max(rooted.abs())
        })
        .fold(0.0, f64::max);
    // A truncated quotient or root is at most 2^-31 of itself too small, and a bit.
    assert!(worst < PROMISE, "{worst:e}");
    assert!(
        worst > PROMISE / 8.0,
        "{worst:e} is too good to be measured"
    );
}

#[test]
fn a_reciprocal_without_its_last_step_breaks_the_promise() {
    // The division less the residual's correction: the promise is not vacuous.
    let careless = |a: u32, b: u32| {
        let x = real_reciprocal(b);
        f64::from(((u64::from(a) * u64::from(x)) >> 32) as u32) / f64::powi(2.0, 31)
    };
    let worst = (0..1u32 << 16)
        .map(|i| {
            let (a, b) = (mix(i) | 0x8000_0000, mix(!i) | 0x8000_0000);
            (careless(a, b) / (f64::from(a) / f64::from(b)) - 1.0).abs()
        })
        .fold(0.0, f64::max);
    assert!(worst > PROMISE, "{worst:e}");
}

#[test]
fn conversions_are_exact_or_nearest() {
    for i in 0..1u32 << 20 {
        let x = f32::from_bits(mix(i));
        if x.is_normal() {
            assert_eq!(value(real(x)), f64::from(x));
            assert_eq!(real_float(real(x)).to_bits(), x.to_bits());
        }
        let a = real_uint(mix(i) | 1, -40);
        let truth = value(a) as f32;
        let tie = a.m & 0xff == 0x80;
        assert!(real_float(a) == truth || tie, "{a:?}");
    }
    assert_eq!(real(f32::from_bits(1)), real_zero());
    assert_eq!(real(-0.0), real_zero());
    assert_eq!(value(real(f32::INFINITY)), f64::powi(2.0, 128));
    assert!(value(real(f32::NAN)) >= f64::powi(2.0, 128));
    assert_eq!(real_float(real(f32::INFINITY)), f32::MAX);
    assert_eq!(real_float(real(f32::NEG_INFINITY)), f32::MIN);
    assert_eq!(real_float(real_uint(0xffff_ffff, 96)), f32::MAX);
    assert_eq!(real_float(real_uint(0x8000_0000, -157)), f32::MIN_POSITIVE);
    assert_eq!(real_float(real_uint(0xffff_ffff, -158)).to_bits(), 0);
    assert_eq!(real_float(real_negate(real_zero())).to_bits(), 0);
}

#[test]
fn fractions_are_floors_and_clamped() {
    assert_eq!(real_fraction(real(1.0)), u32::MAX);
    assert_eq!(real_fraction(real(-0.5)), 0);
    assert_eq!(real_fraction(real(0.5)), 1 << 31);
    assert_eq!(real_fraction(real(f32::MIN_POSITIVE)), 0);
    assert_eq!(real_fraction(real_uint(0xffff_ffff, -33)), 0x7fff_ffff);
    for u in [1, 2, 3, 0x8000_0000, u32::MAX, 12345] {
        assert_eq!(real_fraction(real_uint(u, -32)), u);
    }
    assert_eq!(real_wide(uvec2(0, 3), -64), real_uint(3, -32));
    assert_eq!(real_wide(uvec2(7, 0), 1), real_uint(7, 1));
}

#[test]
fn nothing_divided_by_zero_traps() {
    assert_eq!(real_divide(real_zero(), real_zero()), real_zero());
    assert_eq!(real_float(real_divide(real(-1.0), real_zero())), f32::MIN);
    assert_eq!(real_sqrt(real(-1.0)), real_zero());
}
