//! The arguments.

mod generate;
mod look;
mod merge;
mod scene;
mod study;
mod values;
mod verify;

pub use generate::GenerateArgs;
pub use look::{MeasureArgs, PlotArgs};
pub use merge::MergeArgs;
pub use scene::{SceneArgs, StripArgs};
pub use study::{ConvergeArgs, EstimateArgs, IntegrandsArgs};
pub use values::Param;
pub use verify::VerifyArgs;

use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;
use values::whole;

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
    /// Check that a Zarr store is complete, add estimates of several ranges exactly, or write the report
    /// of a study in shards.
    Merge(MergeArgs),
    /// Make a file of points or a picture again from its FILE.json, or the chunks of a store, and
    /// compare.
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
    /// Write the compiled stock modules, and the specialization constants that make points of them.
    Modules(ModulesArgs),
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
    /// Check nothing: compare the hashes of the exact rows of two documents that --json wrote.
    #[arg(long, num_args = 2, value_names = ["A", "B"], conflicts_with_all = ["device", "seconds", "junit", "only", "report"])]
    pub compare: Option<Vec<PathBuf>>,
    /// Check the catalogue of extreme inputs instead: errors of common formulas, of the CPU, and
    /// of the device in both profiles; with --device cpu of the CPU alone.
    #[arg(long, conflicts_with_all = ["only", "report", "compare"])]
    pub extreme: bool,
    /// Check functions over all their inputs instead: those of one word and the radical inverses in
    /// bases 2, 3, 5 and 8161 over all 2^32, the others and the maps over all pairs of critical values
    /// and 2^24 random inputs; and the sum of 2^28 equal terms. All rows take hours on a CPU's driver; choose with --only.
    #[arg(long, conflicts_with_all = ["report", "compare", "extreme"])]
    pub exhaustive: bool,
    /// Only rows whose name, header or kernel contains this.
    #[arg(long)]
    pub only: Option<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct HeadersArgs {
    /// The folder, which is made if it is not there; the files lie in its folder corput.
    #[arg(long)]
    pub out: PathBuf,
}

#[derive(Debug, Args)]
pub struct ModulesArgs {
    /// The folder, which is made if it is not there.
    #[arg(long)]
    pub out: PathBuf,
    /// Only the module that makes points of this sampler, as sobol:owen-hash, and its constants.
    #[arg(long)]
    pub sampler: Option<String>,
    /// Their dimensions [default: 2].
    #[arg(long, value_parser = whole, allow_hyphen_values = true, requires = "sampler")]
    pub dims: Option<u64>,
    /// How many a dispatch makes, 1 to 2^32 [default: 1048576].
    #[arg(long, value_parser = whole, allow_hyphen_values = true, requires = "sampler")]
    pub count: Option<u64>,
    /// Index of the first [default: 0].
    #[arg(long, value_parser = whole, allow_hyphen_values = true, requires = "sampler")]
    pub first: Option<u64>,
    /// Their seed [default: 0].
    #[arg(long, value_parser = whole, allow_hyphen_values = true, requires = "sampler")]
    pub seed: Option<u64>,
    /// Fractions of 2^32 in place of floats.
    #[arg(long, requires = "sampler")]
    pub fractions: bool,
    /// For drivers of CPUs: long runs of points per invocation.
    #[arg(long, requires = "sampler")]
    pub cpu: bool,
    /// The device has shaderInt64.
    #[arg(long, requires = "sampler")]
    pub int64: bool,
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
    /// Measure 2^25 to 2^32 words of Sobol points instead: the time of a word should stay.
    #[arg(long, conflicts_with_all = ["scene", "only", "against"])]
    pub scaling: bool,
    /// Measure files in this folder instead: one of 4 GiB beside a plain write of as many bytes, three
    /// times, and one of 1,024 points. What is written there is removed.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["scene", "only", "against", "scaling"])]
    pub files: Option<PathBuf>,
    /// With --files: bytes of the large one.
    #[arg(long, value_parser = whole, default_value = "4294967296", requires = "files", allow_hyphen_values = true)]
    pub size: u64,
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
