//! The arguments.

mod merge;
mod study;
mod values;
mod verify;

pub use merge::MergeArgs;
pub use study::{ConvergeArgs, EstimateArgs, IntegrandsArgs};
pub use values::{Grid, Param};
pub use verify::VerifyArgs;

use super::guide;
use clap::{Args, Parser, Subcommand};
use corput::catalog::Shard;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use values::{cells, grid, param, whole};

/// Low-discrepancy points and importance-sampled directions, bit-identical on every
/// conformant Vulkan driver and on the CPU.
#[derive(Debug, Parser)]
#[command(version, about, after_help = EXIT_CODES)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

const EXIT_CODES: &str = "To begin with:
  corput generate sobol --count 1024 --scramble owen --seed 1 --out p.npy
  corput plot p.npy --out p.svg
  corput measure p.npy
  corput check

Exit codes: 0 done; 1 a check failed; 2 refused before work began; \
3 no device present, or none adequate; 4 failed while running.\n\
Environment: CORPUT_DEVICE chooses the device as --device does; CORPUT_VALIDATION=1 runs with \
the Khronos validation layer, whose messages then fail the command; CORPUT_WINDOWS=off has \
generate copy what a device makes, and =require has it fail where the device cannot write to the file.";

#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the Vulkan devices, their limits and what a probe of their floats finds.
    Devices(DevicesArgs),
    /// Make points, or samples of a map over them, and write them to a file.
    Generate(Box<GenerateArgs>),
    /// Check that a Zarr store is complete, or add estimates of several ranges exactly.
    Merge(MergeArgs),
    /// Make a file of points again from its FILE.json, or the chunks of a store, and compare.
    Verify(VerifyArgs),
    /// List the maps: parameters, dimensions, pdf and its measure, errors.
    Maps(MapsArgs),
    /// List the integrands: parameters, dimensions, formula, integral, error of their terms.
    Integrands(IntegrandsArgs),
    /// Estimate an integral by exact sums over up to 2^32 points.
    Estimate(EstimateArgs),
    /// Measure error against run time: samplers on integrands, in replicates.
    Converge(ConvergeArgs),
    /// Compare every kernel and function with the CPU reference on a device.
    Check(CheckArgs),
    /// Say how good a set of points in [0, 1)^d is.
    Measure(MeasureArgs),
    /// Write the GLSL headers as files.
    Headers(HeadersArgs),
    /// Make points and directions, check all of them, and light a real map.
    Demo(DemoArgs),
    /// Measure speed, verified first, as a ratio to a fill of the same bytes.
    Bench(BenchArgs),
    /// Measure errors and speed of single functions, exact against native.
    Accuracy(AccuracyArgs),
    /// Draw the points of .npy files: scatter, pairs of dimensions, power spectrum.
    Plot(PlotArgs),
    /// Say what a scene draws, and why, and what is left out: of a scene file or of glTF.
    Scene(SceneArgs),
    /// Write a kernel that draws one scene's samples and nothing else, in several languages.
    Strip(Box<StripArgs>),
    /// Write arguments and results of everything exact, for ports to test themselves with.
    Vectors(VectorsArgs),
}

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

#[derive(Debug, Args)]
pub struct VectorsArgs {
    /// The folder.
    #[arg(long)]
    pub out: PathBuf,
}

#[derive(Debug, Args)]
pub struct DevicesArgs {
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Clone, Debug, Args, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[command(after_help = "`corput generate --help` says what each sequence is, and what it takes.")]
#[command(after_long_help = guide::generate())]
pub struct GenerateArgs {
    #[arg(help = guide::sequences())]
    pub sequence: String,
    /// Points to make: 1 to 2^32; of blue-noise to 65536.
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub count: Option<u64>,
    /// blue-noise-mask: pixels along a side, 4 to 256.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub size: Option<u64>,
    /// blue-noise-mask: values of a pixel, 1 or 2 [default: 1].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub channels: Option<u64>,
    /// blue-noise-mask: frames of a mask over time, 1 to 16; size x size x frames is at
    /// most 65536 [default: 1].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub frames: Option<u64>,
    /// Index of the first point.
    #[arg(long, default_value = "0", value_parser = whole, allow_hyphen_values = true)]
    pub first: u64,
    /// Dimensions [default: 2, for vdc 1].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub dims: Option<u64>,
    /// Prime bases in place of the first primes, as 2,3,8161.
    #[arg(long, value_delimiter = ',', value_parser = whole, allow_hyphen_values = true)]
    pub bases: Option<Vec<u64>>,
    #[arg(help = guide::total())]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub total: Option<u64>,
    /// hammersley: k/N as the first column instead of the last.
    #[arg(long)]
    pub index_first: bool,
    /// Seed of what is random, 0 to 2^64 - 1 [default: 0]; given to lattice, korobov or r2 it
    /// also rotates them.
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub seed: Option<u64>,
    #[arg(help = guide::scrambles())]
    #[arg(long)]
    pub scramble: Option<String>,
    /// sobol: natural or gray.
    #[arg(long, default_value = "natural")]
    pub order: String,
    /// stratified, cmj: cells along each axis, as 32x16 [default: nearly equal divisors].
    #[arg(long, value_parser = grid, allow_hyphen_values = true)]
    pub grid: Option<Grid>,
    /// korobov: the generator [default: that published for the number of points].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub generator: Option<u64>,
    /// f32; or fractions of 2^32 as u32, as u16 (their leading bits) or as f64 (all of them)
    /// [default: f32].
    #[serde(rename = "type")]
    #[arg(long = "type", value_name = "TYPE")]
    pub element: Option<String>,
    /// As --type u32.
    #[serde(skip)]
    #[arg(long)]
    pub fractions: bool,
    #[arg(help = guide::maps())]
    #[arg(long)]
    pub map: Option<String>,
    /// A parameter of the map, as alpha=0.1 or wo=0.8,0,0.6; `corput maps` lists them.
    #[arg(long, value_name = "NAME=X[,X...]", value_parser = param, allow_hyphen_values = true)]
    pub param: Vec<Param>,
    /// environment maps: the picture whose light is sampled, .exr or .hdr.
    #[arg(long, value_name = "FILE")]
    pub env: Option<PathBuf>,
    /// environment maps: what a texel weighs, luminance or max, the largest channel
    /// [default: luminance].
    #[arg(long, value_name = "NAME")]
    pub env_weight: Option<String>,
    /// environment maps: subtract the mean, for use beside another technique of multiple
    /// importance sampling.
    #[arg(long)]
    pub compensated: bool,
    /// Append the map's pdf as the last column.
    #[arg(long)]
    pub with_pdf: bool,
    /// exact: the same bytes everywhere; native: the device's own functions.
    #[arg(long, default_value = "exact")]
    pub profile: String,
    /// Device by index or part of its name; cpu for none; auto for whichever of the default device
    /// and the CPU is faster in a trial of a tenth of a second each, which standard error reports.
    #[serde(skip)]
    #[arg(long)]
    pub device: Option<String>,
    /// npy, raw, csv, c-header or glsl, an array, or zarr; of blue-noise-mask npy, png or exr
    /// [default: from the file's ending; npy on standard output].
    #[serde(skip)]
    #[arg(long)]
    pub format: Option<String>,
    /// Make share I of N, from 0, of a Zarr store's chunks: other machines make the others in
    /// the same folder. Chunks that are there and whole are kept.
    #[serde(skip)]
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    pub shard: Option<Shard>,
    /// The file, or the folder of a Zarr store; - is standard output. FILE.json beside a file
    /// records arguments and hashes.
    #[serde(skip)]
    #[arg(long)]
    pub out: PathBuf,
    /// Go on from the complete chunks that a run with these arguments left when it was cut off;
    /// without this they are discarded.
    #[serde(skip)]
    #[arg(long)]
    pub resume: bool,
    /// Rows of a chunk, the unit of what is kept and hashed [default: those of about 64 MiB].
    #[serde(skip)]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub chunk_rows: Option<u64>,
}

#[derive(Debug, Args)]
pub struct MapsArgs {
    /// Only this one.
    pub name: Option<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct CheckArgs {
    /// Device by index or part of its name.
    #[arg(long)]
    pub device: Option<String>,
    /// Begin no row after so many seconds; what is left out is counted and named.
    #[arg(long, allow_hyphen_values = true)]
    pub seconds: Option<f64>,
    /// Write a report card into this folder: report.html, report.json and junit.xml.
    #[arg(long, value_name = "DIR")]
    pub report: Option<PathBuf>,
    /// Write the rows as JUnit XML too.
    #[arg(long, value_name = "FILE")]
    pub junit: Option<PathBuf>,
    /// Check nothing: compare the hashes of two documents that --json wrote.
    #[arg(long, num_args = 2, value_names = ["A", "B"], conflicts_with_all = ["device", "seconds", "junit", "only", "report"])]
    pub compare: Option<Vec<PathBuf>>,
    /// Check the catalogue of extreme inputs instead: errors of common formulas, of the CPU, and
    /// of the device in both profiles.
    #[arg(long, conflicts_with_all = ["seconds", "junit", "only", "report", "compare"])]
    pub extreme: bool,
    /// Check functions over all their inputs instead: those of one word and the radical inverses in
    /// bases 2, 3, 5 and 8161 over all 2^32, the others and the maps over all pairs of critical values
    /// and 2^24 random inputs. All rows take hours on a CPU's driver; choose with --only.
    #[arg(long, conflicts_with_all = ["seconds", "junit", "report", "compare", "extreme"])]
    pub exhaustive: bool,
    /// Only rows whose name, header or kernel contains this.
    #[arg(long)]
    pub only: Option<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = CONVENTIONS)]
pub struct MeasureArgs {
    /// An .npy file, one point a row: f4 or f8 in [0, 1), or u4 as fractions of 2^32.
    pub file: PathBuf,
    /// Only these: star, l2-star, centred, wrap-around, mixture, modified-l2, t-value,
    /// intervals, distance, projections, spectrum.
    #[arg(long, value_delimiter = ',')]
    pub only: Option<Vec<String>>,
    /// Bases of the elementary intervals, one for each dimension, as 2,3 [default: 2 for
    /// all].
    #[arg(long, value_delimiter = ',', value_parser = whole, allow_hyphen_values = true)]
    pub base: Option<Vec<u64>>,
    /// Dimensions of the spectrum.
    #[arg(long, value_delimiter = ',', value_parser = whole, allow_hyphen_values = true, default_value = "0,1")]
    pub pair: Vec<u64>,
    /// Also what takes long.
    #[arg(long)]
    pub all: bool,
    /// Device for sums and searches over pairs of points, by index or part of its name
    /// [default: the CPU].
    #[arg(long)]
    pub device: Option<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

const CONVENTIONS: &str = "Conventions: l2-star is a square root; centred, wrap-around, \
mixture and modified-l2 are squares, as SciPy has them (whose MD is mixture, not modified). \
star is a supremum: exact for one and two dimensions, otherwise between two bounds. Of \
projections the worst is that of the largest centred discrepancy. A device sums products in \
fixed point; by how much any square may be off is in the JSON. The spectrum is 1 for white \
noise, its anisotropy 0 dB.";

#[derive(Debug, Args)]
pub struct HeadersArgs {
    /// The folder, which is made if it is not there; the files lie in its folder corput.
    #[arg(long)]
    pub out: PathBuf,
}

#[derive(Debug, Args)]
pub struct DemoArgs {
    /// Device by index or part of its name.
    #[arg(long)]
    pub device: Option<String>,
    /// The environment map.
    #[arg(long, default_value = "tests/data/sunrise.exr")]
    pub env: PathBuf,
    /// Folder for the files, which is made if it is not there.
    #[arg(long, default_value = "target/demo")]
    pub out: PathBuf,
}

#[derive(Debug, Args)]
pub struct BenchArgs {
    /// Measure the kernels of these scenes instead: each against the stock kernels that draw the
    /// same.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["only", "against"])]
    pub scene: Vec<PathBuf>,
    /// Only the jobs whose names hold one of these, as halton,sobol [default: all].
    #[arg(long, value_delimiter = ',')]
    pub only: Vec<String>,
    /// Compare with what `bench --json` printed before; exit code 1 where a job is slower.
    #[arg(long, value_name = "FILE")]
    pub against: Option<PathBuf>,
    /// Device by index or part of its name; cpu measures the CPU path.
    #[arg(long)]
    pub device: Option<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "docs/accuracy.md says what the columns mean.")]
pub struct AccuracyArgs {
    /// Device by index or part of its name.
    #[arg(long)]
    pub device: Option<String>,
    /// Only these functions and maps, as sqrt,cone [default: all].
    #[arg(long, value_delimiter = ',')]
    pub function: Vec<String>,
    /// Name the functions and maps, and measure nothing.
    #[arg(long, conflicts_with_all = ["function", "json", "report"])]
    pub list: bool,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
    /// Write accuracy.html, .svg, .png, .json and .csv into this folder.
    #[arg(long, value_name = "DIR")]
    pub report: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct PlotArgs {
    /// The files, 1 to 8: points of [0, 1) as f4 or f8, or u4 fractions of 2^32. Several
    /// stand side by side.
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// scatter, pairs, spectrum or all [default: all for 1 or 2 dimensions, else pairs].
    #[arg(long)]
    pub kind: Option<String>,
    /// Dimensions, counted from 0, as 0,3,7 [default: the first 8; the first 2 for scatter and
    /// spectrum].
    #[arg(long, value_delimiter = ',', value_parser = whole, allow_hyphen_values = true)]
    pub dims: Option<Vec<u64>>,
    /// Draw and measure the first so many points [default: all, at most 65536, in pairs as
    /// many as can be told apart; the figure says how many].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub points: Option<u64>,
    /// A grid over the points, as 16x9, to show elementary cells.
    #[arg(long, value_parser = cells)]
    pub cells: Option<[u32; 2]>,
    /// Above the figure [default: the file's name].
    #[arg(long)]
    pub title: Option<String>,
    /// Side of a square in pixels, 200 to 1000; a PNG has twice as many.
    #[arg(long, default_value = "360", value_parser = whole, allow_hyphen_values = true)]
    pub size: u64,
    /// The picture: .svg or .png.
    #[arg(long)]
    pub out: PathBuf,
}
