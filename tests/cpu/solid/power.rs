//! Powers of the cosine.

use super::significance::{critical, deviate};
use super::tools::{grid, random, relative, turn_distance, unit};
use corput::glam::{UVec2, Vec3, uvec2, vec3};
use corput::judge::{spherical, ulp_error};
use corput::reference::cosine_power::*;
use corput::reference::hemisphere::{cosine_hemisphere_polar, uniform_hemisphere_pdf};
use corput::reference::native::cosine_power::*;

/// Exponents: uniform, next to it, ordinary, narrow.
const EXPONENTS: [f32; 9] = [0.0, 1e-6, 0.3, 1.0, 2.0, 50.0, 1e3, 1e6, 1e9];

fn direction(n: f32, u: UVec2) -> Vec3 {
    cosine_power(cosine_power_prepare(n), u).direction
}

fn pdf(n: f32, d: Vec3) -> f64 {
    cosine_power_pdf(cosine_power_prepare(n), d).into()
}

#[test]
fn samples_are_those_of_the_judge() {
    let mut worst = [0f64; 4];
    for n in EXPONENTS {
        for u in grid().into_iter().chain(random(20_000)) {
            let made = cosine_power(cosine_power_prepare(n), u);
            let truth = spherical::cosine_power(n.into(), u.to_array());
            let [x, y, z] = made.direction.to_array();
            for (worst, (got, truth)) in worst
                .iter_mut()
                .zip([x, y, z, made.pdf].into_iter().zip(truth))
            {
                *worst = worst.max(ulp_error(got, truth));
            }
        }
    }
    println!("{worst:.3?}");
    assert!(worst.iter().all(|&e| e < 0.6), "{worst:?}");
}

#[test]
fn the_first_power_is_the_cosine_weighted_hemisphere() {
    for u in grid() {
        let away = direction(1.0, u) - cosine_hemisphere_polar(u);
        assert!(away.length() < 2e-7, "{u}: {away}");
    }
}

/// The pdf of a rounded direction, and what a formula by z alone makes of it.
#[test]
fn the_pdf_of_a_direction_is_well_conditioned() {
    let (mut worst, mut by_z) = (0f64, 0f64);
    for n in EXPONENTS {
        for u in grid().into_iter().chain(random(20_000)) {
            let d = direction(n, u);
            let truth = spherical::cosine_power(n.into(), u.to_array())[3];
            worst = worst.max(relative(pdf(n, d), truth));
            let naive =
                (f64::from(n) + 1.0) / std::f64::consts::TAU * f64::from(d.z).powf(f64::from(n));
            by_z = by_z.max(relative(naive, truth));
        }
    }
    println!("{worst:e} {by_z:e}");
    assert!(worst < 20.0 * 2f64.powi(-23), "{worst:e}");
    assert!(by_z > 0.1, "{by_z:e}");
}

#[test]
fn pdfs_vanish_below_the_horizon_and_integrate_to_one() {
    for n in EXPONENTS {
        assert_eq!(pdf(n, vec3(0.6, 0.0, -0.8)), 0.0);
        // By the rule of midpoints over the versine that a power of its fraction stretches.
        let widest = (60.0 / (f64::from(n) + 1.0)).min(1.0);
        let steps = 1 << 16;
        let mass: f64 = (0..steps)
            .map(|i| {
                let s = (f64::from(i) + 0.5) / f64::from(steps);
                let (versine, step) = (widest * s * s, 2.0 * widest * s / f64::from(steps));
                let radius = (versine * (2.0 - versine)).sqrt();
                pdf(n, vec3(radius as f32, 0.0, (1.0 - versine) as f32)) * step
            })
            .sum();
        let mass = mass * std::f64::consts::TAU;
        assert!((mass - 1.0).abs() < 1e-5, "{n}: {mass}");
    }
    assert_eq!(
        pdf(0.0, vec3(1.0, 0.0, 0.0)),
        f64::from(uniform_hemisphere_pdf(Vec3::X))
    );
    assert_eq!(pdf(2.0, vec3(1.0, 0.0, 0.0)), 0.0);
}

#[test]
fn inverses_return_the_fractions() {
    let mut worst = 0f64;
    for n in EXPONENTS {
        for u in grid().into_iter().filter(|u| u.x != 0) {
            let v = cosine_power_invert(cosine_power_prepare(n), direction(n, u));
            worst = worst.max((unit(u.x) - unit(v.x)).abs());
            assert!(turn_distance(u.y, v.y) <= 2f64.powi(-23), "{n} {u}: {v}");
        }
    }
    println!("2^{:.2}", worst.log2());
    assert!(worst <= 2f64.powi(-23), "2^{}", worst.log2());
}

/// Chi-square over cells of equal mass, which the judge's cumulative distribution bounds.
fn statistic(n: f32, first: u32, samples: u32, bend: f64) -> f64 {
    const RINGS: usize = 32;
    const SECTORS: usize = 16;
    let mut counts = vec![0; RINGS * SECTORS];
    for u in random(first + samples).skip(first as usize) {
        let d = direction(n, u);
        // 1 - z^(n + 1), by the angle to the axis.
        let theta = f64::from(d.x).hypot(d.y.into()).atan2(d.z.into()) * bend;
        let versine = 2.0 * (0.5 * theta).sin().powi(2);
        let mass = -((f64::from(n) + 1.0) * (-versine).ln_1p()).exp_m1();
        let turns = (f64::from(d.y).atan2(d.x.into()) / std::f64::consts::TAU).rem_euclid(1.0);
        let ring = ((mass * RINGS as f64) as usize).min(RINGS - 1);
        let sector = ((turns * SECTORS as f64) as usize).min(SECTORS - 1);
        counts[ring * SECTORS + sector] += 1;
    }
    deviate(&counts, f64::from(samples) / counts.len() as f64)
}

#[test]
fn samples_follow_their_density() {
    let most = critical(EXPONENTS.len());
    for (i, n) in EXPONENTS.into_iter().enumerate() {
        let found = statistic(n, 1_000_000 * i as u32, 1_000_000, 1.0);
        println!("{n} {found:.2} of {most:.2}");
        assert!(found < most, "{n} {found}");
        // Angles that are 2 % too small are seen.
        let bent = statistic(n, 0, 200_000, 0.98);
        assert!(bent > most, "{n} bent {bent}");
    }
}

#[test]
fn degenerate_input_gives_what_the_headers_say() {
    let bad = [-1.0, -0.0, f32::NEG_INFINITY, f32::from_bits(1)];
    for n in bad {
        for u in grid() {
            assert_eq!(direction(n, u), direction(0.0, u));
        }
    }
    let odd = [
        0.0,
        -0.0,
        1e-45,
        1e38,
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
        -1.0,
    ];
    for n in odd {
        let (lobe, native) = (cosine_power_prepare(n), native_cosine_power_prepare(n));
        for u in grid() {
            let made = cosine_power(lobe, u);
            assert!(
                made.direction.is_finite() && made.pdf.is_finite(),
                "{n} {u}"
            );
            assert!((made.direction.length() - 1.0).abs() < 3e-7, "{n} {u}");
        }
        for x in odd {
            for z in odd {
                let d = vec3(x, 1.0, z);
                let _ = (
                    cosine_power_invert(lobe, d),
                    native_cosine_power_invert(native, d),
                );
                assert!(cosine_power_pdf(lobe, d).is_finite(), "{n} {d}");
            }
        }
    }
    assert_eq!(direction(f32::NAN, uvec2(5, 0)).z, 1.0);
}

#[test]
fn the_native_profile_is_as_right() {
    for n in EXPONENTS {
        for u in grid() {
            let native = native_cosine_power(native_cosine_power_prepare(n), u);
            let exact = cosine_power(cosine_power_prepare(n), u);
            // Relative to the distance from the axis: a narrow lobe is as exact.
            let radius = exact.direction.truncate().length();
            let away = (native.direction - exact.direction).truncate().length();
            assert!(away <= 1e-6 * radius, "{n} {u}: {away}");
            assert!(
                (native.direction.z - exact.direction.z).abs() < 1e-6,
                "{n} {u}"
            );
            let error = relative(native.pdf.into(), exact.pdf.into());
            assert!(error < 1e-5, "{n} {u}: {error}");
        }
    }
}
