//! The least distance against all pairs.

use super::{Random, halton, unseen};
use corput::stats::{Points, Source, hexagonal_distance, nearest};

fn every_pair(points: &Points, toroidal: bool) -> f64 {
    let rows: Vec<&[f64]> = points.iter().collect();
    let mut least = f64::INFINITY;
    for (i, p) in rows.iter().enumerate() {
        for q in &rows[..i] {
            let difference = |(a, b): (&f64, &f64)| {
                let d: f64 = a - b;
                if toroidal { d - d.round() } else { d }
            };
            let square: f64 = p.iter().zip(*q).map(difference).map(|d| d * d).sum();
            least = least.min(square.sqrt());
        }
    }
    least
}

#[test]
fn the_nearest_pair_is_that_of_all_pairs() {
    for columns in 1..7 {
        for rows in [2, 3, 5, 17, 100, 700] {
            for (set, points) in [
                Random(rows as u64).points(rows, columns),
                halton(rows as u32, columns.min(6)),
            ]
            .iter()
            .enumerate()
            {
                for toroidal in [false, true] {
                    let found = nearest(points, toroidal, &mut unseen).unwrap().unwrap();
                    let truth = every_pair(points, toroidal);
                    assert!(
                        (found.distance - truth).abs() < 1e-14,
                        "set {set} {rows} x {columns} {toroidal}: {found:?} {truth}"
                    );
                    let rows = found
                        .rows
                        .map(|row| points.iter().nth(row).unwrap().to_vec());
                    let pair = Points::new(columns, rows.concat(), Source::F64).unwrap();
                    assert!(found.rows[0] < found.rows[1]);
                    assert!((every_pair(&pair, toroidal) - truth).abs() < 1e-14);
                }
            }
        }
    }
}

#[test]
fn the_torus_has_no_border() {
    let points = Points::new(2, vec![0.01, 0.5, 0.99, 0.5, 0.5, 0.0], Source::F64).unwrap();
    let [plain, torus] = [false, true].map(|t| nearest(&points, t, &mut unseen).unwrap().unwrap());
    assert!((plain.distance - 0.49f64.hypot(0.5)).abs() < 1e-15);
    assert!((torus.distance - 0.02).abs() < 1e-15 && torus.rows == [0, 1]);
}

#[test]
fn one_point_has_no_neighbour_and_two_equal_ones_no_distance() {
    let one = Points::new(2, vec![0.5; 2], Source::F64).unwrap();
    assert_eq!(nearest(&one, true, &mut unseen).unwrap(), None);
    let mut values = Random(4).points(1000, 3).values().to_vec();
    values.copy_within(0..3, 300);
    let found = nearest(
        &Points::new(3, values, Source::F64).unwrap(),
        true,
        &mut unseen,
    )
    .unwrap();
    assert_eq!(found.map(|f| (f.distance, f.rows)), Some((0.0, [0, 100])));
}

/// A hexagonal grid, as near as fractions get to it, has the bound; nothing has more, and
/// random points far less.
#[test]
fn no_set_exceeds_the_hexagonal_bound() {
    // 30 rows of 26, every other one shifted: 30 is near 26 times 2 / sqrt(3).
    let values: Vec<f64> = (0..30 * 26)
        .flat_map(|i| {
            let (row, column) = (f64::from(i / 26), f64::from(i % 26));
            [(column + 0.5 * (row % 2.0)) / 26.0, row / 30.0]
        })
        .collect();
    let ratio = |points: &Points| {
        let found = nearest(points, true, &mut unseen).unwrap().unwrap();
        found.distance / hexagonal_distance(points.rows())
    };
    let hexagonal = Points::new(2, values, Source::F64).unwrap();
    assert!(
        (0.999..=1.0).contains(&ratio(&hexagonal)),
        "{}",
        ratio(&hexagonal)
    );
    assert!(ratio(&Random(5).points(780, 2)) < 0.2);
}
