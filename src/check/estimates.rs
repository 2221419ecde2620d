//! The estimate kernels: exact sums of every integrand, over points of every family.

use super::inputs::mix;
use super::rows::{Row, words128};
use crate::Result;
use crate::bulk::{estimate, integrand_term};
use crate::catalog::{Integrand, Options, Problem, Request, Scramble, Sequence, examples};
use crate::estimate::Estimate;
use crate::interface::integrand;
use crate::judge;
use crate::kernels::{Estimator, spirv};
use crate::variant::{general_estimate, plan_estimate};
use crate::vulkan::Device;
use std::sync::Arc;

/// Points of a sum: more than one run of the longest, and no multiple of it.
const COUNT: u64 = 1_001;

/// Index of the first: within a block of 256, and near a wrap of its lower 16 bits.
const FIRST: u64 = 65_211;

/// Points that the judge sees.
const JUDGED: u32 = 512;

/// Sums that a check wants: the integrand and the points.
pub type Sums<'a> = &'a mut dyn FnMut(&Problem, &Request) -> Result<Vec<Estimate>>;

/// Compares sums of a device with the CPU's, and judges terms: of a few integrands by the
/// general kernel and by tiles of both lengths; of the others, whose kernels compile for
/// long, by tiles for few dimensions and by the general kernel for many.
pub fn check(device: &Arc<Device>, integrand: &'static Integrand) -> Result<Row> {
    let every = EVERYWHERE.contains(&integrand.id);
    // Pipelines, of which one serves all parameters and seeds.
    let mut made: Vec<(Specialized, Estimator)> = Vec::new();
    compare_estimates(integrand, &mut |problem, request| {
        let columns = &request.columns;
        let (few, id) = (columns.len() <= 4, problem.id());
        let tile = |cpu| plan_estimate(columns, id, cpu);
        let mut plans = Vec::new();
        if every || !few {
            plans.push(general_estimate(columns, id));
        }
        if few {
            plans.push(tile(true));
        }
        if every && few {
            plans.push(tile(false));
        }
        let sums = plans.into_iter().map(|plan| {
            let key = (plan.kernel.name, plan.specializations.clone());
            let estimator = match made.iter().position(|(one, _)| *one == key) {
                Some(place) => &mut made[place].1,
                None => {
                    let words = spirv(plan.kernel.name)?;
                    let new = Estimator::with_module(device, problem, request, plan, &words)?;
                    made.push((key, new));
                    let last = made.len() - 1;
                    &mut made[last].1
                }
            };
            estimator.set_problem(problem)?;
            estimator.set_request(request)?;
            Ok(estimator.run(0, request.count, &mut |_| Ok(()))?.0)
        });
        sums.collect()
    })
}

/// The name of a kernel, and the values of its constants.
type Specialized = (&'static str, Vec<Vec<(u32, u32)>>);

/// Compares sums of the caller's with the CPU's, and judges the CPU's terms.
///
/// # Errors
/// Those of `sums`.
pub fn compare_estimates(integrand: &'static Integrand, sums: Sums) -> Result<Row> {
    let mut row = Row::exact(&format!("estimate {}", integrand.name), "estimate");
    row.bound = Some(integrand.error);
    row.unit = "of the peak";
    let mut worst = 0.0;
    for (index, problem) in examples(integrand)?.iter().enumerate() {
        let every = index == 0 && EVERYWHERE.contains(&integrand.id);
        for request in requests(problem, every)? {
            let expected = estimate(problem, &request, 0, request.count)?;
            for got in sums(problem, &request)? {
                row.hash(&words128(got.sum() as u128));
                let parts = got.squares().parts();
                parts
                    .iter()
                    .for_each(|part| row.hash(&[*part as u32, (part >> 32) as u32]));
                row.count(got == expected, || {
                    format!(
                        "{} {:?}, d = {}: {} and {}, not {} and {}",
                        problem.estimator().unwrap_or(""),
                        problem.values(),
                        problem.dimensions(),
                        got.sum(),
                        got.squares(),
                        expected.sum(),
                        expected.squares()
                    )
                });
            }
        }
        worst = judged(problem).fold(worst, f64::max);
    }
    row.worst = Some(worst);
    Ok(row.judged())
}

/// Integrands of one, two and three dimensions that meet every family of columns.
const EVERYWHERE: [u32; 3] = [
    integrand::X_SQUARED,
    integrand::DISK_STEP,
    integrand::ISHIGAMI,
];

/// Points for an example.
fn requests(problem: &Problem, every: bool) -> Result<Vec<Request>> {
    let samplers = [
        (Sequence::Sobol, Some(Scramble::OwenHash), COUNT),
        (Sequence::Halton, None, COUNT),
        (Sequence::Random, None, COUNT),
        (Sequence::Halton, Some(Scramble::Permute), 101),
        (Sequence::LatinHypercube, None, 101),
        (Sequence::Lattice, None, COUNT),
    ];
    let request = |&(sequence, scramble, count): &(Sequence, Option<Scramble>, u64)| {
        Request::new(&Options {
            first: FIRST,
            dimensions: Some(problem.dimensions().into()),
            scramble,
            seed: (scramble.is_some() || sequence == Sequence::Random).then_some(7),
            fractions: true,
            ..Options::new(sequence, count)
        })
    };
    let wanted = if every { samplers.len() } else { 1 };
    samplers.iter().take(wanted).map(request).collect()
}

/// Errors of terms as shares of the peak, less half a unit: at the corners, and in between.
fn judged(problem: &Problem) -> impl Iterator<Item = f64> {
    let ends = [0, u32::MAX, 0x8000_0000, 0x7fff_ffff, 1, 0x9e37_79b9];
    let dimensions = problem.dimensions();
    (0..JUDGED).map(move |n| {
        let coordinate = |j| match (n as usize, mix(n ^ (j << 16))) {
            (n, _) if n < ends.len() => ends[n],
            (_, noise) if noise % 16 == 0 => ends[(noise >> 8) as usize % ends.len()],
            (_, noise) => noise,
        };
        let point: Vec<u32> = (0..dimensions).map(coordinate).collect();
        let term = integrand_term(problem, &point);
        let magnitude = (u64::from(term.m.x) | (u64::from(term.m.y) << 32)) as f64;
        let unit = f64::powi(2.0, -problem.coefficients().scale);
        let got = if term.negative { -magnitude } else { magnitude } * unit;
        let [least, most] = judged_range(problem, &point);
        let distance = match least.is_nan() | most.is_nan() {
            true => f64::NAN,
            false => (least - got).max(got - most).max(0.0),
        };
        let error = distance - 0.5 * unit;
        // f64 itself rounds by 2^-53 of the peak, and x^2 to it.
        let rounding = 4.0 * f64::EPSILON * problem.coefficients().peak;
        // A NaN must not pass as the smaller one.
        match error.is_nan() {
            true => f64::INFINITY,
            false => (error - rounding).max(0.0) / problem.coefficients().peak,
        }
    })
}

/// The least and greatest value at a point, by the judge: one number but where an
/// estimator's direction is near an edge. NaN for an integrand that it does not know.
#[must_use]
pub fn judged_range(problem: &Problem, point: &[u32]) -> [f64; 2] {
    let (name, values) = (problem.integrand().name, problem.values());
    let u = [0, 1, 2].map(|j| point.get(j).copied().unwrap_or(0));
    match (problem.estimator(), problem.map()) {
        (Some(estimator), Some(map)) => {
            let lit = judge::irradiance::Lit {
                tables: map.tables(),
                lights: map.luminances(),
                axis: values.first().map_or(0, |axis| *axis as usize),
            };
            lit.sample(estimator, u)
        }
        (Some("normal"), None) => judge::normal_peak(values[0], values[1], point),
        (Some(estimator), None) if problem.id() >= integrand::SKY_UNIFORM => {
            judge::scene(name, estimator, values, u)
        }
        _ => [judge::integrand(name, values, point); 2],
    }
}
