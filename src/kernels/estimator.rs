//! Exact sums of an integrand over points that never leave the device.

use super::points::{BUFFER_BYTES, add, table};
use super::{groups, pipeline, spirv};
use crate::catalog::{Problem, Request};
use crate::estimate::Estimate;
use crate::interface::EstimatePush;
use crate::variant::{Plan, general_estimate, longest_estimate, plan_estimate};
use crate::vulkan::{Access, Buffer, Device, DeviceKind, Pipeline, Timing};
use crate::{Error, Result};
use std::sync::Arc;

/// Points of the first dispatch: short on the slowest device.
const FIRST: u64 = 1 << 14;

/// A dispatch should take about this long, and is made at most so many times longer at
/// once.
const TARGET_NS: f64 = 1e8;
const GROWTH: f64 = 8.0;

/// Invocations that keep a GPU busy.
const BUSY: u64 = 1 << 16;

/// Bytes of an invocation's record.
const RECORD: u64 = 48;

/// Estimates an integral over the points of a request.
pub struct Estimator {
    plan: Plan,
    pipeline: Pipeline,
    results: Buffer,
    columns: Option<Buffer>,
    coefficients: Buffer,
    tables: Option<Buffer>,
    first: u64,
    count: u64,
    scale: i32,
    longest: u32,
    limit: u64,
    chunk: u64,
    device: Arc<Device>,
}

impl Estimator {
    /// Compiles the pipeline. The request's map and output do not matter: the integrand
    /// takes its fractions.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a request of other dimensions than the integrand's, and those
    /// of the device.
    pub fn new(device: &Arc<Device>, problem: &Problem, request: &Request) -> Result<Self> {
        let (id, cpu) = (problem.id(), device.info().kind == DeviceKind::Cpu);
        let plan = plan_estimate(&request.columns, request.count, id, cpu);
        let words = spirv(plan.kernel.name)?;
        Self::with_module(device, problem, request, plan, &words)
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
        let values = plan.specializations.first().map_or(&[][..], Vec::as_slice);
        let pipeline = pipeline(device, plan.kernel, words, values)?;
        let longest = longest_estimate(&request.columns, problem.id());
        let most = BUFFER_BYTES / 4 / RECORD;
        let bytes = RECORD * most.min(request.count);
        Ok(Self {
            pipeline,
            results: Buffer::new(device, bytes, Access::Readback)?,
            columns: plan
                .table
                .as_deref()
                .map(|words| table(device, words))
                .transpose()?,
            coefficients: table(device, &problem.words())?,
            tables: match problem.tables() {
                [] => None,
                words => Some(table(device, words)?),
            },
            first: request.first,
            count: request.count,
            scale: problem.coefficients().scale,
            longest,
            limit: most,
            chunk: FIRST,
            plan,
            device: Arc::clone(device),
        })
    }

    /// SHIM
    ///
    /// # Errors
    /// SHIM
    pub fn replicates(device: &Arc<Device>, problem: &Problem, request: &Request) -> Result<Self> {
        Self::general(device, problem, request)
    }

    /// SHIM
    ///
    /// # Errors
    /// SHIM
    pub fn set_request(&mut self, request: &Request) -> Result<()> {
        let words: Vec<u32> = crate::variant::general_estimate(&request.columns, 0)
            .table
            .unwrap_or_default();
        self.columns = Some(table(&self.device, &words)?);
        self.first = request.first;
        self.count = request.count;
        let most = BUFFER_BYTES / 4 / RECORD;
        self.results = Buffer::new(
            &self.device,
            RECORD * most.min(request.count),
            Access::Readback,
        )?;
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
        let push = EstimatePush {
            // All fit: first + count <= 2^32, and a dispatch has fewer.
            first: (self.first + start) as u32,
            count: count as u32,
            run,
            invocations: invocations as u32,
            scale: self.scale as u32,
        };
        let mut buffers = vec![(0, &self.results), (2, &self.coefficients)];
        if let Some(columns) = &self.columns {
            buffers.push((1, columns));
        }
        if let Some(tables) = &self.tables {
            buffers.push((3, tables));
        }
        let groups = groups(self.plan.kernel, invocations as u32);
        let timing = self
            .device
            .run(&self.pipeline, &buffers, &push.bytes(), groups)?;
        let scale = self.scale;
        let records = self.results.read(0, RECORD * invocations, |bytes| {
            let words: Vec<[u32; 12]> = bytemuck::pod_collect_to_vec(bytes);
            let record = |[a, b, c, d, e, f, g, h, i, j, count, _]: [u32; 12]| {
                Estimate::from_words(count, scale, [a, b, c, d], [e, f, g, h, i, j])
            };
            words.into_iter().map(record).collect()
        })?;
        Ok((records, timing))
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
        let mut total = Estimate::new(self.scale);
        let mut spent = Timing {
            device_ns: Some(0.0),
            host_ns: 0.0,
        };
        let mut done = 0;
        while done < count {
            let points = (count - done).min(self.chunk);
            let run = self.run_of(points);
            let (records, timing) = self.records(start + done, points, run)?;
            for record in records {
                // 2^32 points are far from what an estimate can hold.
                total = total.merge(record).unwrap_or(total);
            }
            done += points;
            self.adapt(points, &timing);
            add(&mut spent, timing);
            watch(done)?;
        }
        Ok((total, spent))
    }

    /// How long the runs of so many points are: long on a CPU, where each has its cost; on a
    /// GPU so short that all of it has work.
    fn run_of(&self, points: u64) -> u32 {
        let fewest = points.div_ceil(self.limit).max(1);
        let wanted = match self.device.info().kind {
            DeviceKind::Cpu => u64::from(self.longest),
            _ => points.div_ceil(BUSY),
        };
        wanted.max(fewest).min(self.longest.into()) as u32
    }

    fn adapt(&mut self, points: u64, timing: &Timing) {
        let spent = timing.device_ns.unwrap_or(timing.host_ns).max(1.0);
        let ideal = points as f64 * (TARGET_NS / spent).min(GROWTH);
        let most = (self.limit * u64::from(self.longest)).min(u64::from(u32::MAX >> 1));
        self.chunk = (ideal as u64).clamp(1 << 10, most);
    }
}
