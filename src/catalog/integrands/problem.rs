//! An integrand with its parameters and dimensions.

use super::{Coefficients, Integrand, LightMap, MIS, Setting};
use crate::catalog::Request;
use crate::{Error, Result};
use std::path::Path;
use std::sync::Arc;

/// An integrand and what it is to be evaluated with, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    integrand: &'static Integrand,
    estimator: usize,
    dimensions: u32,
    values: Vec<f64>,
    map: Option<Arc<LightMap>>,
    coefficients: Coefficients,
    truth: f64,
}

impl Problem {
    /// An integrand with values for its parameters by name, and `d` for its dimensions; the
    /// others have their defaults, and the estimator is its first.
    ///
    /// # Errors
    /// [`Error::UnknownName`] for a parameter that it does not have, [`Error::Arguments`] for
    /// one given twice or outside its domain, and for an integrand that needs a map.
    pub fn new(integrand: &'static Integrand, given: &[(&str, f64)]) -> Result<Self> {
        Self::with_map(integrand, given, None)
    }

    /// The same with the map of an integrand that needs one.
    ///
    /// # Errors
    /// Those of [`Self::new`], and [`Error::Arguments`] for a map that it does not need.
    pub fn with_map(
        integrand: &'static Integrand,
        given: &[(&str, f64)],
        map: Option<Arc<LightMap>>,
    ) -> Result<Self> {
        for (index, (name, _)) in given.iter().enumerate() {
            let mut known = vec!["d"];
            known.extend(integrand.parameters.iter().map(|one| one.name));
            if !known.contains(name) {
                return Err(Error::unknown_name("parameter", name, &known));
            }
            if given.iter().take(index).any(|(other, _)| other == name) {
                return Err(refused(integrand, name, "given twice", "once is enough"));
            }
        }
        let found = |name| given.iter().find(|(one, _)| *one == name).map(|one| one.1);
        let (least, most) = integrand.dimensions;
        let dimensions = found("d").unwrap_or(integrand.default_dimensions.into());
        if dimensions.fract() != 0.0 || !(least.into()..=most.into()).contains(&dimensions) {
            let domain = match least == most {
                true => format!("it has {least}"),
                false => format!("it must be a whole number from {least} to {most}"),
            };
            return Err(refused(integrand, "d", &dimensions.to_string(), &domain));
        }
        let value = |one: &super::Parameter| {
            let default = one.default.and_then(|numbers| numbers.first().copied());
            found(one.name).or(default).unwrap_or(f64::NAN)
        };
        let values: Vec<f64> = integrand.parameters.iter().map(value).collect();
        Self::made(integrand, &values, dimensions as u32, 0, map)
    }

    /// An integrand with all the numbers of its parameters, in their order.
    ///
    /// # Errors
    /// [`Error::Arguments`] for one outside its domain, for too few or many numbers, and for
    /// dimensions that it does not have, and for an integrand that needs a map.
    pub fn with_values(
        integrand: &'static Integrand,
        values: &[f64],
        dimensions: u32,
    ) -> Result<Self> {
        Self::made(integrand, values, dimensions, 0, None)
    }

    pub(super) fn made(
        integrand: &'static Integrand,
        values: &[f64],
        dimensions: u32,
        estimator: usize,
        map: Option<Arc<LightMap>>,
    ) -> Result<Self> {
        match (integrand.needs_map, &map) {
            (true, None) => {
                let domain = "it must be an environment map, an .exr or .hdr";
                return Err(refused(integrand, "map", "not given", domain));
            }
            (false, Some(map)) => {
                return Err(refused(integrand, "map", map.name(), "it takes none"));
            }
            _ => {}
        }
        let (least, most) = integrand.dimensions;
        let wanted = integrand.parameters.len();
        if values.len() != wanted || !(least..=most).contains(&dimensions) {
            let was = format!("{} parameters, {dimensions} dimensions", values.len());
            let domain = format!("it takes {wanted}, and {least} to {most} dimensions");
            return Err(refused(integrand, "all", &was, &domain));
        }
        let setting = Setting {
            values,
            dimensions,
            estimator,
            map: map.as_deref(),
        };
        let coefficients = (integrand.prepare)(&setting).map_err(|index| {
            let value = values.get(index).copied().unwrap_or(f64::NAN);
            let parameter = integrand.parameters.get(index);
            let (name, domain) = parameter.map_or(("all", ""), |one| (one.name, one.domain));
            refused(integrand, name, &value.to_string(), domain)
        })?;
        let truth = (integrand.truth)(&setting);
        Ok(Self {
            integrand,
            estimator,
            dimensions,
            values: values.to_vec(),
            map,
            coefficients,
            truth,
        })
    }

    /// The same integral by another of its estimators.
    ///
    /// # Errors
    /// [`Error::UnknownName`] for one that it does not have.
    pub fn with_estimator(&self, name: &str) -> Result<Self> {
        let known = self.integrand.estimators;
        let found = known.iter().position(|one| *one == name);
        let estimator = found.ok_or_else(|| match known {
            [] => refused(
                self.integrand,
                "the estimator",
                name,
                "it has only one, without a name",
            ),
            _ => Error::unknown_name("estimator", name, known),
        })?;
        Self::made(
            self.integrand,
            &self.values,
            self.dimensions,
            estimator,
            self.map.clone(),
        )
    }

    /// The same integrand and estimator with other numbers of its parameters.
    ///
    /// # Errors
    /// [`Error::Arguments`] for one outside its domain, and for too few or many numbers.
    pub fn moved(&self, values: &[f64]) -> Result<Self> {
        let map = self.map.clone();
        Self::made(self.integrand, values, self.dimensions, self.estimator, map)
    }

    /// From `NAME` or `NAME:key=value,key=value`, as the command line has it. Values are
    /// numbers; that of `map` is a file, which is read, and that of `axis` as `+z`.
    ///
    /// # Errors
    /// Those of [`Self::with_map`] and [`LightMap::read`], and [`Error::Arguments`] for what
    /// is not of that form.
    pub fn parse(text: &str) -> Result<Self> {
        let (name, rest) = text.split_once(':').unwrap_or((text, ""));
        let integrand = Integrand::from_name(name)?;
        let mut given = Vec::new();
        let mut map = None;
        for part in rest.split(',').filter(|part| !part.is_empty()) {
            let pair = part.split_once('=');
            match pair {
                Some(("map", _)) if map.is_some() => {
                    return Err(refused(integrand, "map", "given twice", "once is enough"));
                }
                Some(("map", path)) if integrand.needs_map => {
                    map = Some(Arc::new(LightMap::read(Path::new(path))?));
                    continue;
                }
                _ => {}
            }
            let number = pair.and_then(|(key, value)| Some((key, number(integrand, key, value)?)));
            given.push(number.ok_or_else(|| unreadable(integrand, text, part))?);
        }
        Self::with_map(integrand, &given, map)
    }

    /// The integrand.
    #[must_use]
    pub fn integrand(&self) -> &'static Integrand {
        self.integrand
    }

    /// Its estimator, where it has a choice.
    #[must_use]
    pub fn estimator(&self) -> Option<&'static str> {
        self.integrand.estimators.get(self.estimator).copied()
    }

    /// Value of the specialization constant `INTEGRAND`: of the integrand and its estimator.
    #[must_use]
    pub fn id(&self) -> u32 {
        self.integrand.id + self.estimator as u32
    }

    /// Its dimensions, which may differ by the estimator.
    #[must_use]
    pub fn dimensions(&self) -> u32 {
        self.dimensions + u32::from(self.estimator() == Some(MIS))
    }

    /// The map of an integrand that needs one.
    #[must_use]
    pub fn map(&self) -> Option<&LightMap> {
        self.map.as_deref()
    }

    /// What kernels read besides the coefficients: the words of its map.
    #[must_use]
    pub fn tables(&self) -> &[u32] {
        self.map.as_ref().map_or(&[], |map| map.words())
    }

    /// The numbers of its parameters, in their order.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Its integral over the unit cube.
    #[must_use]
    pub fn truth(&self) -> f64 {
        self.truth
    }

    /// The same; `None` where no integral is known.
    #[must_use]
    pub fn known_truth(&self) -> Option<f64> {
        (!self.truth.is_nan()).then_some(self.truth)
    }

    /// Checks that it can be summed over `count` points of a request, from `start` on.
    ///
    /// # Errors
    /// [`Error::Arguments`] for points of other dimensions, or that the request lacks.
    pub fn check(&self, request: &Request, start: u64, count: u64) -> Result<()> {
        let given = request.columns.len();
        if self.dimensions() as usize != given {
            return Err(Error::Arguments {
                asked: format!("{} over {given} dimensions", self.integrand.name),
                limit: format!("it has {}", self.dimensions()),
                remedy: "ask for points of as many".into(),
            });
        }
        if start
            .checked_add(count)
            .is_none_or(|end| end > request.count)
        {
            return Err(Error::Arguments {
                asked: format!("an estimate over {count} points from {start} on"),
                limit: format!("the request has {}", request.count),
                remedy: "ask for fewer".into(),
            });
        }
        Ok(())
    }

    /// What kernels take.
    #[must_use]
    pub fn coefficients(&self) -> &Coefficients {
        &self.coefficients
    }

    /// The words of the kernels' table: the head, then each dimension.
    #[must_use]
    pub fn words(&self) -> Vec<u32> {
        let mut words = self.coefficients.head.to_vec();
        words.extend(self.coefficients.columns.iter().flatten());
        // Kernels may read a column where there is none to heed.
        let least = 4 + 4 * self.dimensions() as usize;
        words.resize(words.len().max(least), 0);
        words
    }
}

/// The number that a text gives a parameter: the place of a word, where it has words.
fn number(integrand: &Integrand, key: &str, text: &str) -> Option<f64> {
    match words(integrand, key) {
        [] => text.parse().ok(),
        words => Some(words.iter().position(|word| *word == text)? as f64),
    }
}

fn words(integrand: &Integrand, key: &str) -> &'static [&'static str] {
    let parameter = integrand.parameters.iter().find(|one| one.name == key);
    parameter.map_or(&[], |one| one.words())
}

/// The error for a part of a text that gives no parameter a value.
fn unreadable(integrand: &Integrand, text: &str, part: &str) -> Error {
    let name = integrand.name;
    if let Some((key, value)) = part.split_once('=') {
        let words = words(integrand, key);
        if !words.is_empty() {
            let domain = format!("it must be one of {}", words.join(", "));
            return refused(integrand, key, value, &domain);
        }
    }
    Error::Arguments {
        asked: format!("integrand {text}"),
        limit: format!("`{part}` is no key=number"),
        remedy: format!("write it as {name}:d=2; `corput integrands {name}` has its keys"),
    }
}

fn refused(integrand: &Integrand, name: &str, value: &str, domain: &str) -> Error {
    Error::Arguments {
        asked: format!("integrand {}: {name} is {value}", integrand.name),
        limit: domain.to_owned(),
        remedy: format!("`corput integrands {}` has its parameters", integrand.name),
    }
}
