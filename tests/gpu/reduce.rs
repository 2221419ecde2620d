//! Exact sums of floats on every device: no order, no group and no split shows.

mod support;

use corput::bulk::reduce;
use corput::check::{REDUCTIONS, mix};
use corput::judge::float_sum;
use corput::kernels::{Reducer, Split, largest_group};

#[test]
fn the_order_does_not_show() {
    support::on_each_device(|device| {
        let reducer = Reducer::new(device).expect("a reducer");
        for reduction in REDUCTIONS.iter().filter(|one| one.name != "equal terms") {
            let terms = reduction.terms();
            let mut others = terms.clone();
            others.sort_by(f32::total_cmp);
            let got = [&terms, &others].map(|terms| reducer.reduce(terms).expect("a sum"));
            assert_eq!(got[0], got[1], "{}", reduction.name);
            assert_eq!(got[0], reduce(&terms).expect("a sum"), "{}", reduction.name);
        }
    });
}

/// Values that a sum in floats, or in `f64`, does not have.
#[test]
fn sums_round_once() {
    let tiny = f32::from_bits(1);
    let cases: [(&[f32], f64); 9] = [
        (&[], 0.0),
        (&[-0.0, 0.0], 0.0),
        (&[1e30, 1.0, -1e30], 1.0),
        (
            &[f32::MAX, f32::MAX, tiny, -f32::MAX, -f32::MAX],
            tiny.into(),
        ),
        (&[-3.5, 1.25], -2.25),
        // A tie of f64, which rounds to even, and what decides it from far below.
        (&[9_007_199_254_740_992.0, 1.0], 9_007_199_254_740_992.0),
        (
            &[9_007_199_254_740_992.0, 1.0, tiny],
            9_007_199_254_740_994.0,
        ),
        (
            &[9_007_199_254_740_992.0, 1.0, -tiny],
            9_007_199_254_740_992.0,
        ),
        (
            &[-9_007_199_254_740_992.0, -1.0, -tiny],
            -9_007_199_254_740_994.0,
        ),
    ];
    for (terms, value) in cases {
        let sum = reduce(terms).expect("a sum");
        assert_eq!(sum.value(), value, "{terms:?}");
        assert_eq!(Some(sum.words()), float_sum(terms), "{terms:?}");
    }
    // Where f64 is exact it is the same.
    for i in 0..1000 {
        let terms = [0, 1, 2].map(|j| (mix(3 * i + j) as i32 >> 8) as f32 / 1024.0);
        let exact: f64 = terms.iter().map(|x| f64::from(*x)).sum();
        assert_eq!(reduce(&terms).expect("a sum").value(), exact);
    }
    let sum = reduce(&[1.0, f32::NAN, f32::INFINITY]).expect("a sum");
    assert_eq!((sum.value(), sum.count(), sum.special()), (1.0, 3, 2));
    assert_eq!(float_sum(&[f32::NAN]), None);
}

#[test]
fn splits_and_groups_beyond_limits_are_refused() {
    support::on_one_device(|device| {
        let reducer = Reducer::new(device).expect("a reducer");
        assert_eq!(reducer.reduce(&[]).expect("nothing").count(), 0);
        for (dispatch, run) in [(0, 1), (1, 0), ((1 << 22) + 1, 1), (1, (1 << 15) + 1)] {
            let refused = reducer.reduce_in(&[1.0], Split { dispatch, run });
            assert_eq!(refused.map_err(|error| error.exit_code()).err(), Some(2));
        }
        for group in [0, largest_group(device) + 1] {
            let refused = Reducer::with_group(device, group).map(|_| ());
            assert_eq!(refused.map_err(|error| error.exit_code()), Err(2));
        }
    });
}
