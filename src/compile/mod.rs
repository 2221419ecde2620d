//! GLSL to checked SPIR-V: compile, decorate, lint.
//!
//! `build.rs` includes this file for the stock kernels; tests use it for mutants. The
//! stages are the same: glslang for Vulkan 1.1 and SPIR-V 1.3, `NoContraction` on every
//! float result, then the linter of the kernel's profile.

use crate::interface::{Kernel, Profile};
use crate::spirv;
use glslang::include::{IncludeHandler, IncludeResult, IncludeType};
use glslang::{
    Compiler, CompilerOptions, Shader, ShaderInput, ShaderSource, ShaderStage, SourceLanguage,
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
    compiled(source, defines, lookup, None)
}

/// The same of one file that uses nothing of GLSL after 4.40, such as the kernel of a scene, for
/// processes that compile little. glslang begins by reading the declarations of all that is
/// built in; those of 4.50 on have the stages of rays and meshes too, which take it as long as
/// all others.
///
/// # Errors
/// The compiler's log; a first line without `#version`.
pub fn to_spirv_lean(source: &str) -> Result<Vec<u32>, String> {
    let first = source.lines().next().unwrap_or("");
    let version = first.strip_prefix("#version ").and_then(|rest| {
        let number = rest.split_whitespace().next()?;
        number.parse::<u32>().ok()
    });
    let version = version.ok_or("the first line is no `#version`")?;
    let mut words = compiled(source, &[], &mut |_| None, Some(LEAN))?;
    let module = spirv::Module::parse(&words).map_err(|error| error.to_string())?;
    let said = module.instructions().iter();
    let places: Vec<usize> = said
        .filter(|one| one.op() == Some(::spirv::Op::Source))
        .map(|one| one.at + 2)
        .collect();
    // The module says of what version its text is, not with what tables it was read.
    for place in places {
        if let Some(word) = words.get_mut(place) {
            *word = version;
        }
    }
    Ok(words)
}

/// Makes the first [`to_spirv_lean`] as fast as the others, in some hundredths of a second: for a
/// thread beside other work.
pub fn warm_up() {
    // What is wrong with the compiler is said where it is used.
    let _ = to_spirv_lean("#version 450\nlayout(local_size_x = 1) in;\nvoid main() {}\n");
}

/// The version as which a text is read that needs no later one.
const LEAN: i32 = 440;

fn compiled(
    source: &str,
    defines: &[(&str, &str)],
    lookup: &mut Lookup,
    version: Option<i32>,
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
    .and_then(|input| {
        let mut shader = Shader::new(compiler, input);
        if let Some(version) = version {
            shader.glsl_version(version);
        }
        shader.parse()
    })
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
