//! One elementary function that both profiles have.

use super::{constant, groups, kernel, pipeline, spirv};
use crate::Result;
use crate::catalog::Profile;
use crate::interface::{Kernel, WorkPush};
use crate::vulkan::{Access, Buffer, Device, Pipeline, Timing};
use std::sync::Arc;

/// Evaluates an elementary function in a profile: once for each argument, or many times to
/// measure its speed.
pub struct Elementary {
    pipeline: Pipeline,
    kernel: &'static Kernel,
    unused: Buffer,
    device: Arc<Device>,
}

impl Elementary {
    /// The kernel that has all of them.
    #[must_use]
    pub fn kernel(profile: Profile) -> &'static str {
        match profile {
            Profile::Exact => "function",
            Profile::Native => "function_native",
        }
    }

    /// Compiles the pipeline of function `id`; `task` is `SAMPLE`, `REPEAT` or
    /// `BARE` of [`task`](crate::interface::task).
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Arc<Device>, id: u32, profile: Profile, task: u32) -> Result<Self> {
        let words = spirv(Self::kernel(profile))?;
        Self::with_module(device, id, profile, task, &words)
    }

    /// The same with other SPIR-V of the same interface: how tests run broken kernels.
    ///
    /// # Errors
    /// Those of the device.
    pub fn with_module(
        device: &Arc<Device>,
        id: u32,
        profile: Profile,
        task: u32,
        words: &[u32],
    ) -> Result<Self> {
        let kernel = kernel(Self::kernel(profile))?;
        let constants: Vec<(u32, u32)> = [
            constant(kernel, "FUNCTION", id),
            constant(kernel, "TASK", task),
        ]
        .into_iter()
        .flatten()
        .collect();
        Ok(Self {
            pipeline: pipeline(device, kernel, words, &constants)?,
            kernel,
            unused: Buffer::new(device, 16, Access::Upload)?,
            device: Arc::clone(device),
        })
    }

    /// Results for these arguments, of which a function takes the first or two, by the task
    /// `SAMPLE`; at most 2^22.
    ///
    /// # Errors
    /// Those of the device.
    pub fn run(&self, arguments: &[[u32; 4]]) -> Result<Vec<[u32; 4]>> {
        let bytes = 16 * arguments.len() as u64;
        let mut input = Buffer::new(&self.device, bytes, Access::Upload)?;
        input.write(0, bytemuck::cast_slice(arguments))?;
        let mut results = Buffer::new(&self.device, bytes, Access::Readback)?;
        self.dispatch(&input, &results, arguments.len() as u32)?;
        results.read(0, bytes, bytemuck::pod_collect_to_vec)
    }

    /// The loops of so many invocations by another task, each with 16 bytes of the results.
    ///
    /// # Errors
    /// Those of the device.
    pub fn repeat(&self, results: &Buffer, invocations: u32) -> Result<Timing> {
        self.dispatch(&self.unused, results, invocations)
    }

    fn dispatch(&self, input: &Buffer, results: &Buffer, invocations: u32) -> Result<Timing> {
        let push = WorkPush {
            first: 0,
            invocations,
            stride: 1,
        };
        self.device.run(
            &self.pipeline,
            &[(0, results), (1, input)],
            &push.bytes(),
            groups(self.kernel, invocations),
        )
    }
}
