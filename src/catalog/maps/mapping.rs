//! A map with its parameters.

use super::{Group, Map, Parameter};
use crate::environment::{Environment, Kind};
use crate::interface::{MAP_PARAMETERS, map};
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
        let prepared = super::prepared::prepared(map, &parameters);
        let mapping = Self {
            map,
            values: values.to_vec(),
            parameters,
            tables: Arc::new(Vec::from_iter((!prepared.is_empty()).then_some(prepared))),
        };
        if map.group != Group::Environment {
            return Ok(mapping);
        }
        let options = crate::environment::Options {
            kind: mapping.kind(),
            ..Default::default()
        };
        mapping.with_environment(Environment::new(1, 1, &[[1.0; 3]], options)?)
    }

    /// The same with the tables of an environment; until then its light comes from everywhere
    /// alike.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a map that draws from none, or by tables of the other kind.
    pub fn with_environment(mut self, environment: Environment) -> Result<Self> {
        let domain = match (self.map.group == Group::Environment, self.kind()) {
            (false, _) => "it draws from no environment",
            (true, kind) if kind == environment.kind() => {
                // Bits of integers, not floats.
                self.parameters[0] = f32::from_bits(environment.width());
                self.parameters[1] = f32::from_bits(environment.height());
                self.tables = Arc::new(vec![environment.into_words()]);
                return Ok(self);
            }
            (true, Kind::Hierarchical) => "it must be built with Kind::Hierarchical",
            (true, Kind::Alias) => "it must be built with Kind::Alias",
        };
        Err(refused(self.map, "env", "does not fit", domain))
    }

    /// The tables of an environment that this map draws by.
    fn kind(&self) -> Kind {
        match self.map.id {
            map::ENVIRONMENT_ALIAS => Kind::Alias,
            _ => Kind::Hierarchical,
        }
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

    /// Whether its tables are what the host prepares of its parameters.
    #[must_use]
    pub fn is_prepared(&self) -> bool {
        self.map.group != Group::Environment && !self.tables.is_empty()
    }

    /// The tables of its kernel: those of an environment, or what is prepared of its
    /// parameters.
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
            let plural = if numbers.len() == 1 { "" } else { "s" };
            let was = format!("is {} number{plural}", numbers.len());
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

/// Numbers as the command line takes them, those with many zeros by their exponent.
fn listed<'a>(numbers: impl Iterator<Item = &'a f64>) -> String {
    let short = |x: &f64| match x.abs() {
        0.0 | 1e-6..1e10 => x.to_string(),
        _ => format!("{x:e}"),
    };
    numbers.map(short).collect::<Vec<_>>().join(",")
}

fn refused(map: &Map, name: &str, problem: &str, domain: &str) -> Error {
    Error::Parameter {
        map: map.name,
        name: name.to_owned(),
        problem: problem.to_owned(),
        domain: domain.to_owned(),
    }
}
