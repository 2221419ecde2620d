//! Crates, each in the way that is fastest for it: every thread makes its share of the rows,
//! and what only goes forward begins where the share does, set up before the clock starts.

use crate::VALUES;
use crate::job::{Contender, Job, Kind, Maker, threads};
use crate::versions;
use rand_pcg::rand_core::Rng;
use std::error::Error;
use std::time::Instant;

/// Fills a share of the rows from a state that is cloned for each round.
struct Shares<State, Fill> {
    states: Vec<State>,
    fill: Fill,
    dimensions: usize,
}

impl<State, Fill> Contender for Shares<State, Fill>
where
    State: Clone + Send,
    Fill: Fn(State, &mut [f32]) + Sync,
{
    fn make(&mut self, memory: &mut [f32]) -> Result<f64, Box<dyn Error>> {
        let share = share(self.dimensions) * self.dimensions;
        let states = self.states.clone();
        let fill = &self.fill;
        let begun = Instant::now();
        std::thread::scope(|scope| {
            for (state, part) in states.into_iter().zip(memory.chunks_mut(share)) {
                scope.spawn(move || fill(state, part));
            }
        });
        Ok(begun.elapsed().as_secs_f64())
    }
}

/// Rows of a thread.
fn share(dimensions: usize) -> usize {
    (VALUES / dimensions).div_ceil(threads())
}

/// Makes shares of rows, each by a fill from a state of its own.
fn shares<State: Clone + Send + 'static>(
    job: &Job,
    name: &str,
    note: &str,
    start: impl Fn(usize) -> State,
    fill: impl Fn(State, &mut [f32]) + Sync + 'static,
) -> Maker {
    let first = (0..threads()).map(|thread| thread * share(job.dimensions));
    let shares = Shares {
        states: first.map(start).collect(),
        fill,
        dimensions: job.dimensions,
    };
    Maker {
        library: format!("{name} {}", versions::of(name)),
        note: note.to_owned(),
        column: "crates".to_owned(),
        label: format!("`{name}`"),
        contender: Box::new(shares),
    }
}

/// The same row by row, with a state that goes on.
fn rows<State: Clone + Send + 'static>(
    job: &Job,
    name: &str,
    note: &str,
    start: impl Fn(usize) -> State,
    next: impl Fn(&mut State, &mut [f32]) + Sync + 'static,
) -> Maker {
    let dimensions = job.dimensions;
    let fill = move |mut state: State, part: &mut [f32]| {
        for row in part.chunks_exact_mut(dimensions) {
            next(&mut state, row);
        }
    };
    shares(job, name, note, start, fill)
}

/// Those that make it.
pub fn of(job: &Job) -> Vec<Maker> {
    match job.kind {
        Kind::Halton => vec![halton(job)],
        Kind::Sobol => vec![sobol(job)],
        Kind::SobolScrambled => vec![burley(job), openqmc(job)],
        Kind::Random => vec![pcg(job)],
    }
}

/// It begins at index 1, and its own way to skip goes wrong past 255: so it steps.
fn halton(job: &Job) -> Maker {
    let bases = corput::tables::PRIMES;
    let dimensions = job.dimensions;
    let start = move |first: usize| {
        let bases = bases.iter().take(dimensions);
        let axis = |base: &u32| {
            let mut axis = halton::Sequence::new(*base as u8);
            for _ in 0..first {
                axis.next();
            }
            axis
        };
        bases.map(axis).collect::<Vec<_>>()
    };
    rows(job, "halton", "", start, |axes, row| {
        for (x, axis) in row.iter_mut().zip(axes) {
            *x = axis.next().unwrap_or(0.0) as f32;
        }
    })
}

fn sobol(job: &Job) -> Maker {
    let dimensions = job.dimensions;
    let start = |first: usize| {
        let params = sobol::params::JoeKuoD6::standard();
        let mut points = sobol::Sobol::<f32>::new(dimensions, &params);
        points.by_ref().take(first).for_each(drop);
        points
    };
    rows(job, "sobol", "(Gray order)", start, |points, row| {
        if let Some(point) = points.next() {
            row.copy_from_slice(&point);
        }
    })
}

/// It keeps 2^16 points, after which they repeat.
fn burley(job: &Job) -> Maker {
    let start = |first: usize| first as u32;
    rows(job, "sobol_burley", "", start, |i, row| {
        for (set, four) in (0..).zip(row.chunks_exact_mut(4)) {
            four.copy_from_slice(&sobol_burley::sample_4d(*i % (1 << 16), set, 1));
        }
        *i += 1;
    })
}

/// A port of OpenQMC: four dimensions a domain, and points of their own after 2^16.
fn openqmc(job: &Job) -> Maker {
    let start = |first: usize| first as i32;
    rows(job, "openqmc-rs", "", start, |i, row| {
        let root = openqmc::SobolSampler::new(0, 0, 0, *i);
        for (domain, four) in (0..).zip(row.chunks_exact_mut(4)) {
            let values: [f32; 4] = root.new_domain(domain).draw_sample_f32();
            four.copy_from_slice(&values);
        }
        *i += 1;
    })
}

/// A stream, which need not know of rows.
fn pcg(job: &Job) -> Maker {
    let dimensions = job.dimensions;
    let start = |first: usize| {
        let mut state = rand_pcg::Pcg64Mcg::new(1);
        state.advance((first * dimensions / 2) as u128);
        state
    };
    shares(job, "rand_pcg", "(Pcg64Mcg)", start, |mut state, part| {
        for two in part.chunks_exact_mut(2) {
            let word = state.next_u64();
            let unit = |word: u32| (word >> 8) as f32 * (1.0 / 16_777_216.0);
            two.copy_from_slice(&[unit(word as u32), unit((word >> 32) as u32)]);
        }
    })
}
