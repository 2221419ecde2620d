//! An extreme input: its truth, what the common formula makes of it, and what this crate does.

use super::words::{double, estimate_of, estimate_words, float_sum_words};
use crate::bulk::{estimate, map_sample, reduce};
use crate::catalog::{Mapping, Problem, Profile, Request};
use crate::check::function_words;
use std::sync::Arc;

/// One unit in the last place of a float just above 1.
pub(super) const ULP: f64 = 1.0 / 8_388_608.0;

/// How a truth was obtained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A closed form, in `f64`.
    ClosedForm,
    /// 25 digits of a table that mpmath made.
    Multiprecision,
    /// Integers, which are exact.
    Integers,
    /// The definition in `f64`, term by term.
    Judge,
}

impl Source {
    /// As documents have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form in f64",
            Self::Multiprecision => "mpmath, 25 digits",
            Self::Integers => "integers",
            Self::Judge => "definition in f64",
        }
    }
}

/// What a result should be.
#[derive(Clone, Debug, PartialEq)]
pub struct Truth {
    /// The values, of words of a result that follow each other; of a case on the host, 0: its
    /// figures are errors already.
    pub values: Vec<f64>,
    /// Where they are from.
    pub source: Source,
}

/// What of a result is judged, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// The first word of those that the truth is about.
    pub first: usize,
    /// What their error is.
    pub measure: Measure,
}

/// What an error is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// Of floats, the largest relative to its truth; where that is 0, the result itself.
    Relative,
    /// Of floats, the distance.
    Distance,
    /// Of x, y, z and a pdf: the distance of x and y in this unit, that of z, or that of the
    /// pdf relative to itself, the largest.
    Scattered {
        /// The unit.
        scale: f64,
    },
    /// Of fractions of 2^32, as [`Measure::Relative`].
    Fraction,
    /// Of floats whose reciprocals the truth has, as [`Measure::Relative`].
    Reciprocal,
    /// Of a double in two words, as [`Measure::Relative`].
    Double,
    /// Of the mean of an exact sum of so many terms in units of 2^-scale, as
    /// [`Measure::Relative`].
    Mean {
        /// Terms.
        count: u64,
        /// Their unit.
        scale: i32,
    },
    /// Of the variance of the same, as [`Measure::Relative`].
    Variance {
        /// Terms.
        count: u64,
        /// Their unit.
        scale: i32,
    },
}

impl Measure {
    /// The error of these results; infinite for what is no number.
    #[must_use]
    pub fn error(self, got: &[f64], truth: &[f64]) -> f64 {
        let pairs = || got.iter().zip(truth);
        let error = match self {
            Self::Relative
            | Self::Fraction
            | Self::Reciprocal
            | Self::Double
            | Self::Mean { .. }
            | Self::Variance { .. } => largest(pairs()),
            Self::Distance => pairs().map(|(g, t)| (g - t).powi(2)).sum::<f64>().sqrt(),
            Self::Scattered { scale } => match (got, truth) {
                (&[x, y, z, ref pdf @ ..], &[a, b, c, ref density @ ..]) => [
                    (x - a).hypot(y - b) / scale,
                    (z - c).abs(),
                    largest(pdf.iter().zip(density)),
                ]
                .into_iter()
                .fold(0.0, worse),
                _ => f64::NAN,
            },
        };
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// So many numbers of a result from its word `first` on; `None` if it has too few words.
    fn numbers(self, words: &[u32], first: usize, count: usize) -> Option<Vec<f64>> {
        match self {
            Self::Double => Some(vec![double(words.get(first..first + 2)?)]),
            Self::Mean { count, scale } => estimate_of(words, count, scale)?
                .mean()
                .map(|mean| vec![mean]),
            Self::Variance { count, scale } => {
                let variance = estimate_of(words, count, scale)?.variance();
                variance.map(|variance| vec![variance])
            }
            _ => {
                let words = words.get(first..first + count)?;
                Some(words.iter().map(|&word| self.number(word)).collect())
            }
        }
    }

    /// A word of a result as a number.
    fn number(self, word: u32) -> f64 {
        match self {
            Self::Fraction => f64::from(word) / 4_294_967_296.0,
            Self::Reciprocal => 1.0 / f64::from(f32::from_bits(word)),
            _ => f32::from_bits(word).into(),
        }
    }
}

/// The larger, or the NaN.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

fn largest<'a>(pairs: impl Iterator<Item = (&'a f64, &'a f64)>) -> f64 {
    pairs
        .map(|(g, t)| (g - t).abs() / if *t == 0.0 { 1.0 } else { t.abs() })
        .fold(0.0, worse)
}

/// What a device can be asked for.
#[derive(Clone, Debug)]
pub enum Subject {
    /// Nothing: code of the host, a table, or a function that no kernel gives alone.
    Host,
    /// A call of a function of the catalogue.
    Function {
        /// Its name there.
        name: &'static str,
        /// The arguments, as its kernel takes them.
        call: [u32; 4],
    },
    /// A sample of a map.
    Map {
        /// The map with its parameters.
        mapping: Box<Mapping>,
        /// The fractions.
        u: [u32; 2],
    },
    /// The exact sums of an integrand and of its squares over points.
    Estimate {
        /// The integrand.
        problem: Arc<Problem>,
        /// The points.
        request: Arc<Request>,
    },
    /// The exact sum of floats.
    Sum {
        /// The terms.
        terms: Arc<[f32]>,
        /// Invocations of a group.
        group: u32,
    },
}

impl Subject {
    /// The words that every device must give: four of a function or a sample, twelve of the sums
    /// of an estimate, fourteen of a sum of floats, its double first; `None` of the host.
    #[must_use]
    pub fn reference(&self) -> Option<Vec<u32>> {
        match self {
            Self::Host => None,
            Self::Function { name, call } => Some(function_words(name, *call).to_vec()),
            Self::Map { mapping, u } => {
                Some(map_sample(mapping, Profile::Exact, [u[0], u[1], 0]).to_vec())
            }
            Self::Estimate { problem, request } => estimate(problem, request, 0, request.count)
                .ok()
                .map(|sums| estimate_words(&sums)),
            Self::Sum { terms, .. } => reduce(terms).ok().map(|sum| float_sum_words(&sum)),
        }
    }

    /// The first floats of the reference; zeros where it has none.
    pub(super) fn floats<const N: usize>(&self) -> [f32; N] {
        let words = self.reference().unwrap_or_default();
        std::array::from_fn(|i| words.get(i).map_or(0.0, |&word| f32::from_bits(word)))
    }

    /// As tables have it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Host => "host",
            Self::Function { name, .. } => name,
            Self::Map { mapping, .. } => mapping.map().name,
            Self::Estimate { problem, .. } => problem.integrand().name,
            Self::Sum { .. } => "reduce",
        }
    }
}

/// A case of the catalogue of extreme inputs.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its number.
    pub number: u32,
    /// The input, and what of the result is judged.
    pub input: String,
    /// The error of the common formula in float.
    pub naive: f64,
    /// The error of this crate, exact profile, on the CPU.
    pub ours: f64,
    /// What the result should be.
    pub truth: Truth,
    /// What the error may be.
    pub bound: f64,
    /// What of the result that is.
    pub reading: Reading,
    /// What a device can be asked for.
    pub subject: Subject,
}

impl Case {
    /// A case whose two errors the host has found.
    pub(super) fn host(
        number: u32,
        input: impl Into<String>,
        [naive, ours]: [f64; 2],
        source: Source,
        bound: f64,
    ) -> Self {
        let finite = |error: f64| if error.is_nan() { f64::INFINITY } else { error };
        Self {
            number,
            input: input.into(),
            naive: finite(naive),
            ours: finite(ours),
            truth: Truth {
                values: vec![0.0],
                source,
            },
            bound,
            reading: Reading {
                first: 0,
                measure: Measure::Relative,
            },
            subject: Subject::Host,
        }
    }

    /// A case of which a device can be asked: the errors are those of the common formula's
    /// results and of the reference's words.
    pub(super) fn of(
        number: u32,
        input: impl Into<String>,
        naive: &[f64],
        reading: Reading,
        truth: Truth,
        bound: f64,
        subject: Subject,
    ) -> Self {
        let mut case = Self {
            number,
            input: input.into(),
            naive: reading.measure.error(naive, &truth.values),
            ours: f64::INFINITY,
            truth,
            bound,
            reading,
            subject,
        };
        if let Some(words) = case.subject.reference() {
            case.ours = case.error(&words);
        }
        case
    }

    /// The error of a result with these words; infinite if they are too few.
    #[must_use]
    pub fn error(&self, words: &[u32]) -> f64 {
        let Reading { first, measure } = self.reading;
        let values = &self.truth.values;
        let got = measure.numbers(words, first, values.len());
        got.map_or(f64::INFINITY, |got| measure.error(&got, values))
    }
}
