//! Blue-noise points by weighted sample elimination.
//!
//! Source: Yuksel 2015, Sample elimination for generating Poisson disk sample sets,
//! Computer Graphics Forum 34(2): its weights with weight limiting, and its progressive
//! order by eliminating again and again.

use super::random::word;
use crate::{Error, Result};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The most points of a set.
pub const MAX_POINTS: u64 = 1 << 16;

/// Random points that one point of the result is chosen from.
const CANDIDATES: usize = 10;

/// `count` points on the torus, as fractions of 2^32, in an order whose prefixes are well
/// spread too.
///
/// The least distance of two is about 0.73 of sqrt(2 / (sqrt(3) count)), that of the
/// points of a hexagonal lattice, and about 0.6 for a prefix: measured, not guaranteed.
///
/// # Errors
/// [`Error::ZeroCount`], or [`Error::Arguments`] above [`MAX_POINTS`].
pub fn blue_noise_points(count: u64, seed: u64) -> Result<Vec<[u32; 2]>> {
    check_count(count)?;
    let count = count as usize;
    let candidates = (0..(CANDIDATES * count) as u64).map(|i| {
        let word = word(seed, i);
        [word as u32, (word >> 32) as u32]
    });
    let candidates: Vec<[u32; 2]> = candidates.collect();
    let (mut kept, _) = eliminate(&candidates, count, true);
    // Halved again and again: what goes first is last in the order.
    let mut order = Vec::with_capacity(count);
    while kept.len() > 1 {
        let (stay, gone) = eliminate(&kept, kept.len() / 2, false);
        order.extend(gone);
        kept = stay;
    }
    order.extend(kept);
    order.reverse();
    Ok(order)
}

/// Whether so many points can be made.
///
/// # Errors
/// [`Error::ZeroCount`], or [`Error::Arguments`] above [`MAX_POINTS`].
pub fn check_count(count: u64) -> Result<()> {
    if count == 0 {
        return Err(Error::ZeroCount { what: "--count" });
    }
    if count > MAX_POINTS {
        return Err(Error::Arguments {
            asked: format!("{count} points of blue noise"),
            limit: format!("elimination takes at most {MAX_POINTS}, made all at once"),
            remedy: "ask for fewer, or use a sequence such as sobol or r2".into(),
        });
    }
    Ok(())
}

/// Takes away the point that others crowd most until `target` are left: those, and the
/// others in the order in which they went.
fn eliminate(points: &[[u32; 2]], target: usize, limited: bool) -> (Vec<[u32; 2]>, Vec<[u32; 2]>) {
    let distance = lattice_distance(target as u64);
    let least = if limited { limit(distance) } else { 0 };
    let weigh = |squared: u64| weight(squared, distance, least);
    let grid = Grid::new(points, distance);
    let mut weights = vec![0; points.len()];
    for (i, sum) in weights.iter_mut().enumerate() {
        grid.visit(i, |_, squared| *sum += weigh(squared));
    }
    // The heaviest first, the first of equals.
    let entries = weights.iter().copied().enumerate();
    let mut heap: BinaryHeap<(u64, Reverse<usize>)> =
        entries.map(|(i, weight)| (weight, Reverse(i))).collect();
    let mut stays = vec![true; points.len()];
    let mut gone = Vec::with_capacity(points.len() - target);
    while points.len() - gone.len() > target {
        let Some((weight, Reverse(i))) = heap.pop() else {
            break;
        };
        // Weights only fall, so one that has fallen goes back to its place.
        if weight != weights[i] {
            heap.push((weights[i], Reverse(i)));
            continue;
        }
        stays[i] = false;
        gone.push(points[i]);
        grid.visit(i, |j, squared| weights[j] -= weigh(squared));
    }
    let kept = points.iter().zip(stays).filter(|(_, stays)| *stays);
    (kept.map(|(point, _)| *point).collect(), gone)
}

/// sqrt(2 / (sqrt(3) count)), the least distance of `count` points in a hexagonal
/// lattice, in units of 2^-32 and to within two of them. That of one point is cut to 1,
/// so that its square fits; no two points of the torus are so far apart.
fn lattice_distance(count: u64) -> u64 {
    /// floor(2^62 * 2 / sqrt(3)).
    const AREA: u64 = 0x49e6_9d16_40cc_7134;
    ((AREA / count).isqrt() << 1).min(u64::from(u32::MAX))
}

/// Distance below which all points weigh the same: Yuksel's weight limiting with beta
/// 0.65, gamma 1.5 and a tenth of the candidates kept, 0.65 (1 - 10^-1.5) = 0.629.
fn limit(distance: u64) -> u64 {
    distance * 629 / 1000
}

/// (1 - d / distance)^8 in units of 2^-32, 0 from `distance` on.
fn weight(squared: u64, distance: u64, least: u64) -> u64 {
    let d = squared.isqrt().max(least);
    if d >= distance {
        return 0;
    }
    let x = ((distance - d) << 32) / distance;
    let square = |x: u64| ((u128::from(x) * u128::from(x)) >> 32) as u64;
    square(square(square(x)))
}

/// Points by cells that are at least as wide as their weights reach.
struct Grid<'a> {
    points: &'a [[u32; 2]],
    reach: u64,
    /// Cells along an axis.
    cells: u64,
    /// Where the members of each cell begin, and an end.
    starts: Vec<usize>,
    members: Vec<usize>,
}

impl<'a> Grid<'a> {
    fn new(points: &'a [[u32; 2]], reach: u64) -> Self {
        let cells = ((1u64 << 32) / reach).max(1);
        let cell = |p: &[u32; 2]| (along(p[1], cells) * cells + along(p[0], cells)) as usize;
        let mut starts = vec![0; (cells * cells) as usize + 1];
        for point in points {
            starts[cell(point) + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut members: Vec<usize> = (0..points.len()).collect();
        members.sort_by_key(|i| cell(&points[*i]));
        Self {
            points,
            reach,
            cells,
            starts,
            members,
        }
    }

    /// Shows every other point within reach of point `i`, with the squared distance.
    fn visit(&self, i: usize, mut see: impl FnMut(usize, u64)) {
        let point = self.points[i];
        // Of fewer than three cells, each once.
        let near =
            |at: u64| (0..self.cells.min(3)).map(move |k| (at + self.cells - 1 + k) % self.cells);
        for row in near(along(point[1], self.cells)) {
            for column in near(along(point[0], self.cells)) {
                let cell = (row * self.cells + column) as usize;
                for &j in &self.members[self.starts[cell]..self.starts[cell + 1]] {
                    let squared = squared_distance(point, self.points[j]);
                    if j != i && squared < self.reach * self.reach {
                        see(j, squared);
                    }
                }
            }
        }
    }
}

/// The cell of a coordinate.
fn along(u: u32, cells: u64) -> u64 {
    (u64::from(u) * cells) >> 32
}

/// Squared distance on the torus in units of 2^-64: at most 2^63.
fn squared_distance(p: [u32; 2], q: [u32; 2]) -> u64 {
    let axis = |a: u32, b: u32| {
        let d = a.wrapping_sub(b);
        u64::from(d.min(d.wrapping_neg()))
    };
    let (x, y) = (axis(p[0], q[0]), axis(p[1], q[1]));
    x * x + y * y
}
