//! What a cell's means and times come to: errors with intervals, a slope, times to errors.

use super::cell::{Cell, Point};
use super::counts::SlopeCounts;
use super::hits::{ENOUGH, ENOUGH_OF_ONE, Rarity, missed};
use super::monotone::rising;
use super::statistics::{Interval, Statistic, fit, median, quantile, slope};
use super::truth::Truth;

/// Errors below so many floors say nothing of the sampler.
pub(super) const ABOVE_FLOOR: f64 = 10.0;

/// Counts from which on a slope is fitted: below, the first digits of a sequence decide.
pub(super) const SLOPE_FROM: u64 = 64;

/// A cell in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysis {
    /// How replicates come to one error.
    pub statistic: Statistic,
    /// Whether the sampler is random; if not, errors have no interval.
    pub random: bool,
    /// By count, rising.
    pub errors: Vec<ErrorAt>,
    /// The slope over the counts from 64 on whose hits are not few, and whose errors are
    /// above ten floors; its ends are those of the value where the sampler is not random.
    pub slope: Option<Interval>,
    /// Whether `slope` has an interval.
    pub slope_has_interval: bool,
    /// Which counts it is of.
    pub slope_counts: SlopeCounts,
    /// Means that are not finite.
    pub not_finite: u64,
}

/// The error at a count, in the integrand's unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorAt {
    /// Points.
    pub count: u64,
    /// The error, with its interval; both ends are the value where the sampler is not random.
    pub error: Interval,
    /// The mean over the replicates, less the truth.
    pub bias: f64,
    /// The standard error of that; 0 of one replicate.
    pub bias_error: f64,
    /// Time of a replicate on the device in seconds: the median, and the quartiles.
    pub seconds: Interval,
    /// The same with the host's work, the median.
    pub host_seconds: f64,
    /// Whether it is above ten floors.
    pub above_floor: bool,
    /// Points of all replicates on which the error hangs; `None` where that is not known.
    pub hits: Option<f64>,
    /// Fewer are few: 100, and 100/32 of a single run.
    pub enough: f64,
    /// Whether the mean over the replicates is off by more than they differ: all missed the same.
    pub missed: bool,
}

impl ErrorAt {
    /// Whether so few points speak for the error that its interval is too narrow.
    #[must_use]
    pub fn few_hits(&self) -> bool {
        self.missed || self.hits.is_some_and(|hits| hits < self.enough)
    }
}

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
    /// Of a cell; `rarity` is that of its integrand and estimator, if it is known. A median does
    /// not hang on rare terms, and heeds none.
    #[must_use]
    pub fn new(
        cell: &Cell,
        truth: &Truth,
        random: bool,
        statistic: Statistic,
        rarity: Option<Rarity>,
    ) -> Self {
        let rarity = rarity.filter(|_| statistic == Statistic::Rmse);
        let errors: Vec<Vec<f64>> = cell
            .points
            .iter()
            .map(|point| {
                finite(&point.means)
                    .map(|mean| mean - truth.value)
                    .collect()
            })
            .collect();
        let at: Vec<ErrorAt> = cell
            .points
            .iter()
            .zip(&errors)
            .map(|(point, errors)| {
                let at = error_at(point, errors, truth, statistic);
                ErrorAt {
                    hits: rarity.map(|rarity| rarity.hits(point.count, errors.len())),
                    enough: if random { ENOUGH } else { ENOUGH_OF_ONE },
                    missed: statistic == Statistic::Rmse
                        && missed(
                            at.bias,
                            at.bias_error,
                            errors.len(),
                            ABOVE_FLOOR * truth.floor(),
                        ),
                    ..at
                }
            })
            .collect();
        let fitted = |one: &ErrorAt| one.above_floor && one.count >= SLOPE_FROM && !one.few_hits();
        let counts: Vec<u64> = at
            .iter()
            .filter(|one| fitted(one))
            .map(|one| one.count)
            .collect();
        let kept: Vec<&[f64]> = at
            .iter()
            .zip(&errors)
            .filter(|(one, _)| fitted(one))
            .map(|(_, errors)| errors.as_slice())
            .collect();
        let bare = || {
            let values = kept.iter().map(|errors| statistic.of(errors));
            fit(&counts, values).map(exact)
        };
        let with_interval = slope(&counts, &kept, statistic).filter(|_| random);
        Self {
            statistic,
            random,
            slope_counts: SlopeCounts::of(&at),
            errors: at,
            slope: with_interval.or_else(bare),
            slope_has_interval: with_interval.is_some(),
            not_finite: cell.points.iter().map(not_finite).sum(),
        }
    }

    /// Whether an error at a number of points has too few hits: by the measured count that is the
    /// nearest above.
    #[must_use]
    pub fn few_hits_at(&self, count: f64) -> bool {
        let above = self.errors.iter().find(|one| one.count as f64 >= count);
        above.is_some_and(ErrorAt::few_hits)
    }

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

fn error_at(point: &Point, errors: &[f64], truth: &Truth, statistic: Statistic) -> ErrorAt {
    let n = errors.len() as f64;
    let bias = errors.iter().sum::<f64>() / n;
    let spread: f64 = errors.iter().map(|error| (error - bias).powi(2)).sum();
    let error = statistic
        .interval(errors)
        .unwrap_or_else(|| exact(statistic.of(errors)));
    ErrorAt {
        count: point.count,
        error,
        bias,
        bias_error: if n > 1.0 {
            (spread / (n - 1.0) / n).sqrt()
        } else {
            0.0
        },
        seconds: Interval {
            value: 1e-9 * median(point.device_ns.clone()),
            low: 1e-9 * quantile(point.device_ns.clone(), 0.25),
            high: 1e-9 * quantile(point.device_ns.clone(), 0.75),
        },
        host_seconds: 1e-9 * median(point.host_ns.clone()),
        above_floor: error.value > ABOVE_FLOOR * truth.floor(),
        hits: None,
        enough: ENOUGH,
        missed: false,
    }
}

fn exact(value: f64) -> Interval {
    Interval {
        value,
        low: value,
        high: value,
    }
}

fn finite(means: &[f64]) -> impl Iterator<Item = f64> {
    means.iter().copied().filter(|mean| mean.is_finite())
}

fn not_finite(point: &Point) -> u64 {
    (point.means.len() - finite(&point.means).count()) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(error: impl Fn(u64, u32) -> f64) -> Cell {
        let point = |log: u32| Point {
            count: 1 << log,
            means: (0..32).map(|r| 0.5 + error(1 << log, r)).collect(),
            variances: vec![1.0; 32],
            device_ns: vec![1e3 * f64::from(1 << log); 5],
            host_ns: vec![2e3 * f64::from(1 << log); 5],
        };
        Cell {
            setup_ms: 0.0,
            first_ms: 0.0,
            points: (4..=16).map(point).collect(),
            refused: Vec::new(),
            warnings: Vec::new(),
        }
    }

    fn alternating(count: u64, r: u32) -> f64 {
        let size = 1.0 / count as f64;
        if r.is_multiple_of(2) { size } else { -size }
    }

    fn truth(floor: f64) -> Truth {
        Truth::stated(0.5, floor)
    }

    #[test]
    fn slope_and_time_of_a_known_law() {
        let made = Analysis::new(&cell(alternating), &truth(0.0), true, Statistic::Rmse, None);
        let slope = made.slope.unwrap();
        assert!(
            (slope.value + 1.0).abs() < 1e-9 && made.slope_has_interval,
            "{slope:?}"
        );
        // 1/n = 1e-3 at n = 1000, of 1 us each.
        let reached = made.reached(1e-3).unwrap();
        assert!((reached.count - 1000.0).abs() < 1e-6, "{reached:?}");
        assert!((reached.seconds.value - 1e-3).abs() < 1e-9, "{reached:?}");
        assert_eq!(made.reached(1e-6), None);
        assert_eq!(made.not_finite, 0);
    }

    #[test]
    fn errors_near_the_floor_do_not_bend_the_slope() {
        let level = 1e-4;
        let flat = |count, r| alternating(count, r) + if r % 2 == 0 { level } else { -level };
        let bent = Analysis::new(&cell(flat), &truth(0.0), true, Statistic::Rmse, None);
        let kept = Analysis::new(&cell(flat), &truth(level), true, Statistic::Rmse, None);
        let (bent, kept) = (bent.slope.unwrap().value, kept.slope.unwrap().value);
        // 1/n + 1e-4 by least squares, to 2^16 and to 2^10.
        assert!(
            (bent + 0.7375).abs() < 1e-4 && (kept + 0.9683).abs() < 1e-4,
            "{bent} {kept}"
        );
    }

    #[test]
    fn an_error_that_comes_back_is_not_reached_before() {
        // Good by chance at 256, then worse.
        let lucky = |count, r| {
            if count == 256 {
                1e-9
            } else {
                alternating(count, r)
            }
        };
        let made = Analysis::new(&cell(lucky), &truth(0.0), true, Statistic::Rmse, None);
        assert!(made.reached(1e-3).unwrap().count > 512.0);
    }

    #[test]
    fn the_interval_of_a_time_holds_it() {
        let mut odd = cell(alternating);
        for point in &mut odd.points {
            // The more points the faster.
            point.device_ns = vec![1e9 / point.count as f64; 5];
            for (r, mean) in (0..).zip(&mut point.means) {
                *mean += 0.02 * f64::from(r) * (*mean - 0.5);
            }
        }
        let made = Analysis::new(&odd, &truth(0.0), true, Statistic::Rmse, None);
        let time = made.reached(1e-3).unwrap().seconds;
        assert!(
            time.low <= time.value && time.value <= time.high,
            "{time:?}"
        );
        let error = made.errors[3].error;
        assert!(error.low < error.value && error.value < error.high);
    }

    #[test]
    fn means_that_are_no_numbers_are_counted() {
        let holed = |count, r| {
            if r == 3 {
                f64::NAN
            } else {
                alternating(count, r)
            }
        };
        let made = Analysis::new(&cell(holed), &truth(0.0), true, Statistic::Rmse, None);
        assert_eq!(made.not_finite, 13);
        assert!(made.errors[0].error.value.is_finite());
    }

    /// Replicates that agree on a wrong mean have missed what is rare, however many hits others
    /// count.
    #[test]
    fn what_all_replicates_missed_is_told_by_the_truth() {
        let low = |count, r| 1e-3 * alternating(count, r) - 1e-4;
        let of = |cell: &Cell, floor, statistic| {
            let made = Analysis::new(cell, &truth(floor), true, statistic, None);
            made.errors.iter().filter(|at| at.few_hits()).count()
        };
        let every = cell(low).points.len();
        assert_eq!(of(&cell(low), 0.0, Statistic::Rmse), every);
        assert_eq!(of(&cell(low), 1e-4, Statistic::Rmse), 0);
        assert_eq!(of(&cell(low), 0.0, Statistic::MedianAbsolute), 0);
        assert_eq!(of(&cell(alternating), 0.0, Statistic::Rmse), 0);
        // One of many standard errors is chance.
        let near = |count, r| alternating(count, r) + 0.5 / count as f64;
        assert_eq!(of(&cell(near), 0.0, Statistic::Rmse), 0);
    }

    #[test]
    fn counts_of_few_hits_do_not_bend_the_slope() {
        // As of a peak that hardly a point meets: the error does not fall.
        let missed = |count, r| match count < 1024 {
            true => 512.0 * alternating(1024, r),
            false => alternating(count, r),
        };
        let of = |rarity| {
            let cell = cell(missed);
            Analysis::new(&cell, &truth(1e-6), true, Statistic::Rmse, rarity)
        };
        // 100 hits of 32 replicates at 2^9.64 points.
        let rarity = Some(Rarity {
            share: 100.0 / 32.0 / 800.0,
        });
        let (bent, kept) = (of(None), of(rarity));
        assert!((bent.slope.unwrap().value + 1.0).abs() > 0.1);
        assert!((kept.slope.unwrap().value + 1.0).abs() < 1e-9);
        // 16 and 32; 64 to 512; 2^10 to 2^16, of which all are above 1e-5.
        let counts = SlopeCounts {
            fitted: 7,
            small: 2,
            few_hits: 4,
            near_floor: 0,
        };
        assert_eq!(kept.slope_counts, counts);
        assert!(kept.few_hits_at(300.0) && !kept.few_hits_at(1000.0));
        assert_eq!(bent.slope_counts.few_hits, 0);
        let (cell, truth) = (cell(missed), truth(1e-6));
        let median = Analysis::new(&cell, &truth, true, Statistic::MedianAbsolute, rarity);
        assert_eq!(median.slope_counts.few_hits, 0);
    }
}
