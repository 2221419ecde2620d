//! Means over points on the CPU and on devices, beside what is common.

use super::case::{Case, Measure, Reading, Source, Subject, Truth};
use super::elementary::unit;
use crate::bulk::Reference;
use crate::catalog::{Engine, Options, Problem, Request, Scramble, Sequence};
use crate::{Result, judge};
use std::sync::Arc;

/// Points of a case.
#[derive(Clone, Copy)]
pub(super) struct Points {
    sequence: Sequence,
    scramble: Option<Scramble>,
    first: u64,
    count: u64,
    seed: u64,
}

impl Points {
    /// As they are, from the first on.
    pub(super) fn plain(sequence: Sequence, count: u64) -> Self {
        Self {
            sequence,
            scramble: None,
            first: 0,
            count,
            seed: 1,
        }
    }

    /// Those of Sobol, of one scramble of Owen's.
    pub(super) fn scrambled(count: u64) -> Self {
        Self {
            scramble: Some(Scramble::OwenHash),
            ..Self::plain(Sequence::Sobol, count)
        }
    }

    /// The same from another first point on.
    pub(super) fn from(self, first: u64) -> Self {
        Self { first, ..self }
    }

    /// Of another scramble.
    pub(super) fn seeded(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    pub(super) fn request(self, dimensions: u32) -> Result<Request> {
        Request::new(&Options {
            first: self.first,
            dimensions: Some(dimensions.into()),
            scramble: self.scramble,
            seed: self.scramble.map(|_| self.seed),
            fractions: true,
            ..Options::new(self.sequence, self.count)
        })
    }

    /// The mean of a function of floats, summed in floats.
    pub(super) fn float_mean(self, dimensions: u32, f: impl Fn(&[f32]) -> f32) -> Result<f64> {
        let mut words = vec![0; (self.count * u64::from(dimensions)) as usize];
        Reference::new(&self.request(dimensions)?).fill(0, &mut words)?;
        let rows = words.chunks_exact(dimensions as usize);
        let sum: f32 = rows
            .map(|row| f(&row.iter().map(|&u| unit(u)).collect::<Vec<f32>>()))
            .sum();
        Ok(f64::from(sum) / self.count as f64)
    }
}

/// A mean whose case is made.
#[derive(Clone)]
pub(super) struct Estimated {
    number: u32,
    input: String,
    naive: f64,
    problem: Arc<Problem>,
    request: Arc<Request>,
}

/// What a mean may err by for its arithmetic, relative to it.
const ARITHMETIC: f64 = 1e-6;

/// A mean over points, beside a common one.
pub(super) fn estimated(
    number: u32,
    input: impl Into<String>,
    problem: &str,
    points: Points,
    naive: f64,
) -> Result<Estimated> {
    let problem = Problem::parse(problem)?;
    let request = points.request(problem.dimensions())?;
    Ok(Estimated {
        number,
        input: input.into(),
        naive,
        problem: Arc::new(problem),
        request: Arc::new(request),
    })
}

impl Estimated {
    /// By another of the integrand's estimators.
    pub(super) fn by(self, estimator: &str) -> Result<Self> {
        let problem = Arc::new(self.problem.with_estimator(estimator)?);
        Ok(Self { problem, ..self })
    }

    fn case(self, measure: Measure, truth: f64, bound: f64) -> Case {
        let (problem, request) = (self.problem, self.request);
        Case::of(
            self.number,
            self.input,
            &[self.naive],
            Reading { first: 0, measure },
            Truth {
                values: vec![truth],
                source: Source::ClosedForm,
            },
            bound,
            Subject::Estimate { problem, request },
        )
    }

    fn sums(&self) -> (u64, i32) {
        (self.request.count, self.problem.coefficients().scale)
    }

    /// Judged by its variance.
    pub(super) fn variance(self, truth: f64, bound: f64) -> Case {
        let (count, scale) = self.sums();
        self.case(Measure::Variance { count, scale }, truth, bound)
    }

    /// Judged by the mean of these points, not of the integral.
    pub(super) fn mean_of(self, truth: f64, bound: f64) -> Case {
        let (count, scale) = self.sums();
        self.case(Measure::Mean { count, scale }, truth, bound)
    }

    /// Judged by the integral: within five standard errors of as many random points, whose
    /// standard deviation is given in units of the integral, or by itself where that is 0; and what
    /// the arithmetic may err by.
    pub(super) fn integral(self, deviation: f64) -> Case {
        let truth = self.problem.truth();
        let bound = 5.0 * deviation / (self.request.count as f64).sqrt() + ARITHMETIC;
        let input = format!("{}: the integral", self.input);
        Self { input, ..self }.mean_of(truth, bound)
    }

    /// Judged by the mean of the same terms in `f64`, as the arithmetic alone errs.
    pub(super) fn terms(self) -> Result<Case> {
        let (problem, dimensions) = (&self.problem, self.problem.dimensions() as usize);
        let mut words = vec![0; self.request.count as usize * dimensions];
        Reference::new(&self.request).fill(0, &mut words)?;
        let name = problem.integrand().name;
        let values = problem.values();
        let terms = words.chunks_exact(dimensions);
        let sum: f64 = terms.map(|u| judge::integrand(name, values, u)).sum();
        let mean = sum / self.request.count as f64;
        let input = format!("{}: these terms", self.input);
        let mut case = Self { input, ..self }.mean_of(mean, ARITHMETIC);
        case.truth.source = Source::Judge;
        Ok(case)
    }

    /// Judged by both.
    pub(super) fn both(self, deviation: f64) -> Result<[Case; 2]> {
        Ok([self.clone().integral(deviation), self.terms()?])
    }
}
