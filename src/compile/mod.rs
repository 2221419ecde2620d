//! GLSL to checked SPIR-V: compile, decorate, lint.
//!
//! `build.rs` includes this file for the stock kernels; tests use it for mutants. The
//! stages are the same: glslang for Vulkan 1.1 and SPIR-V 1.3, `NoContraction` on every
//! float result, then the linter of the kernel's profile.

use crate::interface::{Kernel, Profile};
use crate::spirv;
use glslang::include::{IncludeHandler, IncludeResult, IncludeType};
use glslang::{
    Compiler, CompilerOptions, ShaderInput, ShaderSource, ShaderStage, SourceLanguage,
    SpirvVersion, Target, VulkanVersion,
};

/// Looks up the text of an include by its name.
pub type Lookup<'a> = dyn FnMut(&str) -> Option<String> + 'a;

struct Includes<'a, 'b> {
    lookup: &'a mut Lookup<'b>,
    missing: Option<String>,
}

impl IncludeHandler for Includes<'_, '_> {
    fn include(&mut self, _: IncludeType, name: &str, _: &str, _: usize) -> Option<IncludeResult> {
        let data = (self.lookup)(name);
        if data.is_none() {
            self.missing = Some(name.to_owned());
        }
        Some(IncludeResult {
            name: name.to_owned(),
            data: data?,
        })
    }
}

/// SPIR-V 1.3 of a compute shader, as glslang gives it.
///
/// # Errors
/// The compiler's log, or the name of a missing include.
pub fn to_spirv(
    source: &str,
    defines: &[(&str, &str)],
    lookup: &mut Lookup,
) -> Result<Vec<u32>, String> {
    let compiler = Compiler::acquire().ok_or("glslang does not start")?;
    let mut includes = Includes {
        lookup,
        missing: None,
    };
    let options = CompilerOptions {
        source_language: SourceLanguage::GLSL,
        target: Target::Vulkan {
            version: VulkanVersion::Vulkan1_1,
            spirv_version: SpirvVersion::SPIRV1_3,
        },
        ..CompilerOptions::default()
    };
    let source = ShaderSource::from(source);
    let defines: Vec<(&str, Option<&str>)> = defines.iter().map(|d| (d.0, Some(d.1))).collect();
    let result = ShaderInput::new(
        &source,
        ShaderStage::Compute,
        &options,
        Some(&defines[..]),
        Some(&mut includes),
    )
    .and_then(|input| compiler.create_shader(input))
    .and_then(|shader| shader.compile())
    .map_err(|error| error.to_string());
    match (result, includes.missing) {
        (Err(_), Some(name)) => Err(format!("no include `{name}`")),
        (result, _) => result,
    }
}

/// The rules of a profile.
#[must_use]
pub fn policy(profile: Profile) -> spirv::Policy {
    match profile {
        Profile::Integer | Profile::Float => spirv::exact_policy(),
        Profile::Wide => spirv::exact_policy().wide(),
        Profile::Native | Profile::Probe => spirv::native_policy(),
    }
}

/// Decorates a module and holds it to the rules of its profile.
///
/// # Errors
/// Every violation, with function and opcode.
pub fn check(words: &[u32], profile: Profile) -> Result<Vec<u32>, String> {
    let words = spirv::decorate_no_contraction(words).map_err(|error| error.to_string())?;
    let report = spirv::lint(&words, &policy(profile)).map_err(|error| error.to_string())?;
    if !report.is_clean() {
        let lines: Vec<String> = report.violations.iter().map(ToString::to_string).collect();
        return Err(format!("the linter refuses it:\n{}", lines.join("\n")));
    }
    let integers = matches!(profile, Profile::Integer | Profile::Wide);
    if integers && report.tier != Some(spirv::Tier::Integer) {
        return Err("the kernel is declared tier I, and uses tier F functions".to_owned());
    }
    Ok(words)
}

/// A kernel from its source: the module that is shipped.
///
/// # Errors
/// The compiler's or the linter's words.
pub fn kernel(kernel: &Kernel, source: &str, lookup: &mut Lookup) -> Result<Vec<u32>, String> {
    let interface = kernel.glsl();
    let mut lookup = |name: &str| match name {
        "interface.glsl" => Some(interface.clone()),
        other => lookup(other),
    };
    let words = to_spirv(source, kernel.defines, &mut lookup)?;
    check(&words, kernel.profile)
}
