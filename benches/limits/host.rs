//! Stores and arithmetic of the CPU path.

use crate::{Timed, WORDS, compare, parted, threads, timed};
use corput::Result;
use corput::bench::{Job, jobs};
use corput::bulk::Reference;
use corput::catalog::Engine;
use std::hint::black_box;
use std::num::NonZero;
use std::time::Instant;

/// Bytes of a stretch that stays in the first-level cache.
const STRETCH: usize = 1 << 14;

/// Rows that the CPU path makes at a time: fewer take longer each. Of 32 columns they have 64 KiB,
/// which stay in the second level.
const BATCH: usize = 1 << 9;

pub fn report() -> Result<()> {
    println!("\ncpu, {} threads: stores alone, then jobs", threads());
    let stored = |memory: &mut [u32]| Ok(timed(|| parted(memory, store)));
    let cleared = |memory: &mut [u32]| {
        let work = |part: &mut [u8]| {
            for stretch in part.chunks_mut(STRETCH) {
                black_box(&mut *stretch).fill(0);
                store(stretch);
            }
        };
        Ok(timed(|| parted(memory, work)))
    };
    let chosen = jobs()?;
    let mut rows: Vec<(String, Timed)> = vec![
        ("by a loop".to_owned(), Box::new(stored)),
        (
            "by a loop, each 16 KiB cleared before".to_owned(),
            Box::new(cleared),
        ),
    ];
    for job in chosen.iter().filter(|job| job.cpu_goal.is_some()) {
        let (mut whole, words) = (Reference::new(&job.request), words(job));
        let filled = move |memory: &mut [u32]| {
            let begun = Instant::now();
            whole.fill(0, &mut memory[..words])?;
            Ok(begun.elapsed().as_secs_f64())
        };
        rows.push((job.name.clone(), Box::new(filled)));
        let cached = format!("{}, in the cache", job.name);
        rows.push((cached, Box::new(in_cache(job))));
    }
    compare(&mut rows)
}

/// Words of a job: a little less than 2^25 where its rows are no power of two.
fn words(job: &Job) -> usize {
    let width = job.request.words_per_point() as usize;
    (job.request.count as usize * width).min(WORDS / width * width)
}

/// Writes words that differ, and that the compiler makes by vectors.
fn store(part: &mut [u8]) {
    let words: &mut [u32] = bytemuck::cast_slice_mut(part);
    let first = black_box(1u32);
    for (word, n) in words.iter_mut().zip(0u32..) {
        *word = n.wrapping_add(first);
    }
}

/// The points of a job by all threads, each into the same few words again and again.
fn in_cache(job: &Job) -> impl FnMut(&mut [u32]) -> Result<f64> {
    let width = job.request.words_per_point() as usize;
    let rows = (STRETCH / 4 / width).max(BATCH);
    let one = Reference::with_threads(&job.request, NonZero::<usize>::MIN);
    let points = words(job) / width;
    move |_| {
        let share = points.div_ceil(threads());
        let begun = Instant::now();
        std::thread::scope(|scope| {
            let parts = (0..points).step_by(share).map(|first| {
                let mut one = one.clone();
                scope.spawn(move || {
                    let mut words = vec![0; rows * width];
                    for start in (first..points.min(first + share)).step_by(rows) {
                        let some = rows.min(points.min(first + share) - start);
                        one.fill(start as u64, &mut words[..some * width])?;
                        black_box(&mut words);
                    }
                    Ok(())
                })
            });
            let all: Vec<_> = parts.collect();
            all.into_iter()
                .map(|one| {
                    one.join()
                        .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
                })
                .collect::<Result<Vec<()>>>()
        })?;
        Ok(begun.elapsed().as_secs_f64())
    }
}
