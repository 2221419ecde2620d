//! Elementary intervals, and the t-value of a net.
//!
//! An elementary interval in bases b_1, ..., b_d is a box of sides b_j^-k_j with corners
//! on the grid of that mesh; a shape is a choice of the k_j. A (t, m, d)-net in base 2 has
//! 2^m points, of which every elementary interval of volume 2^(t-m) holds 2^t:
//! Niederreiter 1987, Point sets and sequences with small discrepancy, Monatsh. Math. 104.

use super::{Points, Progress, refused};
use crate::error::Result;

/// A shape, and how evenly its cells are filled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shape {
    /// The k_j: digits of each coordinate.
    pub digits: Vec<u32>,
    /// Cells of the shape.
    pub cells: u64,
    /// Cells that hold as many points as is fair: N / cells, rounded down or up.
    pub fair: u64,
    /// Fewest points of a cell.
    pub least: u64,
    /// Most points of a cell.
    pub most: u64,
}

impl Shape {
    /// Whether every cell is filled fairly.
    #[must_use]
    pub fn is_fair(&self) -> bool {
        self.fair == self.cells
    }
}

/// The t-value, as closely as it was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TValue {
    /// log2 of the number of points.
    pub m: u32,
    /// t is at least this.
    pub least: u32,
    /// t is at most this.
    pub most: u32,
}

impl TValue {
    /// t, if it was found exactly.
    #[must_use]
    pub fn exact(self) -> Option<u32> {
        (self.least == self.most).then_some(self.most)
    }
}

/// The most shapes that [`elementary_intervals`] goes through, `full` or not.
pub const MAX_SHAPES: usize = 1 << 16;

/// Shapes in these bases: with `full` those that have as many cells as there are points,
/// otherwise all that have at most as many.
///
/// The first N points of a van der Corput, Halton or (0, d)-sequence are fair in all.
///
/// # Errors
/// [`crate::Error::Arguments`] for a number of bases other than that of coordinates, a base
/// below 2, more than [`MAX_SHAPES`] shapes, or more than `work` looks at a coordinate;
/// those of `progress`, which counts shapes.
pub fn elementary_intervals(
    points: &Points,
    bases: &[u32],
    full: bool,
    work: u64,
    progress: Progress,
) -> Result<Vec<Shape>> {
    if bases.len() != points.columns() || bases.iter().any(|base| *base < 2) {
        return Err(refused(
            format!("elementary intervals in bases {bases:?}"),
            format!(
                "points of {} coordinates take as many bases, each at least 2",
                points.columns()
            ),
            "give one base for each coordinate",
        ));
    }
    let count = points.rows() as u64;
    let (mut shapes, mut seen) = (Vec::new(), 0);
    let mut digits = vec![0; bases.len()];
    list(bases, count, 0, 1, &mut digits, &mut |digits, cells| {
        if !full || cells == count {
            shapes.push((digits.to_vec(), cells));
        }
        seen += 1;
        seen <= MAX_SHAPES
    });
    let asked = || format!("shapes of {count} points in bases {bases:?}");
    let remedy = "measure fewer points or coordinates";
    if seen > MAX_SHAPES {
        let limit = format!("there are more shapes than {MAX_SHAPES}");
        return Err(refused(asked(), limit, remedy));
    }
    let looks = (shapes.len() as u64).saturating_mul(points.values().len() as u64);
    if looks > work {
        let limit = format!(
            "{} shapes of {} coordinates take more than {work} steps",
            shapes.len(),
            points.values().len()
        );
        return Err(refused(asked(), limit, remedy));
    }
    let total = shapes.len() as u64;
    let mut found = Vec::new();
    for (digits, cells) in shapes {
        found.push(shape(points, bases, digits, cells));
        progress(found.len() as u64, total)?;
    }
    Ok(found)
}

/// Visits every shape of at most `most` cells until the visitor has had enough.
fn list(
    bases: &[u32],
    most: u64,
    at: usize,
    cells: u64,
    digits: &mut [u32],
    visit: &mut dyn FnMut(&[u32], u64) -> bool,
) -> bool {
    if at == bases.len() {
        return visit(digits, cells);
    }
    let mut cells = cells;
    for k in 0.. {
        digits[at] = k;
        if !list(bases, most, at + 1, cells, digits, visit) {
            return false;
        }
        match cells.checked_mul(u64::from(bases[at])) {
            Some(more) if more <= most => cells = more,
            _ => break,
        }
    }
    digits[at] = 0;
    true
}

fn shape(points: &Points, bases: &[u32], digits: Vec<u32>, cells: u64) -> Shape {
    let sizes: Vec<u64> = bases
        .iter()
        .zip(&digits)
        .map(|(&base, &k)| u64::from(base).pow(k))
        .collect();
    let mut counts = vec![0u32; cells as usize];
    for point in points.iter() {
        let mut at = 0;
        for (&x, &size) in point.iter().zip(&sizes) {
            at = at * size + cell(x, size);
        }
        counts[at as usize] += 1;
    }
    let low = points.rows() as u64 / cells;
    let high = (points.rows() as u64).div_ceil(cells);
    let fair = |count: &&u32| (low..=high).contains(&u64::from(**count));
    Shape {
        digits,
        cells,
        fair: counts.iter().filter(fair).count() as u64,
        least: counts.iter().min().map_or(0, |n| u64::from(*n)),
        most: counts.iter().max().map_or(0, |n| u64::from(*n)),
    }
}

/// floor(x n), exactly: the rounded product is off by what the fused one finds.
fn cell(x: f64, n: u64) -> u64 {
    let n = n as f64;
    let product = x * n;
    let below = product.floor() == product && x.mul_add(n, -product) < 0.0;
    product as u64 - u64::from(below)
}

/// The t-value of 2^m points as a net in base 2, with at most `work` tests of a point
/// against a shape.
///
/// Any 2^m points are a net with t = m, and none of them a better one than its
/// projections.
///
/// # Errors
/// [`crate::Error::Arguments`] for a number of points that is no power of 2; those of
/// `progress`, which counts shapes.
pub fn t_value(points: &Points, work: u64, progress: Progress) -> Result<TValue> {
    let count = points.rows();
    if !count.is_power_of_two() {
        return Err(refused(
            format!("the t-value of {count} points"),
            "nets in base 2 have a power of 2 of them",
            "measure the first 2^m",
        ));
    }
    let m = count.ilog2();
    let words: Vec<Vec<u32>> = (0..points.columns())
        .map(|k| {
            points
                .iter()
                .map(|p| (p[k] * 4_294_967_296.0) as u32)
                .collect()
        })
        .collect();
    // Evenness at 2^q cells implies that at 2^(q-1): q rises until it fails.
    let mut left = work;
    for q in 1..=m {
        let cost = shapes_of(q, points.columns()).saturating_mul(count as u64);
        if cost > left {
            return Ok(TValue {
                m,
                least: pair_bound(&words, m, q, left),
                most: m - (q - 1),
            });
        }
        left -= cost;
        progress(u64::from(q - 1), u64::from(m))?;
        let mut even = Even {
            words: &words,
            counts: vec![0; 1 << q],
            fair: 1 << (m - q),
        };
        if !even.all(0, q, &vec![0; count]) {
            return Ok(TValue {
                m,
                least: m - (q - 1),
                most: m - (q - 1),
            });
        }
    }
    Ok(TValue {
        m,
        least: 0,
        most: 0,
    })
}

/// Ways to write q as a sum of d terms, in order.
fn shapes_of(q: u32, d: usize) -> u64 {
    let mut ways = 1u128;
    for i in 1..d as u128 {
        ways = ways * (u128::from(q) + i) / i;
        if ways > u128::from(u64::MAX) {
            return u64::MAX;
        }
    }
    ways as u64
}

/// The least t that pairs of dimensions allow, from 2^`from` cells on: as many pairs as the
/// work lasts for.
fn pair_bound(words: &[Vec<u32>], m: u32, from: u32, mut work: u64) -> u32 {
    let mut good = m;
    for (i, first) in words.iter().enumerate() {
        for second in &words[i + 1..] {
            let pair = [first.clone(), second.clone()];
            while good >= from {
                let cost = u64::from(good + 1) * first.len() as u64;
                if cost > work {
                    return m - good;
                }
                work -= cost;
                let mut even = Even {
                    words: &pair,
                    counts: vec![0; 1 << good],
                    fair: 1 << (m - good),
                };
                if even.all(0, good, &vec![0; first.len()]) {
                    break;
                }
                good -= 1;
            }
        }
    }
    m - good
}

/// A test whether all shapes of a volume are filled evenly.
struct Even<'a> {
    words: &'a [Vec<u32>],
    counts: Vec<u32>,
    fair: u32,
}

impl Even<'_> {
    /// Whether all shapes are that split `q` digits among the dimensions from `at` on, where
    /// the earlier ones have put each point into a cell.
    fn all(&mut self, at: usize, q: u32, cells: &[u32]) -> bool {
        let Some(words) = self.words.get(at) else {
            return true;
        };
        let deeper = |k: u32| -> Vec<u32> {
            cells
                .iter()
                .zip(words)
                .map(|(&cell, &word)| {
                    if k == 0 {
                        cell
                    } else {
                        (cell << k) | (word >> (32 - k))
                    }
                })
                .collect()
        };
        if at + 1 == self.words.len() {
            return self.even(&deeper(q));
        }
        (0..=q).all(|k| self.all(at + 1, q - k, &deeper(k)))
    }

    fn even(&mut self, cells: &[u32]) -> bool {
        self.counts.fill(0);
        for &cell in cells {
            let count = &mut self.counts[cell as usize];
            *count += 1;
            if *count > self.fair {
                return false;
            }
        }
        true
    }
}
