//! Free flight, normal distributions and pixel filters: mass, moments, samples against
//! densities, and what degenerate input gives.

use corput::bulk::{map_invert, map_pdf, map_sample};
use corput::catalog::{Map, Mapping, Profile};
use corput::glam::{uvec2, vec2};
use corput::judge::{normal_mass, normal_quantile};
use corput::reference::permute::permute_mix as mix;
use corput::reference::{filter, free_flight, gaussian};

const EXACT: Profile = Profile::Exact;

fn mapping(name: &str, values: &[f64]) -> Mapping {
    let map = Map::from_name(name).unwrap_or_else(|error| panic!("{error}"));
    Mapping::with_values(map, values).unwrap_or_else(|error| panic!("{error}"))
}

/// The maps with ordinary parameters, the farthest coordinate, and the standard deviation of
/// a coordinate.
fn cases() -> Vec<(Mapping, [f64; 2], f64)> {
    let truncated = |r: f64, s: f64| {
        let z = r / s;
        let density = (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
        s * (1.0 - z * density / normal_mass(z)).sqrt()
    };
    vec![
        (mapping("exponential", &[2.0]), [0.0, 12.0], 0.5),
        (mapping("gaussian", &[0.5]), [-3.5, 3.5], 0.5),
        (mapping("normal-pair", &[0.5]), [-3.5, 3.5], 0.5),
        (mapping("box-muller", &[0.5]), [-3.5, 3.5], 0.5),
        (
            mapping("filter-box", &[1.5]),
            [-1.5, 1.5],
            1.5 / 3f64.sqrt(),
        ),
        (
            mapping("filter-tent", &[2.0]),
            [-2.0, 2.0],
            2.0 / 6f64.sqrt(),
        ),
        (
            mapping("filter-gaussian", &[1.5, 0.5]),
            [-1.5, 1.5],
            truncated(1.5, 0.5),
        ),
        (
            mapping("filter-gaussian", &[0.5, 1.0]),
            [-0.5, 0.5],
            truncated(0.5, 1.0),
        ),
    ]
}

fn pdf(mapping: &Mapping, x: f64, y: f64) -> f64 {
    let s = [x as f32, y as f32, 0.0].map(f32::to_bits);
    f64::from(f32::from_bits(map_pdf(mapping, EXACT, s)))
}

fn sample(mapping: &Mapping, u: [u32; 2]) -> Vec<f64> {
    let count = mapping.map().coordinates as usize;
    let words = map_sample(mapping, EXACT, [u[0], u[1], 0]);
    words[..count]
        .iter()
        .map(|&word| f64::from(f32::from_bits(word)))
        .collect()
}

/// By the rule of midpoints, on a grid whose lines lie on the seams.
#[test]
fn pdfs_integrate_to_one() {
    for (mapping, [low, high], _) in cases() {
        let lines = mapping.map().coordinates;
        let steps = if lines == 1 { 1 << 18 } else { 1 << 10 };
        let step = (high - low) / f64::from(steps);
        let at = |i: u32| low + (f64::from(i) + 0.5) * step;
        let mass: f64 = (0..steps)
            .map(|i| {
                if lines == 1 {
                    return pdf(&mapping, at(i), 0.0) * step;
                }
                (0..steps).map(|j| pdf(&mapping, at(i), at(j))).sum::<f64>() * step * step
            })
            .sum();
        assert!((mass - 1.0).abs() < 2e-6, "{} {mass}", mapping.map().name);
    }
}

#[test]
fn beyond_the_edge_there_is_nothing() {
    for (mapping, [low, high], _) in cases() {
        if mapping.map().name.starts_with("filter") {
            let out = high * 1.000_001;
            for (x, y) in [(out, 0.0), (0.0, -out), (out, out), (low * 2.0, 0.0)] {
                assert_eq!(pdf(&mapping, x, y), 0.0, "{mapping:?}");
            }
            assert!(pdf(&mapping, low * 0.99, high * 0.99) > 0.0);
        }
    }
    assert_eq!(pdf(&mapping("exponential", &[2.0]), -0.1, 0.0), 0.0);
}

/// Moments of equidistant fractions, whose samples are quantiles of the distribution.
#[test]
fn moments_are_those_of_the_distribution() {
    const COUNT: u32 = 1 << 16;
    for (mapping, _, deviation) in cases() {
        let name = mapping.map().name;
        let [mut sum, mut square, mut product] = [0.0; 3];
        for i in 0..COUNT {
            // A shifted lattice: both coordinates run through all equidistant fractions.
            let u = [(i << 16) | 0x8000, (i.wrapping_mul(40_503) << 16) | 0x8000];
            let s = sample(&mapping, u);
            let last = s.len() - 1;
            sum += s[0];
            square += s[0] * s[0];
            product += s[0] * s[last];
        }
        let count = f64::from(COUNT);
        let mean = if name == "exponential" { 0.5 } else { 0.0 };
        let found = (square / count - (sum / count).powi(2)).sqrt();
        assert!(
            (sum / count - mean).abs() < 2e-3 * deviation,
            "{name} {}",
            sum / count
        );
        assert!(
            (found / deviation - 1.0).abs() < 2e-3,
            "{name} {found} {deviation}"
        );
        if mapping.map().coordinates == 2 {
            let correlation = product / count / deviation / deviation;
            assert!(correlation.abs() < 4e-3, "{name} {correlation}");
        }
    }
}

/// Pearson's statistic, as a deviate of the normal distribution by Wilson and Hilferty.
fn deviate(counts: &[f64], expected: &[f64]) -> f64 {
    let terms = counts.iter().zip(expected);
    let chi: f64 = terms.map(|(c, e)| (c - e) * (c - e) / e).sum();
    let freedom = counts.len() as f64 - 1.0;
    let share = 2.0 / (9.0 * freedom);
    ((chi / freedom).cbrt() - 1.0 + share) / share.sqrt()
}

/// The statistic of random samples in cells of equal mass, which the judge's own
/// quantiles bound; `bend` distorts the samples.
fn statistic(mapping: &Mapping, samples: u32, seed: u32, bend: impl Fn(f64) -> f64) -> f64 {
    const CELLS: usize = 24;
    let p = mapping.parameters().map(f64::from);
    let cdf = |x: f64| match mapping.map().name {
        "exponential" => -(-x * p[0]).exp_m1(),
        "filter-box" => 0.5 + 0.5 * x / p[0],
        "filter-tent" => {
            let s = (x / p[0]).abs();
            0.5 + (0.5 * s * (2.0 - s)).copysign(x)
        }
        "filter-gaussian" => {
            0.5 + (0.5 * normal_mass((x / p[1]).abs()) / normal_mass(p[0] / p[1])).copysign(x)
        }
        _ => 0.5 + normal_mass((x / p[0]).abs()).copysign(x),
    };
    let cell = |x: f64| ((cdf(bend(x)) * CELLS as f64) as usize).min(CELLS - 1);
    let lines = mapping.map().coordinates as usize;
    let mut counts = vec![0.0; CELLS.pow(lines as u32)];
    for i in 0..samples {
        let i = 2 * i + seed;
        let s = sample(mapping, [mix(i), mix(i ^ 0x5bd1_e995)]);
        let at = s.iter().fold(0, |at, &x| at * CELLS + cell(x));
        counts[at] += 1.0;
    }
    let expected = vec![f64::from(samples) / counts.len() as f64; counts.len()];
    deviate(&counts, &expected)
}

/// A level of 0.01 over all tests, by Sidak.
fn threshold(tests: usize) -> f64 {
    let level = 1.0 - 0.99f64.powf(1.0 / tests as f64);
    -normal_quantile((level * 4_294_967_296.0) as u32)
}

#[test]
fn samples_follow_their_densities() {
    let cases = cases();
    let most = threshold(cases.len());
    for (i, (mapping, _, deviation)) in cases.iter().enumerate() {
        let found = statistic(
            mapping,
            1_000_000,
            0x1000_0000 + 4_000_000 * i as u32,
            |x| x,
        );
        println!("{} {found:.2} of {most:.2}", mapping.map().name);
        assert!(found < most, "{} {found}", mapping.map().name);
        // Samples that are 3 % of the deviation off are seen.
        let bent = statistic(mapping, 200_000, 0x1000_0000, |x| x + 0.03 * deviation);
        assert!(bent > most, "{} bent {bent}", mapping.map().name);
    }
}

#[test]
fn inverses_return_the_fractions() {
    for (mapping, _, _) in cases() {
        let name = mapping.map().name;
        let mut worst = 0;
        // From 1 on: 0 gives the fraction 0, whose point has no angle.
        for i in 1..1u32 << 16 {
            let mut u = [mix(3 * i), mix(3 * i + 1), 0];
            u[mapping.map().dimensions as usize..].fill(0);
            let words = map_sample(&mapping, EXACT, u);
            let mut s = [words[0], words[1], 0];
            s[mapping.map().coordinates as usize..].fill(0);
            let v = map_invert(&mapping, EXACT, s);
            let apart = |a: u32, b: u32| a.wrapping_sub(b).min(b.wrapping_sub(a));
            worst = worst.max(apart(u[0], v[0])).max(apart(u[1], v[1]));
        }
        println!("{name}: {worst} units");
        // Half a place of a coordinate near its edge is 2^-25, of its half.
        assert!(worst <= 300, "{name} {worst}");
    }
}

#[test]
fn degenerate_parameters_give_what_the_headers_say() {
    let bad = [0.0, -0.0, -1.0, f32::NEG_INFINITY, f32::from_bits(1)];
    let odd = [f32::INFINITY, f32::NAN, f32::MAX, f32::MIN_POSITIVE];
    let u = uvec2(0x1234_5678, 0x9abc_def0);
    for s in bad {
        let flight = free_flight::exponential(s, 5);
        assert_eq!((flight.t, flight.pdf), (f32::MAX, 0.0), "{s}");
        assert_eq!(free_flight::exponential(s, 0).t, 0.0, "{s}");
        let made = gaussian::gaussian(s, 5);
        assert_eq!((made.x, made.pdf), (0.0, f32::MAX), "{s}");
        assert_eq!(gaussian::normal_pair(s, u).p, vec2(0.0, 0.0), "{s}");
        assert_eq!(gaussian::box_muller(s, u).p, vec2(0.0, 0.0), "{s}");
        assert_eq!(filter::filter_box(s, u).p, vec2(0.0, 0.0), "{s}");
        assert_eq!(filter::filter_tent(s, u).p, vec2(0.0, 0.0), "{s}");
        for r in bad.into_iter().chain(odd) {
            let f = filter::filter_gaussian_prepare(r, s);
            assert_eq!(filter::filter_gaussian(f, u).p, vec2(0.0, 0.0), "{r} {s}");
        }
    }
    for s in bad.into_iter().chain(odd) {
        for x in bad.into_iter().chain(odd) {
            let p = vec2(x, -x);
            let f = filter::filter_gaussian_prepare(s, x.abs());
            let all = [
                free_flight::exponential(s, 77).t,
                free_flight::exponential_pdf(s, x),
                gaussian::gaussian(s, 77).x,
                gaussian::gaussian_pdf(s, x),
                gaussian::normal_pair_pdf(s, p),
                gaussian::box_muller(s, u).p.x,
                filter::filter_box(s, u).p.x,
                filter::filter_box_pdf(s, p),
                filter::filter_tent_pdf(s, p),
                filter::filter_gaussian(f, u).p.y,
                filter::filter_gaussian_pdf(f, p),
            ];
            assert!(all.iter().all(|x| x.is_finite()), "{s} {x}: {all:?}");
            let _ = (
                free_flight::exponential_invert(s, x),
                filter::filter_gaussian_invert(f, p),
            );
            let _ = (
                gaussian::normal_pair_invert(s, p),
                gaussian::box_muller_invert(s, p),
            );
            let _ = (
                filter::filter_box_invert(s, p),
                filter::filter_tent_invert(s, p),
            );
        }
    }
}

/// Extreme rows of the usual formulas: -ln(u) at u = 0 and next to 1, and the logarithm of a
/// fraction that a float has rounded to 1.
#[test]
fn the_common_formulas_break_where_ours_hold() {
    // t = -ln(u): infinite at 0.
    assert_eq!(-(0f32).ln(), f32::INFINITY);
    assert_eq!(free_flight::exponential(1.0, u32::MAX).t, 22.180_71);
    // t = -ln(1 - u) in float: u = 2^-32 is lost altogether.
    let naive = -(1.0f32 - 2f32.powi(-32)).ln();
    let ours = free_flight::exponential(1.0, 1).t;
    assert_eq!(naive, 0.0);
    assert!(
        (f64::from(ours) * 4_294_967_296.0 - 1.0).abs() < 1e-7,
        "{ours:e}"
    );
    // The radius of the tent by 1 - sqrt(1 - a): a = 2^-32 is lost too.
    let naive = 1.0 - (1.0f32 - 2f32.powi(-32)).sqrt();
    let ours = filter::filter_tent(1.0, uvec2(1 << 31, 0)).p.x;
    assert_eq!(naive, 0.0);
    assert!(
        (f64::from(ours) * 8_589_934_592.0 - 1.0).abs() < 1e-7,
        "{ours:e}"
    );
}
