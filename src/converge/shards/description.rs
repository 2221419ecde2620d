//! A study as a document, by which shards know each other's, and back.

use crate::catalog::Sampler;
use crate::converge::study::{Row, Settings, Study, rows};
use crate::report::{Difference, differences, hexadecimal};
use crate::{Error, Result};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

/// Everything that decides what is measured, and what is asked of it.
pub fn describe(study: &Study) -> Value {
    json!({
        "integrands": study.rows().iter().map(describe_row).collect::<Vec<_>>(),
        "counts": study.counts(),
        "replicates": study.replicates(),
        "seed": study.seed(),
        "targets": study.targets(),
    })
}

fn describe_row(row: &Row) -> Value {
    let tables = row.problem.tables();
    // What a map holds is not in its name.
    let hash = || hexadecimal(&Sha256::digest(bytemuck::cast_slice::<u32, u8>(tables)));
    json!({
        "name": row.name,
        "estimator": row.problem.estimator(),
        "tables": (!tables.is_empty()).then(hash),
        "samplers": row.samplers.iter().map(|one| one.name()).collect::<Vec<_>>(),
    })
}

/// The study of a document. Maps are read again.
///
/// # Errors
/// [`Error::Arguments`] for what [`describe`] does not write, or of a study whose integrands are
/// not in the catalogue, or whose maps are others now; those of the maps.
pub fn restore(document: &Value) -> Result<Study> {
    let study = parse(document).unwrap_or_else(|| Err(unknown("it is no description of one")))?;
    match difference(document, &describe(&study)) {
        None => Ok(study),
        Some(found) => Err(unknown(&found)),
    }
}

/// None where a member is missing or of a wrong kind.
fn parse(document: &Value) -> Option<Result<Study>> {
    let mut all = Vec::new();
    for entry in document["integrands"].as_array()? {
        let name = entry["name"].as_str()?;
        let estimators: Vec<String> = entry["estimator"]
            .as_str()
            .map(str::to_owned)
            .into_iter()
            .collect();
        let samplers = entry["samplers"].as_array()?.iter().map(Value::as_str);
        let samplers: Option<Vec<&str>> = samplers.collect();
        let samplers = samplers?.into_iter().map(Sampler::parse);
        let made = samplers
            .collect::<Result<Vec<_>>>()
            .and_then(|samplers| rows(name, &estimators, &samplers));
        match made {
            Ok(made) => all.extend(made),
            Err(error) => return Some(Err(error)),
        }
    }
    let numbers = document["counts"].as_array()?.iter().map(Value::as_u64);
    let counts: Vec<u64> = numbers.collect::<Option<_>>()?;
    let targets = document["targets"].as_array()?.iter().map(Value::as_f64);
    let settings = Settings {
        min_count: *counts.first()?,
        max_count: *counts.last()?,
        replicates: document["replicates"].as_u64()?.try_into().ok()?,
        seed: document["seed"].as_u64()?,
        targets: targets.collect::<Option<_>>()?,
    };
    Some(Study::new(all, settings))
}

fn unknown(problem: &str) -> Error {
    Error::Arguments {
        asked: "the study that the shards keep".into(),
        limit: format!("it cannot be made again: {problem}"),
        remedy: "use the version of corput and the maps that the shards had".into(),
    }
}

/// What [`differences`] calls a value that no name leads to.
const WHOLE: &str = "the document";

/// The first member in which one study is not another.
pub fn difference(there: &Value, here: &Value) -> Option<String> {
    let first = differences(there, here).into_iter().next()?;
    let Difference { path, there, here } = first;
    let (Some(left), Some(right)) = (there.as_array(), here.as_array()) else {
        return Some(format!("{path} is {there} there, and {here} here"));
    };
    let mut pairs = left.iter().zip(right).enumerate();
    Some(
        match pairs.find_map(|(at, (left, right))| Some((at, difference(left, right)?))) {
            Some((at, within)) => {
                let within = within
                    .strip_prefix(WHOLE)
                    .map_or(format!(".{within}"), str::to_owned);
                format!("{path}[{at}]{within}")
            }
            None => {
                let (left, right) = (left.len(), right.len());
                format!("{path} has {left} entries there, and {right} here")
            }
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn study(replicates: u32) -> Study {
        let samplers = ["random", "sobol:owen"].map(|name| Sampler::parse(name).unwrap());
        let mut all = rows("genz-gaussian:d=3,difficulty=2", &[], &samplers).unwrap();
        let map = concat!(
            "irradiance:map=",
            env!("CARGO_MANIFEST_DIR"),
            "/tests/data/sunrise.exr"
        );
        all.extend(rows(map, &["mis".to_owned()], &samplers[..1]).unwrap());
        let settings = Settings {
            min_count: 10,
            max_count: 1000,
            replicates,
            seed: u64::MAX,
            targets: vec![0.1 + 0.2, 1e-300],
        };
        Study::new(all, settings).unwrap()
    }

    #[test]
    fn a_study_comes_back() {
        let text = describe(&study(4)).to_string();
        let read: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(restore(&read).unwrap(), study(4));
        let other = |change: &dyn Fn(&mut Value)| {
            let mut changed = read.clone();
            change(&mut changed);
            difference(&changed, &read).unwrap()
        };
        let said = other(&|study| study["replicates"] = json!(5));
        assert_eq!(said, "replicates is 5 there, and 4 here");
        let said = other(&|study| study["integrands"][1]["samplers"][0] = json!("sobol"));
        assert_eq!(
            said,
            "integrands[1].samplers[0] is \"sobol\" there, and \"random\" here"
        );
        let said = other(&|study| study["counts"] = json!([16]));
        assert_eq!(said, "counts has 1 entries there, and 7 here");
    }

    #[test]
    fn one_of_another_map_does_not() {
        let mut changed = describe(&study(4));
        changed["integrands"][1]["tables"] = json!("0");
        let refused = restore(&changed).unwrap_err().to_string();
        assert!(
            refused.contains("cannot be made again: integrands[1].tables is"),
            "{refused}"
        );
        for (member, value) in [
            ("counts", json!([])),
            ("counts", json!([16, 64])),
            ("replicates", json!(1)),
            ("seed", json!(-1)),
            ("integrands", json!([{ "name": "x-squared" }])),
        ] {
            let mut changed = describe(&study(4));
            changed[member] = value;
            assert!(restore(&changed).is_err(), "{member}");
        }
    }
}
