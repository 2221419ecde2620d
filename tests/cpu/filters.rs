//! Pixel filters without an inverse in closed form: samples against the judge, mass,
//! inverses, samples against densities, and what degenerate input gives.

mod significance;

use corput::bulk::{map_invert, map_pdf, map_sample};
use corput::catalog::{Map, Mapping, Profile};
use corput::check::truth;
use corput::judge::ulp_error;
use corput::reference::permute::permute_mix as mix;
use significance::{critical, deviate};

fn mapping(name: &str, values: &[f64]) -> Mapping {
    let map = Map::from_name(name).unwrap_or_else(|error| panic!("{error}"));
    Mapping::with_values(map, values).unwrap_or_else(|error| panic!("{error}"))
}

fn cases() -> Vec<Mapping> {
    vec![
        mapping("filter-blackman-harris", &[2.0]),
        mapping("filter-blackman-harris", &[0.37]),
        mapping("filter-mitchell", &[2.0, 1.0 / 3.0, 1.0 / 3.0]),
        mapping("filter-mitchell", &[2.0, 0.0, 0.5]),
        mapping("filter-mitchell", &[0.37, 1.0, 0.0]),
        mapping("filter-mitchell", &[1.0, 1.0, 1.0]),
        mapping("filter-mitchell", &[1.0, 0.0, 0.0]),
        mapping("filter-mitchell", &[1.0, 0.2, 1e-3]),
    ]
}

/// Fractions: random ones, and those next to the ends, the middle and other dyadic numbers.
fn fractions() -> impl Iterator<Item = [u32; 2]> {
    let near = (0..32u32).flat_map(|bit| {
        (0..64u32).flat_map(move |i| {
            let u = (1u32 << bit).wrapping_add(i.wrapping_sub(32));
            [
                [u, mix(u)],
                [0u32.wrapping_sub(u), mix(!u)],
                [u, 0u32.wrapping_sub(u)],
            ]
        })
    });
    near.chain((0..100_000).map(|i| [mix(2 * i), mix(2 * i + 1)]))
}

fn sample(mapping: &Mapping, profile: Profile, u: [u32; 2]) -> [f32; 3] {
    let [x, y, pdf, _] = map_sample(mapping, profile, [u[0], u[1], 0]);
    [x, y, pdf].map(f32::from_bits)
}

fn pdf(mapping: &Mapping, x: f64, y: f64) -> f64 {
    let s = [x as f32, y as f32, 0.0].map(f32::to_bits);
    f64::from(f32::from_bits(map_pdf(mapping, Profile::Exact, s)))
}

#[test]
fn samples_are_those_of_the_judge() {
    for mapping in cases() {
        let mut worst = [0f64; 3];
        for u in fractions() {
            let got = sample(&mapping, Profile::Exact, u);
            let truth = truth(&mapping, [u[0], u[1], 0]).expect("a judge");
            for (worst, (got, truth)) in worst.iter_mut().zip(got.into_iter().zip(truth)) {
                *worst = worst.max(ulp_error(got, truth));
            }
        }
        println!("{} {worst:.3?}", mapping.map().name);
        let [x, y, pdf] = worst;
        assert!(x.max(y) < mapping.map().ulp, "{worst:?}");
        assert!(pdf < mapping.map().pdf_ulp, "{worst:?}");
    }
}

/// By the rule of midpoints, whose lines lie on the seams.
#[test]
fn pdfs_integrate_to_one_and_end_at_the_radius() {
    for mapping in cases() {
        let radius = f64::from(mapping.parameters()[0]);
        let steps = 1 << 10;
        let step = 2.0 * radius / f64::from(steps);
        let at = |i: u32| (f64::from(i) + 0.5) * step - radius;
        let row = |i: u32| (0..steps).map(|j| pdf(&mapping, at(i), at(j))).sum::<f64>();
        let mass = (0..steps).map(row).sum::<f64>() * step * step;
        assert!((mass - 1.0).abs() < 5e-6, "{} {mass}", mapping.map().name);
        let out = radius * 1.000_001;
        for (x, y) in [(out, 0.0), (0.0, -out), (out, out), (-2.0 * radius, 0.0)] {
            assert_eq!(pdf(&mapping, x, y), 0.0, "{mapping:?}");
        }
        assert!(pdf(&mapping, -0.49 * radius, 0.49 * radius) > 0.0);
    }
}

/// The pdf of a sample is that of its offset, but for what rounding the offset does.
#[test]
fn pdfs_of_samples_are_those_of_their_offsets() {
    for mapping in cases() {
        let most = pdf(&mapping, 0.0, 0.0);
        for u in fractions() {
            let [x, y, own] = sample(&mapping, Profile::Exact, u).map(f64::from);
            let away = (pdf(&mapping, x, y) - own).abs() / most;
            assert!(away < 1e-6, "{u:?}: {x} {y} {own} {away:e}");
        }
    }
}

#[test]
fn inverses_return_the_fractions() {
    for mapping in cases() {
        let mut worst = 0;
        for u in fractions() {
            let [x, y, _, _] = map_sample(&mapping, Profile::Exact, [u[0], u[1], 0]);
            let v = map_invert(&mapping, Profile::Exact, [x, y, 0]);
            worst = worst.max(u[0].abs_diff(v[0])).max(u[1].abs_diff(v[1]));
        }
        println!("{}: {worst} units", mapping.map().name);
        // A place of a coordinate is 2^-24 of the radius, at twice the mean density.
        assert!(worst <= 300, "{} {worst}", mapping.map().name);
    }
}

/// The statistic of random samples in cells of equal mass along each axis, bounded by the
/// judge's own quantiles; `bend` distorts the samples.
fn statistic(mapping: &Mapping, first: u32, samples: u32, bend: impl Fn(f64) -> f64) -> f64 {
    const CELLS: usize = 24;
    let edges: Vec<f64> = (1..CELLS)
        .map(|i| {
            let u = (i as f64 / CELLS as f64 * 4_294_967_296.0) as u32;
            truth(mapping, [u, 1, 0]).expect("a judge")[0]
        })
        .collect();
    let cell = |x: f32| edges.partition_point(|&edge| edge < bend(x.into()));
    let mut counts = vec![0; CELLS * CELLS];
    for i in first..first + samples {
        let [x, y, _] = sample(mapping, Profile::Exact, [mix(2 * i), mix(2 * i + 1)]);
        counts[cell(x) * CELLS + cell(y)] += 1;
    }
    deviate(&counts, f64::from(samples) / counts.len() as f64)
}

#[test]
fn samples_follow_their_densities() {
    let cases = cases();
    let most = critical(cases.len());
    for (i, mapping) in cases.iter().enumerate() {
        let first = 0x1000_0000 + 1_000_000 * i as u32;
        let found = statistic(mapping, first, 1_000_000, |x| x);
        println!("{} {found:.2} of {most:.2}", mapping.map().name);
        assert!(found < most, "{} {found}", mapping.map().name);
        // Samples that are 2 % of the radius off are seen.
        let off = 0.02 * f64::from(mapping.parameters()[0]);
        let bent = statistic(mapping, first, 200_000, |x| x + off);
        assert!(bent > most, "{} bent {bent}", mapping.map().name);
    }
}

#[test]
fn the_native_profile_is_as_right() {
    for mapping in cases() {
        let radius = mapping.parameters()[0];
        for u in fractions() {
            let exact = sample(&mapping, Profile::Exact, u);
            let native = sample(&mapping, Profile::Native, u);
            for i in 0..2 {
                let away = (exact[i] - native[i]).abs() / radius;
                assert!(away < 1e-6, "{u:?} {exact:?} {native:?}");
            }
            assert!(
                (native[2] / exact[2] - 1.0).abs() < 1e-5,
                "{u:?} {exact:?} {native:?}"
            );
        }
    }
}

mod window {
    use super::fractions;
    use corput::glam::{uvec2, vec2};
    use corput::reference::filter_blackman_harris::*;
    use corput::reference::native::filter_blackman_harris::*;

    #[test]
    fn degenerate_radii_give_what_the_headers_say() {
        let u = uvec2(0x1234_5678, 0x9abc_def0);
        let bad = [0.0, -0.0, -1.0, f32::NEG_INFINITY, f32::from_bits(1)];
        for r in bad {
            assert_eq!(filter_blackman_harris(r, u).p, vec2(0.0, 0.0), "{r}");
        }
        let odd = [f32::INFINITY, f32::NAN, f32::MAX, f32::MIN_POSITIVE, 1.0];
        for r in bad.into_iter().chain(odd) {
            let made = filter_blackman_harris(r, u);
            assert!(made.p.is_finite() && made.pdf.is_finite(), "{r} {made:?}");
            for x in bad.into_iter().chain(odd) {
                let p = vec2(x, -x);
                assert!(filter_blackman_harris_pdf(r, p).is_finite(), "{r} {x}");
                let _ = filter_blackman_harris_invert(r, p);
                let _ = native_filter_blackman_harris_invert(r, p);
            }
        }
    }

    /// A window without its sidelobes' end: the last fraction lies at the edge, and 1 less the
    /// mass in floats has lost it long before.
    #[test]
    fn the_edge_is_reached() {
        let [mut naive, mut ours] = [0f64; 2];
        for [u, _] in fractions().filter(|u| u[0] > 0xffff_0000) {
            let truth = corput::judge::line::filter_blackman_harris(1.0, u)[0];
            let share = (2.0 * f64::from(u) / 4_294_967_296.0 - 1.0) as f32;
            let mass = |x: f32| {
                let sine = |k: f32| (k * std::f32::consts::PI * x).sin();
                x + (0.433_247_5 * sine(1.0) + 0.062_677_1 * sine(2.0) + 0.003_454_457 * sine(3.0))
            };
            let (mut low, mut high) = (0f32, 1f32);
            for _ in 0..30 {
                let middle = 0.5 * (low + high);
                if mass(middle) < share {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            naive = naive.max((f64::from(low) - truth).abs());
            let got = filter_blackman_harris(1.0, uvec2(u, u)).p.x;
            ours = ours.max((f64::from(got) - truth).abs());
        }
        println!("{naive:e} {ours:e}");
        assert!(ours < 4e-8 && naive > 1e-4, "{naive:e} {ours:e}");
    }
}

mod signed {
    use super::fractions;
    use corput::glam::{uvec2, vec2};
    use corput::judge::line::{mitchell, mitchell_shares};
    use corput::reference::filter_mitchell::*;
    use corput::reference::native::filter_mitchell::*;
    use corput::reference::permute::permute_mix as mix;

    const PARAMETERS: [[f32; 2]; 7] = [
        [0.333_333_34, 0.333_333_34],
        [0.0, 0.5],
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [0.2, 1e-3],
        [0.9, 0.05],
    ];

    /// The parts of one side are right to 2^-31, and even.
    #[test]
    fn shares_are_those_of_the_judge() {
        let each =
            (0..4000).map(|i| [mix(2 * i), mix(2 * i + 1)].map(|u| u as f32 * 2f32.powi(-32)));
        for [b, c] in PARAMETERS.into_iter().chain(each) {
            let f = filter_mitchell_prepare(1.0, b, c);
            let [tail, lobe, total] = mitchell_shares(b.into(), c.into());
            for (got, truth) in [(f.tail, tail), (f.lobe, lobe)] {
                let away = f64::from(got) - truth * 4_294_967_296.0;
                assert!(away.abs() <= 2.0 && got % 2 == 0, "{b} {c}: {away}");
            }
            let weight = f64::from(filter_mitchell_weight(f, vec2(0.0, 0.0)));
            let truth = 4.0 * total * total;
            assert!(
                (weight / truth - 1.0).abs() < 1e-7,
                "{b} {c}: {weight} {truth}"
            );
        }
    }

    /// The pdf times the weight is the filter, whose integral is 1.
    #[test]
    fn weights_make_the_filter_of_the_pdf() {
        for [b, c] in PARAMETERS {
            let f = filter_mitchell_prepare(1.5, b, c);
            let native = native_filter_mitchell_prepare(1.5, b, c);
            let value = |x: f32| mitchell(b.into(), c.into(), f64::from(x) / 0.75) / 0.75;
            let (mut mean, mut count) = (0.0, 0.0);
            for u in fractions() {
                let p = filter_mitchell(f, uvec2(u[0], u[1])).p;
                let weight = f64::from(filter_mitchell_weight(f, p));
                let made = f64::from(filter_mitchell_pdf(f, p)) * weight;
                let truth = value(p.x) * value(p.y);
                assert!((made - truth).abs() < 1e-6, "{b} {c} {p}: {made} {truth}");
                let other = f64::from(native_filter_mitchell_weight(native, p));
                // Next to the change of sign either is right.
                assert!(
                    (other - weight).abs() < 1e-6 || truth.abs() < 1e-5,
                    "{b} {c} {p}"
                );
            }
            for i in 0..1u32 << 16 {
                let u = uvec2((i << 16) | 0x8000, (i.wrapping_mul(40_503) << 16) | 0x8000);
                mean += f64::from(filter_mitchell_weight(f, filter_mitchell(f, u).p));
                count += 1.0;
            }
            assert!(
                (mean / count - 1.0).abs() < 2e-3,
                "{b} {c}: {}",
                mean / count
            );
        }
        let f = filter_mitchell_prepare(1.0, 0.0, 0.5);
        assert!(filter_mitchell_weight(f, vec2(0.75, 0.0)) < 0.0);
        assert_eq!(filter_mitchell_weight(f, vec2(1.1, 0.0)), 0.0);
    }

    #[test]
    fn degenerate_parameters_give_what_the_headers_say() {
        let u = uvec2(0x1234_5678, 0x9abc_def0);
        let bad = [0.0, -0.0, -1.0, f32::NEG_INFINITY, f32::from_bits(1)];
        let odd = [
            f32::INFINITY,
            f32::NAN,
            f32::MAX,
            f32::MIN_POSITIVE,
            1.0,
            1e-20,
        ];
        for r in bad {
            let f = filter_mitchell_prepare(r, 0.3, 0.4);
            assert_eq!(filter_mitchell(f, u).p, vec2(0.0, 0.0), "{r}");
        }
        assert_eq!(
            filter_mitchell_prepare(1.0, -1.0, 7.0),
            filter_mitchell_prepare(1.0, 0.0, 1.0)
        );
        for r in bad.into_iter().chain(odd) {
            for b in bad.into_iter().chain(odd) {
                for c in bad.into_iter().chain(odd) {
                    let f = filter_mitchell_prepare(r, b, c);
                    for u in [u, uvec2(0, u32::MAX), uvec2(1 << 31, 1)] {
                        let made = filter_mitchell(f, u);
                        assert!(
                            made.p.is_finite() && made.pdf.is_finite(),
                            "{r} {b} {c} {made:?}"
                        );
                        let _ = native_filter_mitchell(native_filter_mitchell_prepare(r, b, c), u);
                    }
                    for x in bad.into_iter().chain(odd) {
                        let p = vec2(x, -x);
                        assert!(filter_mitchell_pdf(f, p).is_finite(), "{r} {b} {c} {x}");
                        assert!(filter_mitchell_weight(f, p).is_finite(), "{r} {b} {c} {x}");
                        let _ = filter_mitchell_invert(f, p);
                    }
                }
            }
        }
    }
}
