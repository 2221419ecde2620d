//! The files of a stripped scene: its kernel in the languages asked for, its tables, and what
//! is in them.

mod manifest;
mod optimise;
mod target;

pub use target::{TARGETS, Target};

use super::host::{c_header, rust_module};
use super::program::{Options, Parameters, Program, Table, program};
use super::{About, Shader, Translations, translate};
use crate::scene::{Needs, Scene};
use crate::{Error, Result};

/// A file of a bundle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name, without a folder.
    pub name: String,
    /// The target that it is of; tables and the manifest are of all.
    pub target: Option<Target>,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// How to write a bundle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BundleOptions {
    /// For CPU drivers: see [`Options::cpu`].
    pub cpu: bool,
    /// Runs `spirv-opt` of SPIR-V Tools on the module, which is linted again; without inlining
    /// in the exact profile, whose rules go by functions.
    pub spirv_opt: bool,
}

/// What the optimiser did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Optimised {
    /// Bytes of the module before.
    pub bytes_before: usize,
    /// The line in which the program names itself.
    pub version: String,
}

/// A stripped scene.
#[derive(Clone, Debug)]
pub struct Bundle {
    /// Every file, the manifest last.
    pub files: Vec<File>,
    /// The kernel with push constants.
    pub program: Program,
    /// What its text has kept and left out.
    pub flat: super::Flat,
    /// Its module.
    pub spirv: Vec<u32>,
    /// What the optimiser did, where it was asked for.
    pub optimised: Option<Optimised>,
}

/// Strips a scene for these targets, each once.
///
/// # Errors
/// Those of [`program`]; [`Error::Arguments`](crate::Error::Arguments) of a target that cannot
/// express the scene, with the feature that it lacks; an optimiser that is
/// not there, or whose module breaks the rules.
pub fn bundle(
    scene: &Scene,
    needs: &Needs,
    targets: &[Target],
    asked: BundleOptions,
) -> Result<Bundle> {
    let name = &scene.name;
    // It becomes part of file names.
    if name.is_empty() || name.contains(['/', '\\', '\0']) {
        return Err(Error::Arguments {
            asked: format!("files of a scene named {name:?}"),
            limit: "a name is part of one, so that it has no separators of folders".to_owned(),
            remedy: "give the scene another name".to_owned(),
        });
    }
    let options = Options {
        parameters: Parameters::Push,
        cpu: asked.cpu,
    };
    let made = program(name, needs, options)?;
    let flat = made.flat(false)?;
    let mut spirv = made.spirv(&flat.text)?;
    let mut optimised = None;
    if asked.spirv_opt {
        let bytes_before = 4 * spirv.len();
        let (words, version) = optimise::optimise(name, &spirv, made.rules())?;
        spirv = words;
        optimised = Some(Optimised {
            bytes_before,
            version,
        });
    }
    let interface = made.interface(&spirv)?;
    // Languages and engines without push constants.
    let options = Options {
        parameters: Parameters::Uniform,
        cpu: asked.cpu,
    };
    let uniform = match targets.iter().any(|one| one.has_uniform()) {
        true => Some(program(name, needs, options)?),
        false => None,
    };
    let translated = match &uniform {
        Some(program) if targets.iter().any(|one| one.is_translated()) => {
            Some(translations(program, name)?)
        }
        _ => None,
    };
    let mut files = Vec::new();
    for (at, target) in targets.iter().enumerate() {
        if targets.iter().take(at).any(|one| one == target) {
            continue;
        }
        let text = |of: fn(&Translations) -> &String| {
            translated
                .as_ref()
                .map_or_else(String::new, |t| of(t).clone())
        };
        let bytes = match target {
            Target::Glsl => flat.text.clone().into_bytes(),
            Target::Spirv => spirv.iter().flat_map(|word| word.to_le_bytes()).collect(),
            Target::Godot => match &uniform {
                Some(program) => format!("#[compute]\n{}", program.flat(false)?.text).into_bytes(),
                None => Vec::new(),
            },
            Target::Wgsl => text(|t| &t.wgsl).into_bytes(),
            Target::Hlsl => text(|t| &t.hlsl).into_bytes(),
            Target::Msl => text(|t| &t.msl).into_bytes(),
            Target::C => c_header(&interface)?.into_bytes(),
            Target::Rust => rust_module(&interface)?.into_bytes(),
        };
        files.push(File {
            name: format!("{name}.{}", target.ending()),
            target: Some(*target),
            bytes,
        });
    }
    files.extend(made.tables.iter().map(|table| {
        File {
            name: table_file(name, table),
            target: None,
            bytes: table
                .words
                .iter()
                .flat_map(|word| word.to_le_bytes())
                .collect(),
        }
    }));
    let mut bundle = Bundle {
        files,
        program: made,
        flat,
        spirv,
        optimised,
    };
    let document = manifest::document(scene, needs, &bundle, uniform.as_ref());
    let mut bytes = format!("{document:#}").into_bytes();
    bytes.push(b'\n');
    bundle.files.push(File {
        name: "manifest.json".to_owned(),
        target: None,
        bytes,
    });
    Ok(bundle)
}

/// The name of a table's file: words, the lowest byte first.
fn table_file(name: &str, table: &Table) -> String {
    format!("{name}.{}.bin", table.name)
}

fn translations(program: &Program, scene: &str) -> Result<Translations> {
    let words = program.named(&program.flat(true)?.text)?;
    let about = About {
        what: "the kernel of a scene",
        scene,
    };
    translate(Shader::Spirv(&words), &about).map_err(|error| match error {
        // What it says of stock kernels is done here already.
        Error::Arguments { asked, limit, .. } => Error::Arguments {
            asked: format!("{asked}, {scene}"),
            limit,
            remedy: "leave wgsl, hlsl and msl out of the targets, or change what the scene draws"
                .to_owned(),
        },
        other => other,
    })
}
