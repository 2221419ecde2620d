//! The measures by name.

use corput::stats::{L2, L2_KINDS};
use corput::{Error, Result};

/// What can be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    Star,
    L2(L2),
    TValue,
    Intervals,
    Distance,
    Projections,
    Spectrum,
}

impl Measure {
    /// Its key in JSON.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Star => "star",
            Self::L2(kind) => kind.name(),
            Self::TValue => "t_value",
            Self::Intervals => "intervals",
            Self::Distance => "distance",
            Self::Projections => "projections",
            Self::Spectrum => "spectrum",
        }
    }

    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::L2(L2::Star) => "l2-star",
            Self::L2(L2::WrapAround) => "wrap-around",
            Self::L2(L2::Modified) => "modified-l2",
            Self::TValue => "t-value",
            other => other.key(),
        }
    }
}

fn every() -> Vec<Measure> {
    let mut every = vec![Measure::Star];
    every.extend(L2_KINDS.map(Measure::L2));
    every.extend([
        Measure::TValue,
        Measure::Intervals,
        Measure::Distance,
        Measure::Projections,
        Measure::Spectrum,
    ]);
    every
}

/// Those that are asked for, in the usual order; all of them by default.
pub fn chosen(only: Option<&[String]>) -> Result<Vec<Measure>> {
    let mut every = every();
    let Some(asked) = only else {
        return Ok(every);
    };
    let known: Vec<&str> = every.iter().map(|measure| measure.name()).collect();
    for name in asked {
        if !known.contains(&name.as_str()) {
            return Err(Error::unknown_name("measure", name, &known));
        }
    }
    every.retain(|measure| asked.iter().any(|name| name == measure.name()));
    Ok(every)
}
