//! Integrals that usual points and usual arithmetic miss.

use super::case::{Case, Source};
use super::elementary::unit;
use super::integrals::{Points, estimated};
use super::integrals_float::{self as float, Factors};
use crate::bulk::{estimate, integrand_term};
use crate::catalog::{Problem, Sequence};
use crate::{Result, judge};

/// A loop of 32 bits over the last indices ends before it begins.
pub(super) fn loops() -> Result<Vec<Case>> {
    let count = 1000u32;
    let first = (1u64 << 32) - u64::from(count);
    let points = Points::plain(Sequence::VanDerCorput, count.into()).from(first);
    let (mut steps, end) = (0u32, (first as u32).wrapping_add(count));
    let mut index = first as u32;
    while index < end {
        index += 1;
        steps += 1;
    }
    let squares: f64 = (first..1 << 32)
        .map(|n| judge::radical_inverse(n as u32, 2) as f64 / 4_294_967_296.0)
        .map(|x| x * x)
        .sum();
    let truth = squares / f64::from(count);
    let case = estimated(
        1,
        "the mean of x^2 over the last 1000 of 2^32 indices",
        "x-squared",
        points,
        truth * f64::from(steps) / f64::from(count),
    )?;
    Ok(vec![case.mean_of(truth, 1e-15)])
}

/// Poles, peaks and lattices of cells and waves.
pub(super) fn rough() -> Result<Vec<Case>> {
    let count = 1 << 16;
    let points = Points::scrambled(count);
    let corput = Points::plain(Sequence::VanDerCorput, count);
    let pole = corput.float_mean(1, |x| float::inverse_root(x[0]))?;
    let root = estimated(
        45,
        "the mean of 1 / sqrt(x) over 2^16 points",
        "inverse-root",
        points,
        pole,
    )?;
    // Without a variance, five times the root of as many.
    let mut cases = root.both(1.0)?.to_vec();
    cases.push(slope()?);
    // Of its own points all are in the cube, or half of them.
    for (centre, deviation) in [("0.381966011250105", 0.0), ("0", 1.0)] {
        let problem = format!("gaussian-peak:sigma=1e-6,centre={centre},d=1");
        let place: f32 = centre.parse().unwrap_or(f32::NAN);
        let uniform = points.float_mean(1, |x| float::peak(x[0], place, 1e-6))?;
        let case = estimated(
            46,
            format!("a Gaussian of deviation 1e-6 at {centre}, 2^16 points"),
            &problem,
            points,
            uniform,
        )?;
        cases.push(case.by("normal")?.integral(deviation));
    }
    let (cells, half) = (65_536u32, Points::plain(Sequence::Sobol, 1 << 15));
    let plain = half.float_mean(1, |x| float::cells(x[0], cells))?;
    let case = estimated(
        47,
        "65,536 cells of 0 and 1 in turn, 2^15 points",
        &format!("checkerboard:cells={cells},d=1"),
        Points::scrambled(1 << 15),
        plain,
    )?;
    cases.extend(case.both(1.0)?);
    let plain = Points::plain(Sequence::Sobol, 1 << 12);
    let wave = plain.float_mean(1, |x| float::wave(x[0], 4096.0))?;
    let case = estimated(
        48,
        "a wave of as many periods as points, 2^12",
        "oscillation:frequency=4096,d=1",
        Points::scrambled(1 << 12),
        wave,
    )?;
    cases.extend(case.both(0.71)?);
    Ok(cases)
}

/// How the median error of a pole falls with the points, which is with their root.
fn slope() -> Result<Case> {
    let problem = Problem::parse("inverse-root")?;
    let error = |log: u32| -> Result<f64> {
        let mut errors = Vec::new();
        for seed in 0..64 {
            let points = Points::scrambled(1 << log).seeded(seed);
            let request = points.request(1)?;
            let sums = estimate(&problem, &request, 0, request.count)?;
            errors.push((sums.mean().unwrap_or(f64::NAN) - problem.truth()).abs());
        }
        errors.sort_by(f64::total_cmp);
        Ok(errors.get(32).copied().unwrap_or(f64::NAN))
    };
    // The first point is 0: both means are infinite, and there is no slope.
    let float = |log: u32| -> Result<f64> {
        let points = Points::plain(Sequence::VanDerCorput, 1 << log);
        let mean = points.float_mean(1, |x| float::inverse_root(x[0]))?;
        Ok((mean - problem.truth()).abs())
    };
    let slope = |small: f64, large: f64| (large.log2() - small.log2()) / 8.0;
    let [naive, ours] = [slope(float(6)?, float(14)?), slope(error(6)?, error(14)?)]
        .map(|slope| (slope + 0.5).abs());
    Ok(Case::host(
        45,
        "slope of the median error of 1 / sqrt(x) from 2^6 to 2^14 points, 64 scrambles: from -1/2",
        [naive, ours],
        Source::ClosedForm,
        0.1,
    ))
}

/// The step of a disk: points nearest to its edge, and the area.
pub(super) fn steps() -> Result<Vec<Case>> {
    let disk = Problem::parse("disk-step")?;
    let (mut naive, mut ours, mut all) = (0, 0, 0);
    for i in 1..2048u64 {
        let x = i * 2_097_143;
        // The last y inside, and the first one outside.
        let inside = ((1u128 << 64) - u128::from(x * x) - 1).isqrt() as u64;
        for (y, truth) in [(inside, 1), (inside + 1, 0)] {
            let point = [x as u32, y as u32];
            if u64::from(point[1]) != y {
                continue;
            }
            let [a, b] = point.map(unit);
            naive += u32::from(u8::from(a * a + b * b < 1.0) != truth);
            let term = integrand_term(&disk, &point).m;
            // 1 is the unit of the sum, or 0.
            ours += u32::from(u8::from(term != glam::UVec2::ZERO) != truth);
            all += 1;
        }
    }
    let share = |wrong: u32| f64::from(wrong) / f64::from(all);
    let edge = Case::host(
        49,
        "x^2 + y^2 < 1 at the two points nearest to the edge: share of wrong answers",
        [share(naive), share(ours)],
        Source::Integers,
        0.0,
    );
    let points = Points::scrambled(1 << 16);
    let floats = points.float_mean(2, |x| f32::from(x[0] * x[0] + x[1] * x[1] < 1.0))?;
    let area = estimated(
        49,
        "a quarter of the disk, 2^16 points",
        "disk-step",
        points,
        floats,
    )?;
    let mut cases = vec![edge];
    cases.extend(area.both(0.53)?);
    Ok(cases)
}

/// Products and sums of many dimensions, of which floats lose the scale, and integrands whose
/// definition is extreme at 0.
pub(super) fn products() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    // Standard deviations of 2^18 random points, rounded up.
    for (family, difficulty, dimensions, deviation) in [
        ("oscillatory", 9.0, 64, 0.66),
        ("product-peak", 1.0, 64, 6.4e-4),
        ("product-peak", 9.0, 8, 0.69),
        ("corner-peak", 0.5, 64, 1.6),
        ("gaussian", 7.03, 64, 0.032),
        ("continuous", 9.0, 64, 0.3),
        ("discontinuous", 4.3, 64, 2.5),
    ] {
        let points = Points::scrambled(1 << 12);
        let factors = Factors::new(difficulty, dimensions);
        let naive = points.float_mean(dimensions, |x| factors.genz(family, x))?;
        let input = format!("Genz's {family} of {dimensions} dimensions, 2^12 points");
        let problem = format!("genz-{family}:difficulty={difficulty},d={dimensions}");
        cases.extend(estimated(50, input, &problem, points, naive)?.both(deviation)?);
    }
    for (dimensions, deviation) in [(1, 0.36), (8, 1.3)] {
        let points = Points::plain(Sequence::Sobol, 1 << 12);
        let naive = points.float_mean(dimensions, float::keister)?;
        let input = format!("Keister's integral of {dimensions} dimensions, 2^12 points from 0 on");
        let problem = format!("keister:d={dimensions}");
        cases.extend(estimated(51, input, &problem, points, naive)?.both(deviation)?);
    }
    let points = Points::scrambled(1 << 14);
    let (a, b) = (7.0f64, 0.1f64);
    let pi4 = std::f64::consts::PI.powi(4);
    let variance = a * a / 8.0 + b * pi4 / 5.0 + b * b * pi4 * pi4 / 18.0 + 0.5;
    let [mean, spread] = float::ishigami(|f| points.float_mean(3, f))?;
    let ishigami = |input: &str, naive| estimated(52, input, "ishigami:a=7,b=0.1", points, naive);
    let of_mean = ishigami("Ishigami's function, 2^14 points", mean)?;
    cases.extend(of_mean.both(1.1)?);
    let of_variance = ishigami("the variance of Ishigami's function, 2^14 points", spread)?;
    // Its kurtosis is 3.51: five standard errors of the variance.
    let bound = 5.0 * (2.51 / f64::from(1 << 14)).sqrt();
    cases.push(of_variance.variance(variance, bound));
    let points = Points::scrambled(1 << 10);
    let naive = points.float_mean(1000, |x| float::sobol_g(x, 1.0))?;
    let case = estimated(
        53,
        "Sobol's g of 1000 dimensions, 2^10 points",
        "sobol-g:growth=1,d=1000",
        points,
        naive,
    )?;
    cases.extend(case.both(0.81)?);
    let points = Points::scrambled(1 << 10);
    // As a sampler out of dimensions gives it.
    let naive = points.float_mean(1, |x| float::product(x, 1000))?;
    let case = estimated(
        55,
        "a product of 1000 dimensions, 2^10 points",
        "product:weight=1,decay=2,d=1000",
        points,
        naive,
    )?;
    cases.extend(case.both(0.31)?);
    Ok(cases)
}
