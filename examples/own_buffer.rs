//! Points into a buffer that the caller owns, on a device that the caller owns: submitted by
//! corput and waited for by its fence, and recorded into the caller's own commands.
//!
//! `cargo run --release --example own_buffer` does so on every device, and ends with 1 where the
//! words are not those of the CPU.

use ash::vk;
use corput::bulk::Reference;
use corput::catalog::{Engine, Map, Mapping, Options, Request, Sequence};
use corput::kernels::Generator;
use corput::vulkan::{BufferSlice, Device, Recording, ash};
use std::error::Error;
use std::process::ExitCode;
use std::sync::Arc;

/// Points, of 3 words each, that begin in the middle of the buffer: every device can bind
/// multiples of 256.
const POINTS: u64 = 10_001;
const OFFSET: u64 = 4096;
const BYTES: u64 = 12 * POINTS;

/// A buffer that the host sees, of 0 throughout.
struct Shared {
    buffer: vk::Buffer,
    memory: vk::DeviceMemory,
    words: *mut u32,
}

const SIZE: u64 = OFFSET + BYTES + 4096;

/// SAFETY: the handles belong together, and are alive.
unsafe fn shared(
    instance: &ash::Instance,
    physical: vk::PhysicalDevice,
    device: &ash::Device,
) -> Result<Shared, vk::Result> {
    // What corput asks for: it writes by shaders and by copies.
    let usage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_DST;
    let create = vk::BufferCreateInfo::default().size(SIZE).usage(usage);
    let visible = vk::MemoryPropertyFlags::HOST_VISIBLE | vk::MemoryPropertyFlags::HOST_COHERENT;
    // SAFETY: the memory has the size that the buffer asks for and a type that it allows, and
    // is mapped once.
    unsafe {
        let buffer = device.create_buffer(&create, None)?;
        let needs = device.get_buffer_memory_requirements(buffer);
        let memory = instance.get_physical_device_memory_properties(physical);
        let kind = (0u32..)
            .zip(memory.memory_types_as_slice())
            .find(|(at, kind)| {
                needs.memory_type_bits >> at & 1 == 1 && kind.property_flags.contains(visible)
            });
        let (kind, _) = kind.ok_or(vk::Result::ERROR_OUT_OF_DEVICE_MEMORY)?;
        let allocate = vk::MemoryAllocateInfo::default()
            .allocation_size(needs.size)
            .memory_type_index(kind);
        let memory = device.allocate_memory(&allocate, None)?;
        device.bind_buffer_memory(buffer, memory, 0)?;
        let flags = vk::MemoryMapFlags::empty();
        let words = device.map_memory(memory, 0, vk::WHOLE_SIZE, flags)?;
        words.write_bytes(0, SIZE as usize);
        Ok(Shared {
            buffer,
            memory,
            words: words.cast(),
        })
    }
}

/// What the buffer holds after each of both ways.
///
/// SAFETY: as for [`shared`], and the queue is of this family, and used by this thread alone.
unsafe fn both(
    wrapped: &Arc<Device>,
    request: &Request,
    shared: &Shared,
) -> Result<[Vec<u32>; 2], Box<dyn Error>> {
    let mut generator = Generator::new(wrapped, request)?;
    let (device, queue) = (wrapped.raw(), wrapped.queue());
    let seen = || {
        // SAFETY: nothing is running on the buffer, whose memory is coherent.
        unsafe { std::slice::from_raw_parts(shared.words, SIZE as usize / 4) }.to_vec()
    };
    // SAFETY: the buffer has the usage and outlives both pieces of work, the range lies within
    // it, and the host looks after waits alone; the recording is dropped after its wait.
    unsafe {
        let target = BufferSlice::from_raw(wrapped, shared.buffer, OFFSET, BYTES)?;
        let submission = generator.submit(0, POINTS, &target)?;
        device.wait_for_fences(&[submission.fence()], true, 30_000_000_000)?;
        drop(submission);
        let submitted = seen();
        shared.words.write_bytes(0, SIZE as usize / 4);

        let create =
            vk::CommandPoolCreateInfo::default().queue_family_index(wrapped.queue_family());
        let pool = device.create_command_pool(&create, None)?;
        let allocate = vk::CommandBufferAllocateInfo::default()
            .command_pool(pool)
            .command_buffer_count(1);
        let commands = device.allocate_command_buffers(&allocate)?[0];
        let fence = device.create_fence(&vk::FenceCreateInfo::default(), None)?;
        device.begin_command_buffer(commands, &vk::CommandBufferBeginInfo::default())?;
        let mut recording = Recording::of(wrapped, commands);
        generator.record(&mut recording, 0, POINTS, &target)?;
        // Here compute shaders, copies and the host may read. Others need a barrier of their own.
        device.end_command_buffer(commands)?;
        let buffers = [commands];
        let submit = [vk::SubmitInfo::default().command_buffers(&buffers)];
        device.queue_submit(queue, &submit, fence)?;
        if let Err(error) = device.wait_for_fences(&[fence], true, 30_000_000_000) {
            // What commands use that may still run has to stay.
            std::mem::forget((recording, generator));
            return Err(error.into());
        }
        drop(recording);
        device.destroy_fence(fence, None);
        device.destroy_command_pool(pool, None);
        Ok([submitted, seen()])
    }
}

/// Whether every device gives the words of the CPU, and leaves the others of the buffer alone.
pub fn run(_arguments: &[String]) -> Result<bool, Box<dyn Error>> {
    let mut options = Options::new(Sequence::Halton, POINTS);
    options.map = Some(Mapping::new(Map::from_name("cosine-hemisphere")?, &[])?);
    let request = Request::new(&options)?;
    let mut expected = vec![0; SIZE as usize / 4];
    let place = OFFSET as usize / 4..(OFFSET + BYTES) as usize / 4;
    Reference::new(&request).fill(0, &mut expected[place])?;

    let about = vk::ApplicationInfo::default().api_version(vk::API_VERSION_1_1);
    let create = vk::InstanceCreateInfo::default().application_info(&about);
    let mut equal = true;
    // SAFETY: all handles belong together, and are destroyed once nothing uses them. No feature
    // and no extension is needed.
    unsafe {
        let entry = ash::Entry::load()?;
        let instance = entry.create_instance(&create, None)?;
        for physical in instance.enumerate_physical_devices()? {
            let families = instance.get_physical_device_queue_family_properties(physical);
            let computes = |family: &vk::QueueFamilyProperties| {
                family.queue_flags.contains(vk::QueueFlags::COMPUTE)
            };
            let family = families.iter().position(computes);
            let family = family.ok_or("no queue computes")? as u32;
            let queues = [vk::DeviceQueueCreateInfo::default()
                .queue_family_index(family)
                .queue_priorities(&[1.0])];
            let create = vk::DeviceCreateInfo::default().queue_create_infos(&queues);
            let device = instance.create_device(physical, &create, None)?;
            let queue = device.get_device_queue(family, 0);
            let (own, of) = (device.clone(), &instance);
            let wrapped = Device::from_existing(&entry, of, physical, own, queue, family)?;
            let shared = shared(&instance, physical, &device)?;
            let both = both(&wrapped, &request, &shared)?;
            let same = both.iter().all(|words| *words == expected);
            println!("{}: equal: {same}", wrapped.info().name);
            equal &= same;
            drop(wrapped);
            device.destroy_buffer(shared.buffer, None);
            device.free_memory(shared.memory, None);
            device.destroy_device(None);
        }
        instance.destroy_instance(None);
    }
    Ok(equal)
}

fn main() -> ExitCode {
    match run(&[]) {
        Ok(equal) => ExitCode::from(u8::from(!equal)),
        Err(error) => {
            eprintln!("own_buffer: {error}");
            ExitCode::from(2)
        }
    }
}
