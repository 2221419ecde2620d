//! Sums over pairs in fixed point: the twin of the kernels against floating point, exact
//! integers and exact rationals.

use super::l2::vectors;
use super::{Random, halton, unseen};
use corput::bulk::{Columns, l2_from_sum, nearest_words, pair_scale, pair_sum};
use corput::glam::{self, UVec2, uvec2, uvec3};
use corput::reference::{discrepancy, distance};
use corput::stats::{L2, L2_KINDS, Points, Source, l2_discrepancy, nearest};

/// The value of a kernel, exactly, in units of 2^-67: 2^67 is 8 times 2^64.
fn kernel(kind: L2, x: u32, y: u32) -> u128 {
    let [x, y] = [i128::from(x), i128::from(y)];
    let half = 1i128 << 31;
    let one = 1i128 << 32;
    let (a, b, z) = ((x - half).abs(), (y - half).abs(), (x - y).abs());
    let value = match kind {
        L2::Star => (one - x.max(y)) << 35,
        L2::Centred => (2 * one + a + b - z) << 34,
        L2::WrapAround => (12 << 64) - 8 * z * (one - z),
        L2::Mixture => (15 << 64) - ((a + b) << 33) - ((6 * z) << 32) + 4 * z * z,
        L2::Modified => (2 * one - x.max(y)) << 35,
    };
    value as u128
}

fn factor(kind: L2, p: UVec2, x: u32, y: u32) -> UVec2 {
    match kind {
        L2::Star => discrepancy::star_factor(p, x, y),
        L2::Centred => discrepancy::centred_factor(p, x, y),
        L2::WrapAround => discrepancy::wrap_around_factor(p, x, y),
        L2::Mixture => discrepancy::mixture_factor(p, x, y),
        L2::Modified => discrepancy::modified_factor(p, x, y),
    }
}

/// p K off by more units than the header says, over critical and random arguments.
fn far(kind: L2, factor: impl Fn(UVec2, u32, u32) -> UVec2) -> usize {
    let mut random = Random(30);
    let mut word = || match (random.next() * 8.0) as u32 {
        0 => {
            [0, 1, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, u32::MAX][(random.next() * 6.0) as usize]
        }
        _ => (random.next() * 4_294_967_296.0) as u32,
    };
    let units = match kind {
        L2::WrapAround => 3,
        L2::Mixture => 7,
        _ => 1,
    };
    let mut found = 0;
    for _ in 0..100_000 {
        let p = uvec2(word(), word() >> 2);
        let (x, y) = (word(), word());
        let got = factor(p, x, y);
        let wide = |v: UVec2| u128::from(v.x) | u128::from(v.y) << 32;
        // p K is a product of 62 and 68 bits: its halves are taken apart.
        let k = kernel(kind, x, y);
        let (high, low) = (k >> 32, k & 0xffff_ffff);
        let exact = ((wide(p) * high) + ((wide(p) * low) >> 32)) >> 35;
        found += usize::from(wide(got).abs_diff(exact) > units);
    }
    found
}

#[test]
fn factors_are_within_their_units() {
    for kind in L2_KINDS {
        assert_eq!(far(kind, |p, x, y| factor(kind, p, x, y)), 0, "{kind:?}");
        let off = |p: UVec2, x, y| factor(kind, p + uvec2(0, 1), x, y);
        assert!(far(kind, off) > 90_000, "{kind:?}");
    }
    assert_eq!(
        discrepancy::scale64(uvec2(7, 5), 0x8000_0000),
        uvec2(0x8000_0003, 2)
    );
}

#[test]
fn fixed_point_is_within_its_bound() {
    for (row, points) in vectors() {
        for kind in L2_KINDS {
            let columns = Columns::new(&points).unwrap();
            assert!(columns.is_exact());
            let scale = pair_scale(kind, columns.dimensions());
            let sum = pair_sum(kind, &columns, scale);
            let got = l2_from_sum(kind, &columns, sum, scale).unwrap();
            let exact = row[format!("exact_{}", kind.name())].as_f64().unwrap();
            let error = (got.square - exact).abs();
            assert!(
                error <= got.square_error,
                "{}: {kind:?} {error:e}",
                row["name"]
            );
            assert!(
                got.square_error < 1e-12 * (1.0 + exact),
                "{}",
                got.square_error
            );
        }
    }
    // As many dimensions as are taken: a bound that says little, and holds.
    for kind in L2_KINDS {
        let points = halton(40, 6);
        let wide: Vec<f64> = points.iter().flat_map(|p| [p; 5].concat()).collect();
        let wide = Points::new(30, wide, Source::U32).unwrap();
        let columns = Columns::new(&wide).unwrap();
        let scale = pair_scale(kind, 30);
        assert!((32..63).contains(&scale));
        let got = l2_from_sum(kind, &columns, pair_sum(kind, &columns, scale), scale).unwrap();
        let truth = l2_discrepancy(&wide, kind, &mut unseen).unwrap();
        let error = (got.square - truth.square).abs();
        assert!(
            error <= got.square_error + truth.square_error,
            "{kind:?} {error:e}"
        );
    }
}

#[test]
fn nearest_words_are_the_nearest_points() {
    for (rows, columns) in [(1, 2), (2, 1), (300, 1), (200, 2), (150, 7)] {
        let points = halton(rows, columns.min(6));
        for toroidal in [false, true] {
            let truth = nearest(&points, toroidal, &mut unseen).unwrap();
            let words = nearest_words(&Columns::new(&points).unwrap(), toroidal);
            let Some((truth, words)) = truth.zip(words) else {
                assert!(rows == 1 && truth.is_none() && words.is_none());
                continue;
            };
            assert!((words.nearest().distance / truth.distance - 1.0).abs() < 1e-14);
        }
    }
    // Squares that 64 bits do not hold.
    let far = Points::new(3, vec![0.0, 0.0, 0.0, 0.75, 0.75, 0.75], Source::U32).unwrap();
    let found = nearest_words(&Columns::new(&far).unwrap(), false).unwrap();
    assert_eq!(found.square, uvec3(0, 0xb000_0000, 1));
    assert!((found.nearest().distance - 1.6875f64.sqrt()).abs() < 1e-15);
}

#[test]
fn sums_of_squares_carry_and_compare() {
    let mut random = Random(31);
    let wide = |v: glam::UVec3| u128::from(v.x) | u128::from(v.y) << 32 | u128::from(v.z) << 64;
    let mut word = || match (random.next() * 4.0) as u32 {
        0 => u32::MAX,
        1 => 0,
        _ => (random.next() * 4_294_967_296.0) as u32,
    };
    for _ in 0..10_000 {
        let (sum, d) = (uvec3(word(), word(), word() >> 1), word());
        let square = u128::from(d) * u128::from(d);
        assert_eq!(wide(distance::add_square(sum, d)), wide(sum) + square);
        let other = uvec3(word(), word(), word() >> 1);
        assert_eq!(distance::less96(sum, other), wide(sum) < wide(other));
        let (x, y) = (word(), word());
        assert_eq!(distance::apart(x, y), x.abs_diff(y));
        let around = u64::from(x.abs_diff(y)).min((1 << 32) - u64::from(x.abs_diff(y)));
        assert_eq!(u64::from(distance::apart_toroidal(x, y)), around);
    }
}

#[test]
fn points_between_the_words_are_said_to_be_rounded() {
    let points = Random(32).points(50, 2);
    let columns = Columns::new(&points).unwrap();
    assert!(!columns.is_exact());
    let scale = pair_scale(L2::Centred, 2);
    let sum = pair_sum(L2::Centred, &columns, scale);
    let got = l2_from_sum(L2::Centred, &columns, sum, scale)
        .unwrap()
        .square;
    let truth = l2_discrepancy(&points, L2::Centred, &mut unseen)
        .unwrap()
        .square;
    assert!(got != truth && (got - truth).abs() < 1e-9, "{got} {truth}");
    let error = Columns::new(&Random(33).points(2, 31)).unwrap_err();
    assert!(
        error.to_string().contains("up to 30") && error.exit_code() == 2,
        "{error}"
    );
}
