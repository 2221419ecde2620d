//! The Vulkan host: devices, buffers, compute pipelines, dispatches, and the
//! start-up probe of a device's arithmetic. It knows no sampling words.
//!
//! ```no_run
//! use corput::vulkan::{Access, Buffer, Device, Instance, InstanceOptions, Pipeline, PipelineDescription, select};
//! # fn main() -> corput::Result<()> {
//! # let spirv: Vec<u32> = vec![];
//! let instance = Instance::new(&InstanceOptions::default())?;
//! let devices = instance.devices()?;
//! let device = Device::open(&instance, select(&devices, None)?)?;
//! let pipeline = Pipeline::new(
//!     &device,
//!     &PipelineDescription { name: "fill", spirv: &spirv, bindings: &[0], push_constant_bytes: 4, specialization: &[] },
//! )?;
//! let mut out = Buffer::new(&device, 256, Access::Readback)?;
//! device.run(&pipeline, &[(0, &out)], &7u32.to_ne_bytes(), 1)?;
//! let sum = out.read(0, 256, |bytes| bytes.iter().map(|b| u64::from(*b)).sum::<u64>())?;
//! # let _ = sum;
//! # Ok(())
//! # }
//! ```
//!
//! **Trust.** Shader modules are trusted code: no driver checks SPIR-V, so the
//! words given to [`Pipeline::new`] must be valid and must stay inside the
//! buffers that they are given.
//!
//! **Order.** Everything that this module submits ends with a barrier towards
//! compute, transfer and host, and is waited for. So successive runs, reads
//! and writes are ordered without further words.

mod baseline;
mod buffer;
mod descriptor;
mod device;
mod dispatch;
mod info;
mod instance;
mod kept;
mod memory;
mod orphan;
mod pipeline;
mod probe;
mod probe_rows;
mod probe_samples;
mod query;
mod select;
mod submit;

pub use ash;
pub use buffer::{Access, Buffer};
pub use descriptor::DescriptorSet;
pub use device::Device;
pub use dispatch::{Timing, barrier, record};
pub use info::{DeviceInfo, DeviceKind, Features, FloatControls, Limits};
pub use instance::{Instance, InstanceOptions};
pub use pipeline::{Pipeline, PipelineDescription};
pub use probe::{Denormals, Probe, ProbeGroup, ProbeSample, Rounding, probe};
pub use select::select;

use crate::error::Error;

/// Longest wait for one submission, in seconds, unless
/// [`Device::set_wait_limit`] says otherwise.
pub const WAIT_SECONDS: u64 = 30;

/// Most buffers that one pipeline of this module may bind.
pub const MAX_BINDINGS: usize = 16;

/// Most bytes of a uniform block: what every device allows.
pub const UNIFORM_BYTES: u64 = 16384;

/// Names the call in the error of a failed Vulkan call.
fn failed(call: &'static str) -> impl Fn(ash::vk::Result) -> Error {
    move |code| Error::Vulkan {
        call,
        result: format!("{code:?}"),
    }
}

/// An argument that cannot be honoured.
fn refused(asked: impl Into<String>, limit: impl Into<String>, remedy: impl Into<String>) -> Error {
    Error::Arguments {
        asked: asked.into(),
        limit: limit.into(),
        remedy: remedy.into(),
    }
}
