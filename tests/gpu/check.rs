//! `corput check` on every device present: zero mismatches, every bound kept.

mod support;

use corput::check::{self, Verdict};

#[test]
fn every_row_passes_on_every_device() {
    support::on_each_device(|device| {
        let outcome = check::run(device, &check::Options::default(), &mut |row| {
            println!(
                "{:?} {:<36} {:<18} {:>8} {:?} {:?} {} {}",
                row.verdict,
                row.name,
                row.kernel,
                row.compared,
                row.mismatches,
                row.worst,
                row.unit,
                row.witness
            );
        })
        .unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(outcome.failures(), 0);
        // Of drivers that are known; of others whatever there is.
        let defects = outcome
            .rows
            .iter()
            .filter(|row| row.verdict == Verdict::Defect);
        let defects: Vec<&str> = defects.map(|row| row.name.as_str()).collect();
        let known = ["llvmpipe", "SwiftShader"];
        if known.iter().any(|one| device.info().name.contains(one)) {
            let exponentials = ["native_exp", "native_exp2"];
            assert!(
                defects.iter().all(|name| exponentials.contains(name)),
                "{defects:?}"
            );
        }
        assert_eq!(outcome.defects(), defects.len());
    });
}

/// Desktops take a driver for hung after seconds; half a second is the rule here, for the
/// first dispatch of the widest rows as for any later one.
#[test]
fn dispatches_are_short() {
    use corput::catalog::{Engine, Options, Request, Sequence};
    support::on_each_device(|device| {
        for dimensions in [1, 2, 8, 1024] {
            let mut options = Options::new(Sequence::Halton, 1 << 22);
            options.dimensions = Some(dimensions);
            let request = Request::new(&options).unwrap_or_else(|error| panic!("{error}"));
            let mut generator = corput::kernels::Generator::general(device, &request)
                .unwrap_or_else(|error| panic!("{error}"));
            let mut start = 0;
            // The chunk grows fourfold at most: six reach the size that stays.
            for _ in 0..6 {
                let points = generator.chunk().min(request.count - start);
                let timing = generator
                    .dispatch(start, points)
                    .unwrap_or_else(|error| panic!("{error}"));
                let seconds = timing.device_ns.unwrap_or(timing.host_ns) * 1e-9;
                println!("{dimensions} dimensions, {points} points: {seconds:.3} s");
                assert!(
                    seconds < 0.5,
                    "{points} points of {dimensions}: {seconds} s"
                );
                generator.adapt(points, &timing);
                start += points;
            }
        }
    });
}

/// So are those over pairs of points, which adapt to the device, and count every pair.
#[test]
fn dispatches_over_pairs_are_short() {
    use corput::kernels::Pairs;
    support::on_each_device(|device| {
        for (count, dimensions) in [(6_000u32, 1), (2_000, 8)] {
            let words: Vec<u32> = (0..count * dimensions).map(check::mix).collect();
            for kind in 0..5 {
                let pairs = Pairs::sums(device, &words, dimensions, kind)
                    .unwrap_or_else(|error| panic!("{error}"));
                // Other tests share the machine: a dispatch that is long by itself is long
                // every time.
                let run = || {
                    let (mut last, mut longest) = (std::time::Instant::now(), 0.0f64);
                    let mut counted = 0;
                    pairs
                        .sum(32, &mut |done, total| {
                            longest = longest.max(last.elapsed().as_secs_f64());
                            last = std::time::Instant::now();
                            assert!(counted <= done && done <= total);
                            counted = done;
                            Ok(())
                        })
                        .unwrap_or_else(|error| panic!("{error}"));
                    assert_eq!(counted, u64::from(count) * u64::from(count - 1) / 2);
                    longest
                };
                let mut longest = run();
                for _ in 0..4 {
                    if longest >= 0.5 {
                        longest = longest.min(run());
                    }
                }
                println!("kind {kind}, {count} x {dimensions}: {longest:.3} s at most");
                assert!(longest < 0.5, "kind {kind}: {longest} s");
            }
        }
    });
}

/// Extreme inputs have the CPU's words too, most of them also a result of the native profile.
#[test]
fn every_extreme_case_passes_on_every_device() {
    use corput::extreme::{Counts, run};
    support::on_each_device(|device| {
        let rows = run(device).unwrap_or_else(|error| panic!("{error}"));
        for row in rows.iter().filter(|row| row.failure.is_some()) {
            println!("{} {}: {:?}", row.case.number, row.case.input, row.failure);
        }
        let counts = Counts::of(&rows);
        println!("{counts:?}");
        assert_eq!(counts.failed, 0);
        assert!(2 * counts.device > counts.rows && counts.native > 100);
    });
}

/// What random numbers, nets and errors should be like, of points that the device made: of one, for
/// those of others have the same bits, as the rows compare.
#[test]
fn statistics_pass() {
    support::on_one_device(|device| {
        let found = corput::card::statistics(device).unwrap_or_else(|error| panic!("{error}"));
        let failed: Vec<_> = found.iter().filter(|one| !one.passes()).collect();
        assert!(failed.is_empty(), "{failed:#?}");
        assert_eq!(found.len(), 16);
    });
}
