//! A stripped scene in an engine over ash: the engine's own instance, device, buffer and command
//! buffer, in two ways. First with its own pipeline and descriptor set too: corput gives it a module
//! and numbers, and no handle goes to corput. Then by corput's recorder, which has these.
//!
//! `cargo run --release --example ash_engine [SCENE.toml [MODULE.spv]]` draws a part of the
//! scene's samples on every device in both ways, and ends with 1 where they are not those of the
//! CPU reference, word for word.

use ash::vk;
use corput::bulk::SceneReference;
use corput::scene::Needs;
use corput::strip::program::{Program, Sampler};
use corput::strip::{BundleOptions, bundle};
use corput::vulkan::{BufferSlice, Device, Recording};
use std::error::Error;
use std::process::ExitCode;

const COMPUTE: vk::ShaderStageFlags = vk::ShaderStageFlags::COMPUTE;
const STORAGE: vk::DescriptorType = vk::DescriptorType::STORAGE_BUFFER;

/// What an engine keeps anyway. A failure ends the process, which frees what was made.
struct Engine<'a> {
    instance: &'a ash::Instance,
    physical: vk::PhysicalDevice,
    device: ash::Device,
    family: u32,
}

/// A storage buffer that the host sees.
struct Shared {
    buffer: vk::Buffer,
    memory: vk::DeviceMemory,
    words: *mut u32,
}

impl<'a> Engine<'a> {
    fn new(instance: &'a ash::Instance, physical: vk::PhysicalDevice) -> Result<Self, vk::Result> {
        // SAFETY: `physical` is of this instance, which is alive.
        let families = unsafe { instance.get_physical_device_queue_family_properties(physical) };
        let computes = |family: &vk::QueueFamilyProperties| {
            family.queue_flags.contains(vk::QueueFlags::COMPUTE)
        };
        let family = families.iter().position(computes);
        let family = family.ok_or(vk::Result::ERROR_FEATURE_NOT_PRESENT)? as u32;
        let queues = [vk::DeviceQueueCreateInfo::default()
            .queue_family_index(family)
            .queue_priorities(&[1.0])];
        let create = vk::DeviceCreateInfo::default().queue_create_infos(&queues);
        // SAFETY: the family is one of the device's. No feature and no extension is needed.
        let device = unsafe { instance.create_device(physical, &create, None)? };
        Ok(Self {
            instance,
            physical,
            device,
            family,
        })
    }

    /// In memory that the host sees, of which every device has some. A renderer has its samples
    /// in device-local memory and reads none back.
    fn buffer(&self, words: usize) -> Result<Shared, vk::Result> {
        let create = vk::BufferCreateInfo::default()
            .size(4 * words as u64)
            .usage(vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_DST);
        let visible =
            vk::MemoryPropertyFlags::HOST_VISIBLE | vk::MemoryPropertyFlags::HOST_COHERENT;
        // SAFETY: the device is alive; the memory has the size that the buffer asks for and a
        // type that it allows, and is mapped once.
        unsafe {
            let buffer = self.device.create_buffer(&create, None)?;
            let needs = self.device.get_buffer_memory_requirements(buffer);
            let memory = self
                .instance
                .get_physical_device_memory_properties(self.physical);
            let kind = (0u32..)
                .zip(memory.memory_types_as_slice())
                .find(|(at, kind)| {
                    needs.memory_type_bits >> at & 1 == 1 && kind.property_flags.contains(visible)
                });
            let (kind, _) = kind.ok_or(vk::Result::ERROR_OUT_OF_DEVICE_MEMORY)?;
            let allocate = vk::MemoryAllocateInfo::default()
                .allocation_size(needs.size)
                .memory_type_index(kind);
            let memory = self.device.allocate_memory(&allocate, None)?;
            self.device.bind_buffer_memory(buffer, memory, 0)?;
            let flags = vk::MemoryMapFlags::empty();
            let at = self.device.map_memory(memory, 0, vk::WHOLE_SIZE, flags)?;
            Ok(Shared {
                buffer,
                memory,
                words: at.cast(),
            })
        }
    }

    /// The same samples by corput's recorder: its pipeline, set and tables, in the engine's
    /// commands and buffer.
    fn record(
        &self,
        entry: &ash::Entry,
        program: &Program,
        module: &[u32],
        [first, count]: [u32; 2],
    ) -> Result<Vec<u32>, Box<dyn Error>> {
        let bytes = program.sample_bytes(count.into());
        let samples = self.buffer(bytes.div_ceil(4) as usize)?;
        let device = &self.device;
        // SAFETY: all handles are of this engine, which outlives the device of corput's; the buffer
        // has the usage and the bytes, the queue is used by this thread alone, and the recording is
        // dropped after the wait. Everything is destroyed then.
        unsafe {
            let queue = device.get_device_queue(self.family, 0);
            let (own, of) = (device.clone(), self.instance);
            let known = Device::from_existing(entry, of, self.physical, own, queue, self.family)?;
            let sampler = Sampler::new(&known, program, module)?;
            let target = BufferSlice::from_raw(&known, samples.buffer, 0, bytes)?;
            let create = vk::CommandPoolCreateInfo::default().queue_family_index(self.family);
            let pool = device.create_command_pool(&create, None)?;
            let allocate = vk::CommandBufferAllocateInfo::default()
                .command_pool(pool)
                .command_buffer_count(1);
            let commands = device.allocate_command_buffers(&allocate)?[0];
            device.begin_command_buffer(commands, &vk::CommandBufferBeginInfo::default())?;
            let mut recording = Recording::of(&known, commands);
            sampler.record(&mut recording, &target, first, count)?;
            // The recorder's barrier is for compute shaders, copies and the host.
            device.end_command_buffer(commands)?;
            let buffers = [commands];
            let submit = [vk::SubmitInfo::default().command_buffers(&buffers)];
            device.queue_submit(queue, &submit, vk::Fence::null())?;
            device.queue_wait_idle(queue)?;
            drop(recording);
            let made = (count * program.record.words) as usize;
            let records = std::slice::from_raw_parts(samples.words, made).to_vec();
            device.destroy_command_pool(pool, None);
            device.destroy_buffer(samples.buffer, None);
            device.free_memory(samples.memory, None);
            Ok(records)
        }
    }

    /// Samples `first` to `first + count - 1` of a scene's kernel.
    fn draw(
        &self,
        program: &Program,
        module: &[u32],
        [first, count]: [u32; 2],
    ) -> Result<Vec<u32>, vk::Result> {
        // Binding 0 holds the samples, each further one a table, uploaded as it is.
        let words = program.sample_bytes(count.into()).div_ceil(4) as usize;
        let samples = self.buffer(words)?;
        let mut buffers = vec![(0, samples)];
        for table in &program.tables {
            let buffer = self.buffer(table.words.len())?;
            let from = table.words.as_ptr();
            // SAFETY: the mapping has as many words, and the device does not use it yet.
            unsafe { buffer.words.copy_from(from, table.words.len()) };
            buffers.push((table.binding, buffer));
        }
        let bindings: Vec<_> = buffers
            .iter()
            .map(|(binding, _)| {
                vk::DescriptorSetLayoutBinding::default()
                    .binding(*binding)
                    .descriptor_type(STORAGE)
                    .descriptor_count(1)
                    .stage_flags(COMPUTE)
            })
            .collect();
        let push = [vk::PushConstantRange::default()
            .stage_flags(COMPUTE)
            .size(8)];
        let sizes = [vk::DescriptorPoolSize::default()
            .ty(STORAGE)
            .descriptor_count(buffers.len() as u32)];
        let device = &self.device;
        // SAFETY: all handles are of this device, and every structure outlives its call. The
        // module stays inside buffers of these sizes, the set has the bindings of its layout,
        // and the queue is used by this thread alone. Everything is destroyed after the wait.
        unsafe {
            let create = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
            let set_layouts = [device.create_descriptor_set_layout(&create, None)?];
            let create = vk::PipelineLayoutCreateInfo::default()
                .set_layouts(&set_layouts)
                .push_constant_ranges(&push);
            let layout = device.create_pipeline_layout(&create, None)?;
            let create = vk::ShaderModuleCreateInfo::default().code(module);
            let shader = device.create_shader_module(&create, None)?;
            let stage = vk::PipelineShaderStageCreateInfo::default()
                .stage(COMPUTE)
                .module(shader)
                .name(c"main");
            let create = [vk::ComputePipelineCreateInfo::default()
                .stage(stage)
                .layout(layout)];
            let made = device.create_compute_pipelines(vk::PipelineCache::null(), &create, None);
            let pipeline = made.map_err(|(_, code)| code)?[0];
            device.destroy_shader_module(shader, None);

            let create = vk::DescriptorPoolCreateInfo::default()
                .max_sets(1)
                .pool_sizes(&sizes);
            let pool = device.create_descriptor_pool(&create, None)?;
            let allocate = vk::DescriptorSetAllocateInfo::default()
                .descriptor_pool(pool)
                .set_layouts(&set_layouts);
            let sets = device.allocate_descriptor_sets(&allocate)?;
            for (binding, shared) in &buffers {
                let whole = [vk::DescriptorBufferInfo::default()
                    .buffer(shared.buffer)
                    .range(vk::WHOLE_SIZE)];
                let write = vk::WriteDescriptorSet::default()
                    .dst_set(sets[0])
                    .dst_binding(*binding)
                    .descriptor_type(STORAGE)
                    .buffer_info(&whole);
                device.update_descriptor_sets(&[write], &[]);
            }

            let create = vk::CommandPoolCreateInfo::default().queue_family_index(self.family);
            let command_pool = device.create_command_pool(&create, None)?;
            let allocate = vk::CommandBufferAllocateInfo::default()
                .command_pool(command_pool)
                .command_buffer_count(1);
            let commands = device.allocate_command_buffers(&allocate)?[0];
            device.begin_command_buffer(commands, &vk::CommandBufferBeginInfo::default())?;
            let point = vk::PipelineBindPoint::COMPUTE;
            device.cmd_bind_pipeline(commands, point, pipeline);
            device.cmd_bind_descriptor_sets(commands, point, layout, 0, &sets, &[]);
            let parameters = [first.to_ne_bytes(), count.to_ne_bytes()].concat();
            device.cmd_push_constants(commands, layout, COMPUTE, 0, &parameters);
            // More groups than the x axis holds go over two; surplus ones do nothing.
            let groups = program.groups(count.into()) as u32;
            let columns = groups.clamp(1, 65_535);
            device.cmd_dispatch(commands, columns, groups.div_ceil(columns), 1);
            // Here the host reads next. Before a shader that does, it is that shader's stage,
            // with SHADER_READ.
            let written = [vk::MemoryBarrier::default()
                .src_access_mask(vk::AccessFlags::SHADER_WRITE)
                .dst_access_mask(vk::AccessFlags::HOST_READ)];
            let from = vk::PipelineStageFlags::COMPUTE_SHADER;
            let (to, flags) = (vk::PipelineStageFlags::HOST, vk::DependencyFlags::empty());
            device.cmd_pipeline_barrier(commands, from, to, flags, &written, &[], &[]);
            device.end_command_buffer(commands)?;
            let commands = [commands];
            let submit = [vk::SubmitInfo::default().command_buffers(&commands)];
            let queue = device.get_device_queue(self.family, 0);
            device.queue_submit(queue, &submit, vk::Fence::null())?;
            device.queue_wait_idle(queue)?;

            let made = (count * program.record.words) as usize;
            let records = std::slice::from_raw_parts(buffers[0].1.words, made).to_vec();
            device.destroy_command_pool(command_pool, None);
            device.destroy_descriptor_pool(pool, None);
            device.destroy_pipeline(pipeline, None);
            device.destroy_pipeline_layout(layout, None);
            device.destroy_descriptor_set_layout(set_layouts[0], None);
            for (_, shared) in buffers {
                device.destroy_buffer(shared.buffer, None);
                device.free_memory(shared.memory, None);
            }
            Ok(records)
        }
    }
}

/// Whether every device gives the words of the reference.
pub fn run(arguments: &[String]) -> Result<bool, Box<dyn Error>> {
    let path = arguments
        .first()
        .map_or("tests/data/scenes/diffuse_sky.toml", String::as_str);
    let scene = corput::scene::read(path.as_ref())?;
    let needs = Needs::of(&scene)?;
    // An engine reads the files of `corput strip` instead, and its numbers from the header.
    let stripped = bundle(&scene, &needs, &[], BundleOptions::default())?;
    let module = match arguments.get(1) {
        Some(file) => ash::util::read_spv(&mut std::fs::File::open(file)?)?,
        None => stripped.spirv,
    };
    // Some from within, as a later frame of a renderer draws them.
    let first = u32::try_from(scene.samples.value / 3)?;
    let count = u32::try_from((scene.samples.value - u64::from(first)).min(5000))?;
    let width = stripped.program.record.words as usize;
    let mut expected = vec![0; width * count as usize];
    SceneReference::new(&needs)?.fill(first, &mut expected);

    let about = vk::ApplicationInfo::default().api_version(vk::API_VERSION_1_1);
    let create = vk::InstanceCreateInfo::default().application_info(&about);
    // SAFETY: the loader is the system's, and stays loaded until `entry` is dropped.
    let (entry, instance) = unsafe {
        let entry = ash::Entry::load()?;
        let instance = entry.create_instance(&create, None)?;
        (entry, instance)
    };
    // SAFETY: the instance is alive.
    let devices = unsafe { instance.enumerate_physical_devices()? };
    if devices.is_empty() {
        return Err("no Vulkan device".into());
    }
    let mut equal = true;
    for physical in devices {
        // SAFETY: the device is of this instance.
        let properties = unsafe { instance.get_physical_device_properties(physical) };
        let name = properties.device_name_as_c_str()?.to_string_lossy();
        if properties.api_version < vk::API_VERSION_1_1 {
            println!("{name}: no Vulkan 1.1, so no SPIR-V 1.3");
            continue;
        }
        let engine = Engine::new(&instance, physical)?;
        let made = engine.draw(&stripped.program, &module, [first, count])?;
        let recorded = engine.record(&entry, &stripped.program, &module, [first, count])?;
        // SAFETY: both have waited for the queue, and destroyed what they made.
        unsafe { engine.device.destroy_device(None) };
        for (n, record) in (first..).zip(made.chunks(width)).take(3) {
            let values: Vec<f32> = record.iter().map(|word| f32::from_bits(*word)).collect();
            println!("sample {n}: {values:.4?}");
        }
        let differ = made.iter().zip(&expected).filter(|(a, b)| a != b).count();
        println!(
            "{name}: {differ} of {} words differ from the reference",
            made.len()
        );
        let differ_too = recorded.iter().zip(&expected).filter(|(a, b)| a != b);
        let differ_too = differ_too.count();
        println!("{name}: {differ_too} of those that corput recorded");
        equal &= differ == 0 && differ_too == 0;
    }
    // SAFETY: its devices have been destroyed.
    unsafe { instance.destroy_instance(None) };
    drop(entry);
    Ok(equal)
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(equal) => ExitCode::from(u8::from(!equal)),
        Err(error) => {
            eprintln!("ash_engine: {error}");
            ExitCode::from(2)
        }
    }
}
