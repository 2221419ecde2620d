//! What a scene needs, as JSON.

use super::needs::{Domain, Draw, Needs};
use super::{Cause, Scene};
use serde_json::{Map, Value, json};

/// The version of the document.
pub const SCHEMA: u32 = 1;

/// The document of `corput scene --json`.
#[must_use]
pub fn document(scene: &Scene, needs: &Needs) -> Value {
    let left_out = needs.left_out.iter().map(|one| {
        json!({
            "part": one.part.name(),
            "name": one.name,
            "reason": one.reason,
        })
    });
    json!({
        "schema": SCHEMA,
        "name": scene.name,
        "sampler": scene.sampler.value.name(),
        "samples": scene.samples.value,
        "seed": scene.seed,
        "profile": scene.profile.name(),
        "dimensions": needs.dimensions(),
        "domains": needs.domains.iter().map(domain).collect::<Vec<_>>(),
        "left_out": left_out.collect::<Vec<_>>(),
        "found": scene.found,
        "warnings": needs.warnings,
    })
}

fn domain(domain: &Domain) -> Value {
    let draw = match &domain.draw {
        Draw::Between(ends) => json!({ "between": ends }),
        Draw::Choice(weights) => json!({ "choice": weights }),
        Draw::Map(mapping) => {
            let mut values = mapping.values().iter();
            let mut parameters = Map::new();
            for parameter in mapping.map().parameters {
                let numbers: Vec<f64> = values.by_ref().take(parameter.size).copied().collect();
                parameters.insert(parameter.name.to_owned(), json!(numbers));
            }
            let table_bytes: usize = mapping.tables().iter().map(|words| 4 * words.len()).sum();
            json!({
                "map": mapping.map().name,
                "parameters": parameters,
                "table_bytes": table_bytes,
            })
        }
    };
    json!({
        "key": domain.key,
        "draw": draw,
        "dimensions": domain.draw.dimensions(),
        "first": domain.first,
        "cause": cause(&domain.cause),
    })
}

fn cause(cause: &Cause) -> Value {
    json!({ "line": cause.line, "text": cause.text })
}
