//! Star discrepancy in one and two dimensions, exactly.
//!
//! The largest difference between the volume of a box [0, a) and the share of points in
//! it, over open and closed boxes. Niederreiter 1992, Random number generation and
//! quasi-Monte Carlo methods, theorem 2.6, for one dimension; Bundschuh and Zhu 1993, A
//! method for exact calculation of the discrepancy of low-dimensional finite point sets,
//! for the boxes that matter in two.

use super::{Progress, threads};
use crate::error::Result;
use std::panic::resume_unwind;

/// Distinct abscissas of a piece of work.
const PIECE: usize = 512;

/// Star discrepancy of numbers in [0, 1), in O(N log N); 0 for none.
#[must_use]
pub fn star_1d(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let count = sorted.len() as f64;
    let share = |i: usize| i as f64 / count;
    let worst = |(i, x): (usize, &f64)| (x - share(i)).max(share(i + 1) - x);
    sorted.iter().enumerate().map(worst).fold(0.0, larger)
}

/// Star discrepancy of points in the unit square, in O(N^2): about a second for 2^16
/// points. 0 for none. `progress` counts points.
///
/// # Errors
/// Those of `progress`.
pub fn star_2d(points: &[[f64; 2]], progress: Progress) -> Result<f64> {
    let mut sorted = points.to_vec();
    sorted.sort_unstable_by(|p, q| p[0].total_cmp(&q[0]));
    // Where each distinct abscissa begins.
    let starts: Vec<usize> = (0..sorted.len())
        .filter(|&i| i == 0 || sorted[i][0] != sorted[i - 1][0])
        .collect();
    let pieces: Vec<&[usize]> = starts.chunks(PIECE).collect();
    let mut worst = 0.0f64;
    let mut done = 0;
    for some in pieces.chunks(threads()) {
        std::thread::scope(|scope| {
            let sorted = &sorted;
            let work = |starts| scope.spawn(move || sweep(sorted, starts));
            let running: Vec<_> = some.iter().map(|piece| work(*piece)).collect();
            for one in running {
                // A panic of a thread is a bug, and one here too.
                worst = larger(
                    worst,
                    one.join().unwrap_or_else(|panic| resume_unwind(panic)),
                );
            }
        });
        done += some.iter().map(|piece| piece.len()).sum::<usize>();
        progress(done as u64, starts.len() as u64)?;
    }
    // Boxes as wide as the square: its other side alone.
    let heights: Vec<f64> = points.iter().map(|p| p[1]).collect();
    Ok(larger(worst, star_1d(&heights)))
}

/// The worst of the boxes that end at some of the abscissas: open, before their points
/// come in, and closed, after.
fn sweep(points: &[[f64; 2]], starts: &[usize]) -> f64 {
    let (Some(&first), count) = (starts.first(), points.len()) else {
        return 0.0;
    };
    let share = 1.0 / count as f64;
    let mut heights: Vec<f64> = points[..first].iter().map(|p| p[1]).collect();
    heights.sort_unstable_by(f64::total_cmp);
    let mut worst = 0.0f64;
    for &start in starts {
        let width = points[start][0];
        // Of equal heights the first has the count of the open box.
        worst = larger(worst, most(&heights, width, -share, 0.0));
        worst = larger(worst, width - heights.len() as f64 * share);
        for p in points[start..].iter().take_while(|p| p[0] == width) {
            let at = heights.partition_point(|y| *y <= p[1]);
            heights.insert(at, p[1]);
        }
        worst = larger(worst, most(&heights, -width, share, share));
    }
    worst
}

/// The largest of slope y_i + step i + offset, by lanes that a compiler finds parallel.
fn most(heights: &[f64], slope: f64, step: f64, offset: f64) -> f64 {
    const LANES: usize = 8;
    let mut best = [f64::NEG_INFINITY; LANES];
    let chunks = heights.chunks_exact(LANES);
    let rest = chunks.remainder();
    let mut shift = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0f64];
    for chunk in chunks {
        for k in 0..LANES {
            let value = slope * chunk[k] + step * shift[k];
            best[k] = if value > best[k] { value } else { best[k] };
            shift[k] += LANES as f64;
        }
    }
    for (k, y) in rest.iter().enumerate() {
        best[k] = best[k].max(slope * y + step * shift[k]);
    }
    offset + best.into_iter().fold(f64::NEG_INFINITY, larger)
}

/// The larger, or the NaN; `f64::max` would drop it, and takes longer.
fn larger(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}
