//! Compiled pipelines that a device keeps.

use ash::vk;
use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::sync::PoisonError;

use super::device::Device;
use super::pipeline::PipelineDescription;

/// The objects of a pipeline; null where they were not made.
#[derive(Clone, Copy, Default)]
pub(super) struct Compiled {
    pub(super) raw: vk::Pipeline,
    pub(super) layout: vk::PipelineLayout,
    pub(super) set_layout: vk::DescriptorSetLayout,
}

/// What a device keeps, by the hash of all that it was made from.
pub(super) type Kept = HashMap<[u8; 32], Compiled>;

impl Compiled {
    /// Nothing that was submitted may use them any more.
    pub(super) fn destroy(self, device: &ash::Device) {
        // SAFETY: every submission was waited for, and no one else has these handles. Null
        // handles are allowed.
        unsafe {
            device.destroy_pipeline(self.raw, None);
            device.destroy_pipeline_layout(self.layout, None);
            device.destroy_descriptor_set_layout(self.set_layout, None);
        }
    }
}

impl Device {
    /// From now on keeps every pipeline that it compiles until it is dropped, so that another
    /// of the same words, constants and interface costs nothing: for programs that make the
    /// same pipelines again and again. They take memory, megabytes for long kernels.
    pub fn keep_pipelines(&self) {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.get_or_insert_default();
    }

    /// What it keeps of this key.
    pub(super) fn kept(&self, key: &[u8; 32]) -> Option<Compiled> {
        let kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.as_ref().and_then(|kept| kept.get(key).copied())
    }

    /// Whether it keeps this from now on: not if another thread was faster.
    pub(super) fn keep(&self, key: [u8; 32], compiled: Compiled) -> bool {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        match kept.as_mut() {
            Some(kept) if !kept.contains_key(&key) => kept.insert(key, compiled).is_none(),
            _ => false,
        }
    }
}

/// Of all that a pipeline is made from.
pub(super) fn key(description: &PipelineDescription<'_>, uniforms: &[u32]) -> [u8; 32] {
    let mut hash = Sha256::new();
    let mut add = |words: &[u32]| {
        hash.update((words.len() as u64).to_le_bytes());
        hash.update(bytemuck::cast_slice(words));
    };
    add(description.spirv);
    add(description.bindings);
    add(uniforms);
    add(&[description.push_constant_bytes]);
    let constants = description.specialization.iter();
    add(&constants
        .flat_map(|&(id, value)| [id, value])
        .collect::<Vec<_>>());
    hash.finalize().into()
}
