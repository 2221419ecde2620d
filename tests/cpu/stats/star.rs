//! Star discrepancy: exact values against every box, and bounds around them.

use super::{Random, halton, hammersley, unseen};
use corput::stats::{Points, Source, star_1d, star_2d, star_bounds};

/// The largest local discrepancy over every corner of coordinates of points and 1.
fn every_box(points: &Points) -> f64 {
    let d = points.columns();
    let axis = |k: usize| -> Vec<f64> { points.iter().map(|p| p[k]).chain([1.0]).collect() };
    let axes: Vec<Vec<f64>> = (0..d).map(axis).collect();
    let side = points.rows() + 1;
    let mut worst = 0.0f64;
    for i in 0..side.pow(d as u32) {
        let corner: Vec<f64> = (0..d)
            .map(|k| axes[k][i / side.pow(k as u32) % side])
            .collect();
        let volume: f64 = corner.iter().product();
        let share = |within: &dyn Fn(&f64, &f64) -> bool| {
            let inside = points
                .iter()
                .filter(|p| p.iter().zip(&corner).all(|(x, t)| within(x, t)));
            inside.count() as f64 / points.rows() as f64
        };
        worst = worst
            .max(volume - share(&|x, t| x < t))
            .max(share(&|x, t| x <= t) - volume);
    }
    worst
}

/// Random points, some of them on one another and on common lines.
fn tied(seed: u64, rows: usize, columns: usize) -> Points {
    let points = Random(seed).points(rows, columns);
    let coarse = points
        .values()
        .iter()
        .map(|x| (x * 8.0).floor() / 8.0)
        .collect();
    Points::new(columns, coarse, Source::F64).unwrap()
}

#[test]
fn exact_in_one_dimension() {
    for n in 1..40 {
        for points in [Random(n).points(n as usize, 1), tied(n, n as usize, 1)] {
            let (got, truth) = (star_1d(points.values()), every_box(&points));
            assert!((got - truth).abs() < 1e-14, "{n}: {got} {truth}");
        }
    }
    // Niederreiter: centred strata have the least, 1 / 2N.
    let best: Vec<f64> = (0..10).map(|i| (f64::from(i) + 0.5) / 10.0).collect();
    assert!((star_1d(&best) - 0.05).abs() < 1e-15);
    assert_eq!(star_1d(&[0.0]), 1.0);
}

#[test]
fn exact_in_two_dimensions() {
    for n in 1..30 {
        for points in [Random(n).points(n as usize, 2), tied(n, n as usize, 2)] {
            let got = star_2d(&points.pairs(0, 1).unwrap(), &mut unseen).unwrap();
            let truth = every_box(&points);
            assert!((got - truth).abs() < 1e-14, "{n}: {got} {truth}");
        }
    }
    assert_eq!(star_2d(&[[0.0, 0.0]], &mut unseen).unwrap(), 1.0);
    // More abscissas than a piece of work: a point set and its mirror image in the
    // diagonal agree.
    let points = Random(99).pairs(3000);
    let mirrored: Vec<[f64; 2]> = points.iter().map(|p| [p[1], p[0]]).collect();
    let [a, b] = [points, mirrored].map(|set| star_2d(&set, &mut unseen).unwrap());
    assert!((a - b).abs() < 1e-14, "{a} {b}");
}

/// N times that of the Hammersley set of N = 2^m points is m/3 + 13/9 - (-1)^m 4 / (9 N):
/// De Clerck 1986, A method for exact calculation of the stardiscrepancy of plane sets
/// applied to the sequences of Hammersley, Monatsh. Math. 101.
#[test]
fn hammersley_has_its_published_value() {
    for m in 2..13 {
        let n = f64::from(1 << m);
        let good = star_2d(&hammersley(m).pairs(0, 1).unwrap(), &mut unseen).unwrap();
        let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
        let truth = f64::from(m) / 3.0 + 13.0 / 9.0 - sign * 4.0 / (9.0 * n);
        assert!(
            (good * n - truth).abs() < 1e-11,
            "{m}: {} {truth}",
            good * n
        );
        let bad = star_2d(&Random(3).pairs(1 << m), &mut unseen).unwrap();
        assert!(m < 4 || bad > 1.5 * good, "{m}: {bad} {good}");
    }
}

#[test]
fn bounds_close_in_on_the_exact_value() {
    for (rows, columns) in [(1, 1), (30, 1), (1, 2), (24, 2), (7, 3), (12, 3), (5, 4)] {
        for points in [
            Random(rows as u64).points(rows, columns),
            tied(rows as u64, rows, columns),
        ] {
            let truth = every_box(&points);
            // However little work there is, the truth is between them.
            for work in [0, 100, 3000] {
                let found = star_bounds(&points, work, &mut unseen).unwrap();
                assert!(
                    found.lower <= truth && truth <= found.upper,
                    "{work}: {found:?} {truth}"
                );
            }
            let found = star_bounds(&points, 1 << 24, &mut unseen).unwrap();
            assert!(found.is_exact(), "{rows} x {columns}: {found:?}");
            assert!((found.lower - truth).abs() < 1e-13, "{found:?} {truth}");
        }
    }
}

/// Larger sets: in two dimensions against the exact value, in more a bracket whose lower
/// end no projection exceeds and which more work narrows.
#[test]
fn bounds_hold_for_larger_sets() {
    let flat = halton(512, 2);
    let exact = star_2d(&flat.pairs(0, 1).unwrap(), &mut unseen).unwrap();
    let found = star_bounds(&flat, 1 << 24, &mut unseen).unwrap();
    assert!(
        found.lower <= exact && exact <= found.upper,
        "{found:?} {exact}"
    );
    assert!(found.upper < 1.5 * exact, "{found:?} {exact}");

    for columns in [3, 5] {
        let points = halton(256, columns);
        let little = star_bounds(&points, 1 << 18, &mut unseen).unwrap();
        let much = star_bounds(&points, 1 << 26, &mut unseen).unwrap();
        println!("{columns}: {little:?} {much:?}");
        assert!(much.lower <= much.upper && much.upper < little.upper);
        assert!(much.lower >= little.lower - 1e-12);
        let pair = star_2d(
            &points.pairs(columns - 2, columns - 1).unwrap(),
            &mut unseen,
        )
        .unwrap();
        assert!(pair <= much.upper);
        assert!(much.lower > 0.9 * pair, "{much:?} {pair}");
    }
}
