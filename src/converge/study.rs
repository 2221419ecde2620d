//! What a study measures: integrands, samplers, counts and replicates.

use crate::catalog::{Problem, Sampler};
use crate::{Error, Result};

/// Counts that a study may have.
const COUNTS: std::ops::RangeInclusive<u64> = 1..=1 << 32;

/// Replicates that a study may have.
const REPLICATES: std::ops::RangeInclusive<u32> = 2..=4096;

/// An integrand, and the samplers that try it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The integrand as it was named, with its parameters.
    pub name: String,
    /// The integrand, with its estimator.
    pub problem: Problem,
    /// The samplers.
    pub samplers: Vec<Sampler>,
}

/// A study, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    rows: Vec<Row>,
    counts: Vec<u64>,
    replicates: u32,
    seed: u64,
    targets: Vec<f64>,
}

/// What a study asks besides its rows; `Default` has the values where none are given.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The fewest points.
    pub min_count: u64,
    /// The most.
    pub max_count: u64,
    /// Independent randomisations of each random sampler; their seeds are `seed`, `seed + 1`
    /// and so on.
    pub replicates: u32,
    /// Seed of the first.
    pub seed: u64,
    /// Relative errors of which the time is asked.
    pub targets: Vec<f64>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            min_count: 1 << 4,
            max_count: 1 << 18,
            replicates: 32,
            seed: 1,
            targets: vec![1e-2, 1e-3, 1e-4],
        }
    }
}

impl Study {
    /// Checks a study. The counts are the powers of two from the fewest to the most points,
    /// and the most.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a setting outside its range, for rows that are none, or that
    /// are there twice; those of a sampler that has none of the counts.
    pub fn new(rows: Vec<Row>, settings: Settings) -> Result<Self> {
        let Settings {
            min_count,
            max_count,
            replicates,
            seed,
            targets,
        } = settings;
        if !COUNTS.contains(&min_count) || !COUNTS.contains(&max_count) || min_count > max_count {
            return refuse(
                format!("{min_count} to {max_count} points"),
                "a study has 1 to 2^32, the fewest first",
                "choose --min-count and --max-count in that range",
            );
        }
        if !REPLICATES.contains(&replicates) {
            return refuse(
                format!(
                    "{replicates} replicate{}",
                    if replicates == 1 { "" } else { "s" }
                ),
                "an interval needs 2 to 4096 independent ones",
                "choose --replicates 32 or more for a good interval",
            );
        }
        if let Some(wrong) = targets.iter().find(|t| !(t.is_finite() && **t > 0.0)) {
            return refuse(
                format!("a target of {wrong}"),
                "a relative error is above 0",
                "choose targets such as 1e-2,1e-3",
            );
        }
        let powers = (0..=32).map(|log| 1 << log);
        let mut counts: Vec<u64> = powers
            .filter(|count| (min_count..=max_count).contains(count))
            .collect();
        if counts.last() != Some(&max_count) {
            counts.push(max_count);
        }
        let study = Self {
            rows,
            counts,
            replicates,
            seed,
            targets,
        };
        study.check()?;
        Ok(study)
    }

    fn check(&self) -> Result<()> {
        if self.cells() == 0 {
            return refuse(
                "a study of nothing".into(),
                "it needs an integrand and a sampler",
                "name them with --integrand and --sampler, or in a study file",
            );
        }
        for (index, row) in self.rows.iter().enumerate() {
            let twice = self.rows.iter().take(index).any(|one| {
                one.name == row.name && one.problem.estimator() == row.problem.estimator()
            });
            if twice {
                return refuse(
                    format!("integrand {} twice", row.name),
                    "a study has each once with each estimator",
                    "drop one of the two",
                );
            }
            for (place, sampler) in row.samplers.iter().enumerate() {
                if row.samplers.iter().take(place).any(|one| one == sampler) {
                    return refuse(
                        format!("sampler {} twice for {}", sampler.name(), row.name),
                        "an integrand has each once",
                        "drop one of the two",
                    );
                }
                self.possible(row, *sampler)?;
            }
        }
        Ok(())
    }

    /// Refuses a sampler that has none of the counts.
    fn possible(&self, row: &Row, sampler: Sampler) -> Result<()> {
        let mut refusal = None;
        for &count in &self.counts {
            match sampler.request(row.problem.dimensions(), count, self.seed) {
                Ok(_) => return Ok(()),
                Err(error) => refusal = Some(error),
            }
        }
        refusal.map_or(Ok(()), |error| {
            let (name, integrand) = (sampler.name(), &row.name);
            refuse(
                format!("{name} on {integrand}"),
                &error.to_string(),
                "choose another sampler for it, or other counts",
            )
        })
    }

    /// The integrands.
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Pairs of an integrand and a sampler.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.rows.iter().map(|row| row.samplers.len()).sum()
    }

    /// Numbers of points, rising.
    #[must_use]
    pub fn counts(&self) -> &[u64] {
        &self.counts
    }

    /// Independent randomisations.
    #[must_use]
    pub fn replicates(&self) -> u32 {
        self.replicates
    }

    /// The seed of the first; the others follow it.
    #[must_use]
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Relative errors of which the time is asked.
    #[must_use]
    pub fn targets(&self) -> &[f64] {
        &self.targets
    }
}

/// Rows of an integrand: one for each of the estimators, or for all that it has where none
/// are given.
///
/// # Errors
/// [`Error::UnknownName`] for a name that is none, [`Error::Arguments`] for a parameter out
/// of its domain.
pub fn rows(integrand: &str, estimators: &[String], samplers: &[Sampler]) -> Result<Vec<Row>> {
    let problem = Problem::parse(integrand)?;
    let row = |problem| Row {
        name: integrand.to_owned(),
        problem,
        samplers: samplers.to_vec(),
    };
    if estimators.is_empty() && problem.integrand().estimators.is_empty() {
        return Ok(vec![row(problem)]);
    }
    let all = problem
        .integrand()
        .estimators
        .iter()
        .map(|one| (*one).to_owned());
    let names = match estimators {
        [] => all.collect(),
        given => given.to_vec(),
    };
    names
        .iter()
        .map(|name| problem.with_estimator(name).map(row))
        .collect()
}

fn refuse<T>(asked: String, limit: &str, remedy: &str) -> Result<T> {
    Err(Error::Arguments {
        asked,
        limit: limit.to_owned(),
        remedy: remedy.to_owned(),
    })
}
