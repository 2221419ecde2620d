//! Discrepancies in the mean square, against SciPy and exact rationals.

use super::{Random, hammersley, unseen};
use corput::stats::{L2, L2_KINDS, L2Value, Points, Source, l2_discrepancy};
use serde_json::Value;

fn found(points: &Points, kind: L2) -> L2Value {
    l2_discrepancy(points, kind, &mut unseen).unwrap()
}

fn points(columns: usize, values: &[f64]) -> Points {
    Points::new(columns, values.to_vec(), Source::F64).unwrap()
}

/// The sets of the vector file.
pub fn vectors() -> Vec<(Value, Points)> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/discrepancy.json");
    let text = std::fs::read_to_string(path).unwrap();
    let rows: Vec<Value> = serde_json::from_str(&text).unwrap();
    let set = |row: Value| {
        let list = row["points"].as_array().unwrap();
        let words: Vec<&Value> = list.iter().flat_map(|p| p.as_array().unwrap()).collect();
        let values = words
            .iter()
            .map(|w| w.as_u64().unwrap() as f64 / 4_294_967_296.0);
        let columns = words.len() / list.len();
        let points = Points::new(columns, values.collect(), Source::U32).unwrap();
        (row, points)
    };
    rows.into_iter().map(set).collect()
}

#[test]
fn squares_are_the_exact_ones_within_their_stated_error() {
    let mut closest = f64::INFINITY;
    for (row, points) in vectors() {
        for kind in L2_KINDS {
            let key = |kind: L2| row[format!("exact_{}", kind.name())].as_f64().unwrap();
            let got = found(&points, kind);
            let error = (got.square - key(kind)).abs();
            assert!(
                error <= got.square_error,
                "{}: {kind:?} {error:e}",
                row["name"]
            );
            assert!(got.square_error < 1e-13 * (1.0 + key(kind)) * points.rows().min(90) as f64);
            // Another kind is told apart, unless it is the same in one dimension.
            for other in L2_KINDS.into_iter().filter(|other| *other != kind) {
                if points.columns() > 1 {
                    closest = closest.min((got.square - key(other)).abs() / got.square_error);
                }
            }
        }
    }
    assert!(closest > 1e6, "kinds differ by {closest:e} of the error");
}

/// SciPy sums without compensation, so it is itself off by some 1e-14 of the largest term.
#[test]
fn values_are_scipys() {
    for (row, points) in vectors() {
        for kind in [L2::Star, L2::Centred, L2::WrapAround, L2::Mixture] {
            let scipy = row[kind.name()].as_f64().unwrap();
            let got = found(&points, kind);
            let term = got.square_error / f64::EPSILON;
            let derivative = if kind == L2::Star { 0.5 / scipy } else { 1.0 };
            let allowed = 1e-12 * scipy + 1e-16 * term * derivative;
            let error = (got.value - scipy).abs();
            assert!(
                error <= allowed,
                "{}: {kind:?} {error:e} > {allowed:e}",
                row["name"]
            );
        }
    }
}

#[test]
fn golden_values() {
    let design = [13.0, 26.0, 32.0, 45.0, 51.0, 64.0f64];
    let pairs = design.map(|word| [(word / 10.0).floor(), word % 10.0]);
    let scaled: Vec<f64> = pairs
        .concat()
        .iter()
        .map(|x| (2.0 * x - 1.0) / 12.0)
        .collect();
    let got = found(&points(2, &scaled), L2::Centred).value;
    assert!((got - 0.008_142_039_609_053_464).abs() < 1e-15, "{got}");

    let sobol = &vectors()[0].1;
    for (kind, value) in [
        (L2::Centred, 0.013_882_107_204_860_938),
        (L2::WrapAround, 0.011_406_792_534_722_321),
        (L2::Mixture, 0.015_877_617_730_033_49),
        (L2::Star, 0.104_653_808_840_677_68),
    ] {
        let got = found(sobol, kind).value;
        assert!((got / value - 1.0).abs() < 2e-13, "{kind:?} {got}");
    }
    // L2-star of the point (1, ..., 1), here one unit below.
    for d in 1..12 {
        let got = found(&points(d, &vec![1.0 - f64::EPSILON / 2.0; d]), L2::Star).value;
        assert!(
            (got / 3f64.powf(-0.5 * d as f64) - 1.0).abs() < 1e-12,
            "{d}"
        );
    }
}

/// L2-star's square is the integral of the squared local discrepancy; here by the midpoint
/// rule, which shares nothing with the closed form.
#[test]
fn l2_star_is_the_integral_of_its_definition() {
    let set = Random(11).points(13, 2);
    let side = 1000;
    let mut sum = 0.0;
    for i in 0..side {
        for j in 0..side {
            let [a, b] = [i, j].map(|k| (f64::from(k) + 0.5) / f64::from(side));
            let inside = set.iter().filter(|p| p[0] < a && p[1] < b).count();
            sum += (a * b - inside as f64 / 13.0).powi(2);
        }
    }
    let (integral, got) = (sum / f64::from(side * side), found(&set, L2::Star).square);
    assert!((got / integral - 1.0).abs() < 2e-3, "{got} {integral}");
    assert!((found(&set, L2::Star).value.powi(2) - got).abs() < 1e-16);
}

/// Shifts on the torus change only what does not wrap around; reflections what is no
/// centre of symmetry.
#[test]
fn invariances() {
    let set = Random(12).points(300, 3);
    let change =
        |f: &dyn Fn(f64) -> f64| points(3, &set.values().iter().map(|x| f(*x)).collect::<Vec<_>>());
    let shifted = change(&|x| (x + 0.3).fract());
    let mirrored = change(&|x| 1.0 - f64::EPSILON - x);
    for kind in L2_KINDS {
        let same = |other: &Points| {
            (found(&set, kind).square / found(other, kind).square - 1.0).abs() < 1e-9
        };
        assert_eq!(same(&shifted), kind == L2::WrapAround, "{kind:?}");
        let symmetric = matches!(kind, L2::Centred | L2::WrapAround | L2::Mixture);
        assert_eq!(same(&mirrored), symmetric, "{kind:?}");
    }
}

#[test]
fn good_sets_score_better_than_bad_ones() {
    let (good, random) = (hammersley(10), Random(13).points(1024, 2));
    let clumped = points(
        2,
        &random.values().iter().map(|x| 0.5 * x).collect::<Vec<_>>(),
    );
    for kind in L2_KINDS {
        let [a, b, c] = [&good, &random, &clumped].map(|set| found(set, kind).value);
        assert!(4.0 * a < b && 4.0 * b < c, "{kind:?}: {a} {b} {c}");
    }
}

/// The same bits whatever the order in which pieces end, and an end when asked for.
#[test]
fn work_in_pieces() {
    let set = Random(14).points(20_000, 2);
    let mut steps = 0;
    let first = l2_discrepancy(&set, L2::Centred, &mut |done, total| {
        steps += 1;
        assert!(done <= total && total == 20_000);
        Ok(())
    })
    .unwrap();
    assert!(steps > 2);
    assert_eq!(first, found(&set, L2::Centred));
    let stopped = l2_discrepancy(&set, L2::Star, &mut |done, total| {
        Err(corput::Error::Interrupted { done, total })
    });
    assert!(stopped.is_err());
}
