//! The files of a stripped scene: its kernel in the languages asked for, its tables, and what
//! is in them.

mod manifest;
mod optimise;
mod target;
mod uniform;

pub use target::{TARGETS, Target};

use super::flat::Flat;
use super::host::{c_header, rust_module};
use super::program::{Form, Options, Parameters, Program, Table, program};
use crate::scene::{Needs, Scene};
use crate::{Error, Result};
use std::panic::resume_unwind;
use uniform::Uniform;

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
    /// For those with integers of 64 bits: see [`Options::int64`]. Targets without push constants
    /// are without them, and no scene that this changes has both.
    pub int64: bool,
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
    pub flat: Flat,
    /// Its module.
    pub spirv: Vec<u32>,
    /// What the optimiser did, where it was asked for.
    pub optimised: Option<Optimised>,
}

/// Strips a scene for these targets, each once.
///
/// # Errors
/// Those of [`program`]; [`Error::Arguments`](crate::Error::Arguments) of a target that cannot
/// express the scene, with the feature that it lacks, and of one that would have other runs than
/// the module because it has no integers of 64 bits; an optimiser that is
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
    let (own, uniform) = std::thread::scope(|scope| {
        let uniform = scope.spawn(|| Uniform::new(name, needs, targets, asked.cpu));
        let own = Own::new(name, needs, asked);
        let uniform = uniform.join();
        let uniform = uniform.unwrap_or_else(|panic| resume_unwind(panic));
        Ok::<_, Error>((own?, uniform?))
    })?;
    // The manifest has one set of numbers.
    if let Some(other) = uniform.as_ref().filter(|_| own.program.form == Form::Eight) {
        return Err(Error::Arguments {
            asked: format!("{name} with 64-bit integers and without push constants"),
            limit: format!(
                "stores of eight words have runs of {}, targets in other languages of {}",
                own.program.run, other.program.run
            ),
            remedy: "strip it twice: without --int64 for wgsl, hlsl, msl and godot".to_owned(),
        });
    }
    let interface = own.program.interface(&own.spirv)?;
    let mut files: Vec<File> = Vec::new();
    for target in targets {
        if files.iter().any(|file| file.target == Some(*target)) {
            continue;
        }
        let bytes = match target {
            Target::Glsl => own.flat.text.clone().into_bytes(),
            Target::Spirv => little_endian(&own.spirv),
            Target::C => c_header(&interface)?.into_bytes(),
            Target::Rust => rust_module(&interface)?.into_bytes(),
            Target::Godot | Target::Wgsl | Target::Hlsl | Target::Msl => {
                let text = uniform.as_ref().and_then(|made| made.text(*target));
                text.unwrap_or_default().as_bytes().to_vec()
            }
        };
        files.push(File {
            name: format!("{name}.{}", target.ending()),
            target: Some(*target),
            bytes,
        });
    }
    let tables = own.program.tables.iter();
    files.extend(tables.map(|table| File {
        name: table_file(name, table),
        target: None,
        bytes: little_endian(&table.words),
    }));
    let mut bundle = Bundle {
        files,
        program: own.program,
        flat: own.flat,
        spirv: own.spirv,
        optimised: own.optimised,
    };
    let uniform = uniform.as_ref().map(|made| &made.program);
    let document = manifest::document(scene, needs, &bundle, uniform);
    let mut bytes = format!("{document:#}").into_bytes();
    bytes.push(b'\n');
    bundle.files.push(File {
        name: "manifest.json".to_owned(),
        target: None,
        bytes,
    });
    Ok(bundle)
}

/// The kernel with push constants.
struct Own {
    program: Program,
    flat: Flat,
    spirv: Vec<u32>,
    optimised: Option<Optimised>,
}

impl Own {
    fn new(name: &str, needs: &Needs, asked: BundleOptions) -> Result<Self> {
        let options = Options {
            parameters: Parameters::Push,
            cpu: asked.cpu,
            int64: asked.int64,
        };
        let program = program(name, needs, options)?;
        let flat = program.flat(false)?;
        let mut spirv = program.spirv(&flat.text)?;
        let mut optimised = None;
        if asked.spirv_opt {
            let bytes_before = 4 * spirv.len();
            let (words, version) = optimise::optimise(name, &spirv, program.rules())?;
            spirv = words;
            optimised = Some(Optimised {
                bytes_before,
                version,
            });
        }
        Ok(Self {
            program,
            flat,
            spirv,
            optimised,
        })
    }
}

/// Words as bytes, the lowest first.
fn little_endian(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// The name of a table's file: words, the lowest byte first.
fn table_file(name: &str, table: &Table) -> String {
    format!("{name}.{}.bin", table.name)
}
