//! Heuristics of multiple importance sampling and Russian roulette, at the extremes too.

use corput::glam::{UVec4, Vec4, uvec4, vec4};
use corput::judge::ulp_error;
use corput::reference::mis::*;
use corput::reference::permute::permute_mix as mix;

/// Pdfs of all kinds.
fn pdfs() -> Vec<f32> {
    let mut list = vec![
        0.0,
        -0.0,
        1.0,
        -1.0,
        1e20,
        1e30,
        1e-25,
        1e-38,
        f32::MIN_POSITIVE,
        f32::MAX,
        1e-45,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::NAN,
    ];
    list.extend((0..40).map(|i| f32::from_bits(mix(i) & 0x7f7f_ffff)));
    list
}

const COUNTS: [u32; 5] = [0, 1, 3, 1000, u32::MAX];

/// count * pdf as the headers say: no light is 0.
fn term(count: u32, pdf: f32) -> f64 {
    if pdf.is_nan() || pdf < f32::MIN_POSITIVE {
        0.0
    } else if pdf.is_infinite() {
        // Beyond the ratio of any two finite ones, and its square.
        f64::from(count) * 1e150
    } else {
        f64::from(count) * f64::from(pdf)
    }
}

/// (a / (a + b))^.. by a ratio that cannot overflow in f64.
fn share(a: f64, others: &[f64], power: i32) -> f64 {
    if a == 0.0 {
        return 0.0;
    }
    1.0 / (1.0 + others.iter().map(|b| (b / a).powi(power)).sum::<f64>())
}

type Heuristic = fn(u32, f32, u32, f32) -> f32;

/// The worst error in ULP of a heuristic, and of its weights' sum.
fn worst(heuristic: Heuristic, power: i32) -> (f64, f64) {
    let (mut worst, mut sum) = (0.0f64, 0.0f64);
    for pa in pdfs() {
        for pb in pdfs() {
            for na in COUNTS {
                for nb in COUNTS {
                    let (a, b) = (term(na, pa), term(nb, pb));
                    let got = heuristic(na, pa, nb, pb);
                    assert!((0.0..=1.0).contains(&got), "{na} {pa} {nb} {pb}: {got}");
                    let truth = share(a, &[b], power);
                    // Below the normal floats a weight is 0; next to 2^-126 either.
                    if truth >= 1.1 * f64::powi(2.0, -126) {
                        worst = worst.max(ulp_error(got, truth));
                    } else {
                        assert!(f64::from(got) <= 1.1 * f64::powi(2.0, -126));
                    }
                    if a + b > 0.0 {
                        let other = heuristic(nb, pb, na, pa);
                        sum = sum.max((f64::from(got) + f64::from(other) - 1.0).abs());
                    } else {
                        assert_eq!(got, 0.0);
                    }
                }
            }
        }
    }
    (worst, sum / f64::from(f32::EPSILON))
}

#[test]
fn weights_are_shares_and_sum_to_one() {
    for (name, heuristic, power) in [
        ("balance", mis_balance as Heuristic, 1),
        ("power", mis_power as Heuristic, 2),
    ] {
        let (error, sum) = worst(heuristic, power);
        println!("{name}: {error:.3} ULP, sums to 1 within {sum:.2} ULP");
        assert!(error <= 0.6 && sum <= 2.0);
    }
}

#[test]
fn the_common_formula_fails_at_the_extremes() {
    // Row 40 of the catalogue: the square overflows, or both vanish.
    let common = |a: f32, b: f32| a * a / (a * a + b * b);
    let truth = share(f64::from(1e20f32), &[f64::from(1e30f32)], 2);
    let of_common = common(1e20, 1e30);
    assert!(of_common.is_nan() || ulp_error(of_common, truth) > 1e6);
    assert!(common(1e-25, 1e-25).is_nan());
    assert!(ulp_error(mis_power(1, 1e20, 1, 1e30), truth) <= 0.6);
    assert_eq!(mis_power(1, 1e-25, 1, 1e-25), 0.5);
    println!(
        "(1e20, 1e30): common {}, ours {}; (1e-25, 1e-25): common {}, ours {}",
        common(1e20, 1e30),
        mis_power(1, 1e20, 1, 1e30),
        common(1e-25, 1e-25),
        mis_power(1, 1e-25, 1, 1e-25)
    );
}

#[test]
fn the_maximum_heuristic_takes_the_larger() {
    for pa in pdfs() {
        for pb in pdfs() {
            for (na, nb) in [(1, 1), (3, 1), (1, 0), (u32::MAX, 2)] {
                let (a, b) = (term(na, pa), term(nb, pb));
                let got = mis_maximum(na, pa, nb, pb);
                // Products of a count and a pdf that differ by less than f64 may tie.
                if a > b * (1.0 + 1e-9) {
                    assert_eq!(got, 1.0, "{pa} {pb}");
                } else if a < b * (1.0 - 1e-9) || a == 0.0 {
                    assert_eq!(got, 0.0, "{pa} {pb}");
                }
                if a + b > 0.0 {
                    assert_eq!(got + mis_maximum(nb, pb, na, pa), 1.0);
                }
            }
        }
    }
    assert_eq!(mis_maximum(2, 1.5, 1, 3.0), 0.5);
}

#[test]
fn deltas_and_counts_are_what_the_header_says() {
    let infinite = f32::INFINITY;
    for heuristic in [mis_balance as Heuristic, mis_power, mis_maximum] {
        assert_eq!(heuristic(1, infinite, 1, f32::MAX), 1.0);
        assert_eq!(heuristic(1, f32::MAX, 1, infinite), 0.0);
        assert_eq!(heuristic(5, infinite, 5, infinite), 0.5);
        assert_eq!(heuristic(0, infinite, 1, 1.0), 0.0);
        assert_eq!(heuristic(1, f32::NAN, 1, 1.0), 0.0);
        assert_eq!(heuristic(1, 0.0, 1, 0.0), 0.0);
    }
    assert_eq!(mis_balance(3, infinite, 1, infinite), 0.75);
}

#[test]
fn four_techniques_share_as_two_do() {
    let list = pdfs();
    let mut worst = 0.0f64;
    for i in 0..20_000u32 {
        let pick = |k: u32| list[(mix(4 * i + k) % list.len() as u32) as usize];
        let count = |k: u32| COUNTS[(mix(!(4 * i + k)) % 5) as usize];
        let p: [f32; 4] = std::array::from_fn(|k| pick(k as u32));
        let n: [u32; 4] = std::array::from_fn(|k| count(k as u32));
        let t: [f64; 4] = std::array::from_fn(|k| term(n[k], p[k]));
        let (mut balance, mut power) = (0.0, 0.0);
        for turn in 0..4 {
            let at = |k: usize| (k + turn) % 4;
            let counts = UVec4::from_array(std::array::from_fn(|k| n[at(k)]));
            let values = Vec4::from_array(std::array::from_fn(|k| p[at(k)]));
            let others = [t[at(1)], t[at(2)], t[at(3)]];
            for (got, exponent, sum) in [
                (mis_balance4(counts, values), 1, &mut balance),
                (mis_power4(counts, values), 2, &mut power),
            ] {
                let truth = share(t[turn], &others, exponent);
                if truth >= 1.1 * f64::powi(2.0, -126) {
                    worst = worst.max(ulp_error(got, truth));
                }
                *sum += f64::from(got);
            }
        }
        let expected = if t.iter().any(|&t| t > 0.0) { 1.0 } else { 0.0 };
        for sum in [balance, power] {
            assert!(
                (sum - expected).abs() <= 2.0 * f64::from(f32::EPSILON),
                "{sum}"
            );
        }
    }
    println!("four techniques: {worst:.3} ULP");
    assert!(worst <= 0.6);
    // With two techniques of four it is the heuristic of two.
    let (counts, values) = (uvec4(2, 3, 0, 0), vec4(0.5, 7.0, 1.0, 1.0));
    assert_eq!(mis_balance4(counts, values), mis_balance(2, 0.5, 3, 7.0));
    assert_eq!(mis_power4(counts, values), mis_power(2, 0.5, 3, 7.0));
}

#[test]
fn one_sample_draws_in_proportion_and_has_the_mean_density() {
    for weights in [
        uvec4(1, 1, 0, 0),
        uvec4(0, 0, 3, 1),
        uvec4(1 << 30, 1 << 29, 7, 1),
        uvec4(5, 0, 2, 93),
    ] {
        let w = weights.to_array();
        let total: u64 = w.iter().map(|&w| u64::from(w)).sum();
        let mut before = 0u64;
        for (k, &width) in (0..).zip(&w) {
            // The first u of each technique, and the one before it.
            let first = (before << 32).div_ceil(total);
            let end = ((before + u64::from(width)) << 32).div_ceil(total);
            if end > first {
                for u in [first, end - 1, first + (end - first) / 2] {
                    let got = mis_choose(weights, u as u32);
                    assert_eq!(got.index, k, "{weights} {u}");
                    let rest = (u - first) as f64 / (end - first) as f64 * 4_294_967_296.0;
                    // The rest to 2^-30, and the ends of the range to a u.
                    let grain = 4_294_967_296.0 / (end - first) as f64;
                    assert!((f64::from(got.rest) - rest).abs() <= 5.0 + grain);
                }
            }
            before += u64::from(width);
        }
        let p = [0.25f32, 8.0, 1e-3, 1e9];
        let truth = w
            .iter()
            .zip(p)
            .map(|(&w, p)| f64::from(w) * f64::from(p))
            .sum::<f64>()
            / total as f64;
        let got = mis_one_sample(weights, Vec4::from_array(p));
        assert!(ulp_error(got, truth) <= 0.6);
    }
    assert_eq!(mis_one_sample(UVec4::ZERO, Vec4::ONE), 0.0);
    assert_eq!(
        mis_one_sample(uvec4(1, 1, 0, 0), vec4(f32::INFINITY, 1.0, 0.0, 0.0)),
        f32::MAX
    );
}

#[test]
fn roulette_is_unbiased_and_reuses_the_rest() {
    for survival in [
        0,
        1,
        2,
        1 << 16,
        1 << 31,
        0xffff_fffe,
        u32::MAX,
        0x1234_5678,
    ] {
        let ends = [
            0,
            1,
            survival.wrapping_sub(1),
            survival,
            survival.wrapping_add(1),
            u32::MAX,
        ];
        for u in ends.into_iter().chain((0..200).map(mix)) {
            let got = roulette(survival, u);
            let certain = survival == u32::MAX;
            assert_eq!(got.survives, certain || u < survival);
            let weight = match got.survives {
                true if certain => 1.0,
                true => 4_294_967_296.0 / f64::from(survival),
                false => 0.0,
            };
            assert!(ulp_error(got.weight, weight) <= 0.6);
            let s = f64::from(survival);
            let rest = match (certain, got.survives) {
                (true, _) => f64::from(u) / 4_294_967_296.0,
                (_, true) => f64::from(u) / s,
                (_, false) => (f64::from(u) - s) / (4_294_967_296.0 - s),
            };
            let error = (f64::from(got.rest) - rest * 4_294_967_296.0).abs();
            assert!(error <= 5.0, "{survival} {u}: {error}");
        }
    }
    assert_eq!(roulette_survival(1.0), u32::MAX);
    assert_eq!(roulette_survival(f32::INFINITY), u32::MAX);
    assert_eq!(roulette_survival(0.5), 1 << 31);
    for dead in [0.0, -0.0, -1.0, f32::NAN, f32::NEG_INFINITY, 1e-45, 1e-20] {
        assert_eq!(roulette_survival(dead), 0);
    }
}
