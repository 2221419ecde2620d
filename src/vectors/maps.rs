//! Samples of the maps: three fractions, then the sample and its pdf, floats as their bits.

use super::{Entry, Table, about};
use crate::Result;
use crate::bulk::map_sample;
use crate::catalog::{Mapping, Profile, maps};
use crate::check::{examples, fractions};
use serde_json::{Map, Value};

pub fn each(take: &mut dyn FnMut(&Entry) -> Result<()>) -> Result<()> {
    for map in maps() {
        for (number, mapping) in examples(map)?.iter().enumerate() {
            let mut words = Vec::new();
            for u in fractions() {
                words.extend(u);
                words.extend(map_sample(mapping, Profile::Exact, u));
            }
            let place = format!("maps/{}-{number}", map.name);
            let tables = mapping.tables().iter().enumerate();
            take(&Entry {
                kind: "map",
                name: map.name.to_owned(),
                about: about([
                    ("tier", map.tier.letter().into()),
                    ("parameters", Value::Object(parameters(mapping))),
                ]),
                table: Some(Table {
                    file: format!("{place}.npy"),
                    columns: 7,
                    words,
                    axes: None,
                }),
                tables: tables
                    .map(|(index, words)| Table {
                        file: format!("{place}-reads-{index}.npy"),
                        columns: 1,
                        words: words.clone(),
                        axes: None,
                    })
                    .collect(),
            })?;
        }
    }
    Ok(())
}

fn parameters(mapping: &Mapping) -> Map<String, Value> {
    let mut values = mapping.values().iter();
    let parameters = mapping.map().parameters.iter();
    parameters
        .map(|one| {
            let numbers: Vec<f64> = values.by_ref().take(one.size).copied().collect();
            (one.name.to_owned(), numbers.into())
        })
        .collect()
}
