//! Pictures on every device: each pixel the same sums as the CPU's, and broken kernels seen.

mod support;

use corput::bulk;
use corput::catalog::{Options, Problem, Raster, Scramble, Sequence};
use corput::kernels::{PixelEstimator, kernel};

fn problem(text: &str, estimator: &str) -> Problem {
    let problem = Problem::parse(text).and_then(|one| one.with_estimator(estimator));
    problem.unwrap_or_else(|error| panic!("{error}"))
}

fn raster(problem: &Problem, sampler: (Sequence, Option<Scramble>), count: u64) -> Raster {
    let (sequence, scramble) = sampler;
    let options = Options {
        first: 3,
        seed: Some(11),
        scramble,
        ..Options::new(sequence, count)
    };
    Raster::new(problem, &options, [9, 7]).unwrap_or_else(|error| panic!("{error}"))
}

/// Samplers of every family of columns.
const SAMPLERS: [(Sequence, Option<Scramble>); 6] = [
    (Sequence::Sobol, Some(Scramble::OwenHash)),
    (Sequence::Halton, None),
    (Sequence::Random, None),
    (Sequence::LatinHypercube, None),
    (Sequence::Halton, Some(Scramble::Permute)),
    (Sequence::Lattice, None),
];

#[test]
fn pixels_are_summed_as_on_the_cpu() {
    support::on_each_device(|device| {
        for (text, estimator, samplers) in [
            ("pixel-edge", "filter", &SAMPLERS[..]),
            ("pixel-edge:radius=2", "uniform", &SAMPLERS[..1]),
            ("soft-shadow", "light", &SAMPLERS[..1]),
            ("soft-shadow:elevation=0.4", "cosine", &SAMPLERS[2..3]),
        ] {
            let problem = problem(text, estimator);
            for &sampler in samplers {
                // More than a run of an invocation, too.
                for count in [1, 16, 1000] {
                    let raster = raster(&problem, sampler, count);
                    let mut estimator = PixelEstimator::new(device, &raster).expect("one");
                    let mut heard = 0;
                    let run = estimator.run(&mut |done| {
                        assert!(done > heard);
                        heard = done;
                        Ok(())
                    });
                    let (got, _) = run.unwrap_or_else(|error| panic!("{error}"));
                    assert_eq!(heard, 63 * count);
                    let expected = bulk::estimate_pixels(&raster, 0..63).expect("sums");
                    assert_eq!(got.estimates(), expected, "{text} {sampler:?} {count}");
                }
            }
        }
    });
}

/// Pixels that take the words of another, or points of another, are seen.
#[test]
fn broken_kernels_are_caught() {
    support::on_one_device(|device| {
        let problem = problem("soft-shadow", "light");
        // More than an invocation sums.
        let raster = raster(&problem, SAMPLERS[0], 1000);
        let expected = bulk::estimate_pixels(&raster, 0..63).expect("sums");
        let row = kernel("estimate_pixels_net").expect("the kernel");
        for (from, to, equal) in [
            ("pixel = i / parts", "pixel = i / parts", true),
            ("pixel = i / parts", "pixel = 0u", false),
            ("pixel_columns = pixel * ", "pixel_columns = 0u * ", false),
            ("pixel * PIXEL_ROWS", "0u", false),
            ("part = i - pixel * parts", "part = 0u", false),
        ] {
            let words = support::edited(row, |source| {
                assert!(source.contains(from), "{from}");
                source.replace(from, to)
            });
            let mut estimator =
                PixelEstimator::with_module(device, &raster, Some(&words)).expect("one");
            let (got, _) = estimator.run(&mut |_| Ok(())).expect("sums");
            assert_eq!(got.estimates() == expected, equal, "{from}: {to}");
        }
    });
}

#[test]
fn a_watcher_stops_the_work() {
    support::on_one_device(|device| {
        let problem = problem("pixel-edge", "filter");
        let raster = raster(&problem, SAMPLERS[0], 1000);
        let mut estimator = PixelEstimator::new(device, &raster).expect("one");
        let stop = |done| {
            Err(corput::Error::Interrupted {
                done,
                total: 63_000,
            })
        };
        let error = estimator
            .run(&mut { stop })
            .map(|_| ())
            .expect_err("stopped");
        assert_eq!(error.exit_code(), 4);
    });
}
