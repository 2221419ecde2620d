//! What all make.

use corput::bulk::Reference;
use corput::catalog::{Options, Order, Request, Scramble, Sequence};

/// What a job asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Radical inverses in the first primes.
    Halton,
    /// Sobol's points, unscrambled.
    Sobol,
    /// Sobol's points with a nested scramble, exact or by a hash.
    SobolScrambled,
    /// Independent uniform numbers.
    Random,
}

/// So many values of a kind, in rows of so many.
pub struct Job {
    pub name: &'static str,
    pub kind: Kind,
    pub dimensions: usize,
}

const fn job(name: &'static str, kind: Kind, dimensions: usize) -> Job {
    Job {
        name,
        kind,
        dimensions,
    }
}

pub const JOBS: &[Job] = &[
    job("Halton d=2", Kind::Halton, 2),
    job("Halton d=8", Kind::Halton, 8),
    job("Halton d=32", Kind::Halton, 32),
    job("Sobol d=2", Kind::Sobol, 2),
    job("Sobol d=8", Kind::Sobol, 8),
    job("Sobol d=32", Kind::Sobol, 32),
    job("Sobol scrambled d=4", Kind::SobolScrambled, 4),
    job("Sobol scrambled d=8", Kind::SobolScrambled, 8),
    job("random d=4", Kind::Random, 4),
];

/// Makes a job's values.
pub trait Contender {
    /// Fills memory with rows, and returns the seconds that it took.
    fn make(&mut self, memory: &mut [f32]) -> Result<f64, Box<dyn std::error::Error>>;

    /// Whether the values are in that memory, and not in one of its own.
    fn is_in_memory(&self) -> bool {
        true
    }
}

/// A contender, and what it is called.
pub struct Maker {
    /// The library, with its version.
    pub library: String,
    /// What it does otherwise than others do.
    pub note: String,
    /// The table's column.
    pub column: String,
    /// What tells it from others in that column; of most nothing.
    pub label: String,
    pub contender: Box<dyn Contender>,
}

impl Maker {
    pub fn name(&self) -> String {
        let name = format!("{} {}", self.library, self.note);
        name.trim_end().to_owned()
    }
}

/// All cores.
pub fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

impl Job {
    /// The same as a request of corput.
    pub fn request(&self, order: Order, sequence: Sequence) -> corput::Result<Request> {
        let mut options = Options::new(sequence, (crate::VALUES / self.dimensions) as u64);
        options.dimensions = Some(self.dimensions as u64);
        options.order = order;
        if self.kind == Kind::SobolScrambled {
            options.scramble = Some(Scramble::OwenHash);
        }
        Request::new(&options)
    }

    /// The sequence of corput that it is made by.
    pub fn sequence(&self) -> Sequence {
        match self.kind {
            Kind::Halton => Sequence::Halton,
            Kind::Sobol | Kind::SobolScrambled => Sequence::Sobol,
            Kind::Random => Sequence::RandomFast,
        }
    }

    /// Whether a maker's first rows are the definition's: those of Halton, with or without the
    /// origin, and of Sobol, in either order, to a few units of a float; of others that they
    /// are numbers in [0, 1] whose mean is a half. (1 is wrong, and occurs.)
    pub fn verify(&self, name: &str, memory: Option<&[f32]>) -> Result<(), String> {
        let Some(memory) = memory else { return Ok(()) };
        let rows = &memory[..4096 * self.dimensions];
        let wrong = |what: &str| Err(format!("{name}, {}: {what}", self.name));
        if !rows.iter().all(|x| (0.0..=1.0).contains(x)) {
            return wrong("a value is outside [0, 1]");
        }
        if matches!(self.kind, Kind::SobolScrambled | Kind::Random) {
            let mean = rows.iter().map(|x| f64::from(*x)).sum::<f64>() / rows.len() as f64;
            return match (mean - 0.5).abs() < 0.02 {
                true => Ok(()),
                false => wrong(&format!("their mean is {mean}")),
            };
        }
        let mut ways = Vec::new();
        for order in [Order::Natural, Order::Gray] {
            if order == Order::Gray && self.kind == Kind::Halton {
                continue;
            }
            let request = self.request(order, self.sequence());
            let reference = Reference::new(&request.map_err(|error| error.to_string())?);
            for start in [0, 1] {
                let mut words = vec![0; rows.len()];
                reference.fill_singly(start, &mut words);
                ways.push(words);
            }
        }
        let near = |words: &Vec<u32>| {
            let pairs = rows.iter().zip(words);
            pairs
                .into_iter()
                .all(|(x, word)| (x - f32::from_bits(*word)).abs() < 4e-7)
        };
        match ways.iter().any(near) {
            true => Ok(()),
            false => wrong("its first 4096 points are not those of the definition"),
        }
    }
}
