//! What replicates say: an error with its interval, and the slope of errors over counts.
//!
//! Intervals are percentiles of bootstrap resamples (Efron and Tibshirani 1993, ch. 13): the
//! replicates are drawn anew with replacement, by random numbers of a counter, so that the
//! same estimates always have the same interval.

use crate::reference::random::random;
use glam::UVec2;

/// Resamples: their 25th from either end is the end of the interval.
pub(super) const RESAMPLES: u32 = 1000;

/// A value and its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The value of the replicates as they are.
    pub value: f64,
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

/// How the errors of replicates come to one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Statistic {
    /// Root of the mean square.
    Rmse,
    /// Median of the magnitudes: for integrands whose variance is infinite.
    MedianAbsolute,
}

impl Statistic {
    /// As documents name it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rmse => "rmse",
            Self::MedianAbsolute => "median-absolute-error",
        }
    }

    /// As figures name it.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::Rmse => "RMSE",
            Self::MedianAbsolute => "median |error|",
        }
    }

    /// Of errors; NaN of none.
    #[must_use]
    pub fn of(self, errors: &[f64]) -> f64 {
        match self {
            Self::Rmse => {
                let squares: f64 = errors.iter().map(|e| e * e).sum();
                (squares / errors.len() as f64).sqrt()
            }
            Self::MedianAbsolute => median(errors.iter().map(|e| e.abs()).collect()),
        }
    }

    /// Of errors, with its interval; `None` of fewer than two, which have none.
    #[must_use]
    pub fn interval(self, errors: &[f64]) -> Option<Interval> {
        let resampled = |drawn: &[usize]| Some(self.of(&chosen(errors, drawn)));
        bootstrap(errors.len(), resampled)
    }
}

/// Slope of the logarithm of the error over that of the count, by least squares over all
/// counts, of which each has the errors of the same replicates: one is drawn at every count
/// or at none, since its points at one count are among those at the next. `None` of fewer
/// than three counts or two replicates, and where an error is 0.
#[must_use]
pub fn slope(counts: &[u64], errors: &[&[f64]], statistic: Statistic) -> Option<Interval> {
    let replicates = errors.iter().map(|one| one.len()).min()?;
    bootstrap(replicates, |drawn| {
        let values = errors.iter().map(|one| statistic.of(&chosen(one, drawn)));
        fit(counts, values)
    })
}

/// The slope alone, of errors by count.
#[must_use]
pub fn fit(counts: &[u64], errors: impl Iterator<Item = f64>) -> Option<f64> {
    let points: Vec<(f64, f64)> = counts
        .iter()
        .zip(errors)
        .map(|(&count, error)| ((count as f64).ln(), error.ln()))
        .collect();
    if points.len() < 3 || !points.iter().all(|(_, y)| y.is_finite()) {
        return None;
    }
    let n = points.len() as f64;
    let x_mean = points.iter().map(|p| p.0).sum::<f64>() / n;
    let y_mean = points.iter().map(|p| p.1).sum::<f64>() / n;
    let product: f64 = points
        .iter()
        .map(|(x, y)| (x - x_mean) * (y - y_mean))
        .sum();
    let square: f64 = points.iter().map(|(x, _)| (x - x_mean).powi(2)).sum();
    (square > 0.0).then(|| product / square)
}

/// The middle of values, the mean of the two in the middle; NaN of none.
#[must_use]
pub fn median(values: Vec<f64>) -> f64 {
    quantile(values, 0.5)
}

/// The value below which so large a share lies, between neighbours by their distance; NaN
/// of none.
#[must_use]
pub fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let place = share * values.len().saturating_sub(1) as f64;
    let at = |place: f64| values.get(place as usize).copied().unwrap_or(f64::NAN);
    let (below, above) = (at(place.floor()), at(place.ceil()));
    below + place.fract() * (above - below)
}

/// A statistic of the replicates with these numbers: as they are, and resampled.
fn bootstrap(replicates: usize, of: impl Fn(&[usize]) -> Option<f64>) -> Option<Interval> {
    if replicates < 2 {
        return None;
    }
    let value = of(&(0..replicates).collect::<Vec<usize>>())?;
    let mut drawn = vec![0; replicates];
    let resampled = (0..RESAMPLES).filter_map(|resample| {
        for (place, one) in drawn.iter_mut().enumerate() {
            let word = random(resample, place as u32, UVec2::ZERO);
            *one = ((u64::from(word) * replicates as u64) >> 32) as usize;
        }
        of(&drawn)
    });
    let values: Vec<f64> = resampled.collect();
    Some(Interval {
        value,
        low: quantile(values.clone(), 0.025),
        high: quantile(values, 0.975),
    })
}

fn chosen(errors: &[f64], drawn: &[usize]) -> Vec<f64> {
    drawn
        .iter()
        .filter_map(|&r| errors.get(r).copied())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sums of twelve uniform numbers less 6: nearly normal, of variance 1.
    fn normal(index: u32) -> f64 {
        let uniform = |k| f64::from(random(index, k, UVec2::new(7, 7))) / 4_294_967_296.0;
        (0..12).map(uniform).sum::<f64>() - 6.0
    }

    #[test]
    fn quantiles_are_those_of_the_definition() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), 2.5);
        assert_eq!(quantile(vec![0.0, 10.0], 0.25), 2.5);
        assert!(median(Vec::new()).is_nan());
    }

    /// The true value lies in 95 of 100 intervals, less what percentiles of 32 lack; a
    /// binomial bound of 4 standard errors around a coverage of 0.91.
    #[test]
    fn intervals_cover_the_truth() {
        for (statistic, truth) in [(Statistic::Rmse, 1.0), (Statistic::MedianAbsolute, 0.6745)] {
            let covered = (0..400).filter(|study| {
                let errors: Vec<f64> = (0..32).map(|r| normal(study * 32 + r)).collect();
                let one = statistic.interval(&errors).unwrap();
                (one.low..=one.high).contains(&truth)
            });
            let covered = covered.count();
            assert!((341..=390).contains(&covered), "{statistic:?}: {covered}");
        }
    }

    #[test]
    fn slopes_are_found_with_their_intervals() {
        let counts: Vec<u64> = (4..=16).map(|log| 1 << log).collect();
        let errors: Vec<Vec<f64>> = (0..)
            .zip(&counts)
            .map(|(k, &count)| {
                let size = (count as f64).powf(-1.5);
                (0..32).map(|r| size * normal(1000 * k + r)).collect()
            })
            .collect();
        let slices: Vec<&[f64]> = errors.iter().map(Vec::as_slice).collect();
        let found = slope(&counts, &slices, Statistic::Rmse).unwrap();
        assert!((found.value + 1.5).abs() < 0.05, "{found:?}");
        assert!(found.low < -1.5 && found.high > -1.5, "{found:?}");
        assert!(found.high - found.low < 0.2, "{found:?}");
    }

    #[test]
    fn nothing_is_said_of_too_little() {
        assert_eq!(Statistic::Rmse.interval(&[1.0]), None);
        assert_eq!(fit(&[1, 2], [1.0, 0.5].into_iter()), None);
        assert_eq!(fit(&[1, 2, 4], [1.0, 0.5, 0.0].into_iter()), None);
    }
}
