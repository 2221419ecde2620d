//! When an error is reached.

use super::Analysis;
use crate::converge::monotone::rising;
use crate::converge::statistics::Interval;

/// When an error is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// Seconds on the device: the value, and what the ends of the errors' intervals give; an
    /// upper end that is not reached within the study is infinite.
    pub seconds: Interval,
    /// The number of points, between two that were measured.
    pub count: f64,
}

impl Analysis {
    /// When the error comes below a target for good, for all counts that follow; by
    /// interpolation of the logarithms between measured counts, of times that are made to rise
    /// with them. The interval is from the error's lower end and the time's lower quartile to
    /// their upper ones. `None` where it never does.
    #[must_use]
    pub fn reached(&self, target: f64) -> Option<Reached> {
        let of = |value: fn(&Interval) -> f64, time: fn(&Interval) -> f64| {
            let seconds: Vec<f64> = self.errors.iter().map(|one| time(&one.seconds)).collect();
            let line = self
                .errors
                .iter()
                .zip(rising(&seconds))
                .map(|(one, seconds)| (one.count as f64, seconds, value(&one.error)));
            crossing(&line.collect::<Vec<_>>(), target)
        };
        let (count, value) = of(|error| error.value, |time| time.value)?;
        let low = of(|error| error.low, |time| time.low).map_or(value, |found| found.1);
        let high = of(|error| error.high, |time| time.high).map_or(f64::INFINITY, |found| found.1);
        Some(Reached {
            seconds: Interval {
                value,
                low: low.min(value),
                high: high.max(value),
            },
            count,
        })
    }
}

/// Count and time at which a line of (count, time, error) falls below a target for good.
fn crossing(line: &[(f64, f64, f64)], target: f64) -> Option<(f64, f64)> {
    let below = line
        .iter()
        .rev()
        .take_while(|(_, _, error)| *error <= target)
        .count();
    let first = line.len() - below;
    let &(count, time, error) = line.get(first)?;
    let before = first.checked_sub(1).and_then(|index| line.get(index));
    let Some(&(count_before, time_before, error_before)) = before else {
        return Some((count, time));
    };
    if error <= 0.0 {
        return Some((count, time));
    }
    let part = (error_before / target).ln() / (error_before / error).ln();
    let between = |a: f64, b: f64| a * (b / a).powf(part);
    Some((between(count_before, count), between(time_before, time)))
}
