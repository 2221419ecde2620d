//! The texts of targets without push constants.

use super::Target;
use crate::scene::Needs;
use crate::strip::program::{Options, Parameters, Program, program};
use crate::strip::{About, Shader, Translator};
use crate::{Error, Result};

/// The kernel with its parameters in a uniform block.
pub(super) struct Uniform {
    pub(super) program: Program,
    texts: Vec<(Target, String)>,
}

impl Uniform {
    /// The kernel, and its text for those of the targets that take it; `None` where none does.
    pub(super) fn new(
        name: &str,
        needs: &Needs,
        targets: &[Target],
        cpu: bool,
    ) -> Result<Option<Self>> {
        let mut targets: Vec<Target> = targets.to_vec();
        targets.retain(|target| target.has_uniform());
        if targets.is_empty() {
            return Ok(None);
        }
        let options = Options {
            parameters: Parameters::Uniform,
            cpu,
            int64: false,
        };
        let program = program(name, needs, options)?;
        let mut texts = Vec::new();
        if targets.contains(&Target::Godot) {
            let text = format!("#[compute]\n{}", program.flat(false)?.text);
            texts.push((Target::Godot, text));
        }
        targets.retain(|target| target.is_translated());
        if !targets.is_empty() {
            texts.extend(translations(&program, &targets)?);
        }
        Ok(Some(Self { program, texts }))
    }

    /// The text of a target, if it is one of those.
    pub(super) fn text(&self, target: Target) -> Option<&str> {
        let found = self.texts.iter().find(|(known, _)| *known == target);
        found.map(|(_, text)| text.as_str())
    }
}

/// The kernel in the languages that naga writes.
fn translations(program: &Program, targets: &[Target]) -> Result<Vec<(Target, String)>> {
    let words = program.named(&program.flat(true)?.text)?;
    let about = About {
        what: "the kernel of a scene",
        scene: &program.name,
    };
    let translator = Translator::new(Shader::Spirv(&words), about);
    let translator = translator.map_err(|error| lacking(program, targets, error))?;
    let text = |target: Target| {
        let text = match target {
            Target::Wgsl => translator.wgsl(),
            Target::Hlsl => translator.hlsl(),
            _ => translator.msl(),
        };
        text.map(|text| (target, text))
            .map_err(|error| lacking(program, &[target], error))
    };
    let mut made: Vec<(Target, String)> = Vec::new();
    for target in targets {
        if !made.iter().any(|(known, _)| known == target) {
            made.push(text(*target)?);
        }
    }
    Ok(made)
}

/// The error of targets that cannot express a scene: what naga says of stock kernels is done
/// here already.
fn lacking(program: &Program, targets: &[Target], error: Error) -> Error {
    let names: Vec<&str> = targets.iter().map(|target| target.name()).collect();
    let names = names.join(", ");
    match error {
        Error::Arguments { limit, .. } => Error::Arguments {
            asked: format!("{} for the target {names}", program.name),
            limit,
            remedy: format!("leave {names} out of --target, or change what the scene draws"),
        },
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    #[test]
    fn a_target_that_lacks_something_is_named_with_it() {
        let needs = Needs::of_points(&Scene::new("points").unwrap(), 2, None).unwrap();
        let mut made = program("points", &needs, Options::default()).unwrap();
        // Extended products, as kernels have them where they are not asked to be portable.
        made.source = "#version 450\nlayout(local_size_x = 64) in;\n\
            layout(std430, set = 0, binding = 0) buffer Samples { uint samples[]; };\n\
            void main() {\n    uint high;\n    uint low;\n\
            umulExtended(samples[0], 3u, high, low);\n    samples[1] = high;\n}\n"
            .to_owned();
        let error = translations(&made, &[Target::Wgsl, Target::Msl]).unwrap_err();
        assert_eq!(error.exit_code(), 2);
        let said = error.to_string();
        for part in [
            "points for the target wgsl, msl",
            "UMulExtended",
            "leave wgsl, msl out of --target",
        ] {
            assert!(said.contains(part), "{part} is not in: {said}");
        }
    }
}
