//! `cargo bench --bench cpu`: what `--device cpu` makes, as a ratio to a fill of the same bytes by
//! the same threads in the same run. Verified first: a job whose words are not those of single
//! values is not timed. Words of the command line are parts of names of the jobs to run.

use corput::bulk::Reference;
use corput::catalog::{Map, Mapping, Options, Request, Scramble, Sequence};
use std::hint::black_box;
use std::time::Instant;

/// Words that each job stores, into memory whose pages were touched before.
const WORDS: u64 = 1 << 25;

/// Rounds; fill and jobs take turns, and the median of each is reported.
const ROUNDS: usize = 11;

/// A request with its times.
struct Job {
    name: String,
    request: Request,
    reference: Reference,
    seconds: Vec<f64>,
}

fn jobs() -> corput::Result<Vec<Job>> {
    let mut jobs = Vec::new();
    let mut add = |name: &str, sequence, scramble, dimensions: u64, map: Option<&str>| {
        let map = map.map(|name| Mapping::new(Map::from_name(name)?, &[]));
        let map = map.transpose()?;
        let width = map
            .as_ref()
            .map_or(dimensions, |map| u64::from(map.map().coordinates));
        let request = Request::new(&Options {
            dimensions: Some(dimensions),
            scramble,
            map,
            ..Options::new(sequence, WORDS / width)
        })?;
        jobs.push(Job {
            name: format!("{name}, d={dimensions}"),
            reference: Reference::new(&request),
            request,
            seconds: Vec::new(),
        });
        Ok::<(), corput::Error>(())
    };
    add("van der Corput", Sequence::VanDerCorput, None, 1, None)?;
    add("Hammersley", Sequence::Hammersley, None, 2, None)?;
    for (name, sequence, scramble) in [
        ("Sobol", Sequence::Sobol, Scramble::None),
        ("Halton", Sequence::Halton, Scramble::None),
        (
            "Halton, digits permuted",
            Sequence::Halton,
            Scramble::Permute,
        ),
        ("Sobol, hash-scrambled", Sequence::Sobol, Scramble::OwenHash),
    ] {
        for dimensions in [2, 8, 32] {
            add(name, sequence, Some(scramble), dimensions, None)?;
        }
    }
    add("random", Sequence::Random, None, 4, None)?;
    add("random-fast", Sequence::RandomFast, None, 4, None)?;
    add("pcg32", Sequence::Pcg32, None, 4, None)?;
    add("R2", Sequence::R2, None, 2, None)?;
    add(
        "Sobol, Owen-scrambled",
        Sequence::Sobol,
        Some(Scramble::Owen),
        2,
        None,
    )?;
    add(
        "cosine hemisphere",
        Sequence::Halton,
        None,
        2,
        Some("cosine-hemisphere"),
    )?;
    Ok(jobs)
}

/// Panics where a job's words are not those of single values, at the beginning and the end.
fn verify(job: &Job, words: &mut [u32]) {
    let points = words.len() as u64 / u64::from(job.request.words_per_point());
    let mut single = words.to_vec();
    for start in [0, job.request.count - points] {
        job.reference.fill(start, words);
        job.reference.fill_singly(start, &mut single);
        assert!(words == single, "{} from {start} on", job.name);
    }
}

/// Seconds to fill words with all cores.
fn fill(words: &mut [u32], value: u8) -> f64 {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let share = words.len().div_ceil(threads);
    let start = Instant::now();
    std::thread::scope(|scope| {
        for part in words.chunks_mut(share) {
            // As bytes it is the C library's memset.
            scope.spawn(move || black_box(bytemuck::cast_slice_mut::<_, u8>(part)).fill(value));
        }
    });
    start.elapsed().as_secs_f64()
}

/// The median of the values, which it sorts.
fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn main() -> corput::Result<()> {
    let wanted: Vec<String> = std::env::args()
        .skip(1)
        .filter(|word| !word.starts_with("--"))
        .collect();
    let mut jobs = jobs()?;
    jobs.retain(|job| wanted.is_empty() || wanted.iter().any(|part| job.name.contains(part)));
    let mut words = vec![1u32; WORDS as usize];
    for job in &jobs {
        let width = job.request.words_per_point() as usize;
        verify(job, &mut words[..(1 << 16) / width * width]);
    }
    let mut fills = Vec::new();
    for round in 0..ROUNDS {
        for job in &mut jobs {
            fills.push(fill(&mut words, round as u8));
            let width = u64::from(job.request.words_per_point());
            let whole = (job.request.count * width) as usize;
            let start = Instant::now();
            job.reference.fill(0, black_box(&mut words[..whole]));
            job.seconds.push(start.elapsed().as_secs_f64());
        }
    }
    let fill = median(&mut fills);
    println!(
        "{:<30} {:>8.2} ms                {:>7.2} ms at best",
        "fill",
        fill * 1e3,
        fills[0] * 1e3
    );
    for job in &mut jobs {
        let seconds = median(&mut job.seconds);
        println!(
            "{:<30} {:>8.2} ms {:>7.2} x fill {:>8.2} x at best {:>6.2} G values/s",
            job.name,
            seconds * 1e3,
            seconds / fill,
            job.seconds[0] / fills[0],
            WORDS as f64 / seconds * 1e-9
        );
    }
    Ok(())
}
