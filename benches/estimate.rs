//! `cargo bench --bench estimate`: mean and variance of x^2 over Owen-scrambled Sobol points,
//! on the device by one estimator, and on all cores by the crate `sobol_burley`, in turns.
//!
//! A sample is one x: of the device a point of one dimension, of the crate one of the four
//! lanes that `sample_4d` makes at once, each the x of a sequence of its own. The device
//! adds x^2 and x^4 exactly, the cores in `f64`. Wall time on both sides, with another seed in
//! each round, after a round of both that is not counted.
//!
//! Then what a study's replicates cost beside their time on the device: wall time of 32 that
//! `Estimator::run_each` sums, over the sum of their times by the device's clock, less one.

use corput::bulk;
use corput::catalog::{Options, Problem, Request, Sampler, Scramble, Sequence};
use corput::kernels::Estimator;
use corput::vulkan::{Device, Instance, InstanceOptions, select};
use sobol_burley::sample_4d;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

/// Samples of a round.
const SAMPLES: u32 = 1 << 26;

/// Rounds; medians are reported.
const ROUNDS: u32 = 9;

/// Replicates whose overhead is measured.
const REPLICATES: u64 = 32;

/// The longest sequence that the crate has.
const LENGTH: u32 = 1 << 16;

fn main() -> corput::Result<()> {
    let instance = Instance::new(&InstanceOptions::default())?;
    let devices = instance.devices()?;
    let device = Device::open(&instance, select(&devices, None)?)?;
    let problem = Problem::parse("x-squared")?;
    let first = request(0)?;
    let mut estimator = Estimator::new(&device, &problem, &first)?;
    let (few, _) = estimator.run(0, 10_000, &mut |_| Ok(()))?;
    assert_eq!(few, bulk::estimate(&problem, &first, 0, 10_000)?);

    let (mut ours, mut theirs) = (Vec::new(), Vec::new());
    for round in 0..=ROUNDS {
        let begun = Instant::now();
        estimator.set_request(&request(round.into())?)?;
        let (sum, _) = estimator.run(0, SAMPLES.into(), &mut |_| Ok(()))?;
        let device_s = begun.elapsed().as_secs_f64();
        let begun = Instant::now();
        let (mean, variance) = black_box(cores(round));
        let cores_s = begun.elapsed().as_secs_f64();
        // 1/3 and 4/45.
        let good = |mean: f64, variance: f64| {
            (mean - 1.0 / 3.0).abs() < 1e-4 && (variance - 4.0 / 45.0).abs() < 1e-4
        };
        assert!(good(mean, variance), "{mean} {variance}");
        let both = sum.mean().zip(sum.variance());
        assert!(both.is_some_and(|(mean, variance)| good(mean, variance)));
        if round > 0 {
            ours.push(device_s);
            theirs.push(cores_s);
        }
    }
    let ratios = ours.iter().zip(&theirs).map(|(a, b)| b / a).collect();
    let rate = |times| f64::from(SAMPLES) / median(times) / 1e9;
    println!("{} ({})", device.info().name, device.info().driver_info);
    println!("x-squared, sobol:owen-hash  {:.3} G samples/s", rate(ours));
    println!(
        "sobol_burley, all cores     {:.3} G samples/s",
        rate(theirs)
    );
    println!("ratio                       {:.2}", median(ratios));

    println!(
        "\nms of a replicate by the device's clock, and what the host adds, at 2^20, 2^21, 2^22"
    );
    for integrand in ["x-squared", "disk-step", "genz-gaussian:d=8"] {
        for sampler in ["random", "sobol:owen-hash"] {
            let rows = [20, 21, 22].map(|log| overhead(&device, integrand, sampler, 1 << log));
            print!("{integrand:18} {sampler:16}");
            for row in rows {
                let (device_ms, share) = row?;
                print!("  {device_ms:6.2} {:4.1} %", 1e2 * share);
            }
            println!();
        }
    }
    Ok(())
}

/// Milliseconds of a replicate on the device, and the host's part of its: medians of rounds.
fn overhead(
    device: &Arc<Device>,
    integrand: &str,
    sampler: &str,
    count: u64,
) -> corput::Result<(f64, f64)> {
    let problem = Problem::parse(integrand)?;
    let sampler = Sampler::parse(sampler)?;
    let request = |seed| sampler.request(problem.dimensions(), count, seed);
    let requests = (0..REPLICATES)
        .map(request)
        .collect::<corput::Result<Vec<_>>>()?;
    let mut estimator = Estimator::new(device, &problem, &request(0)?)?;
    let (mut times, mut shares) = (Vec::new(), Vec::new());
    for round in 0..=ROUNDS {
        let begun = Instant::now();
        let sums = estimator.run_each(&requests, &mut |_| Ok(()))?;
        let wall_ns = begun.elapsed().as_nanos() as f64;
        let clock: Option<f64> = sums.iter().map(|(_, timing)| timing.device_ns).sum();
        let clock = clock.expect("a device with timestamps");
        if round > 0 {
            times.push(clock / REPLICATES as f64 / 1e6);
            shares.push(wall_ns / clock - 1.0);
        }
    }
    Ok((median(times), median(shares)))
}

fn request(seed: u64) -> corput::Result<Request> {
    Request::new(&Options {
        seed: Some(seed),
        scramble: Some(Scramble::OwenHash),
        fractions: true,
        dimensions: Some(1),
        ..Options::new(Sequence::Sobol, SAMPLES.into())
    })
}

/// Mean and variance of x^2 over four lanes of whole sequences, each with a seed of its own.
fn cores(seed: u32) -> (f64, f64) {
    let threads = std::thread::available_parallelism().map_or(1, usize::from) as u32;
    let sequences = SAMPLES / 4 / LENGTH;
    let of = |thread: u32| {
        let mut sums = [[0.0; 4]; 2];
        for sequence in (thread..sequences).step_by(threads as usize) {
            let seed = seed * sequences + sequence;
            for n in 0..LENGTH {
                let squares = sample_4d(n, 0, seed).map(|x| f64::from(x) * f64::from(x));
                for (lane, square) in squares.into_iter().enumerate() {
                    sums[0][lane] += square;
                    sums[1][lane] += square * square;
                }
            }
        }
        sums.map(|lanes| lanes.iter().sum::<f64>())
    };
    let totals: Vec<[f64; 2]> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|k| scope.spawn(move || of(k))).collect();
        let sums = workers.into_iter().map(|worker| worker.join());
        sums.map(|sum| sum.expect("no panic")).collect()
    });
    let [mean, square] = [0, 1].map(|k| {
        let total: f64 = totals.iter().map(|sums| sums[k]).sum();
        total / f64::from(SAMPLES)
    });
    (mean, square - mean * mean)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
