//! Who reaches an error first.

use super::analysis::Reached;
use super::results::Series;

/// A series at a target.
#[derive(Clone, Copy, Debug)]
pub struct Standing<'a> {
    /// The series.
    pub series: &'a Series,
    /// When it reaches the target.
    pub reached: Reached,
    /// Its time over that of the fastest.
    pub slower: f64,
    /// Whether its interval and that of the fastest overlap, so that no one can say which is
    /// faster.
    pub tied: bool,
}

/// The series of one integrand that reach a relative error, the fastest first.
#[must_use]
pub fn standings<'a>(series: &[&'a Series], target: f64) -> Vec<Standing<'a>> {
    let mut reached: Vec<(&Series, Reached)> = series
        .iter()
        .filter_map(|one| Some((*one, one.analysis.reached(target * one.scale())?)))
        .collect();
    reached.sort_by(|a, b| a.1.seconds.value.total_cmp(&b.1.seconds.value));
    let Some(&(_, best)) = reached.first() else {
        return Vec::new();
    };
    let standing = |(series, reached): (&'a Series, Reached)| Standing {
        series,
        reached,
        slower: reached.seconds.value / best.seconds.value,
        tied: reached.seconds.low <= best.seconds.high,
    };
    reached.into_iter().map(standing).collect()
}
