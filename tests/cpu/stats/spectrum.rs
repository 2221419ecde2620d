//! The spectrum: against sums by definition, and sets whose spectrum is known.

use super::{Random, unseen};
use corput::stats::{MAX_RANGE, spectrum, spectrum_range};
use std::f64::consts::TAU;

/// |sum exp(-2 pi i f.x)|^2 / N.
fn definition(points: &[[f64; 2]], x: i32, y: i32) -> f64 {
    let angle = |p: &[f64; 2]| -TAU * (f64::from(x) * p[0] + f64::from(y) * p[1]);
    let re: f64 = points.iter().map(|p| angle(p).cos()).sum();
    let im: f64 = points.iter().map(|p| angle(p).sin()).sum();
    (re * re + im * im) / points.len() as f64
}

#[test]
fn each_frequency_is_what_the_definition_gives() {
    for (count, range) in [(1, 1), (7, 3), (300, 17), (5000, 9)] {
        let points = Random(count as u64).pairs(count);
        let found = spectrum(&points, range, &mut unseen).unwrap();
        let r = range as i32;
        for y in -r..=r {
            for x in -r..=r {
                let (got, truth) = (found.power(x, y), definition(&points, x, y));
                assert!(
                    (got - truth).abs() < 1e-9 * truth.max(1.0),
                    "{x},{y}: {got}, not {truth}"
                );
            }
        }
        assert_eq!(found.power(r + 1, 0), 0.0);
        assert_eq!(found.image().len(), (2 * range + 1).pow(2));
        // Every ring is the mean over half of its frequencies.
        for ring in found.rings() {
            let f = ring.frequency as f64;
            let inside = |x: i32, y: i32| f64::from(x).hypot(f64::from(y)).round() == f;
            let all: Vec<f64> = (-r..=r)
                .flat_map(|y| (-r..=r).map(move |x| (x, y)))
                .filter(|&(x, y)| inside(x, y))
                .map(|(x, y)| definition(&points, x, y))
                .collect();
            assert_eq!(all.len(), 2 * ring.count);
            let mean = all.iter().sum::<f64>() / all.len() as f64;
            assert!((ring.power - mean).abs() < 1e-9 * mean.max(1.0));
        }
    }
}

/// A grid of n x n has its power at multiples of n alone.
#[test]
fn a_grid_has_peaks() {
    let points: Vec<_> = (0..64)
        .map(|i| [f64::from(i % 8) / 8.0, f64::from(i / 8) / 8.0])
        .collect();
    let found = spectrum(&points, 16, &mut unseen).unwrap();
    for y in -16..=16 {
        for x in -16..=16 {
            let truth = if x % 8 == 0 && y % 8 == 0 { 64.0 } else { 0.0 };
            assert!((found.power(x, y) - truth).abs() < 1e-9, "{x},{y}");
        }
    }
    // One of 32 frequencies in ring 8 and its turn by a quarter have all the power.
    let ring = found.rings()[7];
    let n = ring.count as f64;
    assert!((ring.power - 128.0 / n).abs() < 1e-9);
    let (mean, big) = (2.0 / n, 1.0 - 2.0 / n);
    let variance = (2.0 * big * big + (n - 2.0) * mean * mean) / (n - 1.0);
    assert!((ring.anisotropy_db - 10.0 * (variance / (mean * mean)).log10()).abs() < 1e-6);
}

/// White noise: powers are exponentially distributed with mean 1, so a ring of n has the
/// mean 1 within z / sqrt(n), and an anisotropy of 0 dB. z = 4.30 is a significance of
/// 0.001 among 57 rings (Sidak); the smallest 7 are too skewed for it. A set with every
/// point twice has powers of mean 2 and must be caught.
#[test]
fn white_noise_is_one_everywhere() {
    let points = Random(5).pairs(1024);
    let deviates = |points: &[[f64; 2]]| {
        let found = spectrum(points, 64, &mut unseen).unwrap();
        let far = |r: &&corput::stats::Ring| (r.power - 1.0).abs() > 4.30 / (r.count as f64).sqrt();
        let (rings, mean) = (found.rings(), found.rings().len() as f64);
        let decibels = rings[7..].iter().map(|r| r.anisotropy_db).sum::<f64>() / (mean - 7.0);
        (rings[7..].iter().filter(far).count(), decibels)
    };
    let (far, decibels) = deviates(&points);
    assert_eq!(far, 0);
    assert!(decibels.abs() < 0.3, "{decibels}");
    let twice = [&points[..512], &points[..512]].concat();
    assert!(deviates(&twice).0 > 50);
}

/// Jittered strata, n by n: P(f) has the mean 1 - sinc^2(fx / n) sinc^2(fy / n).
#[test]
fn jitter_has_the_spectrum_of_its_cells() {
    let mut random = Random(6);
    let cell = |i: u32, random: &mut Random| (f64::from(i) + random.next()) / 32.0;
    let points: Vec<_> = (0..1024)
        .map(|i| [cell(i % 32, &mut random), cell(i / 32, &mut random)])
        .collect();
    let sinc = |f: i32| match std::f64::consts::PI * f64::from(f) / 32.0 {
        0.0 => 1.0,
        x => x.sin() / x,
    };
    let far = |points: &[[f64; 2]]| {
        let found = spectrum(points, spectrum_range(1024), &mut unseen).unwrap();
        let deviates = |ring: &&corput::stats::Ring| {
            let inside =
                |x: i32, y: i32| f64::from(x).hypot(f64::from(y)).round() == ring.frequency as f64;
            let means: Vec<f64> = (-64..=64)
                .flat_map(|y| (-64..=64).map(move |x| (x, y)))
                .filter(|&(x, y)| inside(x, y))
                .map(|(x, y)| 1.0 - (sinc(x) * sinc(y)).powi(2))
                .collect();
            let count = means.len() as f64;
            let mean = means.iter().sum::<f64>() / count;
            // One of f and -f is independent.
            let error = (2.0 * means.iter().map(|m| m * m).sum::<f64>()).sqrt() / count;
            (ring.power - mean).abs() > 4.30 * error
        };
        found.rings()[7..].iter().filter(deviates).count()
    };
    assert_eq!(far(&points), 0);
    assert!(far(&Random(6).pairs(1024)) > 5);
}

#[test]
fn ranges_are_bounded_and_progress_can_stop() {
    assert_eq!([1, 64, 1024, 1 << 20].map(spectrum_range), [8, 16, 64, 256]);
    let points = Random(7).pairs(10_000);
    assert!(spectrum(&[], 8, &mut unseen).is_err());
    assert!(spectrum(&points, 0, &mut unseen).is_err());
    assert!(spectrum(&points, MAX_RANGE + 1, &mut unseen).is_err());
    let mut last = (0, 0);
    let mut steps = 0;
    spectrum(&points, 1, &mut |done, total| {
        assert!(done > last.0 && total == 10_000);
        (last, steps) = ((done, total), steps + 1);
        Ok(())
    })
    .unwrap();
    assert!(last == (10_000, 10_000) && steps > 1);
    let stopped = spectrum(&points, 1, &mut |done, total| {
        Err(corput::Error::Interrupted { done, total })
    });
    assert!(matches!(stopped, Err(corput::Error::Interrupted { .. })));
}
