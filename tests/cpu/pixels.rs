//! Pictures: the problem and the points of each pixel, and estimates that merge.

use corput::bulk::{estimate, estimate_pixels};
use corput::catalog::{Options, Problem, Raster, Scramble, Sequence, integrands};
use corput::estimate::Pixels;
use corput::interface::{INTEGRANDS_OF_GROUP, integrand};
use std::collections::BTreeSet;

fn problem(text: &str, estimator: &str) -> Problem {
    let problem = Problem::parse(text).and_then(|one| one.with_estimator(estimator));
    problem.unwrap_or_else(|error| panic!("{error}"))
}

fn owen(first: u64, count: u64) -> Options {
    Options {
        first,
        seed: Some(5),
        scramble: Some(Scramble::OwenHash),
        ..Options::new(Sequence::Sobol, count)
    }
}

fn raster(problem: &Problem, options: &Options, size: [u32; 2]) -> Raster {
    Raster::new(problem, options, size).unwrap_or_else(|error| panic!("{error}"))
}

fn picture(raster: &Raster) -> Pixels {
    let all = estimate_pixels(raster, 0..raster.pixels());
    let [width, _] = raster.size();
    Pixels::new(width, all.expect("sums")).expect("whole rows")
}

/// All pictures have the kernel of pictures.
#[test]
fn pictures_are_scenes() {
    let pictures: Vec<_> = integrands().filter(|one| one.picture.is_some()).collect();
    assert!(pictures.len() >= 2);
    for one in pictures {
        let group = one.id / INTEGRANDS_OF_GROUP;
        assert_eq!(group, integrand::SKY_UNIFORM / INTEGRANDS_OF_GROUP);
    }
}

/// A pixel is the problem with its parameters and the points of its seed.
#[test]
fn pixels_are_estimates_of_their_problems() {
    let problem = problem("soft-shadow:elevation=0.6", "light");
    let raster = raster(&problem, &owen(7, 40), [6, 5]);
    let all = picture(&raster);
    assert_eq!(all.size(), [6, 5]);
    for index in [0, 11, 29] {
        let (problem, request) = raster.pixel(index).expect("a pixel");
        assert_eq!((request.first, request.count), (7, 40));
        let alone = estimate(&problem, &request, 0, 40).expect("sums");
        assert_eq!(all.estimates()[index as usize], alone);
    }
    assert!(raster.pixel(30).is_err());
}

#[test]
fn each_pixel_has_its_seed_or_all_share_their_points() {
    let problem = problem("pixel-edge", "filter");
    let seeds = |options: &Options| -> BTreeSet<String> {
        let raster = raster(&problem, options, [16, 12]);
        let one = |index| format!("{:?}", raster.pixel(index).expect("a pixel").1.columns);
        (0..192).map(one).collect()
    };
    assert_eq!(seeds(&owen(0, 4)).len(), 192);
    let random = Options::new(Sequence::Random, 4);
    assert_eq!(seeds(&random).len(), 192);
    let other = Options {
        seed: Some(1),
        ..random.clone()
    };
    assert!(seeds(&random).is_disjoint(&seeds(&other)));
    // A lattice without a seed is not rotated, one with a seed is.
    for (seed, number) in [(None, 1), (Some(3), 192)] {
        let lattice = Options {
            seed,
            ..Options::new(Sequence::Lattice, 4)
        };
        assert_eq!(seeds(&lattice).len(), number);
    }
    assert_eq!(seeds(&Options::new(Sequence::Halton, 4)).len(), 1);
}

/// Pixels of disjoint points are those of all of them, in any order.
#[test]
fn pictures_merge() {
    let problem = problem("pixel-edge", "uniform");
    let part = |first, count| picture(&raster(&problem, &owen(first, count), [5, 4]));
    let whole = part(0, 48);
    let parts = [part(0, 16), part(16, 31), part(47, 1)];
    let [a, b, c] = &parts;
    let merge = |x: &Pixels, y: &Pixels| x.clone().merged(y).expect("one size");
    assert_eq!(merge(&merge(a, b), c), whole);
    assert_eq!(merge(c, &merge(b, a)), whole);
    assert_ne!(merge(a, b), whole);
    let wide = picture(&raster(&problem, &owen(0, 1), [4, 5]));
    assert!(whole.clone().merged(&wide).is_err());
    assert!(Pixels::new(3, whole.estimates().to_vec()).is_err());
    let [mean, variance, count] = whole.moments().next().expect("a pixel");
    assert_eq!(Some(mean), whole.estimates()[0].mean());
    assert_eq!(Some(variance), whole.estimates()[0].variance());
    assert_eq!(count, 48.0);
}

/// The tents of all pixels add up to 1 everywhere, so an edge through the middle leaves half of
/// the picture; a step by a pixel along x is one of the edge's offset.
#[test]
fn an_edge_crosses_the_picture() {
    let problem = problem("pixel-edge:angle=0.7,offset=0", "filter");
    let raster = raster(&problem, &owen(0, 1), [8, 6]);
    let at = |x: u32, y: u32| raster.pixel(8 * y + x).expect("a pixel").0;
    let sum: f64 = (0..48).map(|k| at(k % 8, k / 8).truth()).sum();
    assert!((sum - 24.0).abs() < 1e-5, "{sum}");
    let step = at(3, 2).values()[1] - at(4, 2).values()[1];
    assert!((step - 0.7f64.cos()).abs() < 1e-12);
    let step = at(3, 2).values()[1] - at(3, 1).values()[1];
    assert!((step - 0.7f64.sin()).abs() < 1e-12, "up is up");
}

/// Nothing of the light on one side, all of it on the other, and a penumbra that widens
/// downwards.
#[test]
fn a_shadow_widens_away_from_its_edge() {
    let problem = problem("soft-shadow:edge=0", "light");
    let raster = raster(&problem, &owen(0, 1), [64, 16]);
    let truth = |x: u32, y: u32| raster.pixel(64 * y + x).expect("a pixel").0.truth();
    let lit = std::f64::consts::PI * 0.3f64.sin().powi(2) * 0.8f64.sin();
    assert_eq!(truth(0, 8), 0.0);
    assert!((truth(63, 8) / lit - 1.0).abs() < 1e-6);
    let partly = |y| {
        let some = |x: &u32| (0.01..0.99).contains(&(truth(*x, y) / lit));
        (0..64).filter(some).count()
    };
    let widths = [0, 5, 10, 15].map(partly);
    assert!(widths.is_sorted_by(|a, b| a < b), "{widths:?}");
    // The middle has the problem's own edge.
    let middle = 0.5 * (truth(31, 8) + truth(32, 8));
    assert!((middle / (0.5 * lit) - 1.0).abs() < 1e-3, "{middle}");
}

#[test]
fn what_is_no_picture_is_refused() {
    let edge = problem("pixel-edge", "filter");
    let plain = Problem::parse("x-squared").expect("a problem");
    for (problem, options, size, words) in [
        (&plain, owen(0, 4), [4, 4], "soft-shadow and pixel-edge"),
        (&edge, owen(0, 4), [0, 4], "1 to 16777216 pixels"),
        (&edge, owen(0, 4), [1 << 13, 1 << 12], "1 to 16777216"),
        (&edge, owen(0, 4), [1 << 31, 1 << 31], "1 to 16777216"),
    ] {
        let made = Raster::new(problem, &options, size).map(|_| ());
        let error = made.expect_err(words);
        assert_eq!(error.exit_code(), 2);
        assert!(error.to_string().contains(words), "{error}");
    }
    let long = owen(u64::from(u32::MAX), 4);
    assert!(Raster::new(&edge, &long, [4, 4]).is_err());
}
