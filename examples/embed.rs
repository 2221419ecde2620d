//! An engine's own shader over the headers: ambient occlusion of a floor beside a wall.
//!
//! A point of the floor at distance x from an endless wall of height 1 sees the share
//! (1 + x / sqrt(1 + x^2)) / 2 of the cosine-weighted sky.
//!
//! `cargo run --release --example embed`

use corput::vulkan::{
    Access, Buffer, Device, Instance, InstanceOptions, Pipeline, PipelineDescription, select,
};

const SHADER: &str = r#"#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) buffer Results { uint visible[]; };

#define CORPUT_PRIME(d) ((d) == 0u ? 2u : 3u)
#include "corput/halton.glsl"
#include "corput/hemisphere.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    float distance_to_wall = 0.25 * float(i + 1u);
    uint seen = 0u;
    // llvmpipe ends an invocation's loops after 65,535 iterations in all, and a radical
    // inverse takes about 60: more samples belong in more invocations.
    for (uint n = 0u; n < 512u; n++) {
        vec3 d = corput_cosine_hemisphere(uvec2(corput_halton(n, 0u), corput_halton(n, 1u)));
        // The wall stands towards -x.
        bool hit = d.x < 0.0 && d.z * distance_to_wall < -d.x;
        seen += hit ? 0u : 1u;
    }
    visible[i] = seen;
}
"#;

fn main() -> corput::Result<()> {
    // An engine hands the headers to its own compiler; here it is the crate's.
    let headers = corput::headers();
    let mut lookup = |name: &str| {
        let header = headers.iter().find(|(known, _)| *known == name);
        header.map(|(_, text)| (*text).to_owned())
    };
    let spirv = corput::compile::to_spirv(SHADER, &[], &mut lookup).map_err(|problem| {
        corput::Error::Shader {
            shader: "embed".into(),
            problem,
        }
    })?;

    let instance = Instance::new(&InstanceOptions::default())?;
    let devices = instance.devices()?;
    let device = Device::open(&instance, select(&devices, None)?)?;
    let pipeline = Pipeline::new(
        &device,
        &PipelineDescription {
            name: "embed",
            spirv: &spirv,
            bindings: &[0],
            push_constant_bytes: 0,
            specialization: &[],
        },
    )?;
    let mut results = Buffer::new(&device, 4 * 64, Access::Readback)?;
    device.run(&pipeline, &[(0, &results)], &[], 1)?;
    let seen: Vec<u32> = results.read(0, 4 * 8, bytemuck::pod_collect_to_vec)?;
    for (i, seen) in (1..).zip(seen) {
        let x = 0.25 * f64::from(i);
        let truth = 0.5 * (1.0 + x / (1.0 + x * x).sqrt());
        println!(
            "x = {x:.2}: {:.4}, exactly {truth:.4}",
            f64::from(seen) / 512.0
        );
    }
    Ok(())
}
