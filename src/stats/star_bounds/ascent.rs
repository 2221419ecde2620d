//! Boxes of large local discrepancy, by ascents along one axis after the other.
//!
//! Along one axis, with the others held, the best corner is found exactly as in one
//! dimension. Random starts and moves in a neighbourhood as in Gnewuch, Wahlstroem and
//! Winzen 2012, SIAM J. Numer. Anal. 50, would go further; these are to bound from below.

use super::Points;

/// Whether points on the border of a box count.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Border {
    Open,
    Closed,
}

/// The largest local discrepancy that ascents from fixed random starts find, with about
/// `work` looks at a coordinate; at least one start.
pub(super) fn best(points: &Points, axes: &[Vec<f64>], work: u64) -> f64 {
    let mut best = 0.0f64;
    let (mut done, mut state) = (0, 0);
    while done <= work {
        let corner = start(axes, &mut state);
        for border in [Border::Open, Border::Closed] {
            let (found, steps) = climb(points, corner.clone(), border);
            best = best.max(found);
            done += steps * points.values().len() as u64;
        }
    }
    best
}

/// A corner whose volume is uniform, roughly.
fn start(axes: &[Vec<f64>], state: &mut u64) -> Vec<f64> {
    let mut corner = Vec::new();
    for axis in axes {
        *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let uniform = ((z ^ (z >> 31)) >> 11) as f64 / 9_007_199_254_740_992.0;
        let level = uniform.powf(1.0 / axes.len() as f64);
        let at = axis.partition_point(|x| *x < level);
        corner.push(axis[at.min(axis.len() - 1)]);
    }
    corner
}

/// The discrepancy where no axis improves it, and the steps that took.
fn climb(points: &Points, mut corner: Vec<f64>, border: Border) -> (f64, u64) {
    let (mut best, mut steps, mut idle, mut k) = (f64::NEG_INFINITY, 0, 0, 0);
    while idle < corner.len() {
        let (found, at) = along(points, &corner, k, border);
        steps += 1;
        idle += 1;
        if found > best {
            best = found;
            corner[k] = at;
            idle = 1;
        }
        k = (k + 1) % corner.len();
    }
    (best, steps)
}

/// The best corner along an axis: its discrepancy, and its coordinate.
fn along(points: &Points, corner: &[f64], k: usize, border: Border) -> (f64, f64) {
    let within = |point: &[f64]| {
        let mut sides = point
            .iter()
            .zip(corner)
            .enumerate()
            .filter(|(j, _)| *j != k);
        sides.all(|(_, (x, t))| x < t || (border == Border::Closed && x == t))
    };
    let mut line: Vec<f64> = points.iter().filter(|p| within(p)).map(|p| p[k]).collect();
    line.sort_unstable_by(f64::total_cmp);
    let count = points.rows() as f64;
    let others = corner.iter().enumerate().filter(|(j, _)| *j != k);
    let area: f64 = others.map(|(_, t)| t).product();
    let mut best = match border {
        Border::Open => (area - line.len() as f64 / count, 1.0),
        Border::Closed => (f64::NEG_INFINITY, 1.0),
    };
    for (i, &x) in line.iter().enumerate() {
        let found = match border {
            Border::Open => area * x - i as f64 / count,
            Border::Closed => (i + 1) as f64 / count - area * x,
        };
        if found > best.0 {
            best = (found, x);
        }
    }
    best
}
