//! Sums of the integrands over points of the Sobol sequence. Those of a map are left out:
//! the map would have to come with them.

use super::{Entry, about};
use crate::Result;
use crate::bulk::estimate;
use crate::catalog::{
    Integrand, Options, Problem, Request, Scramble, Sequence, examples, integrands,
};
use serde_json::{Map, Value};

const POINTS: u64 = 256;

/// Those whose sums are published.
pub fn published() -> impl Iterator<Item = &'static Integrand> {
    integrands().filter(|one| !one.needs_map)
}

pub fn each(take: &mut dyn FnMut(&Entry) -> Result<()>) -> Result<()> {
    for integrand in published() {
        for problem in examples(integrand)? {
            take(&entry(&problem)?)?;
        }
    }
    Ok(())
}

fn entry(problem: &Problem) -> Result<Entry> {
    let request = Request::new(&Options {
        dimensions: Some(problem.dimensions().into()),
        scramble: Some(Scramble::None),
        fractions: true,
        ..Options::new(Sequence::Sobol, POINTS)
    })?;
    let sum = estimate(problem, &request, 0, POINTS)?;
    let names = problem.integrand().parameters.iter().map(|one| one.name);
    let parameters: Map<String, Value> = names
        .zip(problem.values())
        .map(|(name, &value)| (name.to_owned(), value.into()))
        .collect();
    Ok(Entry {
        kind: "integrand",
        name: problem.integrand().name.to_owned(),
        about: about([
            ("estimator", problem.estimator().into()),
            ("dimensions", problem.dimensions().into()),
            ("parameters", Value::Object(parameters)),
            ("points", format!("the first {POINTS} of sobol").into()),
            ("unit", format!("2^{}", -sum.scale()).into()),
            ("sum", sum.sum().to_string().into()),
            ("sum_of_squares", sum.squares().to_string().into()),
        ]),
        table: None,
        tables: Vec::new(),
    })
}
