//! Which buffers a pipeline's bindings point to.

use ash::vk;
use std::fmt;
use std::sync::Arc;

use super::buffer::Buffer;
use super::device::Device;
use super::orphan::Orphan;
use super::pipeline::Pipeline;
use super::{UNIFORM_BYTES, failed, refused};
use crate::error::{Error, Result};

/// A descriptor set of its own, for [`record`](super::record) into the caller's
/// command buffers. [`Device::run`] needs none.
pub struct DescriptorSet {
    device: Arc<Device>,
    pool: vk::DescriptorPool,
    pub(super) raw: vk::DescriptorSet,
}

impl DescriptorSet {
    /// Points each binding of `pipeline` to a whole buffer.
    ///
    /// # Errors
    /// [`Error::Shader`] when the bindings are not those of the pipeline;
    /// [`Error::Arguments`] for buffers of another device;
    /// [`Error::Vulkan`] when the driver fails.
    pub fn of(
        device: &Arc<Device>,
        pipeline: &Pipeline,
        buffers: &[(u32, &Buffer)],
    ) -> Result<Self> {
        check_owner(device, pipeline, buffers)?;
        Self::build(device, pipeline, &ranges(buffers))
    }

    /// Points each binding of `pipeline` to a part of a buffer:
    /// binding, buffer, byte offset, bytes (or `vk::WHOLE_SIZE`).
    ///
    /// # Errors
    /// As for [`DescriptorSet::of`], and [`Error::Arguments`] for an offset or a
    /// range that the device cannot bind.
    ///
    /// # Safety
    /// The buffers are storage buffers of `device`, they have memory, the ranges
    /// lie within them, and they outlive every use of the set.
    pub unsafe fn new(
        device: &Arc<Device>,
        pipeline: &Pipeline,
        buffers: &[(u32, vk::Buffer, u64, u64)],
    ) -> Result<Self> {
        check_owner(device, pipeline, &[])?;
        let limits = &device.info().limits;
        for (binding, _, offset, range) in buffers {
            if offset % limits.storage_offset_alignment.max(1) != 0 {
                return Err(refused(
                    format!("binding {binding} at byte {offset}"),
                    format!(
                        "offsets are multiples of {}",
                        limits.storage_offset_alignment
                    ),
                    "move the data",
                ));
            }
            let most = limits.max_storage_buffer_range;
            if *range == 0 || (*range != vk::WHOLE_SIZE && *range > most) {
                return Err(refused(
                    format!("binding {binding} with {range} bytes"),
                    format!("the device binds 1 to {most} bytes at once"),
                    "bind a part",
                ));
            }
        }
        Self::build(device, pipeline, buffers)
    }

    /// The handle.
    #[must_use]
    pub fn raw(&self) -> vk::DescriptorSet {
        self.raw
    }

    pub(super) fn build(
        device: &Arc<Device>,
        pipeline: &Pipeline,
        buffers: &[(u32, vk::Buffer, u64, u64)],
    ) -> Result<Self> {
        check_bindings(pipeline, buffers.iter().map(|one| one.0))?;
        let sizes = pool_sizes((pipeline.bindings.len() as u32).max(1));
        let create = vk::DescriptorPoolCreateInfo::default()
            .max_sets(1)
            .pool_sizes(&sizes);
        // SAFETY: the device is alive.
        let pool = unsafe { device.raw().create_descriptor_pool(&create, None) }
            .map_err(failed("vkCreateDescriptorPool"))?;
        let mut set = Self {
            device: Arc::clone(device),
            pool,
            raw: vk::DescriptorSet::null(),
        };
        set.raw = allocate(device, pool, pipeline, buffers)?;
        Ok(set)
    }
}

impl Drop for DescriptorSet {
    fn drop(&mut self) {
        // Whoever recorded the set into a command buffer has promised that it ended before.
        self.device.discard(Orphan::Descriptors(self.pool));
    }
}

impl fmt::Debug for DescriptorSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("DescriptorSet")
            .field("raw", &self.raw)
            .finish_non_exhaustive()
    }
}

/// Room for so many buffers, whichever they are.
pub(super) fn pool_sizes(buffers: u32) -> [vk::DescriptorPoolSize; 2] {
    [
        vk::DescriptorType::STORAGE_BUFFER,
        vk::DescriptorType::UNIFORM_BUFFER,
    ]
    .map(|ty| vk::DescriptorPoolSize {
        ty,
        descriptor_count: buffers,
    })
}

/// Allocates a set from a pool with room for it, and points it to the buffers.
pub(super) fn allocate(
    device: &Device,
    pool: vk::DescriptorPool,
    pipeline: &Pipeline,
    buffers: &[(u32, vk::Buffer, u64, u64)],
) -> Result<vk::DescriptorSet> {
    check_uniforms(pipeline, buffers)?;
    let layouts = [pipeline.compiled.set_layout];
    let create = vk::DescriptorSetAllocateInfo::default()
        .descriptor_pool(pool)
        .set_layouts(&layouts);
    // SAFETY: pool and layout are of this device; nobody else uses the pool now.
    let set = unsafe { device.raw().allocate_descriptor_sets(&create) }
        .map_err(failed("vkAllocateDescriptorSets"))?
        .first()
        .copied()
        .unwrap_or_default();
    let infos: Vec<_> = buffers
        .iter()
        .map(|(_, buffer, offset, range)| {
            [vk::DescriptorBufferInfo {
                buffer: *buffer,
                offset: *offset,
                range: *range,
            }]
        })
        .collect();
    let writes: Vec<_> = infos
        .iter()
        .zip(buffers)
        .map(|(info, (binding, ..))| {
            vk::WriteDescriptorSet::default()
                .dst_set(set)
                .dst_binding(*binding)
                .descriptor_type(pipeline.descriptor_type(*binding))
                .buffer_info(info)
        })
        .collect();
    // SAFETY: the set was just made, its bindings are those of `buffers`, and the
    // infos live until the call returns.
    unsafe { device.raw().update_descriptor_sets(&writes, &[]) };
    Ok(set)
}

/// Uniform blocks must be as short as every device takes them.
fn check_uniforms(pipeline: &Pipeline, buffers: &[(u32, vk::Buffer, u64, u64)]) -> Result<()> {
    let is_uniform =
        |binding: u32| pipeline.descriptor_type(binding) == vk::DescriptorType::UNIFORM_BUFFER;
    let long = buffers
        .iter()
        .find(|(binding, _, _, range)| is_uniform(*binding) && *range > UNIFORM_BYTES);
    match long {
        None => Ok(()),
        Some((binding, ..)) => Err(Error::Shader {
            shader: pipeline.name().to_owned(),
            problem: format!(
                "binding {binding} is a uniform block: give it a buffer of at most \
                 {UNIFORM_BYTES} bytes"
            ),
        }),
    }
}

/// The whole of each buffer.
pub(super) fn ranges(buffers: &[(u32, &Buffer)]) -> Vec<(u32, vk::Buffer, u64, u64)> {
    buffers
        .iter()
        .map(|(binding, buffer)| (*binding, buffer.raw(), 0, buffer.bytes()))
        .collect()
}

/// Pipeline and buffers must come from this very device.
pub(super) fn check_owner(
    device: &Device,
    pipeline: &Pipeline,
    buffers: &[(u32, &Buffer)],
) -> Result<()> {
    let ours = |other: &Arc<Device>| std::ptr::eq(Arc::as_ptr(other), device);
    if ours(pipeline.device()) && buffers.iter().all(|(_, buffer)| ours(buffer.device())) {
        return Ok(());
    }
    Err(refused(
        format!(
            "pipeline {} on device {}",
            pipeline.name(),
            device.info().name
        ),
        "it or one of its buffers was made on another device",
        "make all of them on one device",
    ))
}

/// The bindings given must be those of the pipeline, each once.
pub(super) fn check_bindings(
    pipeline: &Pipeline,
    given: impl ExactSizeIterator<Item = u32> + Clone,
) -> Result<()> {
    let complete = given.len() == pipeline.bindings.len()
        && pipeline
            .bindings
            .iter()
            .all(|binding| given.clone().any(|one| one == *binding));
    if complete {
        return Ok(());
    }
    Err(Error::Shader {
        shader: pipeline.name().to_owned(),
        problem: format!(
            "it binds {:?}, and buffers were given for {:?}: give each binding one buffer",
            pipeline.bindings,
            given.collect::<Vec<_>>()
        ),
    })
}
