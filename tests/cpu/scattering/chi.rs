//! A million samples of each lobe in cells of equal probability: those of the judge's own
//! inverse, which for visible normals is that of the other method.

use super::lobes::{Kind, Lobe};
use super::significance::{critical, deviate};
use corput::glam::{UVec2, uvec2};
use corput::reference::permute::permute_mix as mix;

const SAMPLES: u32 = 1_000_000;
const SIDE: usize = 32;

/// Along the normal, oblique, nearly grazing.
const VIEWS: [[f32; 3]; 3] = [
    [0.0, 0.0, 1.0],
    [-0.48, 0.6, 0.64],
    [0.999_999_5, 0.0, 1e-3],
];

const ALPHAS: [[f32; 2]; 5] = [[1.0; 2], [0.3; 2], [1e-2; 2], [1e-3; 2], [0.1, 0.5]];

fn lobes() -> Vec<Lobe> {
    let mut list: Vec<Lobe> = [1.0, 0.5, 1e-2, 1e-6]
        .into_iter()
        .map(|rest| Lobe::henyey_greenstein(rest, rest < 0.1))
        .collect();
    for (i, alpha) in ALPHAS.into_iter().enumerate() {
        for (j, wo) in VIEWS.into_iter().enumerate() {
            // Each alpha and each view with each map, but not all of all.
            for (k, kind) in [Kind::Vndf, Kind::Cap, Kind::Bounded, Kind::Normal]
                .into_iter()
                .enumerate()
            {
                if kind == Kind::Vndf || (i + j + k) % 2 == 0 {
                    list.push(Lobe::ggx(kind, alpha, wo));
                }
            }
        }
    }
    list
}

/// The fractions that the judge gives a direction.
fn fractions(lobe: &Lobe, d: [f64; 3]) -> [f64; 2] {
    match lobe.kind {
        Kind::HenyeyGreenstein => {
            corput::judge::henyey_greenstein_fractions(lobe.rest, lobe.backward, d)
        }
        Kind::Normal => lobe.judge().normal_fractions(d),
        _ => lobe.judge().cap_fractions(d),
    }
}

/// The deviate of the counts of samples in the cells of the judge.
fn deviation(lobe: &Lobe, samples: u32, sample: impl Fn(&Lobe, UVec2) -> [f64; 3]) -> f64 {
    let mut counts = vec![0u32; SIDE * SIDE];
    for i in 0..samples {
        let u = uvec2(mix((2 * i) ^ 0x5bd1_e995), mix(2 * i + 1));
        let [x, y] =
            fractions(lobe, sample(lobe, u)).map(|v| ((v * SIDE as f64) as usize).min(SIDE - 1));
        counts[SIDE * y + x] += 1;
    }
    deviate(&counts, f64::from(samples) / (SIDE * SIDE) as f64)
}

/// The direction, its largest coordinate from the other two: near an axis they say more, and
/// of a lobe nearly along it the largest has a few values only.
fn ours(lobe: &Lobe, u: UVec2) -> [f64; 3] {
    let mut d = lobe.sample(u).direction.to_array().map(f64::from);
    let largest = (0..3)
        .max_by(|&a, &b| d[a].abs().total_cmp(&d[b].abs()))
        .unwrap_or(2);
    let others: f64 = (0..3).filter(|&k| k != largest).map(|k| d[k] * d[k]).sum();
    d[largest] = (1.0 - others).max(0.0).sqrt().copysign(d[largest]);
    d
}

#[test]
fn a_million_samples_fall_where_the_pdf_says() {
    let lobes = lobes();
    let limit = critical(lobes.len());
    let half = lobes.len() / 2;
    let over = |part: &[Lobe]| -> Vec<f64> {
        part.iter()
            .map(|lobe| deviation(lobe, SAMPLES, ours))
            .collect()
    };
    let found = std::thread::scope(|scope| {
        let first = scope.spawn(|| over(&lobes[..half]));
        let second = over(&lobes[half..]);
        let mut all = first.join().expect("no panic");
        all.extend(second);
        all
    });
    for (lobe, deviate) in lobes.iter().zip(found) {
        println!("{lobe:?}: {deviate:.2} of {limit:.2}");
        assert!(deviate < limit, "{lobe:?}: {deviate}");
    }
}

/// Heitz's disk without its lerp, a cap over the whole sphere, and reflections at all normals
/// rather than visible ones are refused.
#[test]
fn wrong_distributions_are_refused() {
    let limit = critical(60);
    let (alpha, wo) = ([0.3f32; 2], VIEWS[1]);
    let other =
        |kind, alpha, wo: [f32; 3]| move |_: &Lobe, u: UVec2| ours(&Lobe::ggx(kind, alpha, wo), u);
    let right = Lobe::ggx(Kind::Cap, alpha, wo);
    let samples = 1 << 16;
    let cases: [(&str, f64); 4] = [
        (
            "a rougher lobe",
            deviation(&right, samples, other(Kind::Cap, [0.36; 2], wo)),
        ),
        (
            "the bounded cap in place of the whole",
            deviation(&right, samples, other(Kind::Bounded, alpha, wo)),
        ),
        (
            "a cap from the equator up",
            deviation(&right, samples, |lobe, u| {
                // Of the cap's heights only those above 0.
                let view = 1.0 / 1.5;
                let half = (f64::from(u.x) * view) as u32;
                ours(lobe, uvec2(half, u.y))
            }),
        ),
        (
            "all normals as seen from above",
            deviation(&right, samples, |_, u| {
                let h = Lobe::ggx(Kind::Normal, alpha, [0.0, 0.0, 1.0]).sample(u);
                let (h, o) = (
                    h.direction.as_dvec3(),
                    corput::glam::Vec3::from(wo).as_dvec3(),
                );
                (2.0 * o.dot(h) * h - o).to_array()
            }),
        ),
    ];
    for (what, deviate) in cases {
        println!("{what}: {deviate:.1}");
        assert!(deviate > limit, "{what}: {deviate}");
    }
}
