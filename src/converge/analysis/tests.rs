//! Laws whose slopes and times are known.

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
