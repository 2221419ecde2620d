//! A map with its parameters.

use super::{Map, Parameter};
use crate::interface::MAP_PARAMETERS;
use crate::{Error, Result};
use std::sync::Arc;

/// A map and what it is to be applied with, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Mapping {
    map: &'static Map,
    values: Vec<f64>,
    parameters: [f32; MAP_PARAMETERS],
    tables: Arc<Vec<Vec<u32>>>,
}

impl Mapping {
    /// A map with values for its parameters, by name; the others have their defaults.
    ///
    /// # Errors
    /// [`Error::UnknownName`] for a parameter that the map does not have,
    /// [`Error::Parameter`] for one without a value, with another number of numbers, or
    /// outside its domain.
    pub fn new(map: &'static Map, given: &[(&str, &[f64])]) -> Result<Self> {
        for (name, _) in given {
            if !map.parameters.iter().any(|one| one.name == *name) {
                let known: Vec<&str> = map.parameters.iter().map(|one| one.name).collect();
                return Err(match known[..] {
                    [] => refused(map, name, "was given", "it takes no parameters"),
                    _ => Error::unknown_name("parameter", name, &known),
                });
            }
        }
        let mut values = Vec::new();
        for parameter in map.parameters {
            values.extend_from_slice(value(map, parameter, given)?);
        }
        Self::with_values(map, &values)
    }

    /// A map with all the numbers of its parameters, in their order.
    ///
    /// # Errors
    /// [`Error::Parameter`] for one outside its domain, or for too few or many numbers.
    pub fn with_values(map: &'static Map, values: &[f64]) -> Result<Self> {
        let wanted: usize = map.parameters.iter().map(|one| one.size).sum();
        if values.len() != wanted {
            let was = format!("are {} numbers", values.len());
            return Err(refused(
                map,
                "parameters",
                &was,
                &format!("it takes {wanted}"),
            ));
        }
        let parameters = (map.prepare)(values).map_err(|index| {
            let before: usize = map.parameters.iter().take(index).map(|one| one.size).sum();
            match map.parameters.get(index) {
                Some(p) => {
                    let text = listed(values.iter().skip(before).take(p.size));
                    refused(map, p.name, &format!("is {text}"), p.domain)
                }
                None => refused(map, "parameters", "do not fit", "see `corput maps`"),
            }
        })?;
        Ok(Self {
            map,
            values: values.to_vec(),
            parameters,
            tables: Arc::default(),
        })
    }

    /// The same with the tables that the map's kernel binds after its points.
    #[must_use]
    pub fn with_tables(mut self, tables: Vec<Vec<u32>>) -> Self {
        self.tables = Arc::new(tables);
        self
    }

    /// The map.
    #[must_use]
    pub fn map(&self) -> &'static Map {
        self.map
    }

    /// The numbers of its parameters, in order.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// What its functions take.
    #[must_use]
    pub fn parameters(&self) -> &[f32; MAP_PARAMETERS] {
        &self.parameters
    }

    /// The same, as a kernel takes them.
    #[must_use]
    pub fn words(&self) -> [u32; MAP_PARAMETERS] {
        self.parameters.map(f32::to_bits)
    }

    /// The tables of its kernel.
    #[must_use]
    pub fn tables(&self) -> &[Vec<u32>] {
        &self.tables
    }
}

/// The numbers given for a parameter, or its default.
fn value<'a>(
    map: &Map,
    parameter: &Parameter,
    given: &'a [(&str, &'a [f64])],
) -> Result<&'a [f64]> {
    let mut all = given.iter().filter(|(name, _)| *name == parameter.name);
    let found = all.next();
    if all.next().is_some() {
        return Err(refused(
            map,
            parameter.name,
            "was given twice",
            "once is enough",
        ));
    }
    match (found, parameter.default) {
        (Some((_, numbers)), _) if numbers.len() == parameter.size => Ok(numbers),
        (Some((_, numbers)), _) => {
            let was = format!("is {} numbers", numbers.len());
            let limit = format!("it takes {}: {}", parameter.size, parameter.domain);
            Err(refused(map, parameter.name, &was, &limit))
        }
        (None, Some(default)) => Ok(default),
        (None, None) => Err(refused(
            map,
            parameter.name,
            "was not given",
            parameter.domain,
        )),
    }
}

/// Numbers as the command line takes them.
fn listed<'a>(numbers: impl Iterator<Item = &'a f64>) -> String {
    numbers.map(f64::to_string).collect::<Vec<_>>().join(",")
}

fn refused(map: &Map, name: &str, problem: &str, domain: &str) -> Error {
    Error::Parameter {
        map: map.name,
        name: name.to_owned(),
        problem: problem.to_owned(),
        domain: domain.to_owned(),
    }
}
