//! Stores of a device.

use crate::{Timed, WORDS, compare};
use corput::bench::{chosen, on_device};
use corput::compile::to_spirv;
use corput::vulkan::{
    Access, Buffer, Device, Instance, InstanceOptions, Pipeline, PipelineDescription, select,
};
use corput::{Error, Result};
use std::sync::Arc;

/// Type of a store, its words, and the stores of an invocation, one after the other in memory.
const SHAPES: [(&str, usize, usize); 6] = [
    ("uint", 1, 1),
    ("uint", 1, 16),
    ("uvec4", 4, 1),
    ("uvec4", 4, 16),
    ("u64vec4", 8, 1),
    ("u64vec4", 8, 16),
];

/// The jobs that such stores limit.
const JOBS: [&str; 2] = ["van der corput", "sobol d=2"];

/// Invocations of a group.
const GROUP: usize = 64;

pub fn report() -> Result<()> {
    let instance = Instance::new(&InstanceOptions::default())?;
    let devices = instance.devices()?;
    let device = Device::open(&instance, select(&devices, None)?)?;
    let info = device.info();
    println!("{} ({}): stores alone", info.name, info.driver_info);
    let bytes = 4 * WORDS as u64;
    if info.limits.max_storage_buffer_range < bytes {
        println!("it has no buffers of {bytes} bytes");
        return Ok(());
    }
    let results = Buffer::new(&device, bytes, Access::Readback)?;
    let mut rows: Vec<(String, Timed)> = Vec::new();
    for (kind, words, stores) in SHAPES {
        if kind == "u64vec4" && !device.has_int64() {
            continue;
        }
        let pipeline = pipeline(&device, kind, stores)?;
        let name = format!("{} bytes, {stores} an invocation", 4 * words);
        let invocations = WORDS / (words * stores);
        let run = {
            let (device, results) = (&device, &results);
            let mut round = 0u32;
            move |_: &mut [u32]| {
                round += 1;
                let push = [invocations as u32, round];
                let groups = invocations.div_ceil(GROUP) as u64;
                let push = bytemuck::cast_slice(&push);
                let timing = device.run(&pipeline, &[(0, results)], push, groups)?;
                Ok(1e-9 * timing.device_ns.unwrap_or(timing.host_ns))
            }
        };
        rows.push((name, Box::new(run)));
    }
    compare(&mut rows)?;
    for job in chosen(&JOBS.map(str::to_owned))? {
        // Beside them, what is made with such stores.
        if job.name.contains("scrambled") {
            continue;
        }
        let made = on_device(&device, &job)?;
        println!(
            "{:<44} {:>9.2} ms {:>7.2} x fill",
            job.name,
            made.median_s * 1e3,
            made.fills()
        );
    }
    Ok(())
}

/// A kernel of these stores, whose words differ so that no driver makes fills of them.
fn pipeline(device: &Arc<Device>, kind: &str, stores: usize) -> Result<Pipeline> {
    let source = format!(
        "#version 450
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : enable
layout(local_size_x = {GROUP}) in;
layout(std430, binding = 0) writeonly buffer Results {{ {kind} results[]; }};
layout(push_constant) uniform Push {{ uint invocations; uint round; }};
void main() {{
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  uint n = group * {GROUP} + gl_LocalInvocationID.x;
  if (n >= invocations) return;
  for (uint s = 0; s < {stores}; s++) results[{stores} * n + s] = {kind}(n + s + round);
}}
"
    );
    let name = "stores";
    let spirv = to_spirv(&source, &[], &mut |_| None).map_err(|problem| Error::Shader {
        shader: name.to_owned(),
        problem,
    })?;
    let description = PipelineDescription {
        name,
        spirv: &spirv,
        bindings: &[0],
        push_constant_bytes: 8,
        specialization: &[],
    };
    Pipeline::new(device, &description)
}
