//! What is measured: 2^25 words of each sequence, and samples of maps.

use super::Goal;
use crate::catalog::{Map, Mapping, Options, Profile, Request, Scramble, Sequence};
use crate::error::{Error, Result, nearest};

/// Words that each job stores: 2^25, 128 MiB, in dispatches that a buffer holds.
const WORDS: u64 = 1 << 25;

/// A job.
#[derive(Clone, Debug)]
pub struct Job {
    /// What it makes.
    pub name: String,
    /// The same as a request.
    pub request: Request,
    /// What a device of the CPU kind is to reach on two cores.
    pub goal: Option<Goal>,
    /// What the CPU path is to reach.
    pub cpu_goal: Option<Goal>,
}

/// Name, sequence, scramble, dimensions, and the goal as a multiple of the fill.
type Points = (&'static str, Sequence, Option<Scramble>, u64, Option<f64>);

#[rustfmt::skip]
const POINTS: &[Points] = &[
    ("van der Corput", Sequence::VanDerCorput, None, 1, Some(1.5)),
    ("Hammersley d=2", Sequence::Hammersley, None, 2, Some(1.5)),
    ("Halton d=2", Sequence::Halton, None, 2, Some(2.0)),
    ("Halton d=4", Sequence::Halton, None, 4, None),
    ("Halton d=8", Sequence::Halton, None, 8, Some(2.0)),
    ("Halton d=32", Sequence::Halton, None, 32, Some(2.0)),
    ("Halton d=2, permuted", Sequence::Halton, Some(Scramble::Permute), 2, Some(3.0)),
    ("Halton d=8, permuted", Sequence::Halton, Some(Scramble::Permute), 8, Some(3.0)),
    ("Sobol d=2", Sequence::Sobol, None, 2, Some(1.5)),
    ("Sobol d=8", Sequence::Sobol, None, 8, Some(1.5)),
    ("Sobol d=32", Sequence::Sobol, None, 32, Some(1.5)),
    ("Sobol d=2, hash-scrambled", Sequence::Sobol, Some(Scramble::OwenHash), 2, Some(3.0)),
    ("Sobol d=8, hash-scrambled", Sequence::Sobol, Some(Scramble::OwenHash), 8, Some(3.0)),
    ("Sobol d=2, Owen-scrambled", Sequence::Sobol, Some(Scramble::Owen), 2, None),
    ("random d=4", Sequence::Random, None, 4, Some(3.0)),
    ("random-fast d=4", Sequence::RandomFast, None, 4, Some(3.0)),
    ("R2 d=2", Sequence::R2, None, 2, None),
];

/// What the CPU path is to reach wherever a device has a goal.
const CPU_FILLS: f64 = 1.3;

/// Name, sequence, map, profile, and the goal in G points/s.
type Fused = (&'static str, Sequence, &'static str, Profile, Option<f64>);

/// Directions fused with their points.
#[rustfmt::skip]
const FUSED: &[Fused] = &[
    ("cosine polar, exact", Sequence::Halton, "cosine-hemisphere-polar", Profile::Exact, Some(0.41)),
    ("cosine polar of Sobol, exact", Sequence::Sobol, "cosine-hemisphere-polar", Profile::Exact, Some(0.41)),
    ("cosine concentric, exact", Sequence::Halton, "cosine-hemisphere", Profile::Exact, None),
    ("cosine polar, native", Sequence::Halton, "cosine-hemisphere-polar", Profile::Native, Some(0.6)),
];

/// Maps with pdf over Sobol points, in both profiles: name and parameters.
#[rustfmt::skip]
const MAPS: &[(&str, &[f64])] = &[
    ("cone", &[0.1]),
    ("spherical-triangle", &[0.0, 0.0, 1.0, 0.5, 0.0, 1.0, 0.0, 0.5, 1.0]),
    ("henyey-greenstein", &[0.9]),
    ("ggx-vndf", &[0.1, 0.0, 0.8, 0.0, 0.6]),
    ("ggx-vndf-bounded", &[0.1, 0.0, 0.8, 0.0, 0.6]),
    ("normal-pair", &[1.0]),
];

/// All jobs.
///
/// # Errors
/// None that a user could cause.
pub fn jobs() -> Result<Vec<Job>> {
    let mut jobs = Vec::new();
    for &(name, sequence, scramble, dimensions, goal) in POINTS {
        let mut options = Options::new(sequence, WORDS / dimensions);
        options.dimensions = (dimensions > 1).then_some(dimensions);
        options.scramble = scramble;
        jobs.push(Job {
            name: name.to_owned(),
            request: Request::new(&options)?,
            goal: goal.map(Goal::Fill),
            cpu_goal: goal.map(|_| Goal::Fill(CPU_FILLS)),
        });
    }
    for &(name, sequence, map, profile, goal) in FUSED {
        let mut options = Options::new(sequence, WORDS / 3);
        options.dimensions = Some(2);
        options.map = Some(Mapping::new(Map::from_name(map)?, &[])?);
        options.profile = profile;
        jobs.push(Job {
            name: name.to_owned(),
            request: Request::new(&options)?,
            goal: goal.map(|giga| Goal::Rate(giga * 1e9)),
            cpu_goal: goal.map(|_| Goal::Fill(CPU_FILLS)),
        });
    }
    for &(map, values) in MAPS {
        for profile in [Profile::Exact, Profile::Native] {
            let mut options = Options::new(Sequence::Sobol, WORDS / 16);
            options.dimensions = Some(2);
            options.map = Some(Mapping::with_values(Map::from_name(map)?, values)?);
            options.with_pdf = true;
            options.profile = profile;
            jobs.push(Job {
                name: format!("{map}, {}", profile.name()),
                request: Request::new(&options)?,
                goal: None,
                cpu_goal: None,
            });
        }
    }
    Ok(jobs)
}

/// The jobs whose names hold one of these texts, in any case; all for none.
///
/// # Errors
/// [`Error::UnknownName`] for a text that no name holds.
pub fn chosen(only: &[String]) -> Result<Vec<Job>> {
    let mut jobs = jobs()?;
    let holds = |job: &Job, text: &String| job.name.to_lowercase().contains(&text.to_lowercase());
    if let Some(text) = only
        .iter()
        .find(|text| !jobs.iter().any(|j| holds(j, text)))
    {
        let names: Vec<&str> = jobs.iter().map(|job| job.name.as_str()).collect();
        let words = names.iter().flat_map(|name| name.split([' ', ',']));
        let words = words.filter(|word| !word.is_empty());
        let words: Vec<String> = words.map(str::to_lowercase).collect();
        return Err(Error::UnknownName {
            kind: "job",
            name: text.clone(),
            nearest: nearest(text, words.iter().map(String::as_str)).map(str::to_owned),
            known: names.join("; "),
        });
    }
    jobs.retain(|job| only.is_empty() || only.iter().any(|text| holds(job, text)));
    Ok(jobs)
}
