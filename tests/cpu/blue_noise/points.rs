//! Sample elimination: distances, order, determinism, and a slow implementation.

use corput::blue_noise::{MAX_POINTS, blue_noise_points};

fn points(count: u64, seed: u64) -> Vec<[u32; 2]> {
    blue_noise_points(count, seed).unwrap_or_else(|error| panic!("{error}"))
}

/// The least distance of two points on the torus, as a share of that of the hexagonal
/// lattice of as many.
fn share(points: &[[u32; 2]]) -> f64 {
    let axis = |a: u32, b: u32| {
        let d = (f64::from(a) - f64::from(b)).abs() / 4_294_967_296.0;
        d.min(1.0 - d)
    };
    let mut least = f64::INFINITY;
    for (i, p) in points.iter().enumerate() {
        for q in &points[..i] {
            least = least.min(axis(p[0], q[0]).hypot(axis(p[1], q[1])));
        }
    }
    least / (2.0 / (3f64.sqrt() * points.len() as f64)).sqrt()
}

#[test]
fn points_keep_their_distance() {
    for (count, seeds) in [(64, 32), (256, 16), (1024, 8), (4096, 2)] {
        for seed in 0..seeds {
            let points = points(count, super::seed(seed));
            let whole = share(&points);
            assert!(whole >= 0.7, "{count} points, seed {seed}: {whole}");
            for part in [2, 4, 8] {
                let prefix = share(&points[..points.len() / part]);
                assert!(prefix >= 0.5, "a {part}th of {count}: {prefix}");
            }
        }
    }
    // White noise, a jittered grid, and the same points in another order fail.
    let white: Vec<[u32; 2]> = super::white_ranks(1024, 5)
        .iter()
        .zip(super::white_ranks(1024, 9))
        .map(|(x, y)| [x << 22, y << 22])
        .collect();
    assert!(share(&white) < 0.2);
    let jitter = |k: u32| super::white_ranks(1024, u64::from(k))[7] << 17;
    let jittered: Vec<[u32; 2]> = (0..1024u32)
        .map(|i| {
            [
                ((i % 32) << 27) + jitter(2 * i),
                ((i / 32) << 27) + jitter(2 * i + 1),
            ]
        })
        .collect();
    assert!(share(&jittered) < 0.6);
    let set = points(1024, 3);
    let order = super::white_ranks(1024, 3);
    let shuffled: Vec<[u32; 2]> = order.iter().map(|i| set[*i as usize]).collect();
    assert!(share(&shuffled) >= 0.7 && share(&shuffled[..256]) < 0.45);
}

#[test]
fn small_sets_and_limits() {
    for count in 1..40 {
        let points = points(count, 4);
        assert_eq!(points.len() as u64, count);
        assert!(count < 2 || share(&points) > 0.5, "{count}");
    }
    assert_eq!(blue_noise_points(0, 0).expect_err("none").exit_code(), 2);
    let error = blue_noise_points(MAX_POINTS + 1, 0).expect_err("too many");
    assert!(error.to_string().contains("65536"), "{error}");
}

/// Weights of all pairs in `f64` and a scan for the heaviest: the same choice, but for
/// rounding, which one set of 48 points does not meet.
#[test]
fn elimination_is_that_of_the_paper() {
    let found = points(48, 11);
    let distance = |count: usize| (2.0 / (3f64.sqrt() * count as f64)).sqrt();
    let unit = |u: u32| f64::from(u) / 4_294_967_296.0;
    let apart = |p: &[u32; 2], q: &[u32; 2]| {
        let axis = |a: u32, b: u32| {
            let d = (unit(a) - unit(b)).abs();
            d.min(1.0 - d)
        };
        axis(p[0], q[0]).hypot(axis(p[1], q[1]))
    };
    // Any prefix that a halving leaves is what eliminating from the larger one leaves.
    for size in [48usize, 24, 12, 6] {
        let mut left = found[..size].to_vec();
        let mut gone = Vec::new();
        while left.len() > size / 2 {
            let reach = distance(size / 2);
            let weight = |p: &[u32; 2]| -> f64 {
                let others = left.iter().filter(|q| *q != p);
                let each = |q: &[u32; 2]| (1.0 - apart(p, q) / reach).max(0.0).powi(8);
                others.map(each).sum()
            };
            let weights: Vec<f64> = left.iter().map(weight).collect();
            let heaviest = weights.iter().copied().fold(0.0, f64::max);
            let at = weights.iter().position(|w| *w == heaviest).expect("one");
            gone.push(left.remove(at));
        }
        gone.reverse();
        assert_eq!(found[size / 2..size], gone, "of {size}");
    }
}

#[test]
fn seeds_give_other_points_and_the_same_again() {
    assert_eq!(points(100, 1), points(100, 1));
    assert_ne!(points(100, 1), points(100, 2));
    let hash = points(1024, 1).iter().flatten().fold(0u64, |hash, word| {
        (hash ^ u64::from(*word)).wrapping_mul(0x0100_0000_01b3)
    });
    assert_eq!(hash, POINTS_FNV);
}

/// Of 1,024 points of seed 1, so that a change of any kind is seen.
const POINTS_FNV: u64 = 981_379_129_202_820_953;
