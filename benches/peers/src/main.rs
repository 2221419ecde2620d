//! corput beside other makers of samples: the same jobs, verified, and timed in turns in one
//! run. Prints the table that the README shows, or writes it there, and on standard error each
//! rate as it is known.
//!
//! ```text
//! bash benches/peers/run [--python] [--write | JOB ...]     # parts of names of jobs; all without
//! ```

mod job;
mod libraries;
mod ours;
mod processor;
mod python;
mod readme;
mod table;
mod versions;

use job::{JOBS, Job, Maker};
use std::hint::black_box;
use std::time::Instant;
use table::Rate;

/// Values of each job: 64 MiB of floats.
pub const VALUES: usize = 1 << 24;

/// Rounds, of which the median counts; fill and contenders take turns.
const ROUNDS: usize = 9;

/// A contender that takes longer than this is timed in three rounds.
const LONG_S: f64 = 1.0;

const USAGE: &str = "usage: bash benches/peers/run [--python] [--write | JOB ...]";

/// One that fills memory and its times.
struct Entry {
    maker: Maker,
    seconds: Vec<f64>,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (options, parts): (Vec<String>, Vec<String>) = std::env::args()
        .skip(1)
        .partition(|word| word.starts_with('-'));
    let write = !options.is_empty();
    // The README's table has all jobs.
    if options.iter().any(|word| word != "--write") || (write && !parts.is_empty()) {
        return Err(USAGE.into());
    }
    if write {
        // Whether it has a place is better known before minutes are spent than after.
        readme::with("")?;
    }
    let device = ours::device();
    let python = python::Server::start();
    let missing = python::missing(python.as_ref());
    if write && (device.is_none() || !missing.is_empty()) {
        return Err("the README's table has a device, SciPy and Torch: add --python".into());
    }
    let place = format!(
        "2^{} values, {} threads of {}, {}",
        VALUES.ilog2(),
        job::threads(),
        processor::line(),
        ours::line(device.as_ref())
    );
    eprintln!("{place}\n{}\n", python::line(python.as_ref()));
    let mut memory = vec![1f32; VALUES];
    let (mut rates, mut fills_s) = (Vec::new(), Vec::new());
    for job in JOBS {
        if !parts.is_empty() && !parts.iter().any(|part| job.name.contains(part.as_str())) {
            continue;
        }
        let mut makers = vec![ours::cpu(job)?];
        makers.extend(ours::on_device(job, device.as_ref())?);
        makers.extend(libraries::of(job));
        makers.extend(python::of(job, python.as_ref()));
        let untimed = |maker| Entry {
            maker,
            seconds: Vec::new(),
        };
        let mut entries: Vec<Entry> = makers.into_iter().map(untimed).collect();
        let fill_s = measure(job, &mut entries, &mut memory)?;
        fills_s.push(fill_s);
        for Entry { maker, mut seconds } in entries {
            let seconds = median(&mut seconds);
            let values_s = VALUES as f64 / seconds;
            eprintln!(
                "{}: {}: {:.1} x fill, {:.2} G values/s",
                job.name,
                maker.name(),
                seconds / fill_s,
                values_s * 1e-9
            );
            rates.push(Rate {
                job: job.name,
                library: maker.library,
                column: maker.column,
                label: maker.label,
                values_s,
            });
        }
    }
    if rates.is_empty() {
        return Err("no job has such a name".into());
    }
    let fill = VALUES as f64 / median(&mut fills_s) * 1e-9;
    let place = format!("{place}, a fill makes {fill:.1} G values/s");
    let heading = table::heading(&place, &rates, &missing);
    let table = format!("{heading}\n\n{}", table::pivot(&rates));
    print!("{table}");
    if write {
        readme::write(&table)?;
    }
    Ok(())
}

/// Verifies all, and times them in turns; the median seconds of a fill.
fn measure(
    job: &Job,
    entries: &mut [Entry],
    memory: &mut [f32],
) -> Result<f64, Box<dyn std::error::Error>> {
    for entry in &mut *entries {
        entry.maker.contender.make(memory)?;
        let same = entry.maker.contender.is_in_memory();
        job.verify(&entry.maker.name(), same.then_some(&*memory))?;
    }
    let mut fills = Vec::new();
    for round in 0..ROUNDS {
        fills.push(fill(memory, round as u8));
        for entry in &mut *entries {
            let long = entry.seconds.first().is_some_and(|first| *first > LONG_S);
            if round < 3 || !long {
                entry.seconds.push(entry.maker.contender.make(memory)?);
            }
        }
    }
    Ok(median(&mut fills))
}

/// Seconds to fill memory, whose pages were touched before, with all threads.
fn fill(memory: &mut [f32], value: u8) -> f64 {
    let share = memory.len().div_ceil(job::threads());
    let begun = Instant::now();
    std::thread::scope(|scope| {
        for part in memory.chunks_mut(share) {
            scope.spawn(move || black_box(bytemuck::cast_slice_mut::<_, u8>(part)).fill(value));
        }
    });
    begun.elapsed().as_secs_f64()
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
