//! Discrepancies in the mean square, by their closed forms over pairs of points.
//!
//! Each is the worst-case error of a quadrature in a space with a product kernel K, whose
//! square is (int int K)^d - 2 mean_i prod int K(x_i) + mean_i mean_j prod K(x_i, x_j):
//!
//! - L2-star: Warnock 1972, Computational investigations of low-discrepancy point sets,
//!   eq. (1). **The square root**, as in SciPy.
//! - centred (eq. 4.4 there), wrap-around and modified L2 (eq. 3.3): Hickernell 1998, A
//!   generalized discrepancy and quadrature error bound, Math. Comp. 67, and Lattice rules:
//!   how well do they measure up? **Squares**, as SciPy's CD and WD.
//! - mixture: Zhou, Fang and Ning 2013, Mixture discrepancy for quasi-random point sets,
//!   J. Complexity 29, eq. (18). **The square**, as SciPy's MD, which is this one and not
//!   the modified.
//!
//! They take N^2 d / 2 products; sums are compensated, and the error of the rest is
//! bounded and returned.

use super::{Points, Progress, threads};
use crate::error::Result;

/// Which of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum L2 {
    /// L2-star, the square root.
    Star,
    /// Centred, the square.
    Centred,
    /// Wrap-around, the square.
    WrapAround,
    /// Mixture, the square.
    Mixture,
    /// Modified L2, the square: the sum of L2-star's squares over all projections.
    Modified,
}

/// All of them.
pub const L2_KINDS: [L2; 5] = [
    L2::Star,
    L2::Centred,
    L2::WrapAround,
    L2::Mixture,
    L2::Modified,
];

impl L2 {
    /// `l2_star`, `centred`, `wrap_around`, `mixture` or `modified_l2`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Star => "l2_star",
            Self::Centred => "centred",
            Self::WrapAround => "wrap_around",
            Self::Mixture => "mixture",
            Self::Modified => "modified_l2",
        }
    }

    /// Whether the value is the square root: `square root` or `square`.
    #[must_use]
    pub const fn convention(self) -> &'static str {
        match self {
            Self::Star => "square root",
            _ => "square",
        }
    }
}

/// A discrepancy and what rounding may have done to its square.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct L2Value {
    /// The square. Rounding may take it below 0.
    pub square: f64,
    /// The most by which the square may be off.
    pub square_error: f64,
    /// The value by its convention.
    pub value: f64,
}

/// The parts of a closed form.
trait Kernel {
    /// The mean of K over both arguments.
    const MEAN: f64;
    /// The mean of K over one argument.
    fn single(x: f64) -> f64;
    /// K.
    fn pair(x: f64, y: f64) -> f64;
}

struct Star;
struct Centred;
struct WrapAround;
struct Mixture;
struct Modified;

impl Kernel for Star {
    const MEAN: f64 = 1.0 / 3.0;
    fn single(x: f64) -> f64 {
        0.5 * (1.0 - x * x)
    }
    fn pair(x: f64, y: f64) -> f64 {
        1.0 - if x > y { x } else { y }
    }
}

impl Kernel for Centred {
    const MEAN: f64 = 13.0 / 12.0;
    fn single(x: f64) -> f64 {
        let z = (x - 0.5).abs();
        1.0 + 0.5 * (z - z * z)
    }
    fn pair(x: f64, y: f64) -> f64 {
        1.0 + 0.5 * ((x - 0.5).abs() + (y - 0.5).abs() - (x - y).abs())
    }
}

impl Kernel for WrapAround {
    const MEAN: f64 = 4.0 / 3.0;
    fn single(_: f64) -> f64 {
        4.0 / 3.0
    }
    fn pair(x: f64, y: f64) -> f64 {
        let z = (x - y).abs();
        1.5 - z * (1.0 - z)
    }
}

impl Kernel for Mixture {
    const MEAN: f64 = 19.0 / 12.0;
    fn single(x: f64) -> f64 {
        let z = (x - 0.5).abs();
        5.0 / 3.0 - 0.25 * (z + z * z)
    }
    fn pair(x: f64, y: f64) -> f64 {
        let z = (x - y).abs();
        1.875 - 0.25 * ((x - 0.5).abs() + (y - 0.5).abs()) - z * (0.75 - 0.5 * z)
    }
}

impl Kernel for Modified {
    const MEAN: f64 = 4.0 / 3.0;
    fn single(x: f64) -> f64 {
        0.5 * (3.0 - x * x)
    }
    fn pair(x: f64, y: f64) -> f64 {
        2.0 - if x > y { x } else { y }
    }
}

/// The discrepancy of points; `progress` counts points.
///
/// # Errors
/// Those of `progress`.
pub fn l2_discrepancy(points: &Points, kind: L2, progress: Progress) -> Result<L2Value> {
    let above = match kind {
        L2::Star => triangle::<Star>(points, progress),
        L2::Centred => triangle::<Centred>(points, progress),
        L2::WrapAround => triangle::<WrapAround>(points, progress),
        L2::Mixture => triangle::<Mixture>(points, progress),
        L2::Modified => triangle::<Modified>(points, progress),
    }?;
    Ok(l2_from_pairs(points, kind, above, 0.0))
}

/// The discrepancy from the sum of the products over all pairs i < j, which was made
/// elsewhere, and of which each product may be off by `error`.
#[must_use]
pub fn l2_from_pairs(points: &Points, kind: L2, above: f64, error: f64) -> L2Value {
    let [mean, single, diagonal] = match kind {
        L2::Star => rest::<Star>(points),
        L2::Centred => rest::<Centred>(points),
        L2::WrapAround => rest::<WrapAround>(points),
        L2::Mixture => rest::<Mixture>(points),
        L2::Modified => rest::<Modified>(points),
    };
    let count = points.rows() as f64;
    let pairs = (2.0 * above / count + diagonal) / count;
    let square = mean - single - single + pairs;
    // At most 6 roundings a factor, 8 in a block's sum, and a few at the end.
    let roundings = 6.0 * points.columns() as f64 + 16.0;
    let square_error = error + roundings * 0.5 * f64::EPSILON * (mean + 2.0 * single + pairs);
    let value = match kind {
        L2::Star => square.max(0.0).sqrt(),
        _ => square,
    };
    L2Value {
        square,
        square_error,
        value,
    }
}

/// The mean of K over both points and over one, and of its values at a point with itself.
fn rest<K: Kernel>(points: &Points) -> [f64; 3] {
    let count = points.rows() as f64;
    let dimensions = i32::try_from(points.columns()).unwrap_or(i32::MAX);
    let (mut single, mut diagonal) = (Sum::default(), Sum::default());
    for point in points.iter() {
        single.add(point.iter().map(|&x| K::single(x)).product());
        diagonal.add(point.iter().map(|&x| K::pair(x, x)).product());
    }
    [
        K::MEAN.powi(dimensions),
        single.value() / count,
        diagonal.value() / count,
    ]
}

/// Points that are multiplied out at a time, and whose sum is a tree of 8 levels.
const LANES: usize = 256;

/// Rows of a piece of work; the sum is of pieces, whoever works on them.
const ROWS: usize = 64;

/// The sum of the products over i < j, by blocks of rows.
fn triangle<K: Kernel>(points: &Points, progress: Progress) -> Result<f64> {
    let rows = points.rows();
    let mut columns = vec![0.0; points.values().len()];
    for (i, point) in points.iter().enumerate() {
        for (k, &x) in point.iter().enumerate() {
            columns[k * rows + i] = x;
        }
    }
    let mut sums = vec![Sum::default(); rows.div_ceil(ROWS)];
    // So many pieces that a thread is busy for a while, and progress is seen.
    let share = (1 << 24) / (ROWS * points.values().len()).max(1) + 1;
    let mut done = 0;
    for step in sums.chunks_mut(share * threads()) {
        std::thread::scope(|scope| {
            for (i, part) in step.chunks_mut(share).enumerate() {
                let columns = &columns;
                scope.spawn(move || {
                    for (j, sum) in part.iter_mut().enumerate() {
                        *sum = piece::<K>(points, columns, (done + i * share + j) * ROWS);
                    }
                });
            }
        });
        done += step.len();
        progress((done * ROWS).min(rows) as u64, rows as u64)?;
    }
    let mut all = Sum::default();
    for part in sums {
        all.add(part.high);
        all.add(part.low);
    }
    Ok(all.value())
}

fn piece<K: Kernel>(points: &Points, columns: &[f64], first: usize) -> Sum {
    let rows = points.rows();
    let mut sum = Sum::default();
    let mut products = [0.0; LANES];
    for (i, point) in points.iter().enumerate().skip(first).take(ROWS) {
        let mut j = i + 1;
        while j < rows {
            let lanes = LANES.min(rows - j);
            products[..lanes].fill(1.0);
            products[lanes..].fill(0.0);
            for (k, &x) in point.iter().enumerate() {
                let others = &columns[k * rows + j..k * rows + j + lanes];
                for (product, &y) in products.iter_mut().zip(others) {
                    *product *= K::pair(x, y);
                }
            }
            let mut width = LANES / 2;
            while width > 0 {
                let (low, high) = products.split_at_mut(width);
                for (a, b) in low.iter_mut().zip(high) {
                    *a += *b;
                }
                width /= 2;
            }
            sum.add(products[0]);
            j += lanes;
        }
    }
    sum
}

/// A compensated sum (Neumaier 1974).
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    fn add(&mut self, x: f64) {
        let sum = self.high + x;
        self.low += if self.high.abs() >= x.abs() {
            (self.high - sum) + x
        } else {
            (x - sum) + self.high
        };
        self.high = sum;
    }

    fn value(self) -> f64 {
        self.high + self.low
    }
}
