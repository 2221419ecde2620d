//! Adaptive quadrature over the unit square of a chart.

use super::laws::Case;
use corput::glam::{DVec2, DVec3, dvec2};

/// Halvings of an interval.
const DEPTH: u32 = 24;

/// Simpson's rule of several functions, halved until the halves agree with the whole in all.
pub fn adaptive<const N: usize>(
    f: &dyn Fn(f64) -> [f64; N],
    [a, b]: [f64; 2],
    tolerance: f64,
) -> [f64; N] {
    let ends = [f(a), f(0.5 * (a + b)), f(b)];
    let whole = simpson(b - a, ends);
    halved(f, [a, b], ends, whole, tolerance, DEPTH)
}

fn simpson<const N: usize>(width: f64, [a, m, b]: [[f64; N]; 3]) -> [f64; N] {
    std::array::from_fn(|i| width / 6.0 * (a[i] + 4.0 * m[i] + b[i]))
}

fn halved<const N: usize>(
    f: &dyn Fn(f64) -> [f64; N],
    [a, b]: [f64; 2],
    ends: [[f64; N]; 3],
    whole: [f64; N],
    tolerance: f64,
    depth: u32,
) -> [f64; N] {
    let m = 0.5 * (a + b);
    let (l, r) = (f(0.5 * (a + m)), f(0.5 * (m + b)));
    let [left, right] = [[ends[0], l, ends[1]], [ends[1], r, ends[2]]];
    let halves = [simpson(m - a, left), simpson(b - m, right)];
    let sum: [f64; N] = std::array::from_fn(|i| halves[0][i] + halves[1][i]);
    let error = (0..N)
        .map(|i| (sum[i] - whole[i]).abs())
        .fold(0.0, f64::max);
    if depth == 0 || error < 15.0 * tolerance {
        return sum;
    }
    let tolerance = 0.5 * tolerance;
    let first = halved(f, [a, m], left, halves[0], tolerance, depth - 1);
    let second = halved(f, [m, b], right, halves[1], tolerance, depth - 1);
    std::array::from_fn(|i| first[i] + second[i])
}

/// The integrals of `values` times the pdf over the part [from, to] of the chart.
pub fn integrate<const N: usize>(
    case: &Case,
    pdf: &dyn Fn(DVec3) -> f64,
    values: &dyn Fn(DVec3) -> [f64; N],
    [from, to]: [DVec2; 2],
    tolerance: f64,
) -> [f64; N] {
    let weighed = |t: DVec2| {
        let x = case.law.at(t);
        // Where the chart ends, a pdf may be infinite over no area.
        let mass = pdf(x) * case.law.stretch(t);
        values(x).map(|v| if mass.is_finite() { v * mass } else { 0.0 })
    };
    if case.line() {
        return adaptive(&|x| weighed(dvec2(x, 0.5)), [from.x, to.x], tolerance);
    }
    let width = to.x - from.x;
    let row = |y: f64| adaptive(&|x| weighed(dvec2(x, y)), [from.x, to.x], tolerance * width);
    adaptive(&row, [from.y, to.y], tolerance)
}
