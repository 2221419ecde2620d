//! The reference against the judge: coordinates and pdf of samples, pdf of directions.

use super::lobes::*;
use corput::bulk::map_sample;
use corput::catalog::{Group, Profile, maps};
use corput::check::{examples, truth};
use corput::glam::{UVec2, Vec3};
use corput::judge::ulp_error;

/// Random fractions for each set of parameters, besides the edges.
const RANDOM: u32 = 1 << 13;

/// What a coordinate may be off besides half a ULP of itself: 2^-26 for GGX, where wi is
/// a multiple of a normal less wo; 2^-29 for z of Henyey and Greenstein, whose x and y are
/// right to [`ULP`].
const GGX_EXCESS: f64 = 1.0 / (1u64 << 26) as f64;
const PHASE_EXCESS: f64 = 1.0 / (1u64 << 29) as f64;

/// Worst error of a pdf, and of what is relatively exact.
const ULP: f64 = 0.9;

/// A cap's normal this near to perpendicular to the view has no pdf to many digits: its
/// direction on the unit sphere is a small sum of two large vectors.
const PERPENDICULAR: f64 = 1.0 / 64.0;

/// The unit of the last place of a float.
fn ulp_of(x: f64) -> f64 {
    f64::powi(2.0, x.log2().floor() as i32 - 23)
}

/// How far x is from truth beyond half a ULP of truth.
fn excess(x: f32, truth: f64) -> f64 {
    let ulp = f64::powi(2.0, truth.abs().max(1e-30).log2().floor() as i32 - 23);
    (f64::from(x) - truth).abs() - 0.5 * ulp
}

/// The worst excess of a coordinate over its bound, as a multiple, and ULP of the pdf.
fn worst(lobe: &Lobe, sample: impl Fn(&Lobe, UVec2) -> ([f32; 3], f32)) -> (f64, f64) {
    let (mut coordinate, mut pdf) = (0f64, 0f64);
    for u in fractions(RANDOM) {
        let (d, p) = sample(lobe, u);
        let truth = lobe.truth(u);
        for k in 0..3 {
            let ratio = if lobe.kind != Kind::HenyeyGreenstein {
                excess(d[k], truth[k]) / GGX_EXCESS
            } else if k == 2 {
                excess(d[k], truth[k]) / PHASE_EXCESS
            } else {
                ulp_error(d[k], truth[k]) / ULP
            };
            coordinate = coordinate.max(ratio);
        }
        if !lobe.perpendicular(truth, PERPENDICULAR) {
            pdf = pdf.max(ulp_error(p, truth[3]));
        }
    }
    (coordinate, pdf)
}

#[test]
fn samples_are_those_of_the_judge() {
    for lobe in lobes() {
        let (coordinate, pdf) = worst(&lobe, |lobe, u| {
            let s = lobe.sample(u);
            (s.direction.to_array(), s.pdf)
        });
        println!("{lobe:?}: coordinates {coordinate:.3} of their bound, pdf {pdf:.3} ULP");
        assert!(coordinate <= 1.0, "{lobe:?}: {coordinate}");
        assert!(pdf <= ULP, "{lobe:?}: {pdf} ULP");
    }
}

/// Roughnesses far apart, up to the ends of what is allowed.
#[test]
fn anisotropic_lobes_keep_to_their_bounds() {
    let views = [[0.3, 0.4, 0.5], [-0.7, 0.1, 0.01], [1e-3, 2e-3, 1.0]];
    for alpha in [
        [0.676, 0.021],
        [0.3, 3.0],
        [100.0, 0.01],
        [1e-3, 295.0],
        [8e3, 0.3],
    ] {
        let [x, y]: [f32; 2] = alpha;
        let least = x.min(y).min(1.0);
        let spread = f64::from(x.max(y).max(1.0) / least);
        for (kind, wo) in GGX.into_iter().flat_map(|kind| views.map(|wo| (kind, wo))) {
            let lobe = Lobe::ggx(kind, alpha, wo);
            let capped = matches!(kind, Kind::Cap | Kind::Bounded);
            for u in fractions(300) {
                let d = lobe.sample(u).direction;
                let length = d.as_dvec3().length();
                assert!((length - 1.0).abs() < 1.2e-7, "{lobe:?} {u}: {length}");
                let truth = lobe.truth(u);
                let [x, y, z, _] = truth;
                let more = if capped {
                    let cosine = lobe.judge().sphere_cosine([x, y, z]).abs().max(1e-9);
                    f64::powi(2.0, -31) * spread / cosine
                } else {
                    f64::powi(2.0, -32) * spread
                };
                let off = (0..3).map(|k| excess(d[k], truth[k]));
                let off = off.fold(0f64, f64::max);
                assert!(off <= GGX_EXCESS + more, "{lobe:?} {u}: {off:e} {more:e}");
            }
        }
    }
}

/// The pdf of rounded directions, taken as exact by both.
#[test]
fn pdfs_of_directions_are_those_of_the_judge() {
    let ulp = f64::powi(2.0, -24);
    for lobe in lobes() {
        let alpha = f64::from(lobe.alpha[0].min(lobe.alpha[1]));
        let mut worst = 0f64;
        for u in fractions(RANDOM) {
            let d = lobe.sample(u).direction;
            let sum = f64::from((d + Vec3::from(lobe.wo)).length());
            // Opposite directions have no normal between them, and D ends at the horizon.
            let reflects = !matches!(lobe.kind, Kind::HenyeyGreenstein | Kind::Normal);
            if sum < 1.0 / 4096.0 || (reflects && d.z + lobe.wo[2] < 2e-7) {
                continue;
            }
            let bound = match lobe.kind {
                Kind::HenyeyGreenstein => 6.0 * ulp,
                Kind::Normal => 1.1 * ulp + ulp / 32.0 / lobe.cosine(d),
                // The sum of both vectors is as exact as they are, whatever its length.
                _ => 1.1 * ulp + ulp / 16.0 / (alpha * sum),
            };
            let truth = lobe.truth_pdf(d.to_array().map(f64::from));
            // Rounding may take a direction over the rim of the bounded cap.
            let rim = f64::from(!u.x) < f64::powi(2.0, 14) / alpha;
            if lobe.kind == Kind::Bounded && rim && (truth == 0.0 || lobe.pdf(d) == 0.0) {
                continue;
            }
            let away =
                (f64::from(lobe.pdf(d)) - truth).abs() / truth.max(f64::from(f32::MIN_POSITIVE));
            worst = worst.max(away / bound);
        }
        println!("{lobe:?}: pdf of directions {worst:.3} of its bound");
        assert!(worst <= 1.0, "{lobe:?}: {worst}");
    }
}

/// What the catalogue says of its maps, Beckmann's among them, with all its examples.
#[test]
fn the_catalogue_is_right_about_its_errors() {
    let groups = [Group::Phase, Group::Ggx, Group::GgxCap, Group::Beckmann];
    for map in maps().filter(|map| groups.contains(&map.group)) {
        let (mut coordinate, mut pdf) = (0f64, 0f64);
        for mapping in examples(map).expect("examples in their domains") {
            for u in fractions(RANDOM) {
                let u = [u.x, u.y, 0];
                let Some(truth) = truth(&mapping, u) else {
                    continue;
                };
                let got = map_sample(&mapping, Profile::Exact, u).map(f32::from_bits);
                for k in 0..3 {
                    let unit = truth[k].abs().max(map.floor);
                    let ulp = if unit > 0.0 { ulp_of(unit) } else { 1.0 };
                    coordinate = coordinate.max((f64::from(got[k]) - truth[k]).abs() / ulp);
                }
                pdf = pdf.max(ulp_error(got[3], truth[3]));
            }
        }
        println!(
            "{}: {coordinate:.3} of {} ULP, pdf {pdf:.3} of {}",
            map.name, map.ulp, map.pdf_ulp
        );
        assert!(coordinate <= map.ulp, "{}: {coordinate}", map.name);
        assert!(pdf <= map.pdf_ulp, "{}: {pdf}", map.name);
    }
}

/// The common float forms are off by far more: the bounds can be missed.
#[test]
fn float_arithmetic_misses_the_bounds() {
    let lobe = Lobe::henyey_greenstein(1e-3, false);
    let (coordinate, _) = worst(&lobe, |lobe, u| {
        let g = 1.0 - lobe.rest;
        let x = u.x as f32 * 2f32.powi(-32);
        let ratio = (1.0 - g * g) / (1.0 - g + 2.0 * g * x);
        let z = (1.0 + g * g - ratio * ratio) / (2.0 * g);
        let radius = (1.0 - z * z).max(0.0).sqrt();
        let phi = std::f32::consts::TAU * (u.y as f32 * 2f32.powi(-32));
        ([radius * phi.cos(), radius * phi.sin(), z], 1.0)
    });
    assert!(coordinate > 100.0, "{coordinate}");
    // Two thirds of the pdf, which a wrong factor would give.
    let lobe = Lobe::ggx(Kind::Vndf, [0.3; 2], VIEWS[1]);
    let (_, pdf) = worst(&lobe, |lobe, u| {
        let s = lobe.sample(u);
        (s.direction.to_array(), s.pdf * (1.0 + 4e-7))
    });
    assert!(pdf > ULP, "{pdf}");
}
