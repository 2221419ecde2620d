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
//! compute, transfer and host, and is waited for, but for a [`Submission`]. So
//! successive runs, reads and writes are ordered without further words. A
//! [`Recording`] ends with the same barrier; the host may read what a submission
//! writes once that was waited for, which [`Buffer`] sees to.
//!
//! # When a device fails
//!
//! No failure leaves a wrong answer, and every wait has a bound: one submission may take
//! [`WAIT_SECONDS`], or what [`Device::set_wait_limit`] says, and threads that share a device
//! wait one after the other.
//!
//! | fault | outcome |
//! |---|---|
//! | no loader, no driver, a loader of Vulkan 1.0, no device listed | [`Error::NoDevice`] of [`Instance::new`] or of [`select`] |
//! | the list of devices changes after it was read | the device of the same UUID and name is opened; [`Error::UnknownDevice`] where it has gone |
//! | less than the baseline of [`Device::open`]: storage buffers and their bytes, push constants, invocations, groups | [`Error::InadequateDevice`] of [`Device::open`], with both numbers |
//! | a queue family of the caller's that is not there, or cannot compute | [`Error::Arguments`] of [`Device::from_existing`] |
//! | no `int64` | kernels that store 16 bytes at a time in place of 32, with the same words; no other feature is ever enabled |
//! | no `float64`, no subgroup operations | nothing: the stock kernels use none |
//! | no timestamps, or a clock that cannot be read | [`Timing::device_ns`] is `None`; the results are the same |
//! | no `VK_EXT_external_memory_host`, a file or a file system that cannot be mapped, memory that the driver does not import | an error of [`FileWindow::new`], after which a [`Buffer`] does the same |
//! | a buffer of more bytes than can be bound or allocated at once | [`Error::Arguments`] |
//! | memory of the host or of the device runs out, a mapping fails | [`Error::Vulkan`] with the call; what was half made is destroyed, and all else can be used again |
//! | a module or a pipeline that the driver refuses | [`Error::Vulkan`] with the call; nothing of it is kept |
//! | words that do not begin as SPIR-V does (see **Trust**) | [`Error::Shader`]; the driver does not see them |
//! | the device is lost, as a submission, a wait or the clock says | [`Error::Vulkan`] with that call, and again from whatever submits, reads or writes later; other devices go on |
//! | a fence that does not signal | [`Error::Timeout`] after the wait limit; later uses wait again |
//! | a wait that fails, as without memory | [`Error::Vulkan`]; later uses wait again |
//!
//! Any object may be dropped after any of these. What is dropped while work may still run is
//! destroyed once it has ended; a device that is dropped before is left to the end of the
//! process, and so is its instance. A [`Submission`] that is dropped waits first.

mod baseline;
mod buffer;
mod descriptor;
mod device;
mod dispatch;
mod file_window;
mod import;
mod info;
mod instance;
mod kept;
mod mapping;
mod memory;
mod orphan;
mod pipeline;
mod probe;
mod probe_rows;
mod probe_samples;
mod query;
mod recording;
mod select;
mod slice;
mod submission;
mod submit;

pub use ash;
pub use buffer::{Access, Buffer};
pub use descriptor::DescriptorSet;
pub use device::Device;
pub use dispatch::{Dispatch, Timing, barrier, record};
pub use file_window::FileWindow;
pub use info::{DeviceInfo, DeviceKind, Features, FloatControls, Limits};
pub use instance::{Instance, InstanceOptions};
pub use pipeline::{Pipeline, PipelineDescription};
pub use probe::{Denormals, Probe, ProbeGroup, ProbeSample, Rounding, probe};
pub use recording::Recording;
pub use select::select;
pub use slice::BufferSlice;
pub use submission::Submission;

use crate::error::Error;

/// Longest wait for one submission, in seconds, unless
/// [`Device::set_wait_limit`] says otherwise.
pub const WAIT_SECONDS: u64 = 30;

/// Most buffers that one pipeline of this module may bind.
pub const MAX_BINDINGS: usize = 16;

/// Most dispatches of one [`Device::run_batch`].
pub const MAX_BATCH: usize = 64;

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
