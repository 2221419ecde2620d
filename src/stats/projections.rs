//! Projections to pairs of dimensions, and the worst of them.

use super::{L2, Points, Progress, l2_discrepancy, t_value};
use crate::error::Result;

/// A projection to two dimensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// The dimensions, the lower first.
    pub dimensions: [usize; 2],
    /// The square of the centred discrepancy.
    pub centred: f64,
    /// Pearson's correlation; `None` where a coordinate is constant.
    pub correlation: Option<f64>,
    /// The t-value in base 2; `None` for a number of points that is no power of 2.
    pub t: Option<u32>,
}

/// Every pair of dimensions, in order; the worst is that of the largest centred
/// discrepancy. None for points of one coordinate.
///
/// # Errors
/// Those of `progress`, which counts pairs.
pub fn projections(points: &Points, progress: Progress) -> Result<Vec<Projection>> {
    let columns = points.columns();
    let total = (columns * (columns - 1) / 2) as u64;
    let mut found = Vec::new();
    for first in 0..columns {
        for second in first + 1..columns {
            let pairs = points.pairs(first, second)?;
            let flat = Points::new(2, pairs.concat(), points.source())?;
            let centred = l2_discrepancy(&flat, L2::Centred, &mut |_, _| Ok(()))?;
            let t = if flat.rows().is_power_of_two() {
                t_value(&flat, u64::MAX, &mut |_, _| Ok(()))?.exact()
            } else {
                None
            };
            found.push(Projection {
                dimensions: [first, second],
                centred: centred.value,
                correlation: correlation(&pairs),
                t,
            });
            progress(found.len() as u64, total)?;
        }
    }
    Ok(found)
}

fn correlation(pairs: &[[f64; 2]]) -> Option<f64> {
    let count = pairs.len() as f64;
    let mean = |k: usize| pairs.iter().map(|p| p[k]).sum::<f64>() / count;
    let means = [mean(0), mean(1)];
    let moment = |i: usize, j: usize| -> f64 {
        let product = |p: &[f64; 2]| (p[i] - means[i]) * (p[j] - means[j]);
        pairs.iter().map(product).sum()
    };
    let scale = (moment(0, 0) * moment(1, 1)).sqrt();
    (scale > 0.0).then(|| (moment(0, 1) / scale).clamp(-1.0, 1.0))
}
