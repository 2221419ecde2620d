//! The mean of 1/pdf over samples, where the pdf is bounded below: the measure of the domain.

use super::laws::{Case, case, cases, each, random};
use super::moments::{edges, limit, whole};
use corput::glam::dvec2;

const SAMPLES: u32 = 100_000;

/// The mean of 1/pdf over samples over the measure of the domain, less 1, and the deviation of
/// the former; `None` where the pdf comes below a hundredth of that of the uniform one.
fn reciprocal(case: &Case, seed: u64, factor: f64) -> Option<[f64; 2]> {
    let stretch = |i: i32| {
        let t = dvec2(f64::from(i % 64), f64::from(i / 64)) + 0.5;
        case.law.stretch(t / 64.0)
    };
    let about = (0..4096).map(stretch).sum::<f64>() / 4096.0;
    let pdfs = edges().map(|t| case.law.pdf(case.law.at(t)));
    if pdfs.fold(f64::INFINITY, f64::min) * about < 1e-2 {
        return None;
    }
    let [measure] = whole(case, &|_| 1.0, &|_| [1.0], 1e-9 * about);
    let [square] = whole(
        case,
        &|x| case.law.pdf(x).recip(),
        &|_| [1.0],
        1e-8 * measure * about,
    );
    let sum: f64 = (0..SAMPLES)
        .map(|i| 1.0 / (factor * case.own_pdf(random(seed, i))))
        .sum();
    let spread = (square / measure.powi(2) - 1.0).max(0.0);
    let total = f64::from(SAMPLES);
    Some([sum / total / measure - 1.0, (spread / total).sqrt()])
}

/// By the map's own pdf, which is rounded.
#[test]
fn the_mean_of_the_reciprocal_pdf_is_the_measure_of_the_domain() {
    let cases = cases();
    let found = each(&cases, |seed, case| reciprocal(case, 3000 + seed, 1.0));
    let limit = limit(found.iter().flatten().count());
    let mut judged = 0;
    for (case, found) in cases.iter().zip(found) {
        let Some([off, deviation]) = found else {
            continue;
        };
        println!("{}: {off:+.1e}, deviation {deviation:.0e}", case.name());
        assert!(
            off.abs() < limit * deviation + 1e-6,
            "{}: {off:e}",
            case.name()
        );
        judged += 1;
    }
    assert!(judged > 40, "{judged}");
}

/// A pdf a twentieth too large.
#[test]
fn a_reciprocal_of_another_pdf_is_refused() {
    for (name, values) in [
        ("uniform-sphere", &[][..]),
        (
            "spherical-triangle",
            &[0.0, 0.0, 1.0, 1e-5, 0.0, 1.0, 0.0, 1e-5, 1.0],
        ),
        ("henyey-greenstein", &[0.5]),
        ("disk-light", &[1.0, 2.0, 3.0, 1.0, 0.0, -0.3, 2.0]),
    ] {
        let case = case(name, values);
        let judged = |factor| reciprocal(&case, 5, factor).expect("a bounded pdf");
        let limit = limit(cases().len());
        let [off, deviation] = judged(1.0);
        assert!(off.abs() < limit * deviation + 1e-6, "{name}: {off:e}");
        let [off, deviation] = judged(1.05);
        println!("{name}: {off:e}, deviation {deviation:e}");
        assert!(off.abs() > limit * deviation + 1e-6, "{name}: {off:e}");
    }
}
