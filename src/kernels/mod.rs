//! Typed wrappers of the stock kernels: Rust arguments in, results out.

mod elementary;
mod estimator;
mod evaluator;
mod generator;
mod irradiance;
mod mapper;
mod pairs;
mod pixels;
mod points;
mod records;
mod reducer;
mod void_and_cluster;
mod way;

pub use elementary::Elementary;
pub use estimator::Estimator;
pub use evaluator::Evaluator;
pub use generator::Generator;
pub use irradiance::{IrradianceSum, Irradiator};
pub use mapper::Mapper;
pub use pairs::Pairs;
pub use pixels::PixelEstimator;
pub use reducer::{Reducer, Split, largest_group};
pub use void_and_cluster::VoidAndCluster;

use crate::interface::{KERNELS, Kernel, Profile};
use crate::report::hexadecimal;
use crate::spirv::prune;
use crate::vulkan::{Device, Pipeline, PipelineDescription, Probe};
use crate::{Error, Result};
use sha2::{Digest, Sha256};
use std::sync::Arc;

/// The compiled modules, by name.
const MODULES: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/kernels.rs"));

/// The SPIR-V of a stock kernel, for a caller's own pipeline.
///
/// # Errors
/// [`Error::UnknownName`].
pub fn spirv(name: &str) -> Result<Vec<u32>> {
    let module = MODULES.iter().find(|(known, _)| *known == name);
    let (_, bytes) = module.ok_or_else(|| {
        let known: Vec<&str> = MODULES.iter().map(|(name, _)| *name).collect();
        Error::unknown_name("kernel", name, &known)
    })?;
    Ok(bytes
        .chunks_exact(4)
        .map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]))
        .collect())
}

/// The row of a kernel.
///
/// # Errors
/// [`Error::UnknownName`].
pub fn kernel(name: &str) -> Result<&'static Kernel> {
    KERNELS
        .iter()
        .find(|kernel| kernel.name == name)
        .ok_or_else(|| {
            let known: Vec<&str> = KERNELS.iter().map(|kernel| kernel.name).collect();
            Error::unknown_name("kernel", name, &known)
        })
}

/// Asks the device how it treats floats; see [`crate::vulkan::probe`].
///
/// # Errors
/// Those of the device.
pub fn probe(device: &Arc<Device>) -> Result<Probe> {
    crate::vulkan::probe(device, &spirv("probe")?)
}

/// A pipeline of a module with the interface of a row; `words` need not be the stock
/// module, so that tests can run broken ones.
///
/// # Errors
/// [`Error::Shader`] for words that cannot be read as a module, and of 64-bit integers where the
/// device was not opened with them; those of the device.
pub fn pipeline(
    device: &Arc<Device>,
    kernel: &Kernel,
    words: &[u32],
    specialization: &[(u32, u32)],
) -> Result<Pipeline> {
    if kernel.profile == Profile::Wide && !device.has_int64() {
        return Err(Error::Shader {
            shader: kernel.name.to_owned(),
            problem: format!(
                "it needs integers of 64 bits, with which device {} was not opened",
                device.info().name
            ),
        });
    }
    let pruned = prune(words, specialization).map_err(|error| Error::Shader {
        shader: kernel.name.to_owned(),
        problem: error.to_string(),
    })?;
    let bindings: Vec<u32> = kernel.bindings.iter().map(|b| b.binding).collect();
    let uniforms = kernel.bindings.iter().filter(|b| b.uniform().is_some());
    let uniforms: Vec<u32> = uniforms.map(|b| b.binding).collect();
    Pipeline::with_uniforms(
        device,
        &PipelineDescription {
            name: kernel.name,
            spirv: &pruned,
            bindings: &bindings,
            push_constant_bytes: kernel.push_bytes(),
            specialization,
        },
        &uniforms,
    )
}

/// SHA-256 of what [`pipeline`] hands to the driver: the module without what the constants
/// switch off, and their values.
#[must_use]
pub fn fingerprint(words: &[u32], specialization: &[(u32, u32)]) -> String {
    let pruned = prune(words, specialization).unwrap_or_else(|_| words.to_vec());
    let mut hash = Sha256::new();
    hash.update(bytemuck::cast_slice::<u32, u8>(&pruned));
    for (id, value) in specialization {
        hash.update(id.to_le_bytes());
        hash.update(value.to_le_bytes());
    }
    hexadecimal(&hash.finalize())
}

/// Value of the specialization constant with this name, for a row that has it.
fn constant(kernel: &Kernel, name: &str, value: u32) -> Option<(u32, u32)> {
    let found = kernel.constants.iter().find(|c| c.name == name)?;
    Some((found.id, value))
}

/// The groups that hold so many invocations.
fn groups(kernel: &Kernel, invocations: u32) -> u64 {
    u64::from(invocations.div_ceil(kernel.local_size))
}
