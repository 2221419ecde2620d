//! corput beside other makers of samples: the same jobs, verified, and timed in turns in one
//! run. Prints the rates of which the README's table is made.
//!
//! ```text
//! bash benches/peers/run [JOB ...]     # parts of names of jobs; all without
//! ```

mod job;
mod libraries;
mod ours;
mod python;

use job::{Contender, JOBS, Job};
use std::hint::black_box;
use std::time::Instant;

/// Values of each job: 64 MiB of floats.
pub const VALUES: usize = 1 << 24;

/// Rounds, of which the median counts; fill and contenders take turns.
const ROUNDS: usize = 9;

/// A contender that takes longer than this is timed in three rounds.
const LONG_S: f64 = 1.0;

/// One that fills memory and its times.
struct Entry {
    name: String,
    maker: Box<dyn Contender>,
    seconds: Vec<f64>,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let device = ours::device();
    let python = python::Server::start();
    println!(
        "{} threads; {}",
        job::threads(),
        ours::line(device.as_ref())
    );
    println!("{}\n", python::line(python.as_ref()));
    println!("| job | maker | x fill | G values/s |\n|---|---|---|---|");
    let mut memory = vec![1f32; VALUES];
    for job in JOBS {
        if !wanted.is_empty() && !wanted.iter().any(|part| job.name.contains(part.as_str())) {
            continue;
        }
        let mut entries: Vec<Entry> = Vec::new();
        let mut add = |found: Option<(String, Box<dyn Contender>)>| {
            entries.extend(found.map(|(name, maker)| Entry {
                name,
                maker,
                seconds: Vec::new(),
            }));
        };
        add(ours::cpu(job)?);
        for found in ours::on_device(job, device.as_ref())? {
            add(Some(found));
        }
        for found in libraries::of(job) {
            add(Some(found));
        }
        for found in python::of(job, python.as_ref()) {
            add(Some(found));
        }
        let fill_s = measure(job, &mut entries, &mut memory)?;
        for entry in &mut entries {
            let seconds = median(&mut entry.seconds);
            println!(
                "| {} | {} | {:.1} | {:.2} |",
                job.name,
                entry.name,
                seconds / fill_s,
                VALUES as f64 / seconds * 1e-9
            );
        }
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
        entry.maker.make(memory)?;
        let same = entry.maker.is_in_memory();
        job.verify(&entry.name, same.then_some(&*memory))?;
    }
    let mut fills = Vec::new();
    for round in 0..ROUNDS {
        fills.push(fill(memory, round as u8));
        for entry in &mut *entries {
            let long = entry.seconds.first().is_some_and(|first| *first > LONG_S);
            if round < 3 || !long {
                entry.seconds.push(entry.maker.make(memory)?);
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
