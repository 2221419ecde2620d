//! The loop over the inputs: a chunk is made while the one before is compared and hashed.

use super::judge::Judge;
use super::row::{Figures, Row};
use crate::report::hexadecimal;
use crate::{Error, Result};
use sha2::{Digest, Sha256};
use std::thread::ScopedJoinHandle;
use std::time::{Duration, Instant};

/// Makes the words of so many results, from a number of an input on.
pub type Source<'a> = &'a mut (dyn FnMut(u64, u64) -> Result<Vec<u32>> + Send);

/// Hears of the inputs done, of how many, and may stop the work.
pub type Watch<'a> = &'a mut dyn FnMut(u64, u64) -> Result<()>;

/// Inputs of the first chunk: short on the slowest device.
const FIRST: u64 = 1 << 16;

/// Words of a chunk at most.
const MOST: u64 = 1 << 24;

/// A chunk should take about that long: far below the half second after which desktops take a
/// driver for hung, and long enough for what each one costs.
const TARGET: Duration = Duration::from_millis(200);

/// Compares all inputs of a row.
///
/// # Errors
/// Those of the source and of `watch`.
pub fn compare(
    row: Row,
    inputs: u64,
    source: Source,
    judge: &dyn Judge,
    watch: Watch,
) -> Result<Row> {
    let begun = Instant::now();
    let most = MOST / judge.width() as u64;
    let mut figures = Figures::default();
    let mut hash = Sha256::new();
    let mut chunk = FIRST.min(inputs);
    let (mut words, mut spent) = timed(source, 0, chunk, judge.width())?;
    let mut done = 0;
    while done < inputs {
        watch(done, inputs)?;
        let end = done + chunk;
        let next = next_chunk(chunk, spent, most).min(inputs - end);
        let (found, made) = std::thread::scope(|scope| {
            let made = scope.spawn(|| match next {
                0 => Ok((Vec::new(), Duration::ZERO)),
                next => timed(source, end, next, judge.width()),
            });
            let hashed = scope.spawn(|| take(&mut hash, &words));
            let found = judged(judge, done, &words);
            joined(hashed);
            (found, joined(made))
        });
        figures.merge(found);
        (words, spent) = made?;
        (done, chunk) = (end, next);
    }
    watch(done, inputs)?;
    let mut row = row.judged(figures, hexadecimal(&hash.finalize()));
    row.seconds = begun.elapsed().as_secs_f64();
    Ok(row)
}

/// Results of so many inputs, and the time that they took. Fewer words than that are an error:
/// they would pass for inputs that were compared.
fn timed(source: Source, start: u64, count: u64, width: usize) -> Result<(Vec<u32>, Duration)> {
    let begun = Instant::now();
    let words = source(start, count)?;
    if words.len() as u64 != count * width as u64 {
        return Err(Error::Unequal {
            what: format!("{} words for {count} inputs of {width}", words.len()),
        });
    }
    Ok((words, begun.elapsed()))
}

/// Twice as many inputs as before, or half, or the same.
fn next_chunk(chunk: u64, spent: Duration, most: u64) -> u64 {
    match spent {
        spent if spent < TARGET / 2 => (2 * chunk).min(most),
        spent if spent > 2 * TARGET => (chunk / 2).max(1),
        _ => chunk,
    }
}

/// Takes the words, little-endian, into the hash.
fn take(hash: &mut Sha256, words: &[u32]) {
    if cfg!(target_endian = "little") {
        hash.update(bytemuck::cast_slice::<_, u8>(words));
    } else {
        words
            .iter()
            .for_each(|word| hash.update(word.to_le_bytes()));
    }
}

/// The figures of a chunk, on every core.
fn judged(judge: &dyn Judge, start: u64, words: &[u32]) -> Figures {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let width = judge.width();
    let part = (words.len() / width).div_ceil(cores).max(1);
    std::thread::scope(|scope| {
        let parts = (0..).zip(words.chunks(part * width));
        let parts: Vec<_> = parts
            .map(|(i, words)| scope.spawn(move || judge.figures(start + i * part as u64, words)))
            .collect();
        let mut all = Figures::default();
        for part in parts {
            all.merge(joined(part));
        }
        all
    })
}

/// What a thread came to; its panic goes on here.
fn joined<T>(thread: ScopedJoinHandle<T>) -> T {
    thread
        .join()
        .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}
