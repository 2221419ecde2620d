//! Asks a physical device for its [`DeviceInfo`].

use ash::vk;
use std::ffi::CStr;

use super::failed;
use super::info::{DeviceInfo, DeviceKind, Features, FloatControls, Limits};
use crate::error::Result;

/// Fills a [`DeviceInfo`]. Needs an instance of Vulkan 1.1 or later.
pub(super) fn device_info(
    instance: &ash::Instance,
    physical: vk::PhysicalDevice,
    index: usize,
) -> Result<DeviceInfo> {
    // SAFETY: `physical` comes from `instance`, which is alive.
    let base = unsafe { instance.get_physical_device_properties(physical) };
    let extensions = extensions(instance, physical)?;
    let has = |name: &CStr| {
        extensions
            .iter()
            .any(|e| e.extension_name_as_c_str() == Ok(name))
    };
    let v1_1 = base.api_version >= vk::API_VERSION_1_1;
    let v1_2 = base.api_version >= vk::API_VERSION_1_2;

    let mut id = vk::PhysicalDeviceIDProperties::default();
    let mut subgroup = vk::PhysicalDeviceSubgroupProperties::default();
    let mut maintenance3 = vk::PhysicalDeviceMaintenance3Properties::default();
    let mut driver = vk::PhysicalDeviceDriverProperties::default();
    let mut floats = vk::PhysicalDeviceFloatControlsProperties::default();
    let mut half = vk::PhysicalDeviceShaderFloat16Int8Features::default();
    let core;
    if v1_1 {
        let mut properties = vk::PhysicalDeviceProperties2::default()
            .push_next(&mut id)
            .push_next(&mut subgroup)
            .push_next(&mut maintenance3);
        if v1_2 || has(ash::khr::driver_properties::NAME) {
            properties = properties.push_next(&mut driver);
        }
        if v1_2 || has(ash::khr::shader_float_controls::NAME) {
            properties = properties.push_next(&mut floats);
        }
        let mut features = vk::PhysicalDeviceFeatures2::default();
        if v1_2 || has(ash::khr::shader_float16_int8::NAME) {
            features = features.push_next(&mut half);
        }
        // SAFETY: both devices and instance are of Vulkan 1.1 at least, and only
        // structures that the device knows are chained.
        unsafe {
            instance.get_physical_device_properties2(physical, &mut properties);
            instance.get_physical_device_features2(physical, &mut features);
        }
        core = features.features;
    } else {
        // SAFETY: as for the first call.
        core = unsafe { instance.get_physical_device_features(physical) };
    }

    // SAFETY: as for the first call.
    let memory = unsafe { instance.get_physical_device_memory_properties(physical) };
    let memory_bytes = memory
        .memory_heaps_as_slice()
        .iter()
        .filter(|h| h.flags.contains(vk::MemoryHeapFlags::DEVICE_LOCAL))
        .map(|h| h.size)
        .max()
        .unwrap_or(0);
    let timestamp_valid_bits =
        compute_family(instance, physical).map_or(0, |(_, valid_bits)| valid_bits);
    let l = &base.limits;
    Ok(DeviceInfo {
        index,
        name: text(base.device_name_as_c_str()),
        kind: kind(base.device_type),
        vendor_id: base.vendor_id,
        device_id: base.device_id,
        api_version: version(base.api_version),
        driver_name: text(driver.driver_name_as_c_str()),
        driver_info: text(driver.driver_info_as_c_str()),
        driver_version: base.driver_version,
        device_uuid: hex(&id.device_uuid),
        driver_uuid: hex(&id.driver_uuid),
        limits: Limits {
            max_storage_buffer_range: u64::from(l.max_storage_buffer_range),
            max_push_constants: l.max_push_constants_size,
            max_group_invocations: l.max_compute_work_group_invocations,
            max_group_size: l.max_compute_work_group_size,
            max_group_count: l.max_compute_work_group_count,
            max_storage_buffers: l
                .max_per_stage_descriptor_storage_buffers
                .min(l.max_descriptor_set_storage_buffers),
            storage_offset_alignment: l.min_storage_buffer_offset_alignment,
            timestamp_period_ns: l.timestamp_period,
            timestamp_valid_bits,
            subgroup_size: subgroup.subgroup_size,
            // Vulkan 1.0 has no such limit; 2^30 is what 1.1 guarantees.
            max_allocation: match maintenance3.max_memory_allocation_size {
                0 => 1 << 30,
                bytes => bytes,
            },
            memory_bytes,
        },
        features: Features {
            float64: core.shader_float64 != 0,
            int64: core.shader_int64 != 0,
            int16: core.shader_int16 != 0,
            float16: half.shader_float16 != 0,
            external_memory_host: has(ash::ext::external_memory_host::NAME),
        },
        float_controls: FloatControls {
            rte: floats.shader_rounding_mode_rte_float32 != 0,
            rtz: floats.shader_rounding_mode_rtz_float32 != 0,
            denorm_preserve: floats.shader_denorm_preserve_float32 != 0,
            denorm_flush: floats.shader_denorm_flush_to_zero_float32 != 0,
            signed_zero_inf_nan_preserve: floats.shader_signed_zero_inf_nan_preserve_float32 != 0,
        },
    })
}

/// The device extensions of `physical`.
pub(super) fn extensions(
    instance: &ash::Instance,
    physical: vk::PhysicalDevice,
) -> Result<Vec<vk::ExtensionProperties>> {
    // SAFETY: `physical` comes from `instance`, which is alive.
    unsafe { instance.enumerate_device_extension_properties(physical) }
        .map_err(failed("vkEnumerateDeviceExtensionProperties"))
}

/// The first compute queue family, one with timestamps if there is one, and
/// its valid timestamp bits.
pub(super) fn compute_family(
    instance: &ash::Instance,
    physical: vk::PhysicalDevice,
) -> Option<(u32, u32)> {
    // SAFETY: `physical` comes from `instance`, which is alive.
    let families = unsafe { instance.get_physical_device_queue_family_properties(physical) };
    let compute = || {
        (0u32..).zip(&families).filter(|(_, family)| {
            family.queue_count > 0 && family.queue_flags.contains(vk::QueueFlags::COMPUTE)
        })
    };
    compute()
        .find(|(_, family)| family.timestamp_valid_bits > 0)
        .or_else(|| compute().next())
        .map(|(index, family)| (index, family.timestamp_valid_bits))
}

/// Major, minor and patch of a packed version.
pub(super) fn version(packed: u32) -> (u32, u32, u32) {
    (
        vk::api_version_major(packed),
        vk::api_version_minor(packed),
        vk::api_version_patch(packed),
    )
}

fn kind(device_type: vk::PhysicalDeviceType) -> DeviceKind {
    match device_type {
        vk::PhysicalDeviceType::DISCRETE_GPU => DeviceKind::Discrete,
        vk::PhysicalDeviceType::INTEGRATED_GPU => DeviceKind::Integrated,
        vk::PhysicalDeviceType::VIRTUAL_GPU => DeviceKind::Virtual,
        vk::PhysicalDeviceType::CPU => DeviceKind::Cpu,
        _ => DeviceKind::Other,
    }
}

fn text<E>(name: std::result::Result<&CStr, E>) -> String {
    name.map_or_else(
        |_| String::new(),
        |name| name.to_string_lossy().into_owned(),
    )
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
