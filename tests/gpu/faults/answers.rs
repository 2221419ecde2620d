//! What drivers say about themselves, changed as planned; and what ends objects, counted.

use std::ffi::CStr;
use std::mem::transmute;

use corput::vulkan::ash::vk::{
    self, Handle, PhysicalDeviceExternalMemoryHostPropertiesEXT as HostMemory,
    PhysicalDeviceMaintenance3Properties as Maintenance3,
    PhysicalDeviceSubgroupProperties as Subgroup, TaggedStructure,
};

use super::loader::{Function, forget, real};
use super::plan::{Lie, with};

type Allocator<'a> = *const vk::AllocationCallbacks<'a>;

/// Lets each lie that fits change an answer.
fn changed(tell: impl Fn(&Lie) -> bool) {
    with(|plan| {
        for lie in plan.lies.clone() {
            if tell(&lie) {
                plan.lied();
            }
        }
    });
}

macro_rules! ends {
    ($($name:ident: $pfn:ident = $kind:ty;)*) => {
        $(
            #[allow(non_snake_case)]
            unsafe extern "system" fn $name(
                device: vk::Device,
                object: $kind,
                allocator: Allocator<'_>,
            ) {
                if !object.is_null() {
                    with(|plan| plan.live -= 1);
                }
                // SAFETY: the caller vouches for the arguments.
                unsafe { real::<vk::$pfn>(stringify!($name))(device, object, allocator) }
            }
        )*

        fn that_end(name: &CStr) -> vk::PFN_vkVoidFunction {
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

ends! {
    vkDestroyBuffer: PFN_vkDestroyBuffer = vk::Buffer;
    vkFreeMemory: PFN_vkFreeMemory = vk::DeviceMemory;
    vkDestroyCommandPool: PFN_vkDestroyCommandPool = vk::CommandPool;
    vkDestroyFence: PFN_vkDestroyFence = vk::Fence;
    vkDestroyQueryPool: PFN_vkDestroyQueryPool = vk::QueryPool;
    vkDestroyDescriptorPool: PFN_vkDestroyDescriptorPool = vk::DescriptorPool;
    vkDestroyDescriptorSetLayout: PFN_vkDestroyDescriptorSetLayout = vk::DescriptorSetLayout;
    vkDestroyPipelineLayout: PFN_vkDestroyPipelineLayout = vk::PipelineLayout;
    vkDestroyShaderModule: PFN_vkDestroyShaderModule = vk::ShaderModule;
    vkDestroyPipeline: PFN_vkDestroyPipeline = vk::Pipeline;
}

/// What stands in for a function, if its answers may be changed or it ends an object.
pub fn find(name: &CStr) -> vk::PFN_vkVoidFunction {
    // SAFETY: who asks by these names calls by these types.
    let found: Function = unsafe {
        match name.to_bytes() {
            b"vkEnumerateInstanceVersion" => {
                transmute::<vk::PFN_vkEnumerateInstanceVersion, Function>(instance_version)
            }
            b"vkEnumeratePhysicalDevices" => {
                transmute::<vk::PFN_vkEnumeratePhysicalDevices, Function>(physical_devices)
            }
            b"vkGetPhysicalDeviceProperties" => {
                transmute::<vk::PFN_vkGetPhysicalDeviceProperties, Function>(properties)
            }
            b"vkGetPhysicalDeviceProperties2" => {
                transmute::<vk::PFN_vkGetPhysicalDeviceProperties2, Function>(properties2)
            }
            b"vkGetPhysicalDeviceFeatures2" => {
                transmute::<vk::PFN_vkGetPhysicalDeviceFeatures2, Function>(features2)
            }
            b"vkGetPhysicalDeviceQueueFamilyProperties" => {
                transmute::<vk::PFN_vkGetPhysicalDeviceQueueFamilyProperties, Function>(families)
            }
            b"vkGetPhysicalDeviceMemoryProperties" => {
                transmute::<vk::PFN_vkGetPhysicalDeviceMemoryProperties, Function>(memory)
            }
            b"vkUpdateDescriptorSets" => {
                transmute::<vk::PFN_vkUpdateDescriptorSets, Function>(update_descriptor_sets)
            }
            b"vkDestroyDevice" => transmute::<vk::PFN_vkDestroyDevice, Function>(destroy_device),
            b"vkDestroyInstance" => {
                transmute::<vk::PFN_vkDestroyInstance, Function>(destroy_instance)
            }
            _ => return that_end(name),
        }
    };
    Some(found)
}

unsafe extern "system" fn instance_version(version: *mut u32) -> vk::Result {
    if let Some((code, _)) = with(|plan| plan.strike("vkEnumerateInstanceVersion", 0)) {
        return code;
    }
    // SAFETY: the caller vouches for the argument.
    let code = unsafe {
        real::<vk::PFN_vkEnumerateInstanceVersion>("vkEnumerateInstanceVersion")(version)
    };
    changed(|lie| {
        let Lie::Version(other) = lie else {
            return false;
        };
        // SAFETY: the caller's, and it takes any number.
        unsafe { *version = *other };
        true
    });
    code
}

unsafe extern "system" fn physical_devices(
    instance: vk::Instance,
    count: *mut u32,
    out: *mut vk::PhysicalDevice,
) -> vk::Result {
    if let Some((code, _)) = with(|plan| plan.strike("vkEnumeratePhysicalDevices", 0)) {
        return code;
    }
    let mut all = vec![vk::PhysicalDevice::null(); 64];
    let mut found = all.len() as u32;
    // SAFETY: the instance is the caller's; there is room for `found` devices.
    let code = unsafe {
        real::<vk::PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices")(
            instance,
            &mut found,
            all.as_mut_ptr(),
        )
    };
    all.truncate(found as usize);
    with(|plan| {
        if !out.is_null() {
            plan.told += 1;
        }
        // The question for the number comes before the one for the devices.
        let time = plan.told + u64::from(out.is_null());
        for lie in plan.lies.clone() {
            if let Lie::Devices(change) = lie {
                let before = all.clone();
                change(time, &mut all);
                if before != all {
                    plan.lied();
                }
            }
        }
    });
    // SAFETY: the caller gives a number, and room for so many where it gives any.
    unsafe {
        if out.is_null() {
            *count = all.len() as u32;
            return code;
        }
        let room = (*count as usize).min(all.len());
        std::ptr::copy_nonoverlapping(all.as_ptr(), out, room);
        *count = room as u32;
        if room < all.len() {
            return vk::Result::INCOMPLETE;
        }
    }
    code
}

unsafe extern "system" fn properties(
    physical: vk::PhysicalDevice,
    out: *mut vk::PhysicalDeviceProperties,
) {
    // SAFETY: the caller vouches for the arguments, and what it gives is written.
    let out = unsafe {
        real::<vk::PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(
            physical, out,
        );
        &mut *out
    };
    change_properties(out);
}

fn change_properties(out: &mut vk::PhysicalDeviceProperties) {
    let out = std::cell::RefCell::new(out);
    changed(|lie| match lie {
        Lie::Properties(change) => {
            change(&mut out.borrow_mut());
            true
        }
        _ => false,
    });
}

unsafe extern "system" fn properties2(
    physical: vk::PhysicalDevice,
    out: *mut vk::PhysicalDeviceProperties2<'_>,
) {
    // SAFETY: the caller vouches for the arguments, and what it gives is written; each link
    // of its chain begins with its type and the next.
    unsafe {
        real::<vk::PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(
            physical, out,
        );
        change_properties(&mut (*out).properties);
        let mut link = (*out).p_next.cast::<vk::BaseOutStructure<'_>>();
        while !link.is_null() {
            let of = (*link).s_type;
            changed(|lie| match lie {
                Lie::Subgroup(change) if of == Subgroup::STRUCTURE_TYPE => {
                    change(&mut *link.cast());
                    true
                }
                Lie::HostMemory(change) if of == HostMemory::STRUCTURE_TYPE => {
                    change(&mut *link.cast());
                    true
                }
                Lie::Maintenance3(change) if of == Maintenance3::STRUCTURE_TYPE => {
                    change(&mut *link.cast());
                    true
                }
                _ => false,
            });
            link = (*link).p_next;
        }
    }
}

unsafe extern "system" fn features2(
    physical: vk::PhysicalDevice,
    out: *mut vk::PhysicalDeviceFeatures2<'_>,
) {
    // SAFETY: the caller vouches for the arguments, and what it gives is written.
    unsafe {
        real::<vk::PFN_vkGetPhysicalDeviceFeatures2>("vkGetPhysicalDeviceFeatures2")(physical, out);
        changed(|lie| match lie {
            Lie::Features(change) => {
                change(&mut (*out).features);
                true
            }
            _ => false,
        });
    }
}

unsafe extern "system" fn families(
    physical: vk::PhysicalDevice,
    count: *mut u32,
    out: *mut vk::QueueFamilyProperties,
) {
    // SAFETY: the caller vouches for the arguments; where it has room, so many are written.
    unsafe {
        real::<vk::PFN_vkGetPhysicalDeviceQueueFamilyProperties>(
            "vkGetPhysicalDeviceQueueFamilyProperties",
        )(physical, count, out);
        if out.is_null() {
            return;
        }
        for at in 0..*count as usize {
            changed(|lie| match lie {
                Lie::Family(change) => {
                    change(&mut *out.add(at));
                    true
                }
                _ => false,
            });
        }
    }
}

unsafe extern "system" fn memory(
    physical: vk::PhysicalDevice,
    out: *mut vk::PhysicalDeviceMemoryProperties,
) {
    // SAFETY: the caller vouches for the arguments, and what it gives is written.
    unsafe {
        real::<vk::PFN_vkGetPhysicalDeviceMemoryProperties>("vkGetPhysicalDeviceMemoryProperties")(
            physical, out,
        );
        changed(|lie| match lie {
            Lie::Memory(change) => {
                change(&mut *out);
                true
            }
            _ => false,
        });
    }
}

unsafe extern "system" fn update_descriptor_sets(
    device: vk::Device,
    count: u32,
    writes: *const vk::WriteDescriptorSet<'_>,
    copies_count: u32,
    copies: *const vk::CopyDescriptorSet<'_>,
) {
    let unbounded = |lie: &Lie| matches!(lie, Lie::Unbounded);
    let unbounded = with(|plan| plan.lies.iter().any(unbounded));
    for at in 0..count as usize {
        // SAFETY: the caller's, and valid; this host gives each write one buffer.
        let written = unsafe { &*writes.add(at) };
        // SAFETY: as above.
        let mut info = unsafe { *written.p_buffer_info };
        if unbounded {
            info.range = vk::WHOLE_SIZE;
            with(|plan| plan.lied());
        }
        let one = vk::WriteDescriptorSet {
            p_buffer_info: &info,
            ..*written
        };
        // SAFETY: the caller vouches for the rest.
        unsafe {
            real::<vk::PFN_vkUpdateDescriptorSets>("vkUpdateDescriptorSets")(
                device, 1, &one, 0, copies,
            );
        }
    }
    assert_eq!(copies_count, 0, "this host copies no descriptors");
}

unsafe extern "system" fn destroy_device(device: vk::Device, allocator: Allocator<'_>) {
    with(|plan| plan.live -= 1);
    // SAFETY: the caller vouches for the arguments.
    unsafe { real::<vk::PFN_vkDestroyDevice>("vkDestroyDevice")(device, allocator) }
}

unsafe extern "system" fn destroy_instance(instance: vk::Instance, allocator: Allocator<'_>) {
    with(|plan| plan.live -= 1);
    // SAFETY: the caller vouches for the arguments.
    unsafe { real::<vk::PFN_vkDestroyInstance>("vkDestroyInstance")(instance, allocator) }
    forget(instance);
}
