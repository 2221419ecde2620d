//! Compute pipelines.

use ash::vk;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Instant;

use super::baseline::inadequate;
use super::device::{Device, nanoseconds};
use super::kept::{Compiled, key};
use super::orphan::Orphan;
use super::{MAX_BINDINGS, failed};
use crate::error::{Error, Result};

/// The first word of every SPIR-V module.
const SPIRV_MAGIC: u32 = 0x0723_0203;

/// A compute shader and how it is called.
#[derive(Clone, Copy, Debug)]
pub struct PipelineDescription<'a> {
    /// For messages.
    pub name: &'a str,
    /// The module; its entry point is `main`.
    pub spirv: &'a [u32],
    /// Binding numbers of the buffers, all in set 0.
    pub bindings: &'a [u32],
    /// Bytes of the push-constant block.
    pub push_constant_bytes: u32,
    /// Specialization constants: id and the value's 32 bits.
    pub specialization: &'a [(u32, u32)],
}

/// A compiled compute shader.
pub struct Pipeline {
    device: Arc<Device>,
    name: String,
    pub(super) compiled: Compiled,
    /// Else the device keeps what was compiled.
    owned: bool,
    pub(super) bindings: Vec<u32>,
    pub(super) uniforms: Vec<u32>,
    pub(super) push_constant_bytes: u32,
}

impl Pipeline {
    /// Compiles a shader for a device. The SPIR-V must be valid: drivers do not
    /// check it.
    ///
    /// # Errors
    /// [`Error::Shader`] for words that are no SPIR-V module, or for a binding
    /// given twice; [`Error::InadequateDevice`] past the device's limits;
    /// [`Error::Vulkan`] when the driver fails.
    pub fn new(device: &Arc<Device>, description: &PipelineDescription<'_>) -> Result<Self> {
        Self::with_uniforms(device, description, &[])
    }

    /// The same where these of the bindings are uniform blocks, of at most
    /// [`UNIFORM_BYTES`](super::UNIFORM_BYTES) each, and the others storage buffers.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn with_uniforms(
        device: &Arc<Device>,
        description: &PipelineDescription<'_>,
        uniforms: &[u32],
    ) -> Result<Self> {
        check(device, description)?;
        let mut pipeline = Self {
            device: Arc::clone(device),
            name: description.name.to_owned(),
            compiled: Compiled::default(),
            owned: true,
            bindings: description.bindings.to_vec(),
            uniforms: uniforms.to_vec(),
            push_constant_bytes: description.push_constant_bytes,
        };
        let key = key(description, uniforms);
        if let Some(kept) = device.kept(&key) {
            (pipeline.compiled, pipeline.owned) = (kept, false);
            return Ok(pipeline);
        }
        let start = Instant::now();
        // On an error, dropping `pipeline` destroys what was made.
        pipeline.create_layout()?;
        let create = vk::ShaderModuleCreateInfo::default().code(description.spirv);
        // SAFETY: the device is alive; the caller vouches for the words.
        let module = unsafe { device.raw().create_shader_module(&create, None) }
            .map_err(failed("vkCreateShaderModule"))?;
        let compiled = pipeline.compile(module, description.specialization);
        // SAFETY: pipelines need their module no longer once they are made.
        unsafe { device.raw().destroy_shader_module(module, None) };
        pipeline.compiled.raw = compiled?;
        let taken = nanoseconds(start.elapsed());
        device.pipelines.fetch_add(taken, Ordering::Relaxed);
        pipeline.owned = !device.keep(key, pipeline.compiled);
        Ok(pipeline)
    }

    /// The name given in the description.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The handle, for command buffers of the caller.
    #[must_use]
    pub fn raw(&self) -> vk::Pipeline {
        self.compiled.raw
    }

    /// What is bound there.
    pub(super) fn descriptor_type(&self, binding: u32) -> vk::DescriptorType {
        if self.uniforms.contains(&binding) {
            vk::DescriptorType::UNIFORM_BUFFER
        } else {
            vk::DescriptorType::STORAGE_BUFFER
        }
    }

    /// The layout: set 0 with the buffers, and the push constants.
    #[must_use]
    pub fn layout(&self) -> vk::PipelineLayout {
        self.compiled.layout
    }

    pub(super) fn device(&self) -> &Arc<Device> {
        &self.device
    }

    fn create_layout(&mut self) -> Result<()> {
        let raw = self.device.raw();
        let bindings: Vec<_> = self
            .bindings
            .iter()
            .map(|binding| {
                vk::DescriptorSetLayoutBinding::default()
                    .binding(*binding)
                    .descriptor_type(self.descriptor_type(*binding))
                    .descriptor_count(1)
                    .stage_flags(vk::ShaderStageFlags::COMPUTE)
            })
            .collect();
        let create = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
        // SAFETY: the device is alive, and the bindings are distinct.
        self.compiled.set_layout = unsafe { raw.create_descriptor_set_layout(&create, None) }
            .map_err(failed("vkCreateDescriptorSetLayout"))?;
        let sets = [self.compiled.set_layout];
        let push = [vk::PushConstantRange {
            stage_flags: vk::ShaderStageFlags::COMPUTE,
            offset: 0,
            size: self.push_constant_bytes,
        }];
        let mut create = vk::PipelineLayoutCreateInfo::default().set_layouts(&sets);
        if self.push_constant_bytes > 0 {
            create = create.push_constant_ranges(&push);
        }
        // SAFETY: the set layout was just made, and the range is within the limit.
        self.compiled.layout = unsafe { raw.create_pipeline_layout(&create, None) }
            .map_err(failed("vkCreatePipelineLayout"))?;
        Ok(())
    }

    fn compile(&self, module: vk::ShaderModule, constants: &[(u32, u32)]) -> Result<vk::Pipeline> {
        let entries: Vec<_> = (0u32..)
            .zip(constants)
            .map(|(at, (id, _))| vk::SpecializationMapEntry {
                constant_id: *id,
                offset: at * 4,
                size: 4,
            })
            .collect();
        let values: Vec<u8> = constants
            .iter()
            .flat_map(|(_, value)| value.to_ne_bytes())
            .collect();
        let specialization = vk::SpecializationInfo::default()
            .map_entries(&entries)
            .data(&values);
        let stage = vk::PipelineShaderStageCreateInfo::default()
            .stage(vk::ShaderStageFlags::COMPUTE)
            .module(module)
            .name(c"main")
            .specialization_info(&specialization);
        let create = [vk::ComputePipelineCreateInfo::default()
            .stage(stage)
            .layout(self.compiled.layout)];
        // SAFETY: module and layout are of this device and alive, and all that
        // `create` points to lives until the call returns.
        let made = unsafe {
            self.device
                .raw()
                .create_compute_pipelines(vk::PipelineCache::null(), &create, None)
        };
        let made = made.map_err(|(_, code)| failed("vkCreateComputePipelines")(code))?;
        Ok(made.first().copied().unwrap_or_default())
    }
}

impl Drop for Pipeline {
    fn drop(&mut self) {
        if self.owned {
            self.device.discard(Orphan::Pipeline(self.compiled));
        }
    }
}

impl fmt::Debug for Pipeline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Pipeline")
            .field("name", &self.name)
            .finish_non_exhaustive()
    }
}

fn check(device: &Device, description: &PipelineDescription<'_>) -> Result<()> {
    let (name, info) = (description.name, device.info());
    let wrong = |problem: String| {
        Err(Error::Shader {
            shader: name.to_owned(),
            problem,
        })
    };
    if description.spirv.first() != Some(&SPIRV_MAGIC) || description.spirv.len() < 5 {
        return wrong("the words are no SPIR-V module".to_owned());
    }
    let bindings = description.bindings;
    if let Some(twice) = (1..bindings.len()).find(|at| bindings[..*at].contains(&bindings[*at])) {
        return wrong(format!("binding {} is given twice", bindings[twice]));
    }
    let constants = description.specialization;
    if let Some(twice) =
        (1..constants.len()).find(|at| constants[..*at].iter().any(|c| c.0 == constants[*at].0))
    {
        return wrong(format!(
            "specialization constant {} is given twice",
            constants[twice].0
        ));
    }
    if !description.push_constant_bytes.is_multiple_of(4) {
        let bytes = description.push_constant_bytes;
        return wrong(format!(
            "{bytes} bytes of push constants are not whole words"
        ));
    }
    let most = MAX_BINDINGS.min(info.limits.max_storage_buffers as usize);
    if bindings.len() > most {
        let problem = format!(
            "{name} binds {} storage buffers; the most is {most}",
            bindings.len()
        );
        return Err(inadequate(info, problem));
    }
    if description.push_constant_bytes > info.limits.max_push_constants {
        return Err(inadequate(
            info,
            format!(
                "{name} takes {} bytes of push constants; the most is {}",
                description.push_constant_bytes, info.limits.max_push_constants
            ),
        ));
    }
    Ok(())
}
