//! Elementary intervals and t-values: against counts by definition, and nets that are known.

use super::{Random, fractions, halton, hammersley, unseen};
use corput::stats::{MAX_SHAPES, Points, elementary_intervals, projections, t_value};

/// Every vector of `d` numbers with sum `q`.
fn compositions(q: u32, d: usize) -> Vec<Vec<u32>> {
    if d == 1 {
        return vec![vec![q]];
    }
    let rest = |k: u32| {
        compositions(q - k, d - 1)
            .into_iter()
            .map(move |c| [vec![k], c].concat())
    };
    (0..=q).flat_map(rest).collect()
}

/// The least t of the definition, by a map from cells to counts for each shape.
fn definition(points: &Points) -> u32 {
    let m = points.rows().ilog2();
    let even = |shape: &Vec<u32>, t: u32| {
        let mut counts = std::collections::HashMap::new();
        for p in points.iter() {
            let cell: Vec<u64> = p
                .iter()
                .zip(shape)
                .map(|(x, k)| (x * f64::powi(2.0, *k as i32)) as u64)
                .collect();
            *counts.entry(cell).or_insert(0u32) += 1;
        }
        counts.len() == 1 << (m - t) && counts.values().all(|count| *count == 1 << t)
    };
    let net = |t: &u32| {
        compositions(m - t, points.columns())
            .iter()
            .all(|shape| even(shape, *t))
    };
    (0..=m).find(net).unwrap()
}

#[test]
fn t_is_that_of_the_definition() {
    for m in 0..7u32 {
        for columns in 1..5 {
            for points in [
                Random(u64::from(m)).points(1 << m, columns),
                halton(1 << m, columns),
                // Powers of x over GF(2) in reverse: dependent dimensions, large t.
                fractions(1 << m, columns, |n, k| (n ^ (n << k)).reverse_bits()),
            ] {
                let found = t_value(&points, u64::MAX, &mut unseen).unwrap();
                assert_eq!(found.exact(), Some(definition(&points)), "{m} {columns}");
                // Less work gives bounds around it.
                for work in [0, 100, 2000] {
                    let bounds = t_value(&points, work, &mut unseen).unwrap();
                    assert!(
                        bounds.least <= definition(&points) && definition(&points) <= bounds.most
                    );
                }
            }
        }
    }
}

#[test]
fn hammersley_is_a_perfect_net_until_it_is_harmed() {
    for m in [1, 5, 10, 14] {
        let net = hammersley(m);
        assert_eq!(
            t_value(&net, u64::MAX, &mut unseen).unwrap().exact(),
            Some(0)
        );
        let shapes = elementary_intervals(&net, &[2, 2], true, u64::MAX, &mut unseen).unwrap();
        assert_eq!(shapes.len(), m as usize + 1);
        assert!(
            shapes
                .iter()
                .all(|s| s.is_fair() && s.least == 1 && s.most == 1)
        );
        // One point moved to another's place spoils it.
        let mut values = net.values().to_vec();
        (values[0], values[1]) = (values[2], values[3]);
        let harmed = Points::new(2, values, net.source()).unwrap();
        assert!(t_value(&harmed, u64::MAX, &mut unseen).unwrap().exact() > Some(0));
        let shapes = elementary_intervals(&harmed, &[2, 2], true, u64::MAX, &mut unseen).unwrap();
        assert!(
            shapes
                .iter()
                .all(|s| s.cells - s.fair == 2 && s.least == 0 && s.most == 2)
        );
    }
}

/// The first N points of Halton's sequence are fair in every shape of its bases, also where
/// N is no product of their powers; not in other bases.
#[test]
fn halton_is_fair_in_its_own_bases() {
    for n in [1, 6, 100, 216, 1000, 1296] {
        let shapes =
            elementary_intervals(&halton(n, 2), &[2, 3], false, u64::MAX, &mut unseen).unwrap();
        assert!(shapes.iter().all(|s| s.is_fair()), "{n}");
        let product = |s: &corput::stats::Shape| 2u64.pow(s.digits[0]) * 3u64.pow(s.digits[1]);
        assert!(
            shapes
                .iter()
                .all(|s| product(s) == s.cells && s.cells <= u64::from(n))
        );
        let most = shapes.iter().map(|s| s.cells).max();
        assert!(most.is_some_and(|most| 2 * most > u64::from(n)));
    }
    let others =
        elementary_intervals(&halton(1296, 2), &[3, 2], false, u64::MAX, &mut unseen).unwrap();
    assert!(others.iter().any(|s| !s.is_fair()));
    let full = elementary_intervals(&halton(216, 2), &[2, 3], true, u64::MAX, &mut unseen).unwrap();
    assert_eq!(
        full.iter().map(|s| s.digits.clone()).collect::<Vec<_>>(),
        [[3, 3]]
    );
}

/// i/3^k as the float above or below it: only one of the two is in cell i.
#[test]
fn cells_of_odd_bases_are_cut_exactly() {
    for k in [1, 5, 12] {
        let cells = 3u32.pow(k);
        let value = |up: bool| -> Vec<f64> {
            (0..cells)
                .map(|i| {
                    let x = f64::from(i) / f64::from(cells);
                    let exact = (i128::from(i) << 100) / i128::from(cells);
                    let below = ((x * f64::powi(2.0, 100)) as i128) <= exact;
                    match (up, below) {
                        (true, true) if i > 0 => x.next_up(),
                        (false, false) => x.next_down(),
                        _ => x,
                    }
                })
                .collect()
        };
        let shape = |values: Vec<f64>| {
            let points = Points::new(1, values, corput::stats::Source::F64).unwrap();
            elementary_intervals(&points, &[3], true, u64::MAX, &mut unseen)
                .unwrap()
                .remove(0)
        };
        assert!(shape(value(true)).is_fair());
        assert_eq!(shape(value(false)).most, 2);
    }
}

#[test]
fn the_worst_pair_is_found() {
    // Dimension 3 repeats dimension 1 but for its last bits.
    let points = fractions(256, 4, |n, k| match k {
        0 => n << 24,
        1 => n.reverse_bits(),
        2 => corput::reference::radical_inverse::radical_inverse(n, 3),
        _ => n.reverse_bits() ^ 1,
    });
    let found = projections(&points, &mut unseen).unwrap();
    let pairs: Vec<_> = found.iter().map(|p| p.dimensions).collect();
    assert_eq!(pairs, [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]);
    let worst = found
        .iter()
        .max_by(|a, b| a.centred.total_cmp(&b.centred))
        .unwrap();
    assert_eq!(worst.dimensions, [1, 3]);
    assert!(worst.correlation > Some(0.999_999) && worst.t > Some(6));
    assert_eq!(found[0].t, Some(0));
    assert!(found[0].correlation.unwrap().abs() < 0.05);
    assert!(
        projections(
            &points
                .column(0)
                .map(|x| Points::new(1, x, points.source()).unwrap())
                .unwrap(),
            &mut unseen
        )
        .unwrap()
        .is_empty()
    );
    let constant = fractions(8, 2, |n, k| if k == 0 { n << 29 } else { 7 });
    assert_eq!(
        projections(&constant, &mut unseen).unwrap()[0].correlation,
        None
    );
}

#[test]
fn what_cannot_be_counted_is_refused() {
    let points = halton(100, 2);
    assert!(t_value(&points, u64::MAX, &mut unseen).is_err());
    for bases in [&[2][..], &[2, 1], &[2, 0], &[2, 3, 5]] {
        assert!(elementary_intervals(&points, bases, false, u64::MAX, &mut unseen).is_err());
    }
    let wide = Random(1).points(1 << 10, 30);
    let error = elementary_intervals(&wide, &[2; 30], true, u64::MAX, &mut unseen).unwrap_err();
    assert!(
        error.to_string().contains(&MAX_SHAPES.to_string()),
        "{error}"
    );
    let error = elementary_intervals(&points, &[2, 2], false, 5599, &mut unseen).unwrap_err();
    assert!(
        error.to_string().contains("more than 5599 steps"),
        "{error}"
    );
    // A base that no digit of fits is a shape of one cell.
    let shapes =
        elementary_intervals(&points, &[u32::MAX, 101], false, u64::MAX, &mut unseen).unwrap();
    assert_eq!(shapes.len(), 1);
}
