//! A million samples of each map in cells of equal probability, those of the judge's own
//! inverse; and in cells of its chart, whose probabilities are integrals of the judge's pdf.

use super::laws::{Case, cases, each, random};
use super::quadrature::integrate;
use super::significance::{critical, deviate, pearson};
use corput::glam::{DVec2, DVec3, dvec2};

const SAMPLES: u32 = 1_000_000;

/// Of the parameters of a map beyond the first ones.
const FEWER: u32 = 100_000;
const FIRST: usize = 3;

/// Cells along each side of the square of fractions, and of the chart.
const FRACTIONS: usize = 32;
const CHART: usize = 16;

/// Cells that expect fewer samples are counted together.
const FEWEST: f64 = 50.0;

fn place(v: f64, side: usize) -> usize {
    ((v * side as f64) as usize).min(side - 1)
}

/// The integrals of the judge's pdf, times `factor`, over the cells of the chart.
pub fn masses(case: &Case, factor: &dyn Fn(DVec3) -> f64) -> Vec<f64> {
    let side = CHART as f64;
    let columns = if case.line() { 1 } else { CHART };
    let pdf = |x: DVec3| factor(x) * case.law.pdf(x);
    let mut all = Vec::new();
    for j in 0..columns {
        for i in 0..CHART {
            let from = dvec2(i as f64, j as f64) / side;
            let cell = [from, from + DVec2::splat(1.0 / side)];
            let [mass] = integrate(case, &pdf, &|_| [1.0], cell, 1e-9);
            all.push(mass);
        }
    }
    all
}

/// The deviates of the counts of samples in both kinds of cells.
pub fn deviations(
    case: &Case,
    masses: &[f64],
    samples: u32,
    seed: u64,
    sample: &dyn Fn([u32; 2]) -> DVec3,
) -> [f64; 2] {
    let mut fractions = vec![0u32; FRACTIONS * FRACTIONS];
    let mut chart = vec![0u32; masses.len()];
    for i in 0..samples {
        let x = sample(random(seed, i));
        let u = case.law.fractions(x);
        fractions[place(u.y, FRACTIONS) * FRACTIONS + place(u.x, FRACTIONS)] += 1;
        let t = case.law.chart(x);
        let row = if case.line() { 0 } else { place(t.y, CHART) };
        chart[row * CHART + place(t.x, CHART)] += 1;
    }
    let total = f64::from(samples);
    let expected = total / fractions.len() as f64;
    [
        deviate(&fractions, expected),
        unequal(&chart, masses, total),
    ]
}

/// Pearson's deviate of counts whose probabilities differ.
fn unequal(counts: &[u32], masses: &[f64], total: f64) -> f64 {
    let (mut few, mut expected_few) = (0.0, 0.0);
    let (mut chi_square, mut cells) = (0.0, 0.0);
    for (&count, mass) in counts.iter().zip(masses) {
        let (count, expected) = (f64::from(count), mass * total);
        if expected < FEWEST {
            few += count;
            expected_few += expected;
        } else {
            chi_square += (count - expected).powi(2) / expected;
            cells += 1.0;
        }
    }
    if expected_few >= FEWEST {
        chi_square += (few - expected_few).powi(2) / expected_few;
        cells += 1.0;
    } else if few > FEWEST + 10.0 * FEWEST.sqrt() {
        return f64::INFINITY;
    }
    pearson(chi_square, cells - 1.0)
}

/// Whether the masses of all cells, each integrated to 1e-9 or where its pdf bends to a few
/// times that, are together 1.
pub fn integrates(total: f64) -> bool {
    (total - 1.0).abs() < 1e-6
}

/// The deviate that none of both kinds of all cases exceeds by chance.
pub fn limit(cases: &[Case]) -> f64 {
    critical(2 * cases.len())
}

#[test]
fn the_pdf_integrates_to_one_and_a_million_samples_follow_it() {
    let cases = cases();
    let limit = limit(&cases);
    let found = each(&cases, |seed, case| {
        let masses = masses(case, &|_| 1.0);
        let total: f64 = masses.iter().sum();
        let sample = |u| case.sample(u);
        let samples = if case.index < FIRST { SAMPLES } else { FEWER };
        (total, deviations(case, &masses, samples, seed, &sample))
    });
    let mut wrong = Vec::new();
    for (case, (total, [inverse, pdf])) in cases.iter().zip(found) {
        let name = case.name();
        let line = format!(
            "{name}: integral 1 {:+.0e}, cells of the inverse {inverse:.2}, of the pdf {pdf:.2}",
            total - 1.0
        );
        println!("{line}");
        if !integrates(total) || inverse > limit || pdf > limit {
            wrong.push(line);
        }
    }
    println!("limit {limit:.2}");
    assert!(wrong.is_empty(), "beyond {limit:.2}:\n{}", wrong.join("\n"));
}
