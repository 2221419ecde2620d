//! Memory of the host as memory of a buffer: `VK_EXT_external_memory_host`.

use ash::vk;
use std::sync::Arc;

use super::device::Device;
use super::mapping::Mapping;
use super::memory::Block;
use super::{failed, refused};
use crate::error::{Error, Result};

use vk::MemoryPropertyFlags as Flags;

const KIND: vk::ExternalMemoryHandleTypeFlags =
    vk::ExternalMemoryHandleTypeFlags::HOST_ALLOCATION_EXT;

/// What an open device has of the extension.
pub(super) struct Import {
    functions: ash::ext::external_memory_host::Device,
    /// Addresses and lengths are multiples of it.
    alignment: u64,
    /// Whether a buffer can have such memory.
    can: bool,
}

impl Import {
    /// Asks a device that was opened with the extension.
    pub(super) fn of(
        instance: &ash::Instance,
        raw: &ash::Device,
        physical: vk::PhysicalDevice,
    ) -> Self {
        let mut host = vk::PhysicalDeviceExternalMemoryHostPropertiesEXT::default();
        let mut properties = vk::PhysicalDeviceProperties2::default().push_next(&mut host);
        let buffer = vk::PhysicalDeviceExternalBufferInfo::default()
            .usage(usage())
            .handle_type(KIND);
        let mut external = vk::ExternalBufferProperties::default();
        // SAFETY: the device is of the instance, both are of Vulkan 1.1 at least, and the device
        // knows the structure that is chained.
        unsafe {
            instance.get_physical_device_properties2(physical, &mut properties);
            instance.get_physical_device_external_buffer_properties(
                physical,
                &buffer,
                &mut external,
            );
        }
        let features = external.external_memory_properties.external_memory_features;
        Self {
            functions: ash::ext::external_memory_host::Device::new(instance, raw),
            alignment: host.min_imported_host_pointer_alignment.max(1),
            can: features.contains(vk::ExternalMemoryFeatureFlags::IMPORTABLE)
                && !features.contains(vk::ExternalMemoryFeatureFlags::DEDICATED_ONLY),
        }
    }

    /// Bytes to map for so many.
    pub(super) fn length(&self, bytes: u64) -> u64 {
        // No file is so long that there is none.
        let whole = bytes.checked_next_multiple_of(self.alignment);
        whole.unwrap_or(bytes)
    }

    /// Memory types that pages of the host can be of, a bit each.
    fn types(&self, device: &Device, mapping: &Mapping) -> Result<u32> {
        let mut said = vk::MemoryHostPointerPropertiesEXT::default();
        // SAFETY: the device has the extension; the address is that of pages of the host, and
        // aligned.
        let code = unsafe {
            (self.functions.fp().get_memory_host_pointer_properties_ext)(
                device.raw().handle(),
                KIND,
                mapping.at().as_ptr().cast(),
                &mut said,
            )
        };
        match code {
            vk::Result::SUCCESS => Ok(said.memory_type_bits),
            code => Err(failed("vkGetMemoryHostPointerPropertiesEXT")(code)),
        }
    }
}

fn usage() -> vk::BufferUsageFlags {
    vk::BufferUsageFlags::STORAGE_BUFFER
        | vk::BufferUsageFlags::TRANSFER_SRC
        | vk::BufferUsageFlags::TRANSFER_DST
}

impl Block {
    /// Makes a buffer of `bytes` whose memory is the mapping, which is at least as long.
    pub(super) fn import(device: &Arc<Device>, mapping: Mapping, bytes: u64) -> Result<Self> {
        let (at, length) = (mapping.at(), mapping.bytes());
        let refused = |limit: &str| self::refused_by(device, bytes, limit);
        let import = offered(device, bytes)?;
        if !length.is_multiple_of(import.alignment)
            || !(at.addr().get() as u64).is_multiple_of(import.alignment)
        {
            return Err(refused("does not import memory that begins or ends there"));
        }
        let types = import.types(device, &mapping)?;
        let mut block = Self::empty(device, bytes);
        block.backing = Some(mapping);
        let raw = device.raw();
        let mut external = vk::ExternalMemoryBufferCreateInfo::default().handle_types(KIND);
        let create = vk::BufferCreateInfo::default()
            .size(bytes)
            .usage(usage())
            .sharing_mode(vk::SharingMode::EXCLUSIVE)
            .push_next(&mut external);
        // SAFETY: the device is alive and can import for such a buffer; on an error below,
        // dropping `block` destroys what was made, and unmaps.
        block.raw =
            unsafe { raw.create_buffer(&create, None) }.map_err(failed("vkCreateBuffer"))?;
        // SAFETY: the buffer was just made.
        let needs = unsafe { raw.get_buffer_memory_requirements(block.raw) };
        if needs.size > length || length > device.info().limits.max_allocation {
            return Err(refused(
                "needs more memory for it than that, or allocates less",
            ));
        }
        let index = choose(
            device.memory.memory_types_as_slice(),
            types & needs.memory_type_bits,
        )
        .ok_or_else(|| refused("has no coherent memory of such a kind"))?;
        let mut pages = vk::ImportMemoryHostPointerInfoEXT::default()
            .handle_type(KIND)
            .host_pointer(at.as_ptr().cast());
        let allocate = vk::MemoryAllocateInfo::default()
            .allocation_size(length)
            .memory_type_index(index)
            .push_next(&mut pages);
        // SAFETY: the pages are mapped for as long as `block` has the memory; address and length
        // are aligned; the type is one that pages and buffer allow; the memory is bound once, at
        // offset 0, and is as long as the buffer needs.
        unsafe {
            block.memory = raw
                .allocate_memory(&allocate, None)
                .map_err(failed("vkAllocateMemory"))?;
            raw.bind_buffer_memory(block.raw, block.memory, 0)
                .map_err(failed("vkBindBufferMemory"))?;
        }
        Ok(block)
    }
}

/// The extension, where buffers can have memory by it.
pub(super) fn offered(device: &Device, bytes: u64) -> Result<&Import> {
    let most = device.info().limits.max_storage_buffer_range;
    if bytes > most {
        let limit = format!("binds at most {most} bytes at once");
        return Err(refused_by(device, bytes, &limit));
    }
    let limit = match &device.import {
        Some(import) if import.can => return Ok(import),
        Some(_) => "imports no memory of the host for storage buffers",
        None => "was not opened with VK_EXT_external_memory_host",
    };
    Err(refused_by(device, bytes, limit))
}

fn refused_by(device: &Device, bytes: u64, limit: &str) -> Error {
    refused(
        format!("a window of {bytes} bytes of a file"),
        format!("device {} {limit}", device.info().name),
        "make a buffer, and write what it holds to the file",
    )
}

/// What the device writes into coherent memory is in the file without a further word.
fn choose(types: &[vk::MemoryType], allowed: u32) -> Option<u32> {
    let wanted = Flags::HOST_VISIBLE | Flags::HOST_COHERENT;
    let fits = |(index, one): &(u32, &vk::MemoryType)| {
        allowed >> index & 1 == 1 && one.property_flags.contains(wanted)
    };
    (0u32..).zip(types).find(fits).map(|(index, _)| index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_coherent_memory_that_is_allowed_is_chosen() {
        let types = [
            Flags::DEVICE_LOCAL,
            Flags::HOST_VISIBLE | Flags::HOST_CACHED,
            Flags::HOST_VISIBLE | Flags::HOST_COHERENT,
            Flags::DEVICE_LOCAL | Flags::HOST_VISIBLE | Flags::HOST_COHERENT,
        ]
        .map(|property_flags| vk::MemoryType {
            property_flags,
            heap_index: 0,
        });
        assert_eq!(choose(&types, 0b1111), Some(2));
        assert_eq!(choose(&types, 0b1011), Some(3));
        assert_eq!(choose(&types, 0b0011), None);
        assert_eq!(choose(&types, 0), None);
    }
}
