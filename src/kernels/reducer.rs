//! Exact sums of floats of the caller's.

use super::records::RECORD;
use super::{groups, kernel, pipeline, spirv};
use crate::estimate::{Estimate, FloatSum, WINDOWS, window_scale};
use crate::interface::{Kernel, ReducePush};
use crate::vulkan::{Access, Buffer, Device, Pipeline};
use crate::{Error, Result, compile};
use std::sync::Arc;

const NAME: &str = "reduce";
const SOURCE: &str = include_str!("../../shaders/kernels/reduce.comp");

/// Terms of an invocation: a tally takes 2^16, and llvmpipe's loops end after 65,535.
const LONGEST: u32 = 1 << 15;

/// Terms of a dispatch at most: 16 MiB of them, and short on the slowest device.
const MOST: usize = 1 << 22;

/// How the work of a sum is split, which does not show in its bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Split {
    /// Terms of a dispatch, up to 2^22.
    pub dispatch: usize,
    /// Terms of an invocation, up to 2^15.
    pub run: u32,
}

impl Default for Split {
    fn default() -> Self {
        Self {
            dispatch: 1 << 20,
            run: 256,
        }
    }
}

/// Sums floats on a device without rounding: order, groups and dispatches do not show.
pub struct Reducer {
    kernel: Kernel,
    pipeline: Pipeline,
    device: Arc<Device>,
}

impl Reducer {
    /// By the stock kernel.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Arc<Device>) -> Result<Self> {
        Self::with_module(device, *kernel(NAME)?, &spirv(NAME)?)
    }

    /// In groups of so many invocations, for which the kernel is compiled here.
    ///
    /// # Errors
    /// [`Error::Arguments`] for groups that the device does not run, and those of the device.
    pub fn with_group(device: &Arc<Device>, local_size: u32) -> Result<Self> {
        let largest = largest_group(device);
        if local_size == 0 || local_size > largest {
            return Err(Error::Arguments {
                asked: format!("groups of {local_size} invocations"),
                limit: format!("this device runs 1 to {largest}"),
                remedy: "ask for smaller groups".into(),
            });
        }
        let row = Kernel {
            local_size,
            ..*kernel(NAME)?
        };
        let mut lookup = |name: &str| {
            let header = crate::headers().iter().find(|(header, _)| *header == name);
            header.map(|(_, text)| (*text).to_owned())
        };
        let words = compile::kernel(&row, SOURCE, &mut lookup);
        let words = words.map_err(|problem| Error::Shader {
            shader: NAME.into(),
            problem,
        })?;
        Self::with_module(device, row, &words)
    }

    /// With other SPIR-V of the row's interface: how tests run broken kernels.
    ///
    /// # Errors
    /// Those of the device.
    pub fn with_module(device: &Arc<Device>, row: Kernel, words: &[u32]) -> Result<Self> {
        Ok(Self {
            pipeline: pipeline(device, &row, words, &[])?,
            kernel: row,
            device: Arc::clone(device),
        })
    }

    /// The sum of these floats; infinities and NaN are counted apart. Costs an upload of 4 bytes
    /// a term.
    ///
    /// # Errors
    /// Those of the device.
    pub fn reduce(&self, terms: &[f32]) -> Result<FloatSum> {
        self.reduce_in(terms, Split::default())
    }

    /// The same, split otherwise.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a split beyond its limits, and those of the device.
    pub fn reduce_in(&self, terms: &[f32], split: Split) -> Result<FloatSum> {
        if !(1..=MOST).contains(&split.dispatch) || !(1..=LONGEST).contains(&split.run) {
            return Err(Error::Arguments {
                asked: format!(
                    "dispatches of {} terms in runs of {}",
                    split.dispatch, split.run
                ),
                limit: format!("a dispatch has 1 to {MOST}, a run 1 to {LONGEST}"),
                remedy: "split the sum otherwise".into(),
            });
        }
        // No more memory than the terms need.
        let most = split.dispatch.min(terms.len().max(1));
        let parts = most.div_ceil(split.run as usize);
        let bytes = RECORD * (WINDOWS * parts) as u64;
        let limit = self.device.info().limits.max_storage_buffer_range;
        if bytes > limit {
            return Err(Error::Arguments {
                asked: format!("{parts} runs in a dispatch, {bytes} bytes of sums"),
                limit: format!("a buffer of this device has at most {limit}"),
                remedy: "ask for longer runs or shorter dispatches".into(),
            });
        }
        let mut results = Buffer::new(&self.device, bytes, Access::Readback)?;
        let mut input = Buffer::new(&self.device, 4 * most as u64, Access::Upload)?;
        let mut all = FloatSum::default();
        for part in terms.chunks(split.dispatch) {
            input.write(0, bytemuck::cast_slice(part))?;
            all =
                all.merged(self.dispatch(part.len() as u32, split.run, &input, &mut results)?)?;
        }
        Ok(all)
    }

    fn dispatch(
        &self,
        count: u32,
        run: u32,
        input: &Buffer,
        results: &mut Buffer,
    ) -> Result<FloatSum> {
        let parts = count.div_ceil(run);
        let push = ReducePush {
            first: 0,
            count,
            run,
            parts,
            invocations: WINDOWS as u32 * parts,
        };
        let groups = groups(&self.kernel, push.invocations);
        let buffers = [(0, &*results), (1, input)];
        self.device
            .run(&self.pipeline, &buffers, &push.bytes(), groups)?;
        let bytes = RECORD * u64::from(push.invocations);
        let records: Vec<[u32; 12]> = results.read(0, bytes, bytemuck::pod_collect_to_vec)?;
        let mut all = FloatSum::default();
        for (window, records) in records.chunks(parts.max(1) as usize).enumerate() {
            for &[a, b, c, d, e, f, g, h, i, j, count, special] in records {
                let scale = window_scale(window);
                let sum = Estimate::from_words(count, scale, [a, b, c, d], [e, f, g, h, i, j]);
                all = all.with(window, sum, special.into())?;
            }
        }
        Ok(all)
    }
}

/// The most invocations of a group in a row that a device runs.
#[must_use]
pub fn largest_group(device: &Device) -> u32 {
    let limits = &device.info().limits;
    limits.max_group_invocations.min(limits.max_group_size[0])
}
