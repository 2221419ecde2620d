//! Estimates on every device: the same bits as the CPU's however the work is split.

mod support;

use corput::bulk;
use corput::catalog::{Options, Problem, Request, Sampler, Scramble, Sequence};
use corput::estimate::{Estimate, U256};
use corput::interface::Kernel;
use corput::kernels::Estimator;
use corput::variant::{Plan, general_estimate, plan_estimate};
use corput::vulkan::Device;
use std::sync::Arc;

fn problem(text: &str) -> Problem {
    Problem::parse(text).unwrap_or_else(|error| panic!("{error}"))
}

fn points(problem: &Problem, scramble: Option<Scramble>, first: u64, count: u64) -> Request {
    let options = Options {
        first,
        dimensions: Some(problem.dimensions().into()),
        seed: scramble.map(|_| 11),
        scramble,
        fractions: true,
        ..Options::new(Sequence::Sobol, count)
    };
    Request::new(&options).unwrap_or_else(|error| panic!("{error}"))
}

fn merged(parts: impl IntoIterator<Item = Estimate>, scale: i32) -> Estimate {
    let merge = |a: Estimate, b: Estimate| a.merge(b).expect("one scale");
    parts.into_iter().fold(Estimate::new(scale), merge)
}

/// An estimator for the general kernel, and for tiles where there are.
fn both(device: &Arc<Device>, problem: &Problem, request: &Request) -> Vec<Estimator> {
    [Estimator::general, Estimator::new]
        .map(|new| new(device, problem, request).unwrap_or_else(|error| panic!("{error}")))
        .into()
}

#[test]
fn records_are_the_sums_of_their_runs() {
    support::on_each_device(|device| {
        for text in ["x-squared", "disk-step", "ishigami"] {
            let problem = problem(text);
            // Across a wrap of the lower 16 bits, and to the last index of all.
            for first in [65_000, (1 << 32) - 16_500] {
                let request = points(&problem, Some(Scramble::OwenHash), first, 16_500);
                for mut estimator in both(device, &problem, &request) {
                    for run in [1, 7, 64, estimator.longest_run()] {
                        let (start, count) = (15_000, 1_500.min(u64::from(run) * 40 + 3));
                        let (records, _) = estimator
                            .records(start, count, run)
                            .unwrap_or_else(|error| panic!("{error}"));
                        assert_eq!(records.len() as u64, count.div_ceil(run.into()));
                        let mut at = start;
                        for got in records {
                            let points = u64::from(run).min(start + count - at);
                            let expected = bulk::estimate(&problem, &request, at, points);
                            assert_eq!(got, expected.expect("sums"), "{text} {run} {at}");
                            at += points;
                        }
                    }
                }
            }
        }
    });
}

#[test]
fn no_split_shows() {
    const COUNT: u64 = 100_003;
    support::on_each_device(|device| {
        for text in ["x-squared", "disk-step"] {
            let problem = problem(text);
            let request = points(&problem, Some(Scramble::Owen), 1, COUNT);
            let scale = problem.coefficients().scale;
            let expected = bulk::estimate(&problem, &request, 0, COUNT).expect("sums");
            for mut estimator in both(device, &problem, &request) {
                let mut sum = |start, count| {
                    let run = estimator.run(start, count, &mut |_| Ok(()));
                    run.unwrap_or_else(|error| panic!("{error}")).0
                };
                assert_eq!(sum(0, COUNT), expected, "{text}, whole");
                for cut in [1, 255, 50_000, COUNT - 1] {
                    let parts = [sum(cut, COUNT - cut), sum(0, cut)];
                    assert_eq!(merged(parts, scale), expected, "{text}, cut at {cut}");
                }
                let shards = (0..13).map(|k| (k * COUNT / 13, (k + 1) * COUNT / 13));
                let parts: Vec<_> = shards.map(|(from, to)| sum(from, to - from)).collect();
                assert_eq!(merged(parts, scale), expected, "{text}, 13 shards");
            }
        }
    });
}

/// Samplers of every family of columns, and of every kind.
const SAMPLERS: [(Sequence, Scramble); 21] = [
    (Sequence::Sobol, Scramble::None),
    (Sequence::Sobol, Scramble::Shift),
    (Sequence::Sobol, Scramble::Matrix),
    (Sequence::Sobol, Scramble::Owen),
    (Sequence::Sobol, Scramble::OwenHash),
    (Sequence::Pmj02, Scramble::None),
    (Sequence::Random, Scramble::None),
    (Sequence::RandomFast, Scramble::None),
    (Sequence::Pcg32, Scramble::None),
    (Sequence::Halton, Scramble::None),
    (Sequence::Hammersley, Scramble::None),
    (Sequence::Halton, Scramble::Faure),
    (Sequence::Halton, Scramble::Permute),
    (Sequence::Halton, Scramble::Owen),
    (Sequence::Halton, Scramble::Start),
    (Sequence::Stratified, Scramble::None),
    (Sequence::LatinHypercube, Scramble::None),
    (Sequence::MultiJittered, Scramble::None),
    (Sequence::Lattice, Scramble::Rotate),
    (Sequence::Korobov, Scramble::Rotate),
    (Sequence::R2, Scramble::Rotate),
];

/// One estimator, and requests of other seeds, counts and first points.
#[test]
fn an_estimator_takes_requests_of_its_shape() {
    support::on_one_device(|device| {
        for (sequence, scramble) in SAMPLERS {
            let make = |first, count, seed: u64| {
                let options = Options {
                    first,
                    dimensions: Some(2),
                    seed: Some(seed),
                    scramble: (scramble != Scramble::None).then_some(scramble),
                    // A set of another size for each seed.
                    total: (sequence == Sequence::Korobov)
                        .then_some([1021, 2039][seed as usize % 2]),
                    fractions: true,
                    ..Options::new(sequence, count)
                };
                Request::new(&options).unwrap_or_else(|error| panic!("{sequence:?}: {error}"))
            };
            let problem = problem("genz-gaussian:d=2");
            let requests = [make(0, 36, 1), make(0, 900, 2), make(0, 36, 3)];
            for mut estimator in both(device, &problem, &requests[0]) {
                for request in &requests {
                    estimator
                        .set_request(request)
                        .unwrap_or_else(|error| panic!("{sequence:?}: {error}"));
                    let run = estimator.run(0, request.count, &mut |_| Ok(()));
                    let expected = bulk::estimate(&problem, request, 0, request.count);
                    let name = estimator.kernel_name();
                    assert_eq!(
                        run.expect("sums").0,
                        expected.expect("sums"),
                        "{name}, {sequence:?} {scramble:?}, seed {}",
                        request.seed
                    );
                }
            }
        }
    });
}

/// Many dimensions, of all samplers that have so many.
#[test]
fn many_dimensions_are_summed_as_on_the_cpu() {
    support::on_one_device(|device| {
        for (sequence, scramble) in SAMPLERS {
            let most = sequence.dimensions().1;
            for d in [5, 64].into_iter().filter(|&d| d <= u64::from(most)) {
                let options = Options {
                    first: 3 * 1021 - 200,
                    dimensions: Some(d),
                    seed: Some(5),
                    scramble: (scramble != Scramble::None).then_some(scramble),
                    total: (sequence == Sequence::Korobov).then_some(4093),
                    fractions: true,
                    ..Options::new(sequence, 203)
                };
                let request = Request::new(&options).unwrap_or_else(|error| panic!("{error}"));
                let problem = problem(&format!("genz-continuous:d={d}"));
                let mut estimator = Estimator::new(device, &problem, &request).expect("it");
                let (got, _) = estimator.run(0, 203, &mut |_| Ok(())).expect("sums");
                let expected = bulk::estimate(&problem, &request, 0, 203).expect("sums");
                assert_eq!(got, expected, "{sequence:?} {scramble:?}, {d} dimensions");
            }
        }
    });
}

/// More dimensions than uniform blocks hold: as on the CPU, by any split, and refused where a
/// driver might not end.
#[test]
fn a_thousand_dimensions_are_summed_as_on_the_cpu() {
    const COUNT: u64 = 77;
    support::on_each_device(|device| {
        let problem = problem("product:d=1000");
        let make = |sequence, scramble: Option<Scramble>, count, seed| {
            let request = Request::new(&Options {
                first: 3 * 1021 - 20,
                dimensions: Some(1000),
                seed: (sequence == Sequence::Random || scramble.is_some()).then_some(seed),
                scramble,
                total: (sequence == Sequence::Korobov).then_some(4093),
                fractions: true,
                ..Options::new(sequence, count)
            });
            request.unwrap_or_else(|error| panic!("{sequence:?}: {error}"))
        };
        for (sequence, scramble) in [
            (Sequence::Sobol, None),
            (Sequence::Sobol, Some(Scramble::OwenHash)),
            (Sequence::Sobol, Some(Scramble::Matrix)),
            (Sequence::Random, None),
            (Sequence::RandomFast, None),
            (Sequence::Halton, None),
            (Sequence::Korobov, None),
        ] {
            let request = make(sequence, scramble, COUNT, 5);
            let mut estimator = Estimator::new(device, &problem, &request).expect("it");
            assert!(estimator.kernel_name().starts_with("estimate_wide"));
            let longest = estimator.longest_run();
            assert!(longest > 0);
            let expected = bulk::estimate(&problem, &request, 0, COUNT).expect("sums");
            for run in [1, longest.min(8), longest] {
                let (records, _) = estimator.records(0, COUNT, run).expect("sums");
                let scale = problem.coefficients().scale;
                assert_eq!(
                    merged(records, scale),
                    expected,
                    "{sequence:?} {scramble:?} {run}"
                );
            }
            let other = make(sequence, scramble, 33, 6);
            estimator.set_request(&other).expect("one of its shape");
            let (got, _) = estimator.run(0, 33, &mut |_| Ok(())).expect("sums");
            let expected = bulk::estimate(&problem, &other, 0, 33).expect("sums");
            assert_eq!(got, expected, "{sequence:?} {scramble:?}, another request");
        }
        for (sequence, scramble) in [
            (Sequence::Sobol, Scramble::Owen),
            (Sequence::Halton, Scramble::Permute),
        ] {
            let request = make(sequence, Some(scramble), COUNT, 5);
            let refused = Estimator::new(device, &problem, &request).map(|_| ());
            let error = refused.expect_err("more than a driver may do");
            assert_eq!(error.exit_code(), 2);
            assert!(error.to_string().contains("65535 iterations"), "{error}");
        }
    });
}

#[test]
fn requests_of_another_shape_are_refused() {
    support::on_one_device(|device| {
        let problem = problem("disk-step");
        let of = |sequence, scramble, bases: Option<Vec<u64>>| {
            let options = Options {
                dimensions: bases.is_none().then_some(2),
                bases,
                scramble,
                ..Options::new(sequence, 100)
            };
            Request::new(&options).expect("a request")
        };
        let net = |scramble| of(Sequence::Sobol, Some(scramble), None);
        let halton = |bases| of(Sequence::Halton, None, bases);
        let requests = [
            net(Scramble::OwenHash),
            net(Scramble::Owen),
            of(Sequence::Random, None, None),
            halton(Some(vec![2, 3])),
            halton(Some(vec![2, 5])),
            halton(Some(vec![3, 2])),
        ];
        for (i, request) in requests.iter().enumerate() {
            let mut estimator = Estimator::new(device, &problem, request).expect("an estimator");
            let (before, _) = estimator.run(0, 100, &mut |_| Ok(())).expect("sums");
            for (j, other) in requests.iter().enumerate() {
                let set = estimator
                    .set_request(other)
                    .map_err(|error| error.exit_code());
                assert_eq!(set, if i == j { Ok(()) } else { Err(2) }, "{i} {j}");
                let (after, _) = estimator.run(0, 100, &mut |_| Ok(())).expect("sums");
                assert_eq!(after, before);
            }
        }
        let line = points(&problem, None, 0, 100);
        let mut estimator = Estimator::new(device, &problem, &line).expect("an estimator");
        let wide = Request::new(&Options {
            dimensions: Some(3),
            ..Options::new(Sequence::Sobol, 100)
        });
        assert!(estimator.set_request(&wide.expect("a request")).is_err());
    });
}

/// The kernel of a plan with groups of another size.
fn resized(mut plan: Plan, local_size: u32) -> (Plan, Vec<u32>) {
    let row: &'static Kernel = Box::leak(Box::new(Kernel {
        local_size,
        ..*plan.kernel
    }));
    plan.kernel = row;
    let words = support::edited(row, |source| source);
    (plan, words)
}

#[test]
fn no_size_of_a_group_shows() {
    const COUNT: u64 = 20_011;
    support::on_each_device(|device| {
        for (text, general) in [("x-squared", false), ("genz-continuous:d=2", true)] {
            let problem = problem(text);
            let request = points(&problem, Some(Scramble::OwenHash), 77, COUNT);
            let expected = bulk::estimate(&problem, &request, 0, COUNT).expect("sums");
            let id = problem.id();
            let limits = device.info().limits;
            let largest = limits.max_group_invocations.min(limits.max_group_size[0]);
            let sizes = [1, 32, 64, 96, 128, 256, 512, largest];
            for size in sizes.into_iter().filter(|&size| size <= largest) {
                let plan = match general {
                    true => general_estimate(&request.columns, id),
                    false => plan_estimate(&request.columns, id, true),
                };
                let (plan, words) = resized(plan, size);
                let mut estimator =
                    Estimator::with_module(device, &problem, &request, plan, &words)
                        .unwrap_or_else(|error| panic!("{error}"));
                let got = estimator.run(0, COUNT, &mut |_| Ok(())).expect("sums").0;
                assert_eq!(got, expected, "{text}, groups of {size}");
            }
        }
    });
}

/// A driver that compiles a kernel again for what a uniform block holds takes 30 times as
/// long for a few points; how long it takes otherwise differs by a factor of 4.
#[test]
fn no_dispatch_compiles_again() {
    const TURNS: u64 = 33;
    let samplers = ["random", "stratified", "latin-hypercube", "halton:permute"];
    support::on_one_device(|device| {
        let problem = problem("x-squared");
        let request = |name: &str, seed| {
            let sampler = Sampler::parse(name).expect("a sampler");
            sampler.request(1, 16, seed).expect("its points")
        };
        let new = |name| Estimator::new(device, &problem, &request(name, 0)).expect("one");
        let mut estimators = samplers.map(new);
        let mut times = [const { Vec::new() }; 4];
        for turn in 0..TURNS {
            for ((name, one), times) in samplers.iter().zip(&mut estimators).zip(&mut times) {
                one.set_request(&request(name, turn)).expect("its shape");
                let timing = one.run(0, 16, &mut |_| Ok(())).expect("sums").1;
                times.push(timing.device_ns.unwrap_or(timing.host_ns));
            }
        }
        let [random, others @ ..] = times.map(|mut times| {
            times.sort_by(f64::total_cmp);
            times[times.len() / 2]
        });
        assert!(
            others.iter().all(|&ns| ns < 12.0 * random),
            "{random} {others:?}"
        );
    });
}

/// Tables and prepared words reach the kernel of every family of columns, whichever the
/// technique.
#[test]
fn estimators_have_the_same_sums_of_every_family() {
    const COUNT: u64 = 257;
    let samplers = [
        (Sequence::Halton, None),
        (Sequence::Sobol, Some(Scramble::Owen)),
        (Sequence::Random, None),
        (Sequence::LatinHypercube, None),
        (Sequence::Halton, Some(Scramble::Permute)),
        (Sequence::Lattice, None),
    ];
    support::on_one_device(|device| {
        for (text, estimator) in [
            ("irradiance:map=tests/data/sunrise.exr,axis=-y", "mis"),
            ("soft-shadow", "light"),
        ] {
            let problem = problem(text).with_estimator(estimator);
            let problem = problem.unwrap_or_else(|error| panic!("{error}"));
            for (sequence, scramble) in samplers {
                let request = Request::new(&Options {
                    dimensions: Some(problem.dimensions().into()),
                    seed: (scramble.is_some() || sequence == Sequence::Random).then_some(3),
                    scramble,
                    fractions: true,
                    ..Options::new(sequence, COUNT)
                });
                let request = request.unwrap_or_else(|error| panic!("{error}"));
                let expected = bulk::estimate(&problem, &request, 0, COUNT).expect("sums");
                let mut estimator = Estimator::new(device, &problem, &request).expect("one");
                let got = estimator.run(0, COUNT, &mut |_| Ok(())).expect("sums").0;
                assert_eq!(got, expected, "{text} {sequence:?}");
            }
        }
    });
}

/// Sums of k^2 and k^4 for k below n, in units of 2^-(2 bits) and 2^-(4 bits).
fn grid(bits: u32) -> (i128, U256) {
    let (n, m) = (1u128 << bits, (1u128 << bits) - 1);
    let squares = (n - 1) * n * (2 * n - 1) / 6;
    // The fourths are up to 160 bits: one factor in the end.
    let factor = 3 * m * m + 3 * m - 1;
    let (fifth, squares_part, factor) = match factor % 5 {
        0 => (1, squares, factor / 5),
        _ => (5, squares, factor),
    };
    let part = squares_part / fifth;
    // part * factor, factor of up to 66 bits.
    let low = U256::from_u128(part)
        .checked_mul(factor as u64)
        .expect("small");
    let high = U256::from_u128(part)
        .checked_mul((factor >> 64) as u64)
        .expect("small");
    let high = (0..2).fold(high, |x, _| x.checked_mul(1 << 32).expect("small"));
    let fourths = low.checked_add(high).expect("small");
    let shift = 4 * (32 - bits);
    let fourths = fourths.checked_mul(1 << shift).expect("small");
    ((squares as i128) << (2 * (32 - bits)), fourths)
}

fn grid_on(device: &Arc<Device>, bits: u32) {
    let problem = problem("x-squared");
    let request = points(&problem, None, 0, 1 << bits);
    let mut estimator = Estimator::new(device, &problem, &request).expect("an estimator");
    let mut heard = 0;
    let (got, _) = estimator
        .run(0, request.count, &mut |done| {
            heard = done;
            Ok(())
        })
        .expect("sums");
    assert_eq!((got.sum(), got.squares()), grid(bits), "2^{bits}");
    assert_eq!((got.count(), heard), (1 << bits, 1 << bits));
}

#[test]
fn x_squared_over_a_grid_is_its_closed_form() {
    support::on_each_device(|device| grid_on(device, 24));
}

#[test]
#[ignore = "13 s on two cores of llvmpipe, minutes elsewhere"]
fn x_squared_over_all_points_is_its_closed_form() {
    support::on_one_device(|device| grid_on(device, 32));
}

/// 2^28 terms, and 2^26 on devices that take seconds for them; a mean of a million standard
/// deviations.
#[test]
fn a_large_mean_leaves_the_variance() {
    support::on_each_device(|device| {
        let problem = problem("offset:offset=288675");
        let slow = device.info().name.contains("SwiftShader");
        let request = points(&problem, None, 0, if slow { 1 << 26 } else { 1 << 28 });
        let mut estimator = Estimator::new(device, &problem, &request).expect("an estimator");
        let (got, _) = estimator
            .run(0, request.count, &mut |_| Ok(()))
            .expect("sums");
        let n = request.count as f64;
        assert_eq!(got.mean(), Some(288_675.5 - 0.5 / n));
        assert_eq!(got.variance(), Some((n + 1.0) / (12.0 * n)));
    });
}

#[test]
fn what_does_not_fit_is_refused() {
    support::on_one_device(|device| {
        let (line, disk) = (problem("x-squared"), problem("disk-step"));
        let request = points(&line, None, 5, 100);
        assert!(Estimator::new(device, &disk, &request).is_err());
        let mut estimator = Estimator::new(device, &line, &request).expect("an estimator");
        assert!(estimator.set_problem(&disk).is_err());
        let longest = estimator.longest_run();
        for (start, count, run) in [
            (0, 101, 1),
            (100, 1, 1),
            (u64::MAX, 2, 1),
            (0, 10, 0),
            (0, 10, longest + 1),
        ] {
            let refused = estimator.records(start, count, run).map(|_| ());
            assert_eq!(
                refused.map_err(|error| error.exit_code()),
                Err(2),
                "{start} {count} {run}"
            );
        }
        let none = estimator.run(3, 0, &mut |_| Ok(())).expect("nothing").0;
        assert_eq!(none.count(), 0);
    });
}

/// Requests that share submissions, and those that do not.
#[test]
fn sums_of_several_requests_are_those_of_each() {
    support::on_each_device(|device| {
        let problem = problem("genz-gaussian:d=3");
        let request =
            |turn: u64| points(&problem, Some(Scramble::OwenHash), turn, 1000 + 37 * turn);
        let mut requests: Vec<Request> = (0..70).map(request).collect();
        // Longer than what the first dispatch may sum.
        requests.insert(40, points(&problem, Some(Scramble::OwenHash), 5, 200_000));
        let mut estimator = Estimator::new(device, &problem, &requests[0]).expect("an estimator");
        let mut heard = Vec::new();
        for round in 0..3 {
            heard.clear();
            let watch = &mut |done| {
                heard.push(done);
                Ok(())
            };
            let sums = estimator.run_each(&requests, watch).expect("sums");
            assert_eq!(sums.len(), requests.len());
            for (request, (sum, timing)) in requests.iter().zip(&sums) {
                let cpu = bulk::estimate(&problem, request, 0, request.count).expect("sums");
                assert_eq!(*sum, cpu, "{} points, round {round}", request.count);
                assert!(timing.host_ns > 0.0);
            }
            let last = requests.last().expect("one");
            let (again, _) = estimator.run(0, last.count, &mut |_| Ok(())).expect("sums");
            assert_eq!(again, sums.last().expect("one").0);
        }
        // Some share, however slow the device is; the long one does not.
        assert!(heard.is_sorted(), "{heard:?}");
        let clock = device.info().limits.timestamp_valid_bits > 0;
        assert!(!clock || heard.len() < requests.len(), "{heard:?}");
        assert!(
            estimator
                .run_each(&[], &mut |_| Ok(()))
                .is_ok_and(|sums| sums.is_empty())
        );

        let stop = |done| match done {
            0 => Ok(()),
            _ => Err(corput::Error::Interrupted { done: 0, total: 0 }),
        };
        assert!(estimator.run_each(&requests, &mut { stop }).is_err());
        let wide = points(
            &self::problem("genz-gaussian:d=4"),
            Some(Scramble::OwenHash),
            0,
            1000,
        );
        let refused = [request(0), request(1), wide];
        let code = |result: corput::Result<_>| result.map(|_| ()).map_err(|e| e.exit_code());
        assert_eq!(code(estimator.run_each(&refused, &mut |_| Ok(()))), Err(2));
    });
}
