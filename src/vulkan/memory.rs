//! One buffer with memory of its own, mapped where the host can see it, or of a file.

use ash::vk;
use std::ptr::NonNull;
use std::sync::Arc;

use super::device::Device;
use super::info::DeviceKind;
use super::mapping::Mapping;
use super::orphan::Orphan;
use super::{failed, refused};
use crate::error::Result;

use vk::MemoryPropertyFlags as Flags;

/// What the memory of a buffer is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// Shaders use it, and the host mostly writes it.
    Upload,
    /// Shaders use it, and the host mostly reads it.
    Readback,
    /// Only the device uses it.
    DeviceOnly,
    /// Only copies from and to the device use it.
    Staging,
}

/// A `VkBuffer`, its memory, and the mapping if there is one.
pub(super) struct Block {
    device: Arc<Device>,
    pub(super) raw: vk::Buffer,
    pub(super) memory: vk::DeviceMemory,
    bytes: u64,
    allocated: u64,
    map: Option<NonNull<u8>>,
    coherent: bool,
    /// The part of a file that is its memory; none where it has its own.
    pub(super) backing: Option<Mapping>,
}

// SAFETY: the mapping is plain memory that belongs to this block alone; shared
// references never hand it out mutably.
unsafe impl Send for Block {}
// SAFETY: as above.
unsafe impl Sync for Block {}

impl Block {
    /// Neither a buffer nor memory yet: what is put in is destroyed with it.
    pub(super) fn empty(device: &Arc<Device>, bytes: u64) -> Self {
        Self {
            device: Arc::clone(device),
            raw: vk::Buffer::null(),
            memory: vk::DeviceMemory::null(),
            bytes,
            allocated: 0,
            map: None,
            coherent: true,
            backing: None,
        }
    }

    /// Makes a buffer of at least `bytes`, with contents unspecified.
    pub(super) fn new(device: &Arc<Device>, bytes: u64, purpose: Purpose) -> Result<Self> {
        let mut block = Self::empty(device, bytes);
        let raw = device.raw();
        let mut usage = vk::BufferUsageFlags::TRANSFER_SRC | vk::BufferUsageFlags::TRANSFER_DST;
        if purpose != Purpose::Staging {
            usage |= vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::UNIFORM_BUFFER;
        }
        let create = vk::BufferCreateInfo::default()
            .size(bytes)
            .usage(usage)
            .sharing_mode(vk::SharingMode::EXCLUSIVE);
        // SAFETY: the device is alive; on an error below, dropping `block`
        // destroys what was made.
        block.raw =
            unsafe { raw.create_buffer(&create, None) }.map_err(failed("vkCreateBuffer"))?;
        // SAFETY: the buffer was just made.
        let needs = unsafe { raw.get_buffer_memory_requirements(block.raw) };
        let most = device.info().limits.max_allocation;
        if needs.size > most {
            return Err(refused(
                format!("a buffer of {bytes} bytes"),
                format!(
                    "device {} allocates at most {most} bytes at once",
                    device.info().name
                ),
                "use a smaller one, several times",
            ));
        }
        let types = device.memory.memory_types_as_slice();
        let (index, mapped) = choose(types, needs.memory_type_bits, device.info().kind, purpose)
            .ok_or_else(|| failed("vkAllocateMemory")(vk::Result::ERROR_FEATURE_NOT_PRESENT))?;
        let allocate = vk::MemoryAllocateInfo::default()
            .allocation_size(needs.size)
            .memory_type_index(index);
        // SAFETY: the size is within the device's limit, the type is one that the
        // buffer allows, and the memory is bound once, at offset 0.
        unsafe {
            block.memory = raw
                .allocate_memory(&allocate, None)
                .map_err(failed("vkAllocateMemory"))?;
            raw.bind_buffer_memory(block.raw, block.memory, 0)
                .map_err(failed("vkBindBufferMemory"))?;
        }
        block.allocated = needs.size;
        if mapped {
            // SAFETY: the type is host-visible, and the memory is not mapped yet.
            let map = unsafe {
                raw.map_memory(block.memory, 0, vk::WHOLE_SIZE, vk::MemoryMapFlags::empty())
            }
            .map_err(failed("vkMapMemory"))?;
            // Whoever asks for a mapping relies on it.
            let map = NonNull::new(map.cast())
                .ok_or_else(|| failed("vkMapMemory")(vk::Result::ERROR_MEMORY_MAP_FAILED))?;
            block.map = Some(map);
            block.coherent = types
                .get(index as usize)
                .is_some_and(|one| one.property_flags.contains(Flags::HOST_COHERENT));
        }
        Ok(block)
    }

    pub(super) fn bytes(&self) -> u64 {
        self.bytes
    }

    pub(super) fn is_mapped(&self) -> bool {
        self.map.is_some()
    }

    /// Makes the device's writes visible, then shows the mapped bytes.
    /// The range must lie within the buffer, and nothing may be running on it.
    pub(super) fn mapped(&mut self, offset: u64, length: u64) -> Result<&[u8]> {
        self.sync(offset, length, false)?;
        Ok(self.slice(offset, length))
    }

    /// Lets `fill` write the mapped bytes, then makes them visible to the device.
    /// The range must lie within the buffer, and nothing may be running on it.
    pub(super) fn fill(
        &mut self,
        offset: u64,
        length: u64,
        fill: impl FnOnce(&mut [u8]),
    ) -> Result<()> {
        fill(self.slice(offset, length));
        self.sync(offset, length, true)
    }

    fn slice(&mut self, offset: u64, length: u64) -> &mut [u8] {
        let end = offset.checked_add(length).filter(|end| *end <= self.bytes);
        let (Some(map), Some(_)) = (self.map, end) else {
            return &mut [];
        };
        // SAFETY: the range lies within the mapping (and thus fits `usize`), which
        // lives as long as `self`; `&mut self` makes the access exclusive: what is
        // in flight holds a slice of the block, and all else has ended whenever a
        // safe method returns. The bytes come from outside Rust, so each has some
        // value.
        unsafe {
            std::slice::from_raw_parts_mut(map.as_ptr().add(offset as usize), length as usize)
        }
    }

    /// Flushes (`write`) or invalidates a range of memory that is not coherent.
    fn sync(&self, offset: u64, length: u64, write: bool) -> Result<()> {
        if self.coherent || length == 0 {
            return Ok(());
        }
        let (offset, size) = atom_range(
            offset,
            length,
            self.device.non_coherent_atom,
            self.allocated,
        );
        let range = [vk::MappedMemoryRange::default()
            .memory(self.memory)
            .offset(offset)
            .size(size)];
        // SAFETY: the memory is mapped, and the range is aligned as it must be.
        unsafe {
            if write {
                self.device
                    .raw()
                    .flush_mapped_memory_ranges(&range)
                    .map_err(failed("vkFlushMappedMemoryRanges"))
            } else {
                self.device
                    .raw()
                    .invalidate_mapped_memory_ranges(&range)
                    .map_err(failed("vkInvalidateMappedMemoryRanges"))
            }
        }
    }
}

impl Drop for Block {
    fn drop(&mut self) {
        let backing = self.backing.take();
        self.device
            .discard(Orphan::Block(self.raw, self.memory, backing));
    }
}

/// The memory type for a purpose, and whether to map it. On CPU drivers and
/// integrated devices all memory is the device's own, so buffers are mapped;
/// elsewhere reading over the bus is slow, so they are copied.
fn choose(
    types: &[vk::MemoryType],
    allowed: u32,
    kind: DeviceKind,
    purpose: Purpose,
) -> Option<(u32, bool)> {
    let odd = Flags::PROTECTED
        | Flags::LAZILY_ALLOCATED
        | Flags::DEVICE_COHERENT_AMD
        | Flags::DEVICE_UNCACHED_AMD
        | Flags::RDMA_CAPABLE_NV;
    let first = |wishes: &[Flags]| {
        wishes.iter().find_map(|wish| {
            (0u32..).zip(types).find_map(|(index, one)| {
                let fits = allowed >> index & 1 == 1
                    && one.property_flags.contains(*wish)
                    && !one.property_flags.intersects(odd);
                fits.then_some(index)
            })
        })
    };
    let (local, visible) = (Flags::DEVICE_LOCAL, Flags::HOST_VISIBLE);
    let (cached, coherent) = (Flags::HOST_CACHED, Flags::HOST_COHERENT);
    let shared = matches!(kind, DeviceKind::Cpu | DeviceKind::Integrated);
    let mapped: &[Flags] = match purpose {
        Purpose::Staging => &[
            visible | cached | coherent,
            visible | cached,
            visible | coherent,
            visible,
        ],
        Purpose::Upload if shared => &[local | visible | coherent, local | visible],
        // Reading uncached memory is slower than copying it.
        Purpose::Readback if shared => &[
            local | visible | cached | coherent,
            local | visible | cached,
        ],
        _ => &[],
    };
    if let Some(index) = first(mapped) {
        return Some((index, true));
    }
    if purpose == Purpose::Staging {
        return None;
    }
    first(&[local, Flags::empty()]).map(|index| (index, false))
}

/// Widens a range to whole atoms, or to the end of the allocation.
fn atom_range(offset: u64, length: u64, atom: u64, allocated: u64) -> (u64, u64) {
    let begin = offset / atom * atom;
    match (offset + length).checked_next_multiple_of(atom) {
        Some(end) if end < allocated => (begin, end - begin),
        _ => (begin, vk::WHOLE_SIZE),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn types(flags: &[Flags]) -> Vec<vk::MemoryType> {
        let one = |flags: &Flags| vk::MemoryType {
            property_flags: *flags,
            heap_index: 0,
        };
        flags.iter().map(one).collect()
    }

    const L: Flags = Flags::DEVICE_LOCAL;
    const V: Flags = Flags::HOST_VISIBLE;
    const C: Flags = Flags::HOST_COHERENT;
    const K: Flags = Flags::HOST_CACHED;

    #[test]
    fn a_card_is_copied_from_and_to() {
        let card = types(&[L, V | C, L | V | C, V | C | K]);
        let get = |purpose| choose(&card, 0b1111, DeviceKind::Discrete, purpose);
        assert_eq!(get(Purpose::Upload), Some((0, false)));
        assert_eq!(get(Purpose::Readback), Some((0, false)));
        assert_eq!(get(Purpose::DeviceOnly), Some((0, false)));
        assert_eq!(get(Purpose::Staging), Some((3, true)));
        assert_eq!(
            choose(&card, 0b0010, DeviceKind::Discrete, Purpose::Upload),
            Some((1, false))
        );
        assert_eq!(
            choose(&card, 0b0001, DeviceKind::Discrete, Purpose::Staging),
            None
        );
    }

    #[test]
    fn shared_memory_is_mapped_unless_reading_is_slow() {
        let cached = types(&[L | V | C, L | V | C | K]);
        let get = |purpose| choose(&cached, 0b11, DeviceKind::Integrated, purpose);
        assert_eq!(get(Purpose::Upload), Some((0, true)));
        assert_eq!(get(Purpose::Readback), Some((1, true)));
        let uncached = types(&[L | V | C, V | K]);
        let get = |purpose| choose(&uncached, 0b11, DeviceKind::Integrated, purpose);
        assert_eq!(get(Purpose::Readback), Some((0, false)));
        assert_eq!(get(Purpose::Staging), Some((1, true)));
    }

    #[test]
    fn odd_types_are_left_alone() {
        let odd = types(&[
            L | Flags::PROTECTED,
            L | V | C | Flags::DEVICE_COHERENT_AMD,
            L,
        ]);
        assert_eq!(
            choose(&odd, 0b111, DeviceKind::Cpu, Purpose::Upload),
            Some((2, false))
        );
        assert_eq!(choose(&[], 0, DeviceKind::Cpu, Purpose::DeviceOnly), None);
    }

    #[test]
    fn ranges_grow_to_whole_atoms() {
        assert_eq!(atom_range(0, 4, 64, 1024), (0, 64));
        assert_eq!(atom_range(70, 100, 64, 1024), (64, 128));
        assert_eq!(atom_range(64, 64, 64, 1024), (64, 64));
        assert_eq!(atom_range(900, 100, 64, 1000), (896, vk::WHOLE_SIZE));
        assert_eq!(atom_range(0, 1024, 64, 1024), (0, vk::WHOLE_SIZE));
    }
}
