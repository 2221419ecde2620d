//! One function of the headers over many arguments.

use super::{constant, groups, kernel, pipeline, spirv};
use crate::Result;
use crate::interface::{Kernel, WorkPush};
use crate::vulkan::{Access, Buffer, Device, Pipeline};
use std::sync::Arc;

/// Evaluates a function of an `evaluate` kernel.
pub struct Evaluator {
    kernel: &'static Kernel,
    id: u32,
    words: Vec<u32>,
    device: Arc<Device>,
}

/// Results at a time: a short dispatch on the slowest device.
const CHUNK: usize = 1 << 18;

impl Evaluator {
    /// Function `id` of the stock kernel with this name.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Arc<Device>, name: &str, id: u32) -> Result<Self> {
        Self::with_module(device, name, id, &spirv(name)?)
    }

    /// The same with other SPIR-V of the same interface: how tests run broken kernels.
    ///
    /// # Errors
    /// Those of the device.
    pub fn with_module(device: &Arc<Device>, name: &str, id: u32, words: &[u32]) -> Result<Self> {
        Ok(Self {
            kernel: kernel(name)?,
            id,
            words: words.to_vec(),
            device: Arc::clone(device),
        })
    }

    /// The pipeline over a buffer of arguments, or over indices.
    fn pipeline(&self, indexed: bool) -> Result<Pipeline> {
        let constants: Vec<(u32, u32)> = [
            constant(self.kernel, "FUNCTION", self.id),
            constant(self.kernel, "INDEXED", u32::from(indexed)),
        ]
        .into_iter()
        .flatten()
        .collect();
        pipeline(&self.device, self.kernel, &self.words, &constants)
    }

    /// Results for these arguments, four words each.
    ///
    /// # Errors
    /// Those of the device.
    pub fn run(&self, arguments: &[[u32; 4]]) -> Result<Vec<[u32; 4]>> {
        let pipeline = self.pipeline(false)?;
        let mut all = Vec::with_capacity(arguments.len());
        for part in arguments.chunks(CHUNK) {
            let bytes = 16 * part.len() as u64;
            let mut input = Buffer::new(&self.device, bytes, Access::Upload)?;
            input.write(0, bytemuck::cast_slice(part))?;
            let push = WorkPush {
                first: 0,
                invocations: part.len() as u32,
                stride: 1,
            };
            all.extend(self.dispatch(&pipeline, &input, &push)?);
        }
        Ok(all)
    }

    /// Results for the words first, first + stride, ..., `count` of them (at most
    /// 2^22), in all four places of the argument.
    ///
    /// # Errors
    /// Those of the device.
    pub fn run_indexed(&self, first: u32, stride: u32, count: u32) -> Result<Vec<[u32; 4]>> {
        let unused = Buffer::new(&self.device, 16, Access::Upload)?;
        let push = WorkPush {
            first,
            invocations: count,
            stride,
        };
        self.dispatch(&self.pipeline(true)?, &unused, &push)
    }

    fn dispatch(
        &self,
        pipeline: &Pipeline,
        input: &Buffer,
        push: &WorkPush,
    ) -> Result<Vec<[u32; 4]>> {
        let bytes = 16 * u64::from(push.invocations);
        let mut results = Buffer::new(&self.device, bytes, Access::Readback)?;
        self.device.run(
            pipeline,
            &[(0, &results), (1, input)],
            &push.bytes(),
            groups(self.kernel, push.invocations),
        )?;
        results.read(0, bytes, bytemuck::pod_collect_to_vec)
    }
}
