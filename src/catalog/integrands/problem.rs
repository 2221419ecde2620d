//! An integrand with its parameters and dimensions.

use super::{Coefficients, Integrand};
use crate::catalog::Request;
use crate::{Error, Result};

/// An integrand and what it is to be evaluated with, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    integrand: &'static Integrand,
    dimensions: u32,
    values: Vec<f64>,
    coefficients: Coefficients,
}

impl Problem {
    /// An integrand with values for its parameters by name, and `d` for its dimensions; the
    /// others have their defaults.
    ///
    /// # Errors
    /// [`Error::UnknownName`] for a parameter that it does not have, [`Error::Arguments`] for
    /// one given twice or outside its domain.
    pub fn new(integrand: &'static Integrand, given: &[(&str, f64)]) -> Result<Self> {
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
        Self::with_values(integrand, &values, dimensions as u32)
    }

    /// An integrand with all the numbers of its parameters, in their order.
    ///
    /// # Errors
    /// [`Error::Arguments`] for one outside its domain, for too few or many numbers, and for
    /// dimensions that it does not have.
    pub fn with_values(
        integrand: &'static Integrand,
        values: &[f64],
        dimensions: u32,
    ) -> Result<Self> {
        let (least, most) = integrand.dimensions;
        let wanted = integrand.parameters.len();
        if values.len() != wanted || !(least..=most).contains(&dimensions) {
            let was = format!("{} parameters, {dimensions} dimensions", values.len());
            let domain = format!("it takes {wanted}, and {least} to {most} dimensions");
            return Err(refused(integrand, "all", &was, &domain));
        }
        let made = (integrand.prepare)(values, dimensions);
        let coefficients = made.map_err(|index| {
            let value = values.get(index).copied().unwrap_or(f64::NAN);
            let parameter = integrand.parameters.get(index);
            let (name, domain) = parameter.map_or(("all", ""), |one| (one.name, one.domain));
            refused(integrand, name, &value.to_string(), domain)
        })?;
        Ok(Self {
            integrand,
            dimensions,
            values: values.to_vec(),
            coefficients,
        })
    }

    /// From `NAME` or `NAME:key=value,key=value`, as the command line has it.
    ///
    /// # Errors
    /// Those of [`Self::new`], and [`Error::Arguments`] for what is not of that form.
    pub fn parse(text: &str) -> Result<Self> {
        let (name, rest) = text.split_once(':').unwrap_or((text, ""));
        let integrand = Integrand::from_name(name)?;
        let mut given = Vec::new();
        for part in rest.split(',').filter(|part| !part.is_empty()) {
            let pair = part.split_once('=');
            let number = pair.and_then(|(key, value)| Some((key, value.parse::<f64>().ok()?)));
            given.push(number.ok_or_else(|| Error::Arguments {
                asked: format!("integrand {text}"),
                limit: format!("`{part}` is no key=number"),
                remedy: format!("write it as {name}:d=2; `corput integrands {name}` has its keys"),
            })?);
        }
        Self::new(integrand, &given)
    }

    /// The integrand.
    #[must_use]
    pub fn integrand(&self) -> &'static Integrand {
        self.integrand
    }

    /// Its dimensions.
    #[must_use]
    pub fn dimensions(&self) -> u32 {
        self.dimensions
    }

    /// The numbers of its parameters, in their order.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Its integral over the unit cube.
    #[must_use]
    pub fn truth(&self) -> f64 {
        (self.integrand.truth)(&self.values, self.dimensions)
    }

    /// Checks that it can be summed over `count` points of a request, from `start` on.
    ///
    /// # Errors
    /// [`Error::Arguments`] for points of other dimensions, or that the request lacks.
    pub fn check(&self, request: &Request, start: u64, count: u64) -> Result<()> {
        let given = request.columns.len();
        if self.dimensions as usize != given {
            return Err(Error::Arguments {
                asked: format!("{} over {given} dimensions", self.integrand.name),
                limit: format!("it has {}", self.dimensions),
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

    /// SHIM
    #[must_use]
    pub fn estimator(&self) -> Option<&'static str> {
        None
    }

    /// SHIM
    ///
    /// # Errors
    /// SHIM
    pub fn with_estimator(&self, name: &str) -> Result<Self> {
        Err(Error::unknown_name(
            "estimator",
            name,
            self.integrand.estimators,
        ))
    }

    /// SHIM
    #[must_use]
    pub fn tables(&self) -> Vec<&[u32]> {
        Vec::new()
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
        words.resize(4 + 4 * self.dimensions as usize, 0);
        words
    }
}

fn refused(integrand: &Integrand, name: &str, value: &str, domain: &str) -> Error {
    Error::Arguments {
        asked: format!("integrand {}: {name} is {value}", integrand.name),
        limit: domain.to_owned(),
        remedy: format!("`corput integrands {}` has its parameters", integrand.name),
    }
}
