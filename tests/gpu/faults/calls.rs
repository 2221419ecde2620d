//! The functions that may fail: each counts, fails as planned, or goes on to the loader's.

use std::ffi::{CStr, c_char, c_void};
use std::mem::transmute;

use corput::vulkan::ash::vk::{self, Handle};

use super::loader::{Function, real, remember};
use super::plan::{Lie, Way, with};

type Allocator<'a> = *const vk::AllocationCallbacks<'a>;

/// Does what is planned for this call. What makes an object and succeeds counts as one.
fn pass(call: &'static str, first: u64, go: impl FnOnce() -> vk::Result) -> vk::Result {
    let code = match with(|plan| plan.strike(call, first)) {
        Some((code, Way::Instead)) => return code,
        Some((code, Way::After)) => {
            let done = go();
            assert_eq!(done, vk::Result::SUCCESS, "{call}");
            code
        }
        None => go(),
    };
    let makes = call.starts_with("vkCreate") || call == "vkAllocateMemory";
    if makes && code == vk::Result::SUCCESS {
        with(|plan| plan.live += 1);
    }
    code
}

macro_rules! may_fail {
    ($($name:ident: $pfn:ident = $first:ident: $of:ty $(, $argument:ident: $kind:ty)*;)*) => {
        $(
            #[allow(non_snake_case)]
            unsafe extern "system" fn $name($first: $of $(, $argument: $kind)*) -> vk::Result {
                // SAFETY: the caller vouches for the arguments.
                let go = || unsafe { real::<vk::$pfn>(stringify!($name))($first $(, $argument)*) };
                pass(stringify!($name), $first.as_raw(), go)
            }
        )*

        fn that_may_fail(name: &CStr) -> vk::PFN_vkVoidFunction {
            $(
                if name.to_bytes() == stringify!($name).as_bytes() {
                    // SAFETY: who asks by this name calls it by this type.
                    return Some(unsafe {
                        transmute::<vk::$pfn, Function>($name)
                    });
                }
            )*
            None
        }
    };
}

may_fail! {
    vkEnumerateDeviceExtensionProperties: PFN_vkEnumerateDeviceExtensionProperties =
        physical: vk::PhysicalDevice, layer: *const c_char, count: *mut u32,
        out: *mut vk::ExtensionProperties;
    vkAllocateMemory: PFN_vkAllocateMemory =
        device: vk::Device, info: *const vk::MemoryAllocateInfo<'_>, with: Allocator<'_>,
        out: *mut vk::DeviceMemory;
    vkGetMemoryHostPointerPropertiesEXT: PFN_vkGetMemoryHostPointerPropertiesEXT =
        device: vk::Device, kind: vk::ExternalMemoryHandleTypeFlags, at: *const c_void,
        out: *mut vk::MemoryHostPointerPropertiesEXT<'_>;
    vkBindBufferMemory: PFN_vkBindBufferMemory =
        device: vk::Device, buffer: vk::Buffer, memory: vk::DeviceMemory, at: vk::DeviceSize;
    vkFlushMappedMemoryRanges: PFN_vkFlushMappedMemoryRanges =
        device: vk::Device, count: u32, ranges: *const vk::MappedMemoryRange<'_>;
    vkInvalidateMappedMemoryRanges: PFN_vkInvalidateMappedMemoryRanges =
        device: vk::Device, count: u32, ranges: *const vk::MappedMemoryRange<'_>;
    vkCreateBuffer: PFN_vkCreateBuffer =
        device: vk::Device, info: *const vk::BufferCreateInfo<'_>, with: Allocator<'_>,
        out: *mut vk::Buffer;
    vkCreateCommandPool: PFN_vkCreateCommandPool =
        device: vk::Device, info: *const vk::CommandPoolCreateInfo<'_>, with: Allocator<'_>,
        out: *mut vk::CommandPool;
    vkAllocateCommandBuffers: PFN_vkAllocateCommandBuffers =
        device: vk::Device, info: *const vk::CommandBufferAllocateInfo<'_>,
        out: *mut vk::CommandBuffer;
    vkCreateFence: PFN_vkCreateFence =
        device: vk::Device, info: *const vk::FenceCreateInfo<'_>, with: Allocator<'_>,
        out: *mut vk::Fence;
    vkCreateQueryPool: PFN_vkCreateQueryPool =
        device: vk::Device, info: *const vk::QueryPoolCreateInfo<'_>, with: Allocator<'_>,
        out: *mut vk::QueryPool;
    vkCreateDescriptorPool: PFN_vkCreateDescriptorPool =
        device: vk::Device, info: *const vk::DescriptorPoolCreateInfo<'_>, with: Allocator<'_>,
        out: *mut vk::DescriptorPool;
    vkResetDescriptorPool: PFN_vkResetDescriptorPool =
        device: vk::Device, pool: vk::DescriptorPool, flags: vk::DescriptorPoolResetFlags;
    vkAllocateDescriptorSets: PFN_vkAllocateDescriptorSets =
        device: vk::Device, info: *const vk::DescriptorSetAllocateInfo<'_>,
        out: *mut vk::DescriptorSet;
    vkResetCommandPool: PFN_vkResetCommandPool =
        device: vk::Device, pool: vk::CommandPool, flags: vk::CommandPoolResetFlags;
    vkBeginCommandBuffer: PFN_vkBeginCommandBuffer =
        commands: vk::CommandBuffer, info: *const vk::CommandBufferBeginInfo<'_>;
    vkEndCommandBuffer: PFN_vkEndCommandBuffer = commands: vk::CommandBuffer;
    vkQueueSubmit: PFN_vkQueueSubmit =
        queue: vk::Queue, count: u32, info: *const vk::SubmitInfo<'_>, fence: vk::Fence;
    vkResetFences: PFN_vkResetFences = device: vk::Device, count: u32, fences: *const vk::Fence;
    vkGetFenceStatus: PFN_vkGetFenceStatus = device: vk::Device, fence: vk::Fence;
    vkGetQueryPoolResults: PFN_vkGetQueryPoolResults =
        device: vk::Device, pool: vk::QueryPool, first: u32, count: u32, bytes: usize,
        out: *mut c_void, stride: vk::DeviceSize, flags: vk::QueryResultFlags;
    vkCreateDescriptorSetLayout: PFN_vkCreateDescriptorSetLayout =
        device: vk::Device, info: *const vk::DescriptorSetLayoutCreateInfo<'_>,
        with: Allocator<'_>, out: *mut vk::DescriptorSetLayout;
    vkCreatePipelineLayout: PFN_vkCreatePipelineLayout =
        device: vk::Device, info: *const vk::PipelineLayoutCreateInfo<'_>, with: Allocator<'_>,
        out: *mut vk::PipelineLayout;
    vkCreateComputePipelines: PFN_vkCreateComputePipelines =
        device: vk::Device, cache: vk::PipelineCache, count: u32,
        info: *const vk::ComputePipelineCreateInfo<'_>, with: Allocator<'_>,
        out: *mut vk::Pipeline;
}

/// Those that also look at what they are given, or change what they give.
fn that_look(name: &CStr) -> vk::PFN_vkVoidFunction {
    // SAFETY: who asks by these names calls by these types.
    let found: Function = unsafe {
        match name.to_bytes() {
            b"vkCreateInstance" => transmute::<vk::PFN_vkCreateInstance, Function>(create_instance),
            b"vkCreateDevice" => transmute::<vk::PFN_vkCreateDevice, Function>(create_device),
            b"vkCreateShaderModule" => {
                transmute::<vk::PFN_vkCreateShaderModule, Function>(create_shader_module)
            }
            b"vkMapMemory" => transmute::<vk::PFN_vkMapMemory, Function>(map_memory),
            b"vkWaitForFences" => transmute::<vk::PFN_vkWaitForFences, Function>(wait_for_fences),
            _ => return None,
        }
    };
    Some(found)
}

/// What stands in for a function, if it may fail.
pub fn find(name: &CStr) -> vk::PFN_vkVoidFunction {
    that_look(name).or_else(|| that_may_fail(name))
}

unsafe extern "system" fn create_instance(
    info: *const vk::InstanceCreateInfo<'_>,
    allocator: Allocator<'_>,
    out: *mut vk::Instance,
) -> vk::Result {
    let go = || {
        // SAFETY: the caller vouches for the arguments.
        let code =
            unsafe { real::<vk::PFN_vkCreateInstance>("vkCreateInstance")(info, allocator, out) };
        if code == vk::Result::SUCCESS {
            // SAFETY: it was just written.
            remember(unsafe { *out });
        }
        code
    };
    pass("vkCreateInstance", 0, go)
}

unsafe extern "system" fn create_device(
    physical: vk::PhysicalDevice,
    info: *const vk::DeviceCreateInfo<'_>,
    allocator: Allocator<'_>,
    out: *mut vk::Device,
) -> vk::Result {
    // SAFETY: the caller's, and valid.
    let (features, chain) = unsafe { ((*info).p_enabled_features, (*info).p_next) };
    if !features.is_null() || !chain.is_null() {
        with(|plan| plan.features_asked += 1);
    }
    // SAFETY: the caller vouches for the arguments.
    let go = || unsafe {
        real::<vk::PFN_vkCreateDevice>("vkCreateDevice")(physical, info, allocator, out)
    };
    pass("vkCreateDevice", physical.as_raw(), go)
}

unsafe extern "system" fn create_shader_module(
    device: vk::Device,
    info: *const vk::ShaderModuleCreateInfo<'_>,
    allocator: Allocator<'_>,
    out: *mut vk::ShaderModule,
) -> vk::Result {
    // SAFETY: the caller's, and valid.
    let words = unsafe { std::slice::from_raw_parts((*info).p_code, (*info).code_size / 4) };
    let refuses = |lie: &Lie| matches!(lie, Lie::Module(refuses) if refuses(words));
    let refused = with(|plan| {
        let refused = plan.lies.iter().any(refuses);
        if refused {
            plan.lied();
        }
        refused
    });
    let go = || {
        if refused {
            return vk::Result::ERROR_INVALID_SHADER_NV;
        }
        // SAFETY: the caller vouches for the arguments.
        unsafe {
            real::<vk::PFN_vkCreateShaderModule>("vkCreateShaderModule")(
                device, info, allocator, out,
            )
        }
    };
    pass("vkCreateShaderModule", device.as_raw(), go)
}

unsafe extern "system" fn map_memory(
    device: vk::Device,
    memory: vk::DeviceMemory,
    at: vk::DeviceSize,
    bytes: vk::DeviceSize,
    flags: vk::MemoryMapFlags,
    out: *mut *mut c_void,
) -> vk::Result {
    let go = || {
        // SAFETY: the caller vouches for the arguments.
        let code = unsafe {
            real::<vk::PFN_vkMapMemory>("vkMapMemory")(device, memory, at, bytes, flags, out)
        };
        let null = |lie: &Lie| matches!(lie, Lie::NullMap);
        with(|plan| {
            if plan.lies.iter().any(null) {
                plan.lied();
                // SAFETY: the caller's, and it takes any pointer.
                unsafe { *out = std::ptr::null_mut() };
            }
        });
        code
    };
    pass("vkMapMemory", device.as_raw(), go)
}

unsafe extern "system" fn wait_for_fences(
    device: vk::Device,
    count: u32,
    fences: *const vk::Fence,
    all: vk::Bool32,
    timeout: u64,
) -> vk::Result {
    with(|plan| plan.longest_wait = plan.longest_wait.max(timeout));
    // SAFETY: the caller vouches for the arguments.
    let go = || unsafe {
        real::<vk::PFN_vkWaitForFences>("vkWaitForFences")(device, count, fences, all, timeout)
    };
    let code = pass("vkWaitForFences", device.as_raw(), go);
    if code == vk::Result::TIMEOUT {
        // A fence that never signals takes all the time that it is given.
        std::thread::sleep(std::time::Duration::from_nanos(timeout));
    }
    code
}
