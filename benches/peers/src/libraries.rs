//! Crates, each in the way that is fastest for it: every thread makes its share of the rows,
//! and what only goes forward begins where the share does, set up before the clock starts.

use crate::VALUES;
use crate::job::{Contender, Job, Kind, threads};
use rand_pcg::rand_core::Rng;
use std::error::Error;
use std::time::Instant;

type Named = (String, Box<dyn Contender>);

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

fn shares<State: Clone + Send + 'static>(
    job: &Job,
    name: &str,
    start: impl Fn(usize) -> State,
    fill: impl Fn(State, &mut [f32]) + Sync + 'static,
) -> Named {
    let first = (0..threads()).map(|thread| thread * share(job.dimensions));
    let maker = Shares {
        states: first.map(start).collect(),
        fill,
        dimensions: job.dimensions,
    };
    (name.to_owned(), Box::new(maker))
}

/// Those that make it.
pub fn of(job: &Job) -> Vec<Named> {
    let dimensions = job.dimensions;
    match job.kind {
        Kind::Halton => vec![halton(job)],
        Kind::Sobol => vec![shares(
            job,
            "sobol 1.0 (Gray order)",
            move |first| {
                let params = sobol::params::JoeKuoD6::standard();
                let mut points = sobol::Sobol::<f32>::new(dimensions, &params);
                points.by_ref().take(first).for_each(drop);
                points
            },
            move |points, part| {
                for (row, point) in part.chunks_exact_mut(dimensions).zip(points) {
                    row.copy_from_slice(&point);
                }
            },
        )],
        Kind::SobolScrambled => vec![burley(job), openqmc(job)],
        Kind::Random => vec![shares(
            job,
            "rand_pcg 0.10 (Pcg64Mcg)",
            move |first| {
                let mut state = rand_pcg::Pcg64Mcg::new(1);
                state.advance((first * dimensions / 2) as u128);
                state
            },
            |mut state, part| {
                for two in part.chunks_exact_mut(2) {
                    let word = state.next_u64();
                    let unit = |word: u32| (word >> 8) as f32 * (1.0 / 16_777_216.0);
                    two.copy_from_slice(&[unit(word as u32), unit((word >> 32) as u32)]);
                }
            },
        )],
    }
}

/// It keeps 2^16 points, after which they repeat.
fn burley(job: &Job) -> Named {
    let dimensions = job.dimensions;
    shares(
        job,
        "sobol_burley 0.5",
        |first| first as u32,
        move |first, part| {
            for (i, row) in (first..).zip(part.chunks_exact_mut(dimensions)) {
                for (set, four) in (0..).zip(row.chunks_exact_mut(4)) {
                    four.copy_from_slice(&sobol_burley::sample_4d(i % (1 << 16), set, 1));
                }
            }
        },
    )
}

/// A port of OpenQMC: four dimensions a domain, and points of their own after 2^16.
fn openqmc(job: &Job) -> Named {
    let dimensions = job.dimensions;
    shares(
        job,
        "openqmc-rs 0.2",
        |first| first as i32,
        move |first, part| {
            for (i, row) in (first..).zip(part.chunks_exact_mut(dimensions)) {
                let root = openqmc::SobolSampler::new(0, 0, 0, i);
                for (domain, four) in (0..).zip(row.chunks_exact_mut(4)) {
                    let values: [f32; 4] = root.new_domain(domain).draw_sample_f32();
                    four.copy_from_slice(&values);
                }
            }
        },
    )
}

/// It begins at index 1, and its own way to skip goes wrong past 255: so it steps.
fn halton(job: &Job) -> Named {
    let bases = corput::tables::PRIMES;
    let dimensions = job.dimensions;
    shares(
        job,
        "halton 0.2",
        move |first| {
            let bases = bases.iter().take(dimensions);
            let axis = |base: &u32| {
                let mut axis = halton::Sequence::new(*base as u8);
                for _ in 0..first {
                    axis.next();
                }
                axis
            };
            bases.map(axis).collect::<Vec<_>>()
        },
        move |mut axes, part| {
            for row in part.chunks_exact_mut(dimensions) {
                for (x, axis) in row.iter_mut().zip(&mut axes) {
                    *x = axis.next().unwrap_or(0.0) as f32;
                }
            }
        },
    )
}
