//! The normal distribution of the exact profile against the judge, with worst errors.

use corput::judge::{self, ulp_error};
use corput::reference::normal_quantile::*;
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

/// Fractions all over, next to every power of two, and at the seams of the polynomials.
fn fractions() -> impl Iterator<Item = u32> {
    let powers = (0..32).map(|bit| 1u32 << bit);
    // Half of 2^32 (1 - sqrt(1/2)), and 2^32 e^(-3.75^2 / 2).
    let seams = [628_983_898, 3_795_788];
    let near = powers.chain(seams).flat_map(|centre| {
        (0..512u32).flat_map(move |i| {
            let u = centre.wrapping_add(i.wrapping_sub(256));
            [u, !u]
        })
    });
    (0..1u32 << 22).map(|i| i.wrapping_mul(1025)).chain(near)
}

#[test]
fn quantiles_are_within_0_55_ulp_and_odd() {
    let (mut ulp, mut real, mut erf) = (0.0, 0.0, 0.0);
    for u in fractions() {
        let truth = judge::normal_quantile(u);
        let got = real_normal_quantile(u);
        ulp = worse(ulp, ulp_error(normal_quantile(u), truth));
        erf = worse(
            erf,
            ulp_error(inverse_erf(u), truth * std::f64::consts::FRAC_1_SQRT_2),
        );
        real = worse(real, (value(got) / truth - 1.0).abs());
        assert_eq!(real_normal_quantile(!u), real_negate(got), "{u:#x}");
        assert_eq!(got.m >> 31, 1, "{u:#x}");
    }
    println!("{ulp:.4} ULP, {erf:.4} ULP, 2^{:.2}", real.log2());
    assert!(ulp < 0.55 && erf < 0.55, "{ulp} {erf}");
    assert!(real < f64::powi(2.0, -28), "2^{:.2}", real.log2());
    assert_eq!(normal_quantile(0), -6.337_958);
    assert_eq!(normal_quantile(u32::MAX), 6.337_958);
}

/// The worst of all 2^32 words: an inverse error function so near the middle of two floats that
/// the other one is taken. By mpmath it is 0.54541677 of the way from one to the next.
#[test]
fn the_worst_word_is_within_the_promise() {
    let u = 0x00a2_e596;
    let truth = judge::normal_quantile(u) * std::f64::consts::FRAC_1_SQRT_2;
    let error = ulp_error(inverse_erf(u), truth);
    assert!((error - 0.545_416_77).abs() < 1e-6, "{error}");
}

#[test]
fn quantiles_rise() {
    let mut last = f32::NEG_INFINITY;
    for u in (0..1u32 << 22).map(|i| i << 10 | (i & 0x3ff)) {
        let z = normal_quantile(u);
        assert!(z >= last, "{u:#x}");
        last = z;
    }
    // One by one across the seams.
    for seam in [628_983_898u32, 3_795_788] {
        for u in seam - 100_000..seam + 100_000 {
            assert!(normal_quantile(u) <= normal_quantile(u + 1), "{u}");
        }
    }
}

#[test]
fn tails_and_densities_are_within_their_bounds() {
    let (mut tail, mut density) = (0.0, 0.0);
    for i in 0..1u32 << 20 {
        let z = f32::from_bits(0x3000_0000 + (mix(i) >> 1) % 0x1100_0000);
        let wide = f64::from(z);
        let got = real_normal_masses(real(z)).tail;
        assert_eq!(got, real_normal_masses(real(-z)).tail);
        if wide < 7.0 {
            tail = worse(tail, (value(got) / judge::normal_tail(wide) - 1.0).abs());
        }
        if wide < 30.0 {
            let got = value(real_normal_density(real(z)));
            density = worse(density, (got / judge::normal_density(wide) - 1.0).abs());
        }
    }
    println!("2^{:.2}, 2^{:.2}", f64::log2(tail), f64::log2(density));
    assert!(tail < f64::powi(2.0, -26), "2^{:.2}", tail.log2());
    assert!(density < f64::powi(2.0, -29), "2^{:.2}", density.log2());
}

#[test]
fn fractions_come_back_from_their_quantiles() {
    let (mut worst, mut relative) = (0.0f64, 0.0f64);
    for u in fractions() {
        // From 32 bits of z: next to the midpoint the fraction itself.
        let exact = normal_fraction(real_normal_quantile(u));
        assert!(exact.abs_diff(u) <= 4, "{u:#x} {exact:#x}");
        // From a float, as well as a float can say: half its last place times the density.
        let z = normal_quantile(u);
        let difference = f64::from(normal_fraction(real(z)).abs_diff(u));
        let wide = f64::from(z.abs());
        let place = wide * f64::powi(2.0, -24) * judge::normal_density(wide) * 4_294_967_296.0;
        worst = worst.max(difference - place);
        let tail = u.min(!u);
        relative = relative.max(difference / (f64::from(tail) + 0.5));
        if tail < 1 << 16 {
            assert_eq!(difference, 0.0, "{u:#x}");
        }
    }
    println!("{worst} {:.2}", relative.log2());
    assert!(worst < 4.0, "{worst}");
    assert!(relative < f64::powi(2.0, -19), "2^{:.2}", relative.log2());
}

#[test]
fn degenerate_values_stand_for_the_ends() {
    for z in [
        f32::INFINITY,
        f32::MAX,
        1e10,
        7.0,
        f32::from_bits(0x7fc0_0000),
    ] {
        assert_eq!(normal_fraction(real(z)), u32::MAX, "{z}");
        assert_eq!(normal_fraction(real(-z)), 0, "{z}");
    }
    assert_eq!(normal_fraction(real(0.0)), 0x7fff_ffff);
    assert_eq!(real_float(real_normal_density(real(1e30))), 0.0);
    assert_eq!(value(real_normal_masses(real(0.0)).tail), 0.5);
}

#[test]
fn the_judge_agrees_with_itself() {
    // Two routes: the rational quantile, and the tail by series or continued fraction.
    for u in fractions().step_by(7) {
        let z = judge::normal_quantile(u);
        let tail = (f64::from(u.min(!u)) + 0.5) / 4_294_967_296.0;
        let back = judge::normal_tail(z.abs());
        assert!((back / tail - 1.0).abs() < 2e-13, "{u:#x} {back} {tail}");
    }
}

#[test]
fn a_quantile_of_the_lower_edge_breaks_the_bound() {
    // u / 2^32 in place of the midpoint: the tails tell.
    let worst = (1..1000)
        .map(|u| {
            let truth = judge::normal_quantile(u);
            let edge = 0.5 * (truth + judge::normal_quantile(u - 1));
            ulp_error(edge as f32, truth)
        })
        .fold(0.0, f64::max);
    assert!(worst > 100.0, "{worst}");
}
