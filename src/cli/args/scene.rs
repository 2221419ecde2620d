//! The arguments of what a renderer draws from.

use super::values::{Param, param, whole};
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct SceneArgs {
    /// A scene file (.toml), .gltf or .glb.
    pub file: PathBuf,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct StripArgs {
    /// A scene file (.toml), .gltf or .glb; or give a sampler.
    pub file: Option<PathBuf>,
    /// Points of this sampler in place of a scene, as sobol:owen-hash.
    #[arg(long)]
    pub sampler: Option<String>,
    /// Their dimensions [default: those of the map, or 2].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub dims: Option<u64>,
    /// How many there will ever be, 1 to 2^32 [default: 1024].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub samples: Option<u64>,
    /// Their seed [default: 0].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub seed: Option<u64>,
    /// A map over their first dimensions; the others stay numbers in [0, 1).
    #[arg(long)]
    pub map: Option<String>,
    /// A parameter of the map, as alpha=0.1 or wo=0.8,0,0.6; `corput maps` lists them.
    #[arg(long, value_name = "NAME=X[,X...]", value_parser = param, allow_hyphen_values = true)]
    pub param: Vec<Param>,
    /// exact: the same bytes everywhere; native: the device's own functions [default: exact].
    #[arg(long)]
    pub profile: Option<String>,
    /// The folder of the files: NAME.glsl and so on, tables, manifest.json.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// glsl, spirv, godot, wgsl, hlsl, msl, c, rust [default: glsl,spirv,c,rust].
    #[arg(long, value_delimiter = ',')]
    pub target: Vec<String>,
    /// Long runs of samples per invocation, for drivers of CPUs.
    #[arg(long)]
    pub cpu: bool,
    /// With --cpu: stores of 64-bit integers (shaderInt64), for bare points by short coordinates.
    #[arg(long, requires = "cpu")]
    pub int64: bool,
    /// Run spirv-opt of SPIR-V Tools on the module, and lint it again.
    #[arg(long)]
    pub spirv_opt: bool,
    /// Write what is kept and left out, sizes and times as a page.
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Time on this device, by index or part of its name; a report is timed on the first.
    #[arg(long)]
    pub device: Option<String>,
    /// Print sizes and times as one JSON document.
    #[arg(long)]
    pub json: bool,
}
