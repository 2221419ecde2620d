//! A stripped scene in an engine over wgpu: its WGSL, whose parameters are in a uniform buffer.
//!
//! `cargo run --release --example wgpu_engine [SCENE.toml [SHADER.wgsl]]` draws a part of the
//! scene's samples on every adapter, and ends with 1 where they are not those of the CPU
//! reference, word for word. Without an adapter it says so.

use corput::bulk::SceneReference;
use corput::scene::Needs;
use corput::strip::program::Program;
use corput::strip::{BundleOptions, Target, bundle};
use pollster::block_on;
use std::error::Error;
use std::process::ExitCode;
use wgpu::util::{DeviceExt, DownloadBuffer};

/// Samples `first` to `first + count - 1` of a scene's shader.
fn draw(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    program: &Program,
    shader: &str,
    [first, count]: [u32; 2],
) -> Result<Vec<u32>, Box<dyn Error>> {
    let refused = device.push_error_scope(wgpu::ErrorFilter::Validation);
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(&program.name),
        source: wgpu::ShaderSource::Wgsl(shader.into()),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(&program.name),
        layout: None,
        module: &module,
        entry_point: Some("main"),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });
    if let Some(error) = block_on(refused.pop()) {
        return Err(error.to_string().into());
    }

    // Binding 0 holds the samples, each further one a table, and the last the parameters.
    let samples = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("samples"),
        size: program.sample_bytes(count.into()),
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    let filled = |label, words: &[u32], usage| {
        device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some(label),
            contents: bytemuck::cast_slice(words),
            usage,
        })
    };
    let mut buffers = vec![samples];
    for table in &program.tables {
        let usage = wgpu::BufferUsages::STORAGE;
        buffers.push(filled(&table.name, &table.words, usage));
    }
    let usage = wgpu::BufferUsages::UNIFORM;
    buffers.push(filled("parameters", &[first, count, 0, 0], usage));
    let entries: Vec<_> = (0..)
        .zip(&buffers)
        .map(|(binding, buffer)| wgpu::BindGroupEntry {
            binding,
            resource: buffer.as_entire_binding(),
        })
        .collect();
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &entries,
    });

    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &group, &[]);
    // More groups than the x axis holds go over two; surplus ones do nothing.
    let groups = program.groups(count.into()) as u32;
    let columns = groups.clamp(1, 65_535);
    pass.dispatch_workgroups(columns, groups.div_ceil(columns), 1);
    drop(pass);
    queue.submit([encoder.finish()]);

    // A renderer reads none back: its next pass binds the buffer, and wgpu sets the barrier.
    let made = 4 * u64::from(count) * u64::from(program.record.words);
    let (send, receive) = std::sync::mpsc::channel();
    let slice = buffers[0].slice(..made);
    DownloadBuffer::read_buffer(device, queue, &slice, move |bytes| {
        // Nobody waits any more where this fails.
        let _ = send.send(bytes.map(|bytes| bytemuck::pod_collect_to_vec(&bytes)));
    });
    device.poll(wgpu::PollType::wait_indefinitely())?;
    Ok(receive.recv()??)
}

/// Whether every adapter gives the words of the reference.
pub fn run(arguments: &[String]) -> Result<bool, Box<dyn Error>> {
    let path = arguments
        .first()
        .map_or("tests/data/scenes/diffuse_sky.toml", String::as_str);
    let scene = corput::scene::read(path.as_ref())?;
    let needs = Needs::of(&scene)?;
    // An engine has the file that `corput strip --target wgsl` writes.
    let stripped = bundle(&scene, &needs, &[Target::Wgsl], BundleOptions::default())?;
    let shader = match arguments.get(1) {
        Some(file) => std::fs::read_to_string(file)?,
        None => String::from_utf8(stripped.files[0].bytes.clone())?,
    };
    let program = &stripped.program;
    // Some from within, as a later frame of a renderer draws them.
    let first = u32::try_from(scene.samples.value / 3)?;
    let count = u32::try_from((scene.samples.value - u64::from(first)).min(5000))?;
    let width = program.record.words as usize;
    let mut expected = vec![0; width * count as usize];
    SceneReference::new(&needs)?.fill(first, &mut expected);

    let instance = wgpu::Instance::default();
    let adapters = block_on(instance.enumerate_adapters(wgpu::Backends::all()));
    if adapters.is_empty() {
        println!("SKIPPED: wgpu finds no adapter");
    }
    let mut equal = true;
    for adapter in adapters {
        let (device, queue) = block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))?;
        let made = draw(&device, &queue, program, &shader, [first, count])?;
        for (n, record) in (first..).zip(made.chunks(width)).take(3) {
            let values: Vec<f32> = record.iter().map(|word| f32::from_bits(*word)).collect();
            println!("sample {n}: {values:.4?}");
        }
        let differ = made.iter().zip(&expected).filter(|(a, b)| a != b).count();
        let name = adapter.get_info().name;
        println!(
            "{name}: {differ} of {} words differ from the reference",
            made.len()
        );
        equal &= differ == 0;
    }
    Ok(equal)
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(equal) => ExitCode::from(u8::from(!equal)),
        Err(error) => {
            eprintln!("wgpu_engine: {error}");
            ExitCode::from(2)
        }
    }
}
