//! Means over samples against integrals of the judge's pdf: moments and half-spaces.
//! Coordinates count from the middle of the distribution in units of its width. Where tails
//! reach far beyond that, as those of GGX do, powers have no spread that a mean could be
//! judged by; hence also functions that are like them in the middle and bounded beyond.

use super::laws::{Case, axes, case, cases, each, random};
use super::quadrature::integrate;
use super::significance::critical;
use corput::glam::{DVec2, DVec3, dvec2, dvec3};

const SAMPLES: u32 = 100_000;

/// Moments: bounded ones, and then powers.
const BOUNDED: usize = 7;
const ALL: usize = 14;

/// Directions of half-spaces, in turns.
const HALVES: [f64; 3] = [0.03, 0.39, 0.78];

/// Powers are judged where the domain ends within so many widths.
const FAR: f64 = 30.0;

/// Coordinates of points, in which the distribution is about as wide as 1.
pub struct Frame {
    middle: DVec3,
    axes: [DVec3; 3],
}

impl Frame {
    /// By samples of the judge: their mean, and their mean distances from it.
    pub fn new(case: &Case) -> Self {
        let points: Vec<DVec3> = (0..1000)
            .filter_map(|i| Some(case.truth(random(4242, i))?.0))
            .collect();
        let mean = |f: &dyn Fn(DVec3) -> DVec3| {
            points.iter().map(|x| f(*x)).sum::<DVec3>() / points.len() as f64
        };
        let middle = mean(&|x| x);
        let directions = match case.mapping.map().coordinates {
            3 => axes(middle.normalize()),
            _ => [DVec3::X, DVec3::Y, DVec3::Z],
        };
        let axes = directions.map(|axis| {
            let width = mean(&|x| DVec3::splat(axis.dot(x - middle).abs())).x;
            // Of narrow lobes, what is along them is rounding.
            if width > 1e-3 * mean(&|x| (x - middle).abs()).length() {
                axis / width
            } else {
                DVec3::ZERO
            }
        });
        Self { middle, axes }
    }

    pub fn coordinates(&self, x: DVec3) -> DVec3 {
        let away = x - self.middle;
        dvec3(
            self.axes[0].dot(away),
            self.axes[1].dot(away),
            self.axes[2].dot(away),
        )
    }
}

fn moments(y: DVec3) -> [f64; ALL] {
    let wide = |x: f64| 1.0 + x * x;
    [
        y.x / wide(y.x).sqrt(),
        y.y / wide(y.y).sqrt(),
        y.z / wide(y.z).sqrt(),
        wide(y.x).recip(),
        wide(y.y).recip(),
        wide(y.z).recip(),
        y.x * y.y / (wide(y.x) + y.y * y.y),
        y.x,
        y.y,
        y.z,
        y.x * y.x,
        y.y * y.y,
        y.z * y.z,
        y.x * y.y,
    ]
}

/// Places of a chart up to its edges, and all but there.
pub fn edges() -> impl Iterator<Item = DVec2> {
    let near = |k: i32| 1.0 - 0.5f64.powi(k);
    (0..=60).flat_map(move |k| (0..16).map(move |i| dvec2(near(k), f64::from(i) / 15.0)))
}

/// The integrals over the chart, in parts lest one overlooks a lobe.
pub fn whole<const N: usize>(
    case: &Case,
    pdf: &dyn Fn(DVec3) -> f64,
    values: &dyn Fn(DVec3) -> [f64; N],
    tolerance: f64,
) -> [f64; N] {
    const PARTS: usize = 8;
    let rows = if case.line() { 1 } else { PARTS };
    let mut all = [0.0; N];
    for k in 0..PARTS * rows {
        let from = dvec2((k % PARTS) as f64, (k / PARTS) as f64) / PARTS as f64;
        let part = [from, from + DVec2::splat(1.0 / PARTS as f64)];
        let found = integrate(case, pdf, values, part, tolerance);
        all = std::array::from_fn(|i| all[i] + found[i]);
    }
    all
}

/// Of each moment, how many deviations the mean over samples is off its integral.
fn moment_deviates(case: &Case, seed: u64, sample: &dyn Fn([u32; 2]) -> DVec3) -> Vec<f64> {
    let frame = Frame::new(case);
    let ends = edges().map(|t| frame.coordinates(case.law.at(t)).abs().max_element());
    let judged = if ends.fold(0.0, f64::max) < FAR {
        ALL
    } else {
        BOUNDED
    };
    let values = |x: DVec3| {
        let mut of = moments(frame.coordinates(x));
        of[judged..].fill(0.0);
        of
    };
    let truth = whole(case, &|x| case.law.pdf(x), &values, 1e-6);
    let mut sums = [[0.0; ALL]; 2];
    for i in 0..SAMPLES {
        let of = values(sample(random(seed, i)));
        for k in 0..judged {
            sums[0][k] += of[k];
            sums[1][k] += (of[k] - truth[k]).powi(2);
        }
    }
    let total = f64::from(SAMPLES);
    let off = |k: usize| {
        let deviation = (sums[1][k] / total / total).sqrt();
        // What quadrature and the rounding of samples leave.
        (sums[0][k] / total - truth[k]).abs() / (deviation + 1e-5)
    };
    (0..judged).map(off).collect()
}

/// Of half-spaces through the middle, how many deviations the count of samples is off.
fn half_deviates(case: &Case, seed: u64, sample: &dyn Fn([u32; 2]) -> DVec3) -> Vec<f64> {
    let frame = Frame::new(case);
    let inside = |y: DVec3, turns: f64| {
        let (s, c) = (std::f64::consts::TAU * turns).sin_cos();
        f64::from(u8::from(c * y.x + s * y.y + 0.1 * y.z > 0.05))
    };
    let values = |x: DVec3| HALVES.map(|turns| inside(frame.coordinates(x), turns));
    let truth = whole(case, &|x| case.law.pdf(x), &values, 1e-6);
    let mut sums = [0.0; HALVES.len()];
    for i in 0..SAMPLES {
        let of = values(sample(random(seed, i)));
        sums = std::array::from_fn(|k| sums[k] + of[k]);
    }
    let total = f64::from(SAMPLES);
    let off = |k: usize| {
        let spread = truth[k] * (1.0 - truth[k]);
        (sums[k] / total - truth[k]).abs() / (spread / total).sqrt()
    };
    (0..HALVES.len()).map(off).collect()
}

/// The deviate that none of so many exceeds by chance, on either side.
pub fn limit(tests: usize) -> f64 {
    critical(2 * tests)
}

fn judge(what: &str, found: impl Fn(u64, &Case) -> Vec<f64> + Sync) {
    let cases = cases();
    let found = each(&cases, found);
    let limit = limit(found.iter().map(Vec::len).sum());
    let mut worst: f64 = 0.0;
    for (case, all) in cases.iter().zip(found) {
        for (k, off) in all.into_iter().enumerate() {
            assert!(
                off < limit,
                "{}: {what} {k} {off:.2} of {limit:.2}",
                case.name()
            );
            worst = worst.max(off);
        }
    }
    println!("{what}: {worst:.2} of {limit:.2}");
}

#[test]
fn moments_are_those_of_the_pdf() {
    judge("moment", |seed, case| {
        moment_deviates(case, 1000 + seed, &|u| case.sample(u))
    });
}

#[test]
fn half_spaces_have_the_samples_that_the_pdf_gives_them() {
    judge("half-space", |seed, case| {
        half_deviates(case, 2000 + seed, &|u| case.sample(u))
    });
}

/// Samples of half of the domain, and samples that are all a tenth of a width off.
#[test]
fn broken_samples_are_refused() {
    let limit = limit(cases().len() * ALL);
    let most = |all: Vec<f64>| all.into_iter().fold(0.0, f64::max);
    for (name, values) in [
        ("uniform-sphere", &[][..]),
        ("cone", &[1e-4]),
        ("ggx-vndf", &[1e-4, 0.0, -0.48, 0.6, 0.64]),
        ("box-muller", &[1.0]),
        ("exponential", &[1.0]),
    ] {
        let case = case(name, values);
        let frame = Frame::new(&case);
        let sound = |u| case.sample(u);
        let half = |[a, b]: [u32; 2]| case.sample([a >> 1, b >> 1]);
        let step = 0.1 * frame.axes[0] / frame.axes[0].length_squared();
        let moved = |u| case.sample(u) + step;
        for deviates in [moment_deviates, half_deviates] {
            let broken: [&dyn Fn([u32; 2]) -> DVec3; 2] = [&half, &moved];
            let found = broken.map(|sample| most(deviates(&case, 5, sample)));
            let passed = most(deviates(&case, 5, &sound));
            println!("{name}: {passed:.1} {found:.1?} of {limit:.1}");
            assert!(passed < limit, "{name}: {passed}");
            assert!(found.iter().all(|off| *off > limit), "{name}: {found:?}");
        }
    }
}
