//! Who reaches an error first.

use super::analysis::Reached;
use super::series::Series;
use super::statistics::Interval;

/// A series at a target.
#[derive(Clone, Copy, Debug)]
pub struct Standing<'a> {
    /// The series.
    pub series: &'a Series,
    /// When it reaches the target.
    pub reached: Reached,
    /// Its time over that of the first: below 1 of one run that was faster.
    pub slower: f64,
    /// Whether its interval and that of the first overlap, or its time is within a tenth, so
    /// that no one can say which is faster.
    pub tied: bool,
}

/// The share of a time that two runs of one study differ by.
const NOISE: f64 = 0.1;

/// Whether the times of these series are of one device, by its name and driver: those of several
/// say nothing of who is faster.
#[must_use]
pub fn comparable(series: &[&Series]) -> bool {
    series.windows(2).all(|pair| match pair {
        [one, other] => one.device == other.device,
        _ => true,
    })
}

/// The series of one integrand that reach a relative error: random ones with the fastest
/// first, then those of one run, which may have been lucky.
#[must_use]
pub fn standings<'a>(series: &[&'a Series], target: f64) -> Vec<Standing<'a>> {
    let mut reached: Vec<(&Series, Reached)> = series
        .iter()
        .filter_map(|one| Some((*one, one.analysis.reached(target * one.scale())?)))
        .collect();
    reached.sort_by(|(a, at), (b, bt)| {
        let runs = b.analysis.random.cmp(&a.analysis.random);
        runs.then(at.seconds.value.total_cmp(&bt.seconds.value))
    });
    let Some(&(_, best)) = reached.first() else {
        return Vec::new();
    };
    let standing = |(series, reached): (&'a Series, Reached)| Standing {
        series,
        reached,
        slower: reached.seconds.value / best.seconds.value,
        tied: overlap(&reached.seconds, &best.seconds)
            || (reached.seconds.value / best.seconds.value).ln().abs() <= NOISE.ln_1p(),
    };
    reached.into_iter().map(standing).collect()
}

fn overlap(one: &Interval, other: &Interval) -> bool {
    one.low <= other.high && other.low <= one.high
}
