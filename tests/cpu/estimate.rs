//! Exact sums, what is read from them, and the integrands' integrals.

use corput::bulk::{estimate, integrand_term};
use corput::catalog::{
    Integrand, Options, Problem, Request, Scramble, Sequence, examples, integrands,
};
use corput::estimate::{Estimate, U256};
use corput::glam::{UVec2, uvec2};
use corput::judge;
use corput::reference::permute::permute_mix as mix;
use corput::reference::real::{Real, real_zero};
use corput::reference::sum::{
    Sum, Term, sum_add, sum_zero, tally_add, tally_sum, tally_zero, term,
};

fn problem(text: &str) -> Problem {
    Problem::parse(text).unwrap_or_else(|error| panic!("{error}"))
}

fn points(problem: &Problem, sequence: Sequence, seed: Option<u64>, count: u64) -> Request {
    let scramble = (sequence == Sequence::Sobol && seed.is_some()).then_some(Scramble::OwenHash);
    let options = Options {
        dimensions: Some(problem.dimensions().into()),
        seed,
        scramble,
        fractions: true,
        ..Options::new(sequence, count)
    };
    Request::new(&options).unwrap_or_else(|error| panic!("{error}"))
}

fn sums(problem: &Problem, request: &Request) -> Estimate {
    estimate(problem, request, 0, request.count).unwrap_or_else(|error| panic!("{error}"))
}

fn number(v: UVec2) -> u64 {
    u64::from(v.x) | (u64::from(v.y) << 32)
}

/// Terms whose words are at their ends and in between, with both signs.
fn hostile_terms() -> Vec<Term> {
    let ends = [0, 1, 0x7fff_ffff, 0x8000_0000, 0xffff_fffe, u32::MAX];
    let mut list = Vec::new();
    for x in ends {
        for y in ends {
            for negative in [false, true] {
                let m = uvec2(x, y);
                list.push(Term { m, negative });
            }
        }
    }
    list.extend((0..4000).map(|n| Term {
        m: uvec2(mix(2 * n), mix(2 * n + 1)),
        negative: mix(n ^ 0x55) & 1 == 1,
    }));
    list
}

fn words(sum: Sum) -> Estimate {
    let ([a, b, c, d], [e, f]) = (sum.squares.to_array(), sum.squares_high.to_array());
    Estimate::from_words(0, 0, sum.total.to_array(), [a, b, c, d, e, f])
}

/// The sums of terms in integers of the host: squares in two halves.
fn expected(terms: &[Term]) -> (i128, U256) {
    let mut total = 0i128;
    let (mut low, mut high) = (0u128, 0u64);
    for term in terms {
        let m = i128::from(number(term.m));
        total += if term.negative { -m } else { m };
        let square = u128::from(number(term.m)).pow(2);
        let (sum, carry) = low.overflowing_add(square);
        (low, high) = (sum, high + u64::from(carry));
    }
    (total, U256::new([low as u64, (low >> 64) as u64, high, 0]))
}

#[test]
fn sums_of_hostile_terms_are_exact() {
    let terms = hostile_terms();
    let mut sum = sum_zero();
    for (n, &term) in terms.iter().enumerate() {
        sum = sum_add(sum, term);
        let got = words(sum);
        let (total, squares) = expected(&terms[..=n]);
        assert_eq!((got.sum(), got.squares()), (total, squares), "{n}");
    }
    // Zeros of either sign change nothing.
    for negative in [false, true] {
        let m = UVec2::ZERO;
        assert_eq!(sum_add(sum, Term { m, negative }), sum);
    }
}

#[test]
fn tallies_have_the_sums_of_their_terms() {
    let mut tally = tally_zero();
    let mut sum = sum_zero();
    assert_eq!(tally_sum(tally), sum);
    for term in hostile_terms() {
        tally = tally_add(tally, term);
        sum = sum_add(sum, term);
        assert_eq!(tally_sum(tally), sum, "{term:?}");
    }
    // As many terms as a tally takes, each as large as a term may be, or as its complement is.
    for (m, negative) in [
        (UVec2::MAX, false),
        (UVec2::MAX, true),
        (UVec2::ZERO, true),
        (uvec2(1, 0), true),
        (uvec2(u32::MAX, 0), false),
        (uvec2(0, u32::MAX), true),
    ] {
        let (mut tally, mut sum) = (tally_zero(), sum_zero());
        for _ in 0..1 << 16 {
            tally = tally_add(tally, Term { m, negative });
            sum = sum_add(sum, Term { m, negative });
        }
        assert_eq!(tally_sum(tally), sum, "{m} {negative}");
    }
}

#[test]
fn terms_are_the_nearest_integers() {
    assert_eq!(number(term(real_zero(), 60).m), 0);
    for n in 0..2000u32 {
        let ends = [0x8000_0000, 0x8000_0001, 0xc000_0000, u32::MAX];
        let m = if n % 3 == 0 {
            ends[n as usize / 3 % 4]
        } else {
            mix(n) | 0x8000_0000
        };
        for place in -70..40 {
            let negative = mix(n) & 1 == 1;
            let scale = (mix(n) % 128) as i32 - 64;
            let real = Real {
                m,
                e: place - scale,
                negative,
            };
            // m * 2^place, and a half, cut.
            let wanted = match place {
                0.. => u64::try_from(u128::from(m) << place).unwrap_or(u64::MAX),
                -60..0 => ((u128::from(m) + (1u128 << (-place - 1))) >> -place) as u64,
                _ => 0,
            };
            let got = term(real, scale);
            assert_eq!(
                (number(got.m), got.negative),
                (wanted, negative),
                "{m:x} {place}"
            );
        }
    }
}

#[test]
fn quotients_are_correctly_rounded() {
    // Of integers below 2^53 the division of f64 is.
    for n in 0..20_000u32 {
        let a = (u64::from(mix(n)) << 21 | u64::from(mix(n + 1)) >> 11) >> (mix(n + 2) % 53);
        let b = ((u64::from(mix(n + 3)) << 21) >> (mix(n + 4) % 53)).max(1);
        let quotient = a as f64 / b as f64;
        for shift in [0, 7, 64, 100] {
            let wide = shifted(a, shift);
            assert_eq!(wide.over(b.into(), -(shift as i32)), quotient, "{a} / {b}");
        }
    }
    // Halves go to even, and what is left decides.
    let half = U256::from_u128((1 << 53) + 1);
    assert_eq!(half.over(1, 0), 9_007_199_254_740_992.0);
    let far = shifted((1 << 53) + 1, 190).checked_add(U256::from_u128(1));
    assert_eq!(
        far.map(|far| far.over(1, -190)),
        Some(9_007_199_254_740_994.0)
    );
    assert_eq!(U256::from_u128(u128::MAX).over(1, 896), f64::INFINITY);
    assert_eq!(U256::default().over(3, 0), 0.0);
}

fn shifted(a: u64, shift: u32) -> U256 {
    let low = u128::from(a) << (shift % 64);
    let parts = [low as u64, (low >> 64) as u64];
    match shift / 64 {
        0 => U256::new([parts[0], parts[1], 0, 0]),
        1 => U256::new([0, parts[0], parts[1], 0]),
        _ => U256::new([0, 0, parts[0], parts[1]]),
    }
}

#[test]
fn wide_integers_multiply_and_print() {
    let x = u128::MAX;
    // (2^128 - 1)^2 = 2^256 - 2^129 + 1.
    let square = U256::square(x);
    assert_eq!(square, U256::new([1, 0, u64::MAX - 1, u64::MAX]));
    assert_eq!(
        square.to_string(),
        "115792089237316195423570985008687907852589419931798687112530834793049593217025"
    );
    assert_eq!(square.checked_mul(2), None);
    assert_eq!(square.checked_add(square), None);
    assert_eq!(U256::default().checked_sub(square), None);
    assert_eq!(square.checked_sub(square), Some(U256::default()));
    for n in 0..500 {
        let a = u128::from(mix(n)) << 40 | u128::from(mix(n + 1));
        let text = U256::from_u128(a).to_string();
        assert_eq!(text, a.to_string());
        let product = U256::from_u128(a).checked_mul(mix(n + 2).into());
        assert_eq!(product, Some(U256::from_u128(a * u128::from(mix(n + 2)))));
        assert_eq!(
            U256::square(a >> 16),
            U256::from_u128((a >> 16) * (a >> 16))
        );
    }
    assert_eq!(
        U256::from_u128(10u128.pow(36)).to_string(),
        10u128.pow(36).to_string()
    );
}

#[test]
fn wide_integers_read_what_they_print() {
    let most = U256::new([u64::MAX; 4]);
    for x in [U256::default(), U256::square(u128::MAX), most] {
        assert_eq!(U256::from_decimal(&x.to_string()), Some(x));
    }
    // One more than the largest is too much, in the last step or before it.
    let over = most.to_string().replace("39935", "39936");
    assert_eq!(over.len(), 78);
    for text in [
        &over,
        &format!("{most}0"),
        "",
        "-1",
        "+1",
        "1e3",
        " 1",
        "0x1",
    ] {
        assert_eq!(U256::from_decimal(text), None, "{text}");
    }
}

#[test]
fn written_sums_are_those_of_some_terms() {
    let found = Estimate::from_sums(2, 64, -6, U256::from_u128(20));
    let found = found.unwrap_or_else(|| panic!("2 and 4, negated"));
    assert_eq!(
        (found.mean(), found.variance()),
        (Some(-3.0 / 2f64.powi(64)), Some(2.0 / 2f64.powi(128)))
    );
    // The bound of Cauchy and Schwarz itself, and one below it.
    assert!(Estimate::from_sums(2, 64, 6, U256::from_u128(18)).is_some());
    assert_eq!(Estimate::from_sums(2, 64, 6, U256::from_u128(17)), None);
    assert!(Estimate::from_sums(0, 64, 0, U256::default()).is_some());
    assert_eq!(Estimate::from_sums(0, 64, 0, U256::from_u128(1)), None);
    assert_eq!(Estimate::from_sums(0, 64, 1, U256::default()), None);
    assert_eq!(Estimate::from_sums(1, 4097, 1, U256::square(1)), None);
    assert_eq!(Estimate::from_sums(1, i32::MIN, 1, U256::square(1)), None);
    assert_eq!(
        Estimate::from_sums((1 << 62) + 1, 64, 1, U256::square(1)),
        None
    );
    assert_eq!(
        Estimate::from_sums(1, 64, i128::MIN, U256::square(1 << 126)),
        None
    );
}

/// The first 2^24 points of Sobol's first dimension are the multiples of 2^-24.
#[test]
fn x_squared_over_a_grid_is_its_closed_form() {
    const N: u128 = 1 << 24;
    let x_squared = problem("x-squared");
    let got = sums(
        &x_squared,
        &points(&x_squared, Sequence::Sobol, None, N as u64),
    );
    let squares = (N - 1) * N * (2 * N - 1) / 6;
    let m = N - 1;
    let fourths = m * (m + 1) * (2 * m + 1) / 6 * (3 * m * m + 3 * m - 1) / 5;
    assert_eq!(got.sum(), (squares << 16) as i128);
    // Of 116 bits, in units of 2^32.
    assert_eq!(got.squares(), times_two_to_32(fourths));
    assert_eq!(got.count(), N as u64);
}

fn times_two_to_32(x: u128) -> U256 {
    U256::from_u128(x).checked_mul(1 << 32).expect("small")
}

/// A mean of a million standard deviations, where sums of f64 lose the variance.
#[test]
fn the_variance_under_a_large_mean_is_exact() {
    const N: u64 = 1 << 20;
    let offset = 288_675;
    let problem = problem(&format!("offset:offset={offset}"));
    let got = sums(&problem, &points(&problem, Sequence::VanDerCorput, None, N));
    let n = N as f64;
    // Multiples of 1/n from 0 on.
    assert_eq!(got.mean(), Some(f64::from(offset) + 0.5 - 0.5 / n));
    let variance = (n + 1.0) / (12.0 * n);
    assert_eq!(got.variance(), Some(variance));
    let (mut sum, mut squares) = (0f32, 0f32);
    for k in 0..N {
        let value = (f64::from(offset) + k as f64 / n) as f32;
        sum += value;
        squares += value * value;
    }
    let lost = f64::from(squares) / n - (f64::from(sum) / n).powi(2);
    assert!((lost - variance).abs() > 100.0 * variance, "{lost}");
}

#[test]
fn a_wave_of_as_many_periods_as_points_needs_a_scramble() {
    // The first 2^k points of Sobol are all multiples of 2^-k, where the wave is 1.
    for count in [16u32, 1024, 1 << 16] {
        let wave = problem(&format!("oscillation:frequency={count}"));
        assert_eq!(wave.truth(), 0.0);
        let mean = |sequence, seed| {
            let request = points(&wave, sequence, seed, count.into());
            sums(&wave, &request).mean().expect("points")
        };
        // A cosine is within 2^-29 of its own.
        assert!((mean(Sequence::Sobol, None) - 1.0).abs() < 2e-9);
        // One of each cell, which the wave runs through once: means of variance 1 / 2N.
        let bound = 4.0 / f64::from(2 * count).sqrt();
        for seed in 0..8 {
            let scrambled = mean(Sequence::Sobol, Some(seed));
            assert!(scrambled.abs() < bound, "{count} points: {scrambled}");
        }
        // One period less or more, and their sum over the grid is 0.
        for frequency in [count - 1, count + 1] {
            let wave = problem(&format!("oscillation:frequency={frequency}"));
            let request = points(&wave, Sequence::Sobol, None, count.into());
            let mean = sums(&wave, &request).mean().expect("points");
            assert!(mean.abs() < 1e-8, "{frequency}: {mean}");
        }
    }
}

/// Records of sums, with words at their ends.
fn records() -> Vec<(u32, [u32; 4], [u32; 6])> {
    let word = |n: u32| match n % 5 {
        0 => u32::MAX,
        1 => 0,
        _ => mix(n),
    };
    let record = |n: u32| {
        // Sums keep to 2^120 or so, of either sign, as those of a dispatch do.
        let high = [0, u32::MAX, mix(n) >> 8, !(mix(n) >> 8)][n as usize % 4];
        let total = [word(8 * n), word(8 * n + 1), word(8 * n + 2), high];
        let squares = std::array::from_fn(|k| word(8 * n + 2 + k as u32) >> (k / 5 * 8));
        (word(n), total, squares)
    };
    (0..5_000).map(record).collect()
}

#[test]
fn sums_of_words_are_merged_estimates() {
    for take in [0, 1, 2, 63, 5_000] {
        let some = &records()[..take];
        let merged = some
            .iter()
            .fold(Estimate::new(7), |sum, (count, total, squares)| {
                let one = Estimate::from_words(*count, 7, *total, *squares);
                sum.merge(one).expect("no sum overflows")
            });
        let (mut count, mut total, mut squares) = (0, [0; 4], [0; 6]);
        for (more, words, others) in some {
            count += u64::from(*more);
            total
                .iter_mut()
                .zip(words)
                .for_each(|(sum, word)| *sum += u64::from(*word));
            squares
                .iter_mut()
                .zip(others)
                .for_each(|(sum, word)| *sum += u64::from(*word));
        }
        assert_eq!(
            Estimate::from_word_sums(count, 7, total, squares),
            merged,
            "{take}"
        );
        if take > 0 {
            total[3] += 1;
            assert_ne!(Estimate::from_word_sums(count, 7, total, squares), merged);
        }
    }
}

#[test]
fn estimates_merge_in_any_grouping() {
    let problem = problem("genz-oscillatory:d=3");
    let request = points(&problem, Sequence::Random, Some(3), 10_007);
    let whole = sums(&problem, &request);
    for cuts in [
        vec![1u64],
        vec![5_000],
        vec![1, 2, 3, 9_999],
        (1..1_000).collect(),
    ] {
        let mut ends = cuts.clone();
        ends.push(request.count);
        let mut begin = 0;
        let mut parts = Vec::new();
        for end in ends {
            let part = estimate(&problem, &request, begin, end - begin);
            parts.push(part.unwrap_or_else(|error| panic!("{error}")));
            begin = end;
        }
        let merge = |a: Estimate, b: &Estimate| a.merge(*b).expect("one scale");
        let none = Estimate::new(whole.scale());
        assert_eq!(parts.iter().fold(none, merge), whole);
        assert_eq!(parts.iter().rev().fold(none, merge), whole);
    }
    assert_eq!(whole.merge(Estimate::new(whole.scale() + 1)), None);
    let many = Estimate::from_words(u32::MAX, 0, [0; 4], [0; 6]);
    let doubled = (0..31).try_fold(many, |sum, _| sum.merge(sum));
    assert!((0..30).try_fold(many, |sum, _| sum.merge(sum)).is_some());
    assert_eq!(doubled, None, "2^63 terms");
    let none = Estimate::new(0);
    assert_eq!((none.mean(), none.variance()), (None, None));
    let one = Estimate::from_words(1, 0, [1, 0, 0, 0], [1, 0, 0, 0, 0, 0]);
    assert_eq!((one.mean(), one.variance()), (Some(1.0), None));
    let negative = Estimate::from_words(
        2,
        1,
        [u32::MAX - 2, u32::MAX, u32::MAX, u32::MAX],
        [9, 0, 0, 0, 0, 0],
    );
    assert_eq!(
        (negative.mean(), negative.variance()),
        (Some(-0.75), Some(1.125))
    );
}

/// Every integral against another estimate of it: by the midpoint rule in f64 for one
/// dimension, and by independent scrambles of Sobol points for more. The same test rejects
/// an integral that is 2 % off.
#[test]
fn integrals_are_what_sums_come_to() {
    for integrand in integrands() {
        for problem in examples(integrand).unwrap_or_else(|error| panic!("{error}")) {
            let (values, dimensions) = (problem.values(), problem.dimensions());
            let (mean, margin) = match dimensions {
                1 => midpoint(integrand, values),
                _ => scrambled(&problem),
            };
            let truth = problem.truth();
            // A wave's is 0, beside which the rounding of the other estimate would be seen.
            let scale = if truth == 0.0 {
                problem.coefficients().peak
            } else {
                truth
            };
            let margin = margin + f64::EPSILON * scale.abs();
            let estimator = problem.estimator().unwrap_or("");
            let name = format!("{} {estimator} {values:?} {dimensions}", integrand.name);
            assert!(
                (mean - truth).abs() <= margin,
                "{name}: {mean}, not {truth} +- {margin}"
            );
            if dimensions == 1 || dimensions == 8 {
                assert!(
                    (mean - (truth + 0.02 * scale)).abs() > margin,
                    "{name}: {margin} sees nothing"
                );
            }
        }
    }
}

/// The mean of the judge's integrand over the middles of 2^16 cells, each of 2^16 fractions,
/// and twice what half as many leave; a narrow peak takes more.
fn midpoint(integrand: &Integrand, values: &[f64]) -> (f64, f64) {
    let mean = |bits: u32| {
        let half = 1u32 << (31 - bits);
        let cell = |k: u32| judge::integrand(integrand.name, values, &[(k << (32 - bits)) + half]);
        (0..1u32 << bits).map(cell).sum::<f64>() / f64::from(1u32 << bits)
    };
    let bits = if values.first().is_some_and(|v| *v <= 1e-5) {
        23
    } else {
        20
    };
    let (fine, coarse) = (mean(bits), mean(bits - 1));
    (fine, 4.0 * (fine - coarse).abs() + 1e-5 * fine.abs())
}

/// The mean of 16 independent estimates, and 4.1 of its standard errors, Student's
/// two-sided 0.1 % of 15 degrees of freedom.
fn scrambled(problem: &Problem) -> (f64, f64) {
    const POINTS: u64 = 1 << 12;
    let one = |seed| {
        let request = points(problem, Sequence::Sobol, Some(seed), POINTS);
        sums(problem, &request).mean().expect("points")
    };
    let means: Vec<f64> = (0..16).map(one).collect();
    let mean = means.iter().sum::<f64>() / 16.0;
    let variance = means.iter().map(|m| (m - mean).powi(2)).sum::<f64>() / 15.0;
    let margin = 4.1 * (variance / 16.0).sqrt() + 1e-8 * mean.abs();
    // What ten points of all meet may be met by none, which no spread tells: of a sharp lobe or
    // a small light that is up to the peak in so large a part of the cube.
    let unseen = match (problem.integrand().name, problem.values()) {
        ("ggx-lobe", &[alpha, _, radius, _]) if alpha.min(radius) <= 0.001 => {
            10.0 / (16.0 * POINTS as f64) * problem.coefficients().peak
        }
        _ => 0.0,
    };
    (mean, margin + unseen)
}

#[test]
fn problems_refuse_what_is_outside() {
    for (text, word) in [
        ("x-sqared", "did you mean `x-squared`"),
        ("x-squared:d=2", "d is 2: it has 1"),
        ("genz-gaussian:d=0", "from 1 to 64"),
        ("genz-gaussian:d=65", "from 1 to 64"),
        ("genz-gaussian:d=2.5", "whole number"),
        ("genz-gaussian:dificulty=2", "did you mean `difficulty`"),
        ("genz-gaussian:difficulty=0", "from 0.001 to 100"),
        ("genz-gaussian:difficulty=nan", "from 0.001 to 100"),
        ("genz-gaussian:difficulty=inf", "from 0.001 to 100"),
        ("genz-gaussian:difficulty", "no key=number"),
        ("genz-gaussian:d=2,d=2", "given twice"),
        ("genz-corner-peak:d=64", "2^-34 of the peak"),
        ("gaussian-peak:sigma=1e-6,d=2", "2^-34 of the peak"),
        ("gaussian-peak:sigma=1e-7", "from 1e-6 to 1"),
        ("offset:offset=0.5", "whole number"),
        ("offset:offset=-1", "whole number"),
        ("offset:offset=4294967296", "whole number"),
        ("checkerboard:cells=0", "from 1 to 65536"),
        ("oscillation:frequency=0.5", "from 1 to 16777216"),
        ("", "unknown integrand"),
        (":", "unknown integrand"),
    ] {
        let error = Problem::parse(text).expect_err(text);
        assert_eq!(error.exit_code(), 2, "{text}");
        assert!(error.to_string().contains(word), "{text}: {error}");
    }
    let disk = problem("disk-step");
    let line = points(&problem("x-squared"), Sequence::Sobol, None, 8);
    assert!(estimate(&disk, &line, 0, 8).is_err());
    let request = points(&disk, Sequence::Sobol, None, 8);
    assert!(estimate(&disk, &request, 1, 8).is_err());
    assert!(estimate(&disk, &request, u64::MAX, 2).is_err());
    assert!(estimate(&disk, &request, 8, 0).is_ok_and(|none| none.count() == 0));
}

/// The estimate of an integral of x^2 by five points that an introduction works out by hand:
/// 0.04, 0.64, 0.09, 0.49 and 0.25, whose mean is 0.302.
#[test]
fn five_points_by_hand() {
    let square = problem("x-squared");
    let fraction = |x: f64| (x * 4_294_967_296.0).round() as u32;
    let mut sum = sum_zero();
    for x in [0.2, 0.8, 0.3, 0.7, 0.5] {
        sum = sum_add(sum, integrand_term(&square, &[fraction(x)]));
    }
    let ([a, b, c, d], [e, f]) = (sum.squares.to_array(), sum.squares_high.to_array());
    let squares = [a, b, c, d, e, f];
    let five = Estimate::from_words(5, 64, sum.total.to_array(), squares);
    let (mean, variance) = (five.mean().unwrap(), five.variance().unwrap());
    // Points are rounded to 2^-33, and x^2 has a slope of 2 at most.
    assert!((mean - 0.302).abs() < 2.0 / 8_589_934_592.0, "{mean}");
    // (0.04^2 + 0.64^2 + 0.09^2 + 0.49^2 + 0.25^2 - 5 * 0.302^2) / 4.
    assert!((variance - 0.066_47).abs() < 1e-9, "{variance}");
}
