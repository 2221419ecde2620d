//! The least distance of two points.
//!
//! Points enter one by one, in a fixed random order, a grid whose cells are no smaller than
//! the least distance so far; only neighbouring cells can hold a nearer point, and the grid
//! is made anew when the distance falls. Expected time is linear in N for up to three
//! dimensions: Rabin 1976; Golin, Raman, Schwarz and Smid 1995, Simple randomized
//! algorithms for closest pair problems. Further dimensions take part in the distance, not
//! in the grid.

use super::{Points, Progress};
use crate::error::Result;

/// Two points and their distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Euclidean distance.
    pub distance: f64,
    /// Rows of the two points, the lower first.
    pub rows: [usize; 2],
}

/// Dimensions of the grid.
const GRID: usize = 3;

/// The two nearest points, on the torus or in the cube; `None` for a single point.
///
/// # Errors
/// Those of `progress`, which counts points.
pub fn nearest(points: &Points, toroidal: bool, progress: Progress) -> Result<Option<Nearest>> {
    let count = points.rows();
    if count < 2 {
        return Ok(None);
    }
    let point = |row: usize| {
        let at = row * points.columns();
        &points.values()[at..at + points.columns()]
    };
    let order = shuffled(count);
    let mut least = square(point(order[0]), point(order[1]), toroidal, f64::INFINITY);
    let mut rows = [order[0], order[1]];
    let mut grid = Grid::new(least, count, points.columns(), toroidal);
    grid.insert(order[0], point(order[0]));
    for (i, &row) in order.iter().enumerate().skip(1) {
        let p = point(row);
        let mut found = None;
        grid.visit_near(p, &mut |other| {
            let distance = square(p, point(other), toroidal, least);
            if distance < least {
                (least, found) = (distance, Some(other));
            }
        });
        if let Some(other) = found {
            rows = [row, other];
            if least == 0.0 {
                break;
            }
            let finer = Grid::new(least, count, points.columns(), toroidal);
            // Cells stop shrinking when they are as many as the points.
            if finer.size > grid.size {
                grid = finer;
                for &earlier in &order[..i] {
                    grid.insert(earlier, point(earlier));
                }
            }
        }
        grid.insert(row, p);
        if i % (1 << 14) == 0 {
            progress(i as u64, count as u64)?;
        }
    }
    rows.sort_unstable();
    Ok(Some(Nearest {
        distance: least.sqrt(),
        rows,
    }))
}

/// The distance that no N points on the unit torus of two dimensions exceed, that of a
/// hexagonal grid: Lagae and Dutre 2008, eq. 5, twice their radius.
#[must_use]
pub fn hexagonal_distance(count: usize) -> f64 {
    (2.0 / (3f64.sqrt() * count as f64)).sqrt()
}

/// The squared distance, or a part of it that is `enough`.
fn square(p: &[f64], q: &[f64], toroidal: bool, enough: f64) -> f64 {
    let mut sum = 0.0;
    for (a, b) in p.iter().zip(q) {
        let mut difference = (a - b).abs();
        if toroidal && difference > 0.5 {
            difference = 1.0 - difference;
        }
        sum += difference * difference;
        if sum >= enough {
            break;
        }
    }
    sum
}

/// The rows in a fixed random order (Fisher-Yates, SplitMix64).
fn shuffled(count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    let mut state = 0u64;
    for i in (1..count).rev() {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let random = (z ^ (z >> 31)) % (i as u64 + 1);
        order.swap(i, random as usize);
    }
    order
}

/// Rows by the cell of their first coordinates, as linked lists.
struct Grid {
    /// Cells along an axis.
    size: i64,
    axes: usize,
    toroidal: bool,
    /// The last row that came into a cell, plus 1.
    heads: Vec<usize>,
    /// The row before it in its cell, plus 1.
    next: Vec<usize>,
}

impl Grid {
    /// A grid whose cells are at least as wide as the root of `least`, but not many more
    /// than there are points.
    fn new(least: f64, count: usize, columns: usize, toroidal: bool) -> Self {
        let axes = columns.min(GRID);
        // A little wider, for the rounding of distances and cells.
        let side = 1.000_001 * least.sqrt();
        let most = (count as f64).powf(1.0 / axes as f64).ceil();
        let size = (1.0 / side).floor().clamp(1.0, most) as i64;
        Self {
            size,
            axes,
            toroidal,
            heads: vec![0; (size as usize).pow(axes as u32)],
            next: vec![0; count],
        }
    }

    fn cell(&self, x: f64) -> i64 {
        ((x * self.size as f64) as i64).min(self.size - 1)
    }

    fn insert(&mut self, row: usize, point: &[f64]) {
        let place = |at: i64, &x: &f64| at * self.size + self.cell(x);
        let at = point[..self.axes].iter().fold(0, place) as usize;
        self.next[row] = self.heads[at];
        self.heads[at] = row + 1;
    }

    /// Shows every row of the point's cell and its neighbours, perhaps more than once.
    fn visit_near(&self, point: &[f64], visit: &mut dyn FnMut(usize)) {
        let mut offsets = [-1i64; GRID];
        loop {
            let mut at = Some(0);
            for (&x, &offset) in point.iter().zip(&offsets[..self.axes]) {
                let cell = self.cell(x) + offset;
                let inside = (0..self.size).contains(&cell);
                at = at.filter(|_| inside || self.toroidal);
                at = at.map(|at| at * self.size + cell.rem_euclid(self.size));
            }
            let mut row = at.map_or(0, |at| self.heads[at as usize]);
            while row > 0 {
                visit(row - 1);
                row = self.next[row - 1];
            }
            let Some(axis) = offsets[..self.axes].iter().position(|&o| o < 1) else {
                return;
            };
            offsets[..axis].fill(-1);
            offsets[axis] += 1;
        }
    }
}
