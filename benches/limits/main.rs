//! `cargo bench --bench limits`: what is between the goals of `corput bench` and what is reached.
//!
//! - On the device, stores alone: kernels that compute next to nothing, by the width of a store
//!   and by who stores what. No kernel of points of such stores is faster.
//! - On the CPU, stores alone, and each job with its points left in the first-level cache: what
//!   it computes, without memory.
//!
//! All of 2^25 words, in turns with a fill of the same bytes, as multiples of it.

mod device;
mod host;

use std::hint::black_box;
use std::time::Instant;

/// Words that are stored: 128 MiB.
pub const WORDS: usize = 1 << 25;

/// Rounds; medians are reported.
const ROUNDS: usize = 9;

fn main() -> corput::Result<()> {
    if let Err(error) = device::report() {
        println!("no device: {error}");
    }
    host::report()
}

/// Something that takes seconds.
type Timed<'a> = Box<dyn FnMut(&mut [u32]) -> corput::Result<f64> + 'a>;

/// Times these in turns with fills of the memory that they are given, and prints a line of each.
fn compare(rows: &mut [(String, Timed)]) -> corput::Result<()> {
    let mut memory = vec![1; WORDS];
    let mut fills = Vec::new();
    let mut times = vec![Vec::new(); rows.len()];
    // The first round compiles.
    for round in 0..=ROUNDS {
        let fill_s = timed(|| parted(&mut memory, |part| black_box(part).fill(round as u8)));
        let all = rows.iter_mut().zip(&mut times);
        for ((_, run), times) in all {
            let seconds = run(&mut memory)?;
            if round > 0 {
                times.push(seconds);
            }
        }
        if round > 0 {
            fills.push(fill_s);
        }
    }
    let fill_s = median(&mut fills);
    println!("{:<44} {:>9.2} ms", "fill", fill_s * 1e3);
    for ((name, _), times) in rows.iter().zip(&mut times) {
        let seconds = median(times);
        println!(
            "{name:<44} {:>9.2} ms {:>7.2} x fill",
            seconds * 1e3,
            seconds / fill_s
        );
    }
    Ok(())
}

/// Calls `work` with a part of the memory, as bytes, on each core.
fn parted(memory: &mut [u32], work: impl Fn(&mut [u8]) + Sync) {
    let share = memory.len().div_ceil(threads());
    let work = &work;
    std::thread::scope(|scope| {
        for part in memory.chunks_mut(share) {
            scope.spawn(move || work(bytemuck::cast_slice_mut(part)));
        }
    });
}

fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

fn timed(work: impl FnOnce()) -> f64 {
    let begun = Instant::now();
    work();
    begun.elapsed().as_secs_f64()
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
