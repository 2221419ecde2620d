//! Star discrepancy in any number of dimensions, between bounds.
//!
//! Only boxes whose corner t has coordinates of points, or 1, matter. Over the corners
//! between `low` and `high` the local discrepancy is at most
//! max(V(high) - A(low) / N, A(high) / N - V(low)), where A counts the open box at the
//! low corner and the closed one at the high: Thiemard 2001, An algorithm to compute bounds
//! for the star discrepancy, J. Complexity 17. The cell of corners with the worst bound is
//! halved until it is no worse than a box that was found, which makes the result exact, or
//! until the work is spent. Boxes are found at corners of cells, and before that by ascents
//! along one axis after the other.

mod ascent;

use super::{Points, Progress};
use crate::error::Result;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Bounds of a star discrepancy, rounding included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StarBounds {
    /// A box of at least this local discrepancy exists.
    pub lower: f64,
    /// No box has more than this.
    pub upper: f64,
}

impl StarBounds {
    /// Whether nothing but rounding is between the bounds.
    #[must_use]
    pub fn is_exact(self) -> bool {
        self.upper - self.lower < 1e-12
    }
}

/// Most entries of the lists of undecided points in memory: 1 GiB of them.
const MEMORY: usize = 1 << 28;

/// Bounds of the star discrepancy of points, with about `work` looks at a coordinate.
///
/// # Errors
/// Those of `progress`, which counts work.
pub fn star_bounds(points: &Points, work: u64, progress: Progress) -> Result<StarBounds> {
    let (rows, columns) = (points.rows(), points.columns());
    let axes: Vec<Vec<f64>> = (0..columns).map(|k| axis(points, k)).collect();
    // Volumes are products, and shares quotients.
    let slack = (columns as f64 + 4.0) * f64::EPSILON;
    let mut lower = ascent::best(points, &axes, work / 8);
    let search = Search {
        points,
        axes: &axes,
    };
    let ends = axes.iter().map(|axis| [0, axis.len() - 1]);
    let mut heap = BinaryHeap::new();
    heap.push(search.cell(ends.collect(), (0..rows as u32).collect(), 0, &mut lower));
    let (mut done, mut held, mut said) = (work / 8, rows, 0);
    while let Some(cell) = heap.pop() {
        if cell.upper <= lower || done >= work || held > MEMORY {
            // Whatever is left is no worse than this one.
            heap.push(cell);
            break;
        }
        held -= cell.undecided.len();
        done += (2 * columns * (cell.undecided.len() + 1)) as u64;
        for half in search.halves(&cell, &mut lower) {
            if half.upper > lower {
                held += half.undecided.len();
                heap.push(half);
            }
        }
        if done - said > work / 64 {
            said = done;
            progress(done.min(work), work)?;
        }
    }
    let upper = heap.peek().map_or(lower, |cell| cell.upper.max(lower));
    Ok(StarBounds {
        lower: (lower - slack).max(0.0),
        upper: (upper + slack).min(1.0),
    })
}

/// The coordinates of a corner along an axis: those of points, and 1, in order.
fn axis(points: &Points, k: usize) -> Vec<f64> {
    let mut axis: Vec<f64> = points.iter().map(|point| point[k]).collect();
    axis.push(1.0);
    axis.sort_unstable_by(f64::total_cmp);
    axis.dedup();
    axis
}

/// What stays the same.
struct Search<'a> {
    points: &'a Points,
    axes: &'a [Vec<f64>],
}

/// Corners between two of them.
struct Cell {
    /// On each axis the first and the last coordinate.
    ends: Vec<[usize; 2]>,
    /// Points in the closed box of the high corner and not in the open one of the low.
    undecided: Vec<u32>,
    /// Points in the open box of the low corner.
    inside: usize,
    /// No corner of the cell has a larger local discrepancy.
    upper: f64,
}

impl Search<'_> {
    /// A cell from its ends, the points in the closed box of its high corner but for those
    /// that are known to be inside, and their number.
    fn cell(
        &self,
        ends: Vec<[usize; 2]>,
        mut undecided: Vec<u32>,
        mut inside: usize,
        lower: &mut f64,
    ) -> Cell {
        let count = self.points.rows() as f64;
        let corner = |end: usize| -> Vec<f64> {
            let of = |(axis, ends): (&Vec<f64>, &[usize; 2])| axis[ends[end]];
            self.axes.iter().zip(&ends).map(of).collect()
        };
        let (low, high) = (corner(0), corner(1));
        let before = undecided.len();
        undecided.retain(|&row| self.row(row).iter().zip(&low).any(|(x, t)| x >= t));
        inside += before - undecided.len();
        let (small, large) = (low.iter().product::<f64>(), high.iter().product::<f64>());
        let (fewest, most) = (
            inside as f64 / count,
            (inside + undecided.len()) as f64 / count,
        );
        *lower = lower.max(small - fewest).max(most - large);
        Cell {
            upper: (large - fewest).max(most - small),
            ends,
            undecided,
            inside,
        }
    }

    fn row(&self, row: u32) -> &[f64] {
        let columns = self.points.columns();
        &self.points.values()[row as usize * columns..][..columns]
    }

    /// The cell in two, across the axis along which volumes differ most; none for a
    /// single corner, whose bound is its discrepancy.
    fn halves(&self, cell: &Cell, lower: &mut f64) -> Vec<Cell> {
        let ratio = |k: usize| self.axes[k][cell.ends[k][0]] / self.axes[k][cell.ends[k][1]];
        let wide = (0..cell.ends.len()).filter(|&k| cell.ends[k][0] < cell.ends[k][1]);
        let Some(k) = wide.min_by(|&i, &j| ratio(i).total_cmp(&ratio(j))) else {
            return Vec::new();
        };
        let [first, last] = cell.ends[k];
        let axis = &self.axes[k];
        let middle = 0.5 * (axis[first] + axis[last]);
        let after = first + axis[first..=last].partition_point(|x| *x <= middle);
        let split = after.clamp(first + 1, last);
        let half = |ends: [usize; 2]| {
            let mut all = cell.ends.clone();
            all[k] = ends;
            all
        };
        let edge = axis[split - 1];
        let mut below = cell.undecided.clone();
        below.retain(|&row| self.row(row)[k] <= edge);
        vec![
            self.cell(half([first, split - 1]), below, cell.inside, lower),
            self.cell(
                half([split, last]),
                cell.undecided.clone(),
                cell.inside,
                lower,
            ),
        ]
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        self.upper.total_cmp(&other.upper)
    }
}
