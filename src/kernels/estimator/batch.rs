//! Sums of several requests in one submission.

use super::{Estimator, block};
use crate::Result;
use crate::catalog::Request;
use crate::estimate::Estimate;
use crate::interface::EstimatePush;
use crate::kernels::groups;
use crate::kernels::points::BUFFER_BYTES;
use crate::kernels::records::{RECORD, TARGET_NS, total};
use crate::variant::longest_estimate;
use crate::vulkan::{Access, Buffer, Dispatch, MAX_BATCH, Timing};
use std::time::Instant;

/// What is not shared by the dispatches of a batch.
pub(super) struct Slot {
    results: Buffer,
    columns: Option<Buffer>,
}

impl Estimator {
    /// The sums over all points of each of some requests of the same shape, each by dispatches
    /// of its own; short ones share a submission, whose price for the host is a fraction of a
    /// millisecond on llvmpipe. Times of the device are those of each; to them the host's add an
    /// equal part of what it spent besides on a submission. The estimator has the last request
    /// afterwards. `watch` hears before each submission of the requests that are done, and may
    /// stop.
    ///
    /// # Errors
    /// Those of [`Self::set_request`] and of [`Self::records`], and those of `watch`.
    pub fn run_each(
        &mut self,
        requests: &[Request],
        watch: &mut dyn FnMut(usize) -> Result<()>,
    ) -> Result<Vec<(Estimate, Timing)>> {
        let mut sums = Vec::with_capacity(requests.len());
        let mut left = requests;
        while !left.is_empty() {
            let (some, others) = left.split_at(self.together(left));
            watch(sums.len())?;
            match self.sums_together(some)? {
                Some(batch) => sums.extend(batch),
                None => {
                    for request in some {
                        let (done, begun) = (sums.len(), Instant::now());
                        self.set_request(request)?;
                        let (sum, mut timing) = self.run(0, request.count, &mut |_| watch(done))?;
                        timing.host_ns = begun.elapsed().as_nanos() as f64;
                        sums.push((sum, timing));
                    }
                }
            }
            left = others;
        }
        if let Some(last) = requests.last() {
            self.set_request(last)?;
        }
        Ok(sums)
    }

    /// How many of the requests, from the first on, take about as long together as one dispatch
    /// should, and no more memory; one where a dispatch does not hold it, or has no clock to
    /// tell it from others.
    fn together(&self, requests: &[Request]) -> usize {
        let most = if self.clock { MAX_BATCH } else { 1 };
        let (mut points, mut bytes) = (0, 0);
        let fits = |request: &&Request| {
            points += request.count;
            bytes += RECORD * u64::from(self.whole(request).invocations);
            request.count <= self.chunk
                && self.pace * points as f64 <= TARGET_NS
                && bytes <= BUFFER_BYTES
        };
        requests.iter().take(most).take_while(fits).count().max(1)
    }

    /// Push constants of all points of a request in one dispatch.
    fn whole(&self, request: &Request) -> EstimatePush {
        let longest = longest_estimate(&request.columns, self.problem.id()).max(1);
        let run = self.run_of(request.count, longest);
        self.push(request.first, request.count, run)
    }

    /// Sums of requests by one dispatch each, in one submission; `None` of one request, or
    /// where the device's clock fails.
    fn sums_together(&mut self, requests: &[Request]) -> Result<Option<Vec<(Estimate, Timing)>>> {
        if requests.len() < 2 {
            return Ok(None);
        }
        let begun = Instant::now();
        let mut pushes = Vec::with_capacity(requests.len());
        for (at, request) in requests.iter().enumerate() {
            pushes.push(self.prepare(at, request)?);
        }
        let times = self.dispatch(&pushes)?;
        let Some(times) = times.into_iter().collect::<Option<Vec<f64>>>() else {
            self.clock = false;
            return Ok(None);
        };
        let mut sums = Vec::with_capacity(requests.len());
        for ((push, slot), device_ns) in pushes.iter().zip(&mut self.batch).zip(&times) {
            let invocations = push.invocations.into();
            let sum = total(&mut slot.results, invocations, push.scale as i32)?;
            let timing = Timing {
                device_ns: Some(*device_ns),
                host_ns: *device_ns,
            };
            sums.push((sum, timing));
        }
        let (device, number) = (times.iter().sum::<f64>(), times.len() as f64);
        // A clock may run faster than the host's.
        let share = (begun.elapsed().as_nanos() as f64 - device).max(0.0) / number;
        for (_, timing) in &mut sums {
            timing.host_ns += share;
        }
        let points = pushes.iter().map(|push| u64::from(push.count)).sum::<u64>();
        let mean = Timing {
            device_ns: Some(device / number),
            host_ns: 0.0,
        };
        self.adapt(points / requests.len() as u64, &mean);
        Ok(Some(sums))
    }

    /// Makes a slot ready for all points of a request, by one dispatch.
    fn prepare(&mut self, at: usize, request: &Request) -> Result<EstimatePush> {
        let plan = self.replan(request)?;
        let push = self.whole(request);
        let bytes = RECORD * u64::from(push.invocations).next_power_of_two();
        match self.batch.get_mut(at) {
            Some(slot) => {
                if let (Some(columns), Some(words)) = (&mut slot.columns, &plan.table) {
                    columns.write(0, bytemuck::cast_slice(words))?;
                }
                if slot.results.bytes() < bytes {
                    slot.results = Buffer::new(&self.device, bytes, Access::Readback)?;
                }
            }
            None => {
                let columns = plan.table.as_deref();
                let columns = columns.map(|words| block(&self.device, plan.kernel, 1, words));
                self.batch.push(Slot {
                    results: Buffer::new(&self.device, bytes, Access::Readback)?,
                    columns: columns.transpose()?,
                });
            }
        }
        Ok(push)
    }

    /// Runs the slots that were made ready.
    fn dispatch(&self, pushes: &[EstimatePush]) -> Result<Vec<Option<f64>>> {
        let words: Vec<_> = pushes.iter().map(EstimatePush::bytes).collect();
        let slots = self.batch.iter();
        let buffers: Vec<_> = slots
            .map(|slot| self.buffers(&slot.results, slot.columns.as_ref()))
            .collect();
        let parts = pushes.iter().zip(&words).zip(&buffers);
        let dispatches: Vec<_> = parts
            .map(|((push, words), buffers)| Dispatch {
                buffers,
                push: words,
                groups: groups(self.plan.kernel, push.invocations),
            })
            .collect();
        self.device.run_batch(&self.pipeline, &dispatches)
    }
}
