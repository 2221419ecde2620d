//! Integrands with a choice of estimators: what each may give, what they cost, and the
//! truths by other methods.

use corput::bulk::{estimate, integrand_term};
use corput::catalog::{
    Integrand, LightMap, MIS, Options, Problem, Request, Scramble, Sequence, examples, integrands,
};
use corput::environment::Weight;
use corput::estimate::Estimate;
use corput::irradiance::irradiance;
use corput::reference::permute::permute_mix as mix;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

fn problem(text: &str) -> Problem {
    Problem::parse(text).unwrap_or_else(|error| panic!("{error}"))
}

fn by(problem: &Problem, name: &str) -> Problem {
    let other = problem.with_estimator(name);
    other.unwrap_or_else(|error| panic!("{error}"))
}

fn sums(problem: &Problem, sequence: Sequence, seed: u64, count: u64) -> Estimate {
    let request = Request::new(&Options {
        dimensions: Some(problem.dimensions().into()),
        seed: Some(seed),
        scramble: (sequence == Sequence::Sobol).then_some(Scramble::OwenHash),
        fractions: true,
        ..Options::new(sequence, count)
    });
    let request = request.unwrap_or_else(|error| panic!("{error}"));
    estimate(problem, &request, 0, count).unwrap_or_else(|error| panic!("{error}"))
}

/// Problems of every integrand that has a choice.
fn chosen() -> impl Iterator<Item = Problem> {
    let all = integrands().filter(|one| !one.estimators.is_empty());
    all.flat_map(|one| examples(one).unwrap_or_else(|error| panic!("{error}")))
}

fn sunrise(axis: &str) -> Problem {
    problem(&format!(
        "irradiance:map=tests/data/sunrise.exr,axis={axis}"
    ))
}

#[test]
fn estimators_are_chosen_by_name() {
    let sunrise = sunrise("-x");
    assert_eq!(sunrise.estimator(), Some("uniform"));
    assert_eq!(sunrise.values(), [1.0]);
    let mut ids = Vec::new();
    for name in sunrise.integrand().estimators {
        let one = by(&sunrise, name);
        assert_eq!(one.estimator(), Some(*name));
        assert_eq!(one.dimensions(), if *name == MIS { 3 } else { 2 });
        assert_eq!(one.truth(), sunrise.truth());
        assert_eq!(by(&one, "uniform"), sunrise);
        ids.push(one.id());
    }
    assert_eq!(ids, [64, 65, 66, 67]);
    let plain = problem("x-squared");
    assert_eq!(plain.estimator(), None);
    let mut ids: Vec<u32> = chosen().map(|one| one.id()).collect();
    ids.sort_unstable();
    ids.dedup();
    let known = integrands().map(|one| one.estimators.len()).sum::<usize>();
    assert_eq!(ids.len(), known, "an id twice");
    for (problem, name, words) in [
        (&sunrise, "enviroment", "did you mean `environment`"),
        (&plain, "uniform", "it has only one"),
    ] {
        let error = problem.with_estimator(name).expect_err(name);
        assert_eq!(error.exit_code(), 2, "{name}");
        assert!(error.to_string().contains(words), "{error}");
    }
}

#[test]
fn maps_and_axes_are_refused_in_words() {
    for (text, words) in [
        ("irradiance", "map is not given"),
        ("irradiance:map=tests/data/none.exr", "none.exr"),
        ("irradiance:map=tests/data/README.md", "README.md"),
        (
            "irradiance:map=tests/data/sunrise.exr,axis=up",
            "one of +x, -x, +y, -y, +z, -z",
        ),
        (
            "irradiance:map=tests/data/sunrise.exr,map=b.exr",
            "given twice",
        ),
        ("x-squared:map=tests/data/sunrise.exr", "no key=number"),
        (
            "polygon-irradiance:elevation=0.2,radius=0.3",
            "at most the elevation",
        ),
        ("ggx-furnace:alpha=0.01", "from 0.1 to 1"),
        ("ggx-lobe:alpha=0.0001", "from 0.001 to 1"),
        (
            "ggx-lobe:cosine=0.1,radius=0.2,offset=0",
            "above the horizon",
        ),
        ("ggx-lobe:radius=0.1,offset=30", "above the horizon"),
        ("soft-shadow:edge=2", "from -1.04 to 1.04"),
        ("pixel-edge:radius=0.1", "from 0.25 to 16"),
        ("gaussian-peak:sigma=2", "from 1e-6 to 1"),
    ] {
        let error = Problem::parse(text).expect_err(text);
        assert_eq!(error.exit_code(), 2, "{text}");
        assert!(error.to_string().contains(words), "{text}: {error}");
    }
    let irradiance = Integrand::from_name("irradiance").expect("one");
    let plain = Integrand::from_name("x-squared").expect("one");
    let map = LightMap::new("two", 2, 1, &[[1.0, 0.0, 0.0], [f32::NAN; 3]]);
    let map = Arc::new(map.unwrap_or_else(|error| panic!("{error}")));
    assert!(Problem::with_map(plain, &[], Some(Arc::clone(&map))).is_err());
    for axis in [-1.0, 0.5, 6.0, f64::NAN] {
        let refused = Problem::with_map(irradiance, &[("axis", axis)], Some(Arc::clone(&map)));
        assert!(refused.is_err(), "{axis}");
    }
    assert!(LightMap::new("black", 2, 1, &[[0.0; 3]; 2]).is_err());
    assert!(LightMap::new("short", 2, 2, &[[1.0; 3]; 2]).is_err());
    assert_eq!(map.luminances(), [0.2126, 0.0]);
}

/// Far from a sharp lobe visible normals meet a small light too seldom for the unit of their
/// terms; directions of the light do.
#[test]
fn means_below_the_unit_of_terms_are_refused() {
    let far = problem("ggx-lobe:alpha=0.001,radius=0.001,cosine=0.5,offset=800");
    assert!(far.with_estimator("light").is_ok());
    let error = far.with_estimator("ggx").expect_err("a mean of 1e-12");
    assert_eq!(error.exit_code(), 2);
    assert!(error.to_string().contains("2^-34"), "{error}");
}

/// No term is above the peak of its estimator, and none is below 0, where the unit of terms
/// would not hold it.
#[test]
fn peaks_are_upper_bounds() {
    const POINTS: u32 = 20_000;
    for problem in chosen() {
        let unit = f64::powi(2.0, -problem.coefficients().scale);
        let peak = problem.coefficients().peak;
        let mut largest = 0f64;
        for n in 0..POINTS {
            let coordinate = |j| match n % 4 {
                // Near the ends, where peaks are.
                0 => mix(n ^ (j << 20)) >> 24,
                1 => !(mix(n ^ (j << 20)) >> 24),
                _ => mix(n ^ (j << 20)),
            };
            let point: Vec<u32> = (0..problem.dimensions()).map(coordinate).collect();
            let term = integrand_term(&problem, &point);
            assert!(!term.negative || term.m == corput::glam::UVec2::ZERO);
            let value = (u64::from(term.m.x) | u64::from(term.m.y) << 32) as f64 * unit;
            largest = largest.max(value);
        }
        let name = problem.integrand().name;
        let text = format!("{name} {:?} {:?}", problem.estimator(), problem.values());
        assert!(largest <= peak, "{text}: {largest}, not at most {peak}");
        // A unit of 2^-63 of 10^5 times the largest is still below the terms' errors. Of a map
        // the peak counts all texels, whether the surface sees them or not; and a peak of 1e-6
        // is not met.
        let told = problem.map().is_some() || largest >= 1e-5 * peak || largest == 0.0;
        assert!(told, "{text}: {largest} of {peak}");
    }
}

/// What each technique is for: the variance by independent points, as a share of the worst.
#[test]
fn importance_lowers_the_variance() {
    let spread = |problem: &Problem| {
        let sums = sums(problem, Sequence::Random, 5, 1 << 14);
        sums.variance().expect("points")
    };
    for (text, better, worse, factor) in [
        (
            "irradiance:map=tests/data/sunrise.exr",
            "environment",
            "cosine",
            100.0,
        ),
        (
            "irradiance:map=tests/data/sunrise.exr",
            "mis",
            "cosine",
            100.0,
        ),
        ("cosine-irradiance:gradient=1", "cosine", "uniform", 5.0),
        ("polygon-irradiance", "light", "cosine", 20.0),
        ("polygon-irradiance", "mis", "uniform", 2.0),
        ("ggx-furnace", "visible-normals", "cosine", 20.0),
        ("gaussian-peak", "normal", "uniform", 1e5),
        ("henyey-greenstein", "phase", "uniform", 3.0),
        ("soft-shadow", "light", "cosine", 5.0),
        ("soft-shadow", "mis", "cosine", 4.0),
        ("ggx-lobe", "ggx", "light", 5.0),
        ("ggx-lobe", "mis", "uniform", 100.0),
        ("ggx-lobe:alpha=0.5,radius=0.01", "light", "ggx", 100.0),
        ("ggx-lobe:alpha=0.5,radius=0.01", "mis", "ggx", 100.0),
        ("defocus-disk", "concentric", "square", 1.05),
        ("pixel-edge", "filter", "uniform", 3.0),
    ] {
        let problem = problem(text);
        let (good, bad) = (spread(&by(&problem, better)), spread(&by(&problem, worse)));
        assert!(
            factor * good < bad,
            "{text}: {better} {good}, {worse} {bad}"
        );
    }
    // The importance of a peak within the cube is the peak: each term is the integral.
    let peak = by(&problem("gaussian-peak"), "normal");
    let one = sums(&peak, Sequence::Random, 1, 1 << 12);
    assert_eq!(one.variance(), Some(0.0));
    let mean = one.mean().expect("points");
    assert!((mean / peak.truth() - 1.0).abs() < 1e-9, "{mean}");
}

/// Each integrand has an estimator that finds its integral to a thousandth, and tells it
/// from one that is half a percent off.
#[test]
fn the_best_estimators_tell_half_a_percent() {
    for integrand in integrands().filter(|one| !one.estimators.is_empty()) {
        let list = examples(integrand).unwrap_or_else(|error| panic!("{error}"));
        let off = |problem: &Problem| {
            let mean = sums(problem, Sequence::Sobol, 3, 1 << 14).mean();
            (mean.expect("points") / problem.truth() - 1.0).abs()
        };
        let first = &list[..integrand.estimators.len()];
        let best = first.iter().map(off).fold(f64::INFINITY, f64::min);
        assert!(best < 1e-3, "{}: {best}", integrand.name);
    }
}

/// The irradiance of luminances against the luminance of irradiances, which rounds no texel.
#[test]
fn the_truth_under_a_map_is_the_exact_sum() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/sunrise.exr");
    let image = corput::image::load(&path).unwrap_or_else(|error| panic!("{error}"));
    for (axis, normal) in [
        ("+x", [1.0, 0.0, 0.0]),
        ("-y", [0.0, -1.0, 0.0]),
        ("+z", [0.0, 0.0, 1.0]),
    ] {
        let [r, g, b] = irradiance(image.width, image.height, &image.texels, normal);
        let wanted = 0.2126 * r + 0.7152 * g + 0.0722 * b;
        let found = sunrise(axis).truth();
        assert!(
            (found / wanted - 1.0).abs() < 6e-8,
            "{axis}: {found}, not {wanted}"
        );
    }
    assert_eq!(Weight::Luminance.of([0.0, 1.0, 0.0]), 0.7152);
}

/// The middles of cells in z and azimuth, so many of each.
fn hemisphere(cells: u32, of: impl Fn([f64; 3]) -> f64) -> f64 {
    let n = f64::from(cells);
    let mut sum = 0.0;
    for i in 0..cells {
        let z = (f64::from(i) + 0.5) / n;
        let radius = (1.0 - z * z).sqrt();
        for j in 0..cells {
            let (sine, cosine) = (TAU * (f64::from(j) + 0.5) / n).sin_cos();
            sum += of([radius * cosine, radius * sine, z]);
        }
    }
    sum * TAU / (n * n)
}

/// The probability that x cos + y sin is below an offset, for x and y of tents of radius 1,
/// each the sum of two uniform numbers from -1/2 to 1/2: with s the sum of widths a, a, b, b,
/// the alternating sum over their subsets of (offset + s/2 - subset)_+^4 / (4! a^2 b^2).
fn spline(angle: f64, offset: f64) -> f64 {
    // Floats, as the kernel has them.
    let [a, b, offset] =
        [angle.cos().abs(), angle.sin().abs(), offset].map(|x| f64::from(x as f32));
    let mut sum = 0.0;
    for (i, ways) in [(0.0, 1.0), (1.0, -2.0), (2.0, 1.0)] {
        for (j, others) in [(0.0, 1.0), (1.0, -2.0), (2.0, 1.0)] {
            let rest = offset + (a + b) - i * a - j * b;
            sum += ways * others * rest.max(0.0).powi(4);
        }
    }
    sum / (24.0 * a * a * b * b)
}

/// Closed forms and quadratures against midpoints over the hemisphere, and published or
/// separately computed values.
#[test]
fn truths_are_found_by_other_methods() {
    let near = |text: &str, wanted: f64, share: f64| {
        let truth = problem(text).truth();
        let off = (truth / wanted - 1.0).abs();
        assert!(off < share, "{text}: {truth}, not {wanted}");
        // The same comparison sees the thousandth part.
        assert!(share < 1e-3);
    };
    // Simpson's rule in r with 2^17 and more steps; the first two are Keister's own.
    for (d, wanted) in [
        (1, 1.380_388_447_043_143),
        (2, 1.808_186_429_263_62),
        (3, 2.168_309_102_165_481),
        (5, 1.135_323_991_012_492),
        (8, -30.609_075_003_558_56),
        (20, -82_757.010_806_261_5),
    ] {
        near(&format!("keister:d={d}"), wanted, 1e-12);
    }
    near("cosine-irradiance:gradient=2", PI * 7.0 / 3.0, 1e-15);
    near("defocus-disk:offset=0", 0.5, 1e-12);
    near(
        "soft-shadow:edge=0",
        0.5 * PI * 0.3f64.sin().powi(2) * 0.8f64.sin(),
        1e-6,
    );
    near(
        "soft-shadow:edge=0.999,radius=0.5",
        PI * 0.5f64.sin().powi(2) * 0.8f64.sin(),
        1e-4,
    );
    // Of an edge along an axis the share of one tent; through the middle a half; in general
    // the sum of four independent uniform numbers, whose distribution is a spline.
    near(
        "pixel-edge:angle=0,offset=0.25",
        1.0 - 0.5 * 0.75 * 0.75,
        1e-12,
    );
    near("pixel-edge:offset=0,angle=1.1", 0.5, 1e-12);
    near("pixel-edge:offset=-1,radius=2", spline(0.4, -0.5), 1e-11);
    for angle in [0.3, 0.9, 2.0, 3.0, 4.4, 5.9] {
        for offset in [-0.8, -0.2, 0.1, 0.5, 1.1] {
            let text = format!("pixel-edge:angle={angle},offset={offset}");
            near(&text, spline(angle, offset), 1e-11);
        }
    }
    let wo = [0.75f64.sqrt(), 0.0, 0.5];
    let stretch = |z: f64| (0.09 * (1.0 - z * z) + z * z).sqrt();
    let furnace = hemisphere(1500, |wi| {
        let h = [0, 1, 2].map(|i| wo[i] + wi[i]);
        let length = h.iter().map(|x| x * x).sum::<f64>();
        let cosine = h[2] * h[2] / length;
        let density = 0.09 / (PI * (1.0 + (0.09 - 1.0) * cosine).powi(2));
        density * wi[2] / (2.0 * (wi[2] * stretch(wo[2]) + wo[2] * stretch(wi[2])))
    });
    near("ggx-furnace:alpha=0.3,cosine=0.5", furnace, 2e-5);
    // The slab's integral over the sphere by its cosine alone, of the pdf.
    let steps = 1 << 16;
    let phase: f64 = (0..steps)
        .map(|k| -1.0 + 2.0 * (f64::from(k) + 0.5) / f64::from(steps))
        .map(|z| (1.0 - 0.64) / (1.0 + 0.64 - 1.6 * z).powf(1.5) * (1.0 + z))
        .sum::<f64>()
        / f64::from(steps);
    near(
        "henyey-greenstein:g=0.8,depth=2",
        phase * (1.0 - (-2f64).exp()),
        1e-6,
    );
}

/// The highlight by rays through the slopes of its normals against brute force over the light,
/// which has no formula in common with it: sharp lobes and blunt, lights that hide the lobe's
/// peak, touch it, miss it and touch the horizon.
#[test]
fn highlights_are_found_by_brute_force() {
    for values in [
        [0.02, 0.6, 0.1, 0.5],
        [0.001, 0.9, 0.02, 0.99],
        [0.001, 0.1, 0.05, 1.01],
        [0.05, 1.0, 1.5, 0.0],
        [0.001, 0.5, 0.001, 300.0],
        [0.05, 0.3, 0.304_692_654, 0.0],
        [1.0, 0.1, 0.1, 0.0],
        [1.0, 0.7, 0.001, -500.0],
    ] {
        let integrand = Integrand::from_name("ggx-lobe").expect("one");
        let found = Problem::with_values(integrand, &values, 2);
        let truth = found.unwrap_or_else(|error| panic!("{error}")).truth();
        let wanted = corput::judge::highlight(&values);
        let off = |truth: f64| (truth / wanted - 1.0).abs();
        assert!(off(truth) < 1e-10, "{values:?}: {truth}, not {wanted}");
        // Brute force tells a lobe, and a light, that are a millionth wider.
        for wider in [0, 2] {
            let mut other = values;
            other[wider] *= if other[wider] == 1.0 {
                1.0 - 1e-6
            } else {
                1.0 + 1e-6
            };
            if let Ok(found) = Problem::with_values(integrand, &other, 2) {
                assert!(off(found.truth()) > 1e-10, "{values:?} {wider}");
            }
        }
    }
}
