//! Exact sums of an integrand over points that never leave the device.

mod batch;

use super::points::{BUFFER_BYTES, add, table};
use super::records::{BUSY, BUSY_CPU, FIRST, RECORD, next_chunk, read};
use super::{fingerprint, groups, pipeline, spirv};
use crate::catalog::{Problem, Request};
use crate::estimate::Estimate;
use crate::interface::{Binding, EstimatePush, Kernel};
use crate::variant::{Plan, general_estimate, longest_estimate, plan_estimate, replan_estimate};
use crate::vulkan::{Access, Buffer, Device, DeviceKind, Pipeline, Timing};
use crate::{Error, Result};
use std::sync::Arc;

/// A number of points that an invocation of a CPU sums at about the price of fewer.
const CHEAP: u64 = 16;

/// Estimates an integral over the points of a request, and then over those of others that
/// differ in seed, first point or number of points: [`Self::set_request`].
pub struct Estimator {
    problem: Problem,
    plan: Plan,
    pipeline: Pipeline,
    results: Buffer,
    columns: Option<Buffer>,
    batch: Vec<batch::Slot>,
    coefficients: Buffer,
    tables: Option<Buffer>,
    first: u64,
    count: u64,
    longest: u32,
    limit: u64,
    chunk: u64,
    /// Nanoseconds of a point in the last dispatch.
    pace: f64,
    /// Whether the device has a clock, which has not failed yet.
    clock: bool,
    device: Arc<Device>,
}

impl Estimator {
    /// Compiles the pipeline, which takes a tenth of a second to one on llvmpipe. The
    /// request's map and output do not matter: the integrand takes its fractions.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a request of other dimensions than the integrand's, and those
    /// of the device.
    pub fn new(device: &Arc<Device>, problem: &Problem, request: &Request) -> Result<Self> {
        let (id, cpu) = (problem.id(), device.info().kind == DeviceKind::Cpu);
        let plan = plan_estimate(&request.columns, id, cpu);
        let words = spirv(plan.kernel.name)?;
        Self::with_module(device, problem, request, plan, &words)
    }

    /// The [`fingerprint`] of the kernel that [`Self::new`] would run; `cpu` is whether its
    /// device is a CPU. Takes milliseconds, and no device.
    ///
    /// # Errors
    /// [`Error::UnknownName`] for a kernel that this build lacks.
    pub fn fingerprint(problem: &Problem, request: &Request, cpu: bool) -> Result<String> {
        let plan = plan_estimate(&request.columns, problem.id(), cpu);
        let values = plan.specializations.first().map_or(&[][..], Vec::as_slice);
        Ok(fingerprint(&spirv(plan.kernel.name)?, values))
    }

    /// The same with the general kernel, which every other must equal.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn general(device: &Arc<Device>, problem: &Problem, request: &Request) -> Result<Self> {
        let plan = general_estimate(&request.columns, problem.id());
        let words = spirv(plan.kernel.name)?;
        Self::with_module(device, problem, request, plan, &words)
    }

    /// The same with other SPIR-V of the plan's interface: how tests run broken kernels.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn with_module(
        device: &Arc<Device>,
        problem: &Problem,
        request: &Request,
        plan: Plan,
        words: &[u32],
    ) -> Result<Self> {
        problem.check(request, 0, request.count)?;
        let longest = longest_estimate(&request.columns, problem.id());
        if longest == 0 {
            return Err(too_wide(request));
        }
        let values = plan.specializations.first().map_or(&[][..], Vec::as_slice);
        let pipeline = pipeline(device, plan.kernel, words, values)?;
        Ok(Self {
            pipeline,
            results: Buffer::new(device, RECORD, Access::Readback)?,
            columns: plan
                .table
                .as_deref()
                .map(|words| block(device, plan.kernel, 1, words))
                .transpose()?,
            batch: Vec::new(),
            coefficients: block(device, plan.kernel, 2, &problem.words())?,
            tables: bulk_words(device, problem)?,
            first: request.first,
            count: request.count,
            longest,
            limit: BUFFER_BYTES / 4 / RECORD,
            chunk: FIRST,
            pace: f64::INFINITY,
            clock: device.info().limits.timestamp_valid_bits > 0,
            problem: problem.clone(),
            plan,
            device: Arc::clone(device),
        })
    }

    /// Takes another request of the same shape, without compiling anything: another seed,
    /// first point or number of points, of the same sequence, dimensions, bases and scramble.
    /// What is summed next is over its points. Costs a write of 10 KiB.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a request of another shape, which leaves everything as it was,
    /// and those of the device.
    pub fn set_request(&mut self, request: &Request) -> Result<()> {
        let plan = self.replan(request)?;
        if let (Some(columns), Some(words)) = (&mut self.columns, &plan.table) {
            columns.write(0, bytemuck::cast_slice(words))?;
        }
        self.plan = plan;
        self.longest = longest_estimate(&request.columns, self.problem.id());
        (self.first, self.count) = (request.first, request.count);
        Ok(())
    }

    /// The plan of another request of the same shape.
    fn replan(&self, request: &Request) -> Result<Plan> {
        self.problem.check(request, 0, request.count)?;
        let plan = replan_estimate(&self.plan, &request.columns, self.problem.id());
        plan.ok_or_else(|| Error::Arguments {
            asked: format!("an estimate of {} by an estimator", request.sequence.name()),
            limit: "it was compiled for points of another shape".into(),
            remedy: "keep to its sequence, scramble, dimensions and bases, or make another".into(),
        })
    }

    /// Takes other parameters of the same integrand, by the same of its estimators and in as many
    /// dimensions, without compiling anything. The request stays.
    ///
    /// # Errors
    /// [`Error::Arguments`] for what is not of that kind, which leaves everything as it was, and
    /// those of the device.
    pub fn set_problem(&mut self, problem: &Problem) -> Result<()> {
        let of = |one: &Problem| (one.id(), one.dimensions());
        if of(problem) != of(&self.problem) {
            return Err(Error::Arguments {
                asked: format!("{} by an estimator", problem.integrand().name),
                limit: format!("it was compiled for {}", self.problem.integrand().name),
                remedy: "keep to its integrand, estimator and dimensions, or make another".into(),
            });
        }
        let tables = bulk_words(&self.device, problem)?;
        self.coefficients
            .write(0, bytemuck::cast_slice(&problem.words()))?;
        self.tables = tables;
        self.problem = problem.clone();
        Ok(())
    }

    /// The kernel that runs.
    #[must_use]
    pub fn kernel_name(&self) -> &'static str {
        self.plan.kernel.name
    }

    /// Points that an invocation may sum.
    #[must_use]
    pub fn longest_run(&self) -> u32 {
        self.longest
    }

    /// The sums of one dispatch, a record for each run of `run` points; the last may be
    /// shorter. `start` counts from the request's first.
    ///
    /// # Errors
    /// [`Error::Arguments`] for more points than the request has or a dispatch can sum, and
    /// those of the device.
    pub fn records(&mut self, start: u64, count: u64, run: u32) -> Result<(Vec<Estimate>, Timing)> {
        let invocations = count.div_ceil(run.max(1).into());
        let fits = start
            .checked_add(count)
            .is_some_and(|end| end <= self.count);
        if !fits || run == 0 || run > self.longest || invocations > self.limit {
            return Err(Error::Arguments {
                asked: format!("sums of {count} points from {start} on, {run} an invocation"),
                limit: format!(
                    "there are {}, of which one sums 1 to {}, and a dispatch at most {}",
                    self.count, self.longest, self.limit
                ),
                remedy: "ask for several shorter sums, and merge them".into(),
            });
        }
        let push = self.push(self.first + start, count, run);
        self.reserve(invocations)?;
        let buffers = self.buffers(&self.results, self.columns.as_ref());
        let groups = groups(self.plan.kernel, invocations as u32);
        let timing = self
            .device
            .run(&self.pipeline, &buffers, &push.bytes(), groups)?;
        let records = read(&mut self.results, invocations, push.scale as i32)?;
        Ok((records, timing))
    }

    /// All fit: first + count <= 2^32, and a dispatch has fewer points.
    fn push(&self, first: u64, count: u64, run: u32) -> EstimatePush {
        EstimatePush {
            first: first as u32,
            count: count as u32,
            run,
            invocations: count.div_ceil(run.into()) as u32,
            scale: self.problem.coefficients().scale as u32,
        }
    }

    fn buffers<'a>(
        &'a self,
        results: &'a Buffer,
        columns: Option<&'a Buffer>,
    ) -> Vec<(u32, &'a Buffer)> {
        let mut buffers = vec![(0, results), (2, &self.coefficients)];
        buffers.extend(columns.map(|columns| (1, columns)));
        buffers.extend(self.tables.as_ref().map(|tables| (3, tables)));
        buffers
    }

    /// The sums over `count` points of the request from `start` on, by as many dispatches as
    /// keep each short; `watch` hears of the points done, and may stop.
    ///
    /// # Errors
    /// Those of [`Self::records`], and those of `watch`.
    pub fn run(
        &mut self,
        start: u64,
        count: u64,
        watch: &mut dyn FnMut(u64) -> Result<()>,
    ) -> Result<(Estimate, Timing)> {
        let mut total = Estimate::new(self.problem.coefficients().scale);
        let mut spent = Timing {
            device_ns: Some(0.0),
            host_ns: 0.0,
        };
        let mut done = 0;
        while done < count {
            let points = (count - done).min(self.chunk);
            let run = self.run_of(points, self.longest);
            let (records, timing) = self.records(start + done, points, run)?;
            for record in records {
                total = total.merged(record)?;
            }
            done += points;
            self.adapt(points, &timing);
            add(&mut spent, timing);
            watch(done)?;
        }
        Ok((total, spent))
    }

    /// Room for so many records.
    fn reserve(&mut self, records: u64) -> Result<()> {
        let bytes = RECORD * records;
        if self.results.bytes() < bytes {
            let most = RECORD * self.limit;
            let bytes = bytes.next_power_of_two().min(most.max(bytes));
            self.results = Buffer::new(&self.device, bytes, Access::Readback)?;
        }
        Ok(())
    }

    /// How long the runs of so many points are: on a CPU long, since each has its cost, once
    /// all cores have work; on a GPU so short that all of it has work. Of the general kernel
    /// whole tiles.
    fn run_of(&self, points: u64, longest: u32) -> u32 {
        let (busy, cheap) = match self.device.info().kind {
            DeviceKind::Cpu => (BUSY_CPU, CHEAP),
            _ => (BUSY, 1),
        };
        let shared = u64::from(self.plan.tile.clamp(1, 8));
        let wanted = points.div_ceil(busy).max(points.div_ceil(self.limit));
        let longest = u64::from(longest) / shared * shared;
        wanted.max(cheap).next_multiple_of(shared).min(longest) as u32
    }

    fn adapt(&mut self, points: u64, timing: &Timing) {
        let most = (self.limit * u64::from(self.longest)).min(u64::from(u32::MAX >> 1));
        self.chunk = next_chunk(points, timing, most);
        self.pace = timing.device_ns.unwrap_or(timing.host_ns).max(1.0) / points.max(1) as f64;
    }
}

/// The error for more columns of a kind than a point may take.
fn too_wide(request: &Request) -> Error {
    Error::Arguments {
        asked: format!(
            "an estimate over {} dimensions of {}",
            request.columns.len(),
            request.sequence.name()
        ),
        limit: "a point may take more than the 65535 iterations that some drivers allow".into(),
        remedy: "take fewer dimensions, a plainer scramble such as owen-hash, or --device cpu"
            .into(),
    }
}

/// What a problem tells its kernel in bulk.
fn bulk_words(device: &Arc<Device>, problem: &Problem) -> Result<Option<Buffer>> {
    match problem.tables() {
        [] => Ok(None),
        words => table(device, words).map(Some),
    }
}

/// A uniform block of a kernel, with these words first.
fn block(device: &Arc<Device>, kernel: &Kernel, binding: u32, words: &[u32]) -> Result<Buffer> {
    let found = kernel.bindings.iter().find(|b| b.binding == binding);
    let bytes = found.and_then(Binding::uniform).unwrap_or(0);
    let mut words = words.to_vec();
    words.resize(words.len().max(bytes as usize / 4), 0);
    table(device, &words)
}
