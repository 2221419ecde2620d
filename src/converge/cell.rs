//! A cell of a study: one sampler on one integrand, at every count.

use super::study::{Row, Study};
use crate::bulk;
use crate::catalog::{Problem, Request, Sampler};
use crate::estimate::Estimate;
use crate::kernels::Estimator;
use crate::vulkan::{Device, DeviceKind, Timing};
use crate::{Error, Result};
use std::sync::Arc;
use std::time::Instant;

/// Dispatches that time a sampler which is not random: their points are all the same.
pub(super) const REPEATS: u32 = 9;

/// Counts up to here are summed on the CPU too, once each, and compared.
pub(super) const CHECKED: u64 = 1 << 12;

/// What one sampler gave.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Milliseconds until the first dispatch could be made: buffers and compilation.
    pub setup_ms: f64,
    /// Milliseconds of that dispatch, which compiles too where a driver does so late; it is
    /// not among the times below.
    pub first_ms: f64,
    /// One for each count that the sampler has, rising.
    pub points: Vec<Point>,
    /// Counts that it does not have, with its words.
    pub refused: Vec<(u64, String)>,
    /// What may disappoint although it is right: a sentence each.
    pub warnings: Vec<String>,
}

/// What it gave at one count.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Points of a replicate.
    pub count: u64,
    /// The mean of each replicate: one alone of a sampler that is not random.
    pub means: Vec<f64>,
    /// The sample variance of the terms of each; NaN of one term.
    pub variances: Vec<f64>,
    /// Nanoseconds on the device of each dispatch that summed one replicate, warm; on the
    /// CPU, of each sum.
    pub device_ns: Vec<f64>,
    /// The same with the host's work around it, of which each replicate has an equal part.
    pub host_ns: Vec<f64>,
}

impl Cell {
    /// The warnings, of which those that differ in the number of points alone are one.
    #[must_use]
    pub fn notices(&self) -> Vec<String> {
        let mut found: Vec<(Option<[u64; 2]>, &str)> = Vec::new();
        for warning in &self.warnings {
            let begin = warning.split_once(' ');
            let count = begin.and_then(|(count, rest)| Some((count.parse::<u64>().ok()?, rest)));
            let (count, rest) = match count {
                Some((count, rest)) => (Some([count; 2]), rest),
                None => (None, warning.as_str()),
            };
            let same = found.iter_mut().find(|(_, text)| *text == rest);
            match (same, count) {
                (Some((Some([_, last]), _)), Some([_, more])) => *last = more.max(*last),
                (Some(_), None) => {}
                _ => found.push((count, rest)),
            }
        }
        let text = |(count, rest): (Option<[u64; 2]>, &str)| match count {
            None => rest.to_owned(),
            Some([one, other]) if one == other => format!("{one} {rest}"),
            Some([first, last]) => format!("{first} to {last} {rest}"),
        };
        found.into_iter().map(text).collect()
    }

    /// Whether it can be a study's cell of this sampler: one that was kept in a file may be anything.
    #[must_use]
    pub fn fits(&self, study: &Study, sampler: Sampler) -> bool {
        let replicates = match sampler.is_random() {
            true => study.replicates(),
            false => 1,
        };
        let times = |times: &[f64]| {
            !times.is_empty() && times.iter().all(|time| time.is_finite() && *time >= 0.0)
        };
        let sound = |point: &Point| {
            let [means, variances] = [&point.means, &point.variances].map(Vec::len);
            means == replicates as usize
                && variances == means
                && times(&point.device_ns)
                && times(&point.host_ns)
        };
        let refused = self.refused.iter().map(|(count, _)| *count);
        let mut counts: Vec<u64> = self.points.iter().map(|point| point.count).collect();
        let rising = counts.is_sorted();
        counts.extend(refused);
        counts.sort_unstable();
        rising && counts == study.counts() && self.points.iter().all(sound)
    }
}

/// Who sums: a device, or the reference on the CPU.
pub enum Engine {
    /// The device.
    Device(Arc<Device>),
    /// Every core of the CPU.
    Cpu,
}

impl Engine {
    /// Measures a sampler on an integrand; `watch` is asked between dispatches whether to go
    /// on.
    ///
    /// # Errors
    /// Those of the device, those of `watch`, and [`Error::Unequal`] where its sums are not
    /// the CPU's.
    pub fn measure(
        &self,
        study: &Study,
        row: &Row,
        sampler: Sampler,
        watch: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Cell> {
        let dimensions = row.problem.dimensions();
        let mut cell = Cell {
            setup_ms: 0.0,
            first_ms: 0.0,
            points: Vec::new(),
            refused: Vec::new(),
            warnings: Vec::new(),
        };
        let mut summer = None;
        for &count in study.counts() {
            let request = |replicate: u32| {
                sampler.request(
                    dimensions,
                    count,
                    study.seed().wrapping_add(replicate.into()),
                )
            };
            let first = match request(0) {
                Ok(first) => first,
                Err(refusal) => {
                    cell.refused.push((count, refusal.to_string()));
                    continue;
                }
            };
            for warning in first.warnings.iter().cloned().chain(sampler.lost_at(count)) {
                if !cell.warnings.contains(&warning) {
                    cell.warnings.push(warning);
                }
            }
            let summer = match &mut summer {
                Some(summer) => summer,
                none => {
                    let begun = Instant::now();
                    let mut made = self.summer(&row.problem, &first)?;
                    cell.setup_ms = begun.elapsed().as_secs_f64() * 1e3;
                    let begun = Instant::now();
                    made.sum(&row.problem, std::slice::from_ref(&first), watch)?;
                    cell.first_ms = begun.elapsed().as_secs_f64() * 1e3;
                    none.insert(made)
                }
            };
            let what = || format!("{}, {count} points of {}", row.name, sampler.name());
            let dispatches = match sampler.is_random() {
                true => study.replicates(),
                false => REPEATS.min(study.replicates()),
            };
            let requests = (0..dispatches).map(request).collect::<Result<Vec<_>>>()?;
            let mut sums = Vec::new();
            let mut point = Point {
                count,
                means: Vec::new(),
                variances: Vec::new(),
                device_ns: Vec::new(),
                host_ns: Vec::new(),
            };
            for (sum, timing) in summer.sum(&row.problem, &requests, watch)? {
                point.host_ns.push(timing.host_ns);
                let device_ns = timing.device_ns.unwrap_or(timing.host_ns);
                point.device_ns.push(device_ns);
                sums.push(sum);
            }
            if let (Some(request), Some(sum), true) =
                (requests.first(), sums.first(), count <= CHECKED)
            {
                self.verify(&row.problem, request, sum, &what)?;
            }
            if !sampler.is_random() {
                repeated(&sums, &what)?;
                sums.truncate(1);
            }
            point.means = sums
                .iter()
                .map(|sum| sum.mean().unwrap_or(f64::NAN))
                .collect();
            point.variances = sums
                .iter()
                .map(|sum| sum.variance().unwrap_or(f64::NAN))
                .collect();
            cell.points.push(point);
        }
        Ok(cell)
    }

    /// What a cell's numbers depend on besides the study: the version of corput, and the kernel
    /// that the cell runs. The CPU's reference has the bits of the kernels, and the tests demand
    /// it, so that it changes with that one.
    ///
    /// Nothing of a sampler that has none of the counts.
    ///
    /// # Errors
    /// None, if the stock kernels are as built.
    pub fn program(&self, study: &Study, row: &Row, sampler: Sampler) -> Result<String> {
        let cpu = match self {
            Self::Device(device) => device.info().kind == DeviceKind::Cpu,
            Self::Cpu => true,
        };
        program(study, row, sampler, cpu)
    }

    fn summer(&self, problem: &Problem, request: &Request) -> Result<Summer> {
        match self {
            Self::Device(device) => {
                let estimator = Estimator::new(device, problem, request)?;
                Ok(Summer::Device(Box::new(estimator)))
            }
            Self::Cpu => Ok(Summer::Cpu),
        }
    }

    /// Times are worth nothing of sums that are wrong.
    fn verify(
        &self,
        problem: &Problem,
        request: &Request,
        sum: &Estimate,
        what: &dyn Fn() -> String,
    ) -> Result<()> {
        if matches!(self, Self::Device(_)) {
            equal(
                sum,
                &bulk::estimate(problem, request, 0, request.count)?,
                what,
            )?;
        }
        Ok(())
    }
}

/// The same of any device of a CPU, or of any other.
pub(super) fn program(study: &Study, row: &Row, sampler: Sampler, cpu: bool) -> Result<String> {
    let dimensions = row.problem.dimensions();
    let mut counts = study.counts().iter();
    let first = counts.find_map(|&count| sampler.request(dimensions, count, study.seed()).ok());
    let Some(first) = first else {
        return Ok(String::new());
    };
    let kernel = Estimator::fingerprint(&row.problem, &first, cpu)?;
    Ok(format!("{} {kernel}", env!("CARGO_PKG_VERSION")))
}

/// An engine that knows the integrand and the shape of the points.
enum Summer {
    Device(Box<Estimator>),
    Cpu,
}

impl Summer {
    /// All points of each request.
    fn sum(
        &mut self,
        problem: &Problem,
        requests: &[Request],
        watch: &mut dyn FnMut() -> Result<()>,
    ) -> Result<Vec<(Estimate, Timing)>> {
        match self {
            Self::Device(estimator) => estimator.run_each(requests, &mut |_| watch()),
            Self::Cpu => requests
                .iter()
                .map(|request| {
                    watch()?;
                    let begun = Instant::now();
                    let sum = bulk::estimate(problem, request, 0, request.count)?;
                    let timing = Timing {
                        device_ns: None,
                        host_ns: begun.elapsed().as_secs_f64() * 1e9,
                    };
                    Ok((sum, timing))
                })
                .collect(),
        }
    }
}

/// The same points must give the same sums.
fn repeated(sums: &[Estimate], what: &dyn Fn() -> String) -> Result<()> {
    sums.windows(2).try_for_each(|pair| match pair {
        [one, other] => equal(other, one, what),
        _ => Ok(()),
    })
}

fn equal(got: &Estimate, expected: &Estimate, what: &dyn Fn() -> String) -> Result<()> {
    match got == expected {
        true => Ok(()),
        false => Err(Error::Unequal { what: what() }),
    }
}

#[cfg(test)]
mod tests {
    use super::Cell;

    #[test]
    fn warnings_of_many_counts_are_one() {
        let warnings = [
            "16 points are few",
            "seed 3",
            "32 points are few",
            "64 points lie",
            "seed 3",
        ];
        let cell = Cell {
            setup_ms: 0.0,
            first_ms: 0.0,
            points: Vec::new(),
            refused: Vec::new(),
            warnings: warnings.map(str::to_owned).to_vec(),
        };
        assert_eq!(
            cell.notices(),
            ["16 to 32 points are few", "seed 3", "64 points lie"]
        );
    }
}
